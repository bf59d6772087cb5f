//! Parts of a scene whose level nothing sets: nothing is told of them where all is adiabatic, and the rest is as
//! without them.

use radiosity::Work;
use radiosity::audit::{Effort, HeatReferee};
use radiosity::heat::{Heat, HeatOptions};
use radiosity_test_support::compare::assert_close;
use radiosity_test_support::scenes::typed;

use super::shared::{level, of};

/// A hot box without a bottom that stands a hair above an adiabatic plate, and a hot plate far away.
const FOOT: &str = r#"
    materials.hot = { emissivity = 0.8, temperature = 400 }
    materials.plate = { emissivity = 0.6, adiabatic = true }
    [[surfaces]]
    name = "plate"
    material = "plate"
    quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }
    [[surfaces]]
    name = "box"
    material = "hot"
    box = { origin = [0, 0, 1e-4], size = [1, 1, 1], open = ["bottom"] }
"#;

fn heat(text: &str) -> Heat {
    Heat::of(&typed(text), &HeatOptions::default(), &Work::alone()).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn backs_under_a_box_that_stands_on_nothing_have_no_level() {
    let heat = heat(FOOT);
    for name in ["plate", "box-top:back", "box-left:back"] {
        let own = of(&heat, name);
        assert!(own.temperature.is_nan() && own.temperature_error.is_nan(), "{own:?}");
        assert_eq!((own.flow, own.flow_error), (0.0, 0.0));
    }
    // Outside nothing sees anything.
    let flow = 0.8 * level(400.0);
    assert_close(of(&heat, "box-top").flow, flow, 1e-12);
    assert_close(heat.lost, 5.0 * flow, 1e-12);
    let called = &heat.without_level;
    assert!(called.contains(&"\"plate\"".to_owned()), "{called:?}");
    assert!(called.contains(&"the back of \"box-top\"".to_owned()) && called.len() == 6, "{called:?}");
    assert!(heat.usual_backs(&typed(FOOT)).is_empty());
}

#[test]
fn heat_that_is_given_where_nothing_sets_a_level_is_refused_by_the_names_that_were_typed() {
    let given = FOOT.replace("adiabatic = true", "heat_flux = 5");
    let error =
        Heat::of(&typed(&given), &HeatOptions::default(), &Work::alone()).expect_err("it has no level");
    let told = error.to_string();
    assert!(told.contains("\"plate\", the back of \"box-") && !told.contains(":back"), "{told}");
}

#[test]
fn an_adiabatic_box_beside_a_plate_leaves_its_heat_as_it_is() {
    let text = r#"
        materials.hot = { emissivity = 0.8, temperature = 400 }
        materials.brick = { emissivity = 0.5, adiabatic = true }
        [[surfaces]]
        name = "plate"
        material = "hot"
        quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }
        [[surfaces]]
        name = "cell"
        material = "brick"
        box = { origin = [0, 0, -5], size = [1, 1, 1], inward = true }
        [[surfaces]]
        name = "foil"
        material = "brick"
        two_sided = true
        quad = { vertices = [[0.2,0.2,-4.5],[0.8,0.2,-4.5],[0.8,0.8,-4.5],[0.2,0.8,-4.5]] }
    "#;
    let heat = heat(text);
    assert_close(of(&heat, "plate").flow, 0.8 * level(400.0), 1e-12);
    for name in ["cell-top", "cell-left", "foil", "foil:back"] {
        assert!(of(&heat, name).temperature.is_nan(), "{name}");
    }
    let referee = HeatReferee::of(&typed(text)).unwrap_or_else(|fault| panic!("{fault}"));
    let found = referee.estimates(&[0, 1, 7], &Effort::of_walks(1024.0), &Work::alone());
    assert!(found[1].level.value.is_nan() && found[2].level.value.is_nan(), "{found:?}");
    assert_close(found[0].flow.value, 0.8 * level(400.0), 1e-12);
}
