//! Transfers that are kept: balances of other temperatures, fluxes and emissivities are those of the scenes alone.

use std::sync::Mutex;

use radiosity::Work;
use radiosity::audit::Effort;
use radiosity::heat::{Heat, HeatError, HeatModel, HeatOptions, SurfaceHeat};
use radiosity::request::{CheckRequest, HeatSweep, SweptHeat};
use radiosity::scene::{FaultKind, HeatSetting, Scene};
use radiosity::solve::{Failure, Options};
use radiosity::work::{Progress, Stage};
use radiosity_test_support::compare::assert_close;
use radiosity_test_support::scenes::{NEAR_PLATES, builtin, typed};

use super::shared::{CUBE, level, of};

fn with(scene: &Scene, setting: &str, value: f64) -> Scene {
    let setting = HeatSetting::named(setting).unwrap_or_else(|fault| panic!("{fault}"));
    scene.with_heat(&setting, value).unwrap_or_else(|error| panic!("{error}"))
}

fn kept(scene: &Scene, options: &Options) -> HeatModel {
    HeatModel::of(scene, options, &Work::alone()).unwrap_or_else(|error| panic!("{error}")).0
}

fn balance(model: &mut HeatModel, scene: &Scene) -> Heat {
    model.balance(scene, &Work::alone()).unwrap_or_else(|error| panic!("{error}"))
}

/// A sphere in another, whose view factors follow from sums: Q = A₁ σ (T₁⁴ − T₂⁴) / (1/ε₁ + (A₁/A₂) (1/ε₂ − 1)).
#[test]
fn spheres_of_any_heat_come_from_one_model() {
    let scene = typed(
        r#"
        materials.hot = { emissivity = 0.8, temperature = 500 }
        materials.cold = { emissivity = 0.2, temperature = 300 }
        [[surfaces]]
        name = "inner"
        material = "hot"
        sphere = { center = [0, 0, 0], radius = 1 }
        [[surfaces]]
        name = "outer"
        material = "cold"
        flip = true
        sphere = { center = [0, 0, 0], radius = 2 }
        "#,
    );
    let usual = HeatOptions::default().options;
    let mut model = kept(&scene, &Options { order: 0, eps: 1e-3, shadow_eps: 1e-3, ..usual });
    let area = 4.0 * std::f64::consts::PI;
    let flow = |one: f64, other: f64, hot: f64| {
        area * (level(hot) - level(300.0)) / (1.0 / one + 0.25 * (1.0 / other - 1.0))
    };
    for own in [0.01, 0.3, 0.77, 1.0] {
        let found = balance(&mut model, &with(&scene, "outer.emissivity", own));
        assert_close(of(&found, "inner").flow, flow(0.8, own, 500.0), 1e-10);
        let found = balance(&mut model, &with(&scene, "hot.emissivity", own));
        assert_close(of(&found, "inner").flow, flow(own, 0.2, 500.0), 1e-10);
    }
    for kelvin in [10.0, 299.0, 5000.0] {
        let found = balance(&mut model, &with(&scene, "inner.temperature", kelvin));
        assert_close(of(&found, "outer").flow, -flow(0.8, 0.2, kelvin), 1e-10);
    }
    let given = flow(0.8, 0.2, 450.0);
    let found = balance(&mut model, &with(&scene, "hot.heat_flux", given / area));
    assert_close(of(&found, "inner").temperature, 450.0, 1e-10);
}

/// Figures of a surface, and by how much they may be off.
fn figures(own: &SurfaceHeat) -> [f64; 4] {
    [own.temperature, own.flow, own.temperature_error, own.flow_error]
}

/// Rules do not depend on what surfaces reflect, and all elements of the oven are cut once more.
#[test]
fn a_kept_oven_tells_what_it_tells_alone_with_the_same_errors() {
    let oven = builtin("oven");
    let options = HeatOptions::default();
    let mut model = kept(&oven, &options.options);
    let changes = [
        ("brick.emissivity", 0.2),
        ("panel.temperature", 1700.0),
        ("slab.heat_flux", -3e4),
        ("wall-*.heat_flux", 50.0),
    ];
    for (setting, value) in changes {
        let scene = with(&oven, setting, value);
        let alone = Heat::of(&scene, &options, &Work::alone()).unwrap_or_else(|error| panic!("{error}"));
        let found = balance(&mut model, &scene);
        assert!(alone.is_cut && found.is_cut);
        assert_eq!(
            found.outcome.checks.spectral_bound, 0.0,
            "it is not told of heat, and takes longer than all else"
        );
        let largest = alone.surfaces.iter().map(|own| own.flow.abs()).fold(0.0, f64::max);
        for (own, other) in found.surfaces.iter().zip(&alone.surfaces) {
            for (figure, expected) in figures(own).into_iter().zip(figures(other)) {
                let room = 1e-9 * expected.abs().max(largest);
                assert!((figure - expected).abs() <= room, "{setting}: {own:?} for {other:?}");
            }
        }
    }
}

/// Light is linear in levels, and between two emissivities follows from that of few cases: most balances of a sweep
/// take no iteration of the solver, and each is the one of its scene alone.
#[test]
fn balances_of_a_sweep_follow_from_few_of_them() {
    let oven = builtin("oven");
    let options = HeatOptions::default();
    for (text, solved) in [("panel.temperature=300..1400/9", 1), ("brick.emissivity=0.3..0.9/9", 6)] {
        let sweep: HeatSweep = text.parse().expect(text);
        let mut model = kept(&oven, &options.options);
        let heats: Vec<Heat> = [0, 8, 4, 2, 6, 1, 3, 5, 7]
            .map(|point| {
                balance(&mut model, &with(&oven, &sweep.setting().to_string(), sweep.values()[point]))
            })
            .into();
        let iterated = heats.iter().filter(|own| own.outcome.iterations > 0).count();
        assert!(iterated <= solved, "{text}: {iterated}");
        for (point, found) in [(1, &heats[5]), (4, &heats[2]), (7, &heats[8])] {
            assert!(found.outcome.residual < 1e-12, "{text}: {}", found.outcome.residual);
            let scene = with(&oven, &sweep.setting().to_string(), sweep.values()[point]);
            let alone = Heat::of(&scene, &options, &Work::alone()).unwrap_or_else(|error| panic!("{error}"));
            let largest = alone.surfaces.iter().map(|own| own.flow.abs()).fold(0.0, f64::max);
            for (own, other) in found.surfaces.iter().zip(&alone.surfaces) {
                assert!((own.flow - other.flow).abs() <= 1e-12 * largest, "{text}: {own:?} for {other:?}");
                assert_close(own.temperature, other.temperature, 1e-12);
            }
        }
    }
}

/// Even fluxes on whole surfaces, which tell too little of near plates.
fn even_on_whole_surfaces() -> Options {
    Options { order: 0, subdivide: Some(1), ..HeatOptions::default().options }
}

#[test]
fn a_check_of_one_balance_makes_the_errors_of_others_as_many_times_larger() {
    let plates = typed(NEAR_PLATES);
    let options = even_on_whole_surfaces();
    let (mut model, mut first) =
        HeatModel::of(&plates, &options, &Work::alone()).unwrap_or_else(|error| panic!("{error}"));
    let before = first.surfaces.clone();
    let surfaces = first.to_check(&plates, 8);
    let effort = Effort::of_walks(100_000.0);
    first.check(&plates, &surfaces, &effort, &Work::alone()).unwrap_or_else(|fault| panic!("{fault}"));
    let hotter = with(&plates, "body.temperature", 350.0);
    let [plain, mut found] = [0, 1].map(|_| balance(&mut model, &hotter));
    first.check_others(&mut found.surfaces);
    let mut has_grown = false;
    for (surface, own) in found.surfaces.iter().enumerate() {
        let growth = first.surfaces[surface].flow_error / before[surface].flow_error;
        has_grown |= growth > 1.0;
        assert_close(own.flow_error, growth * plain.surfaces[surface].flow_error, 1e-12);
    }
    assert!(has_grown, "even fluxes are off by more than they tell: {:?}", first.checked);
}

/// Where all has one temperature nothing flows, and no error can be seen; elsewhere in the sweep even fluxes of the
/// plates are nearly a tenth too large.
#[test]
fn a_sweep_is_checked_where_most_flows() {
    let plates = typed(NEAR_PLATES);
    let options = even_on_whole_surfaces();
    let check = CheckRequest { audit: "0.5".parse().ok(), ..CheckRequest::default() };
    for (text, expected) in [
        ("foil.temperature=293.15..143/3", 2),
        ("body.temperature=143..293.15/2", 1),
        ("body.emissivity=1e-6..0.8/2", 1),
    ] {
        let sweep: HeatSweep = text.parse().expect(text);
        let last = Mutex::new([0; 2]);
        let observe = |progress| {
            if let Progress::Done { stage: Stage::Runs, done, of } = progress {
                *last.lock().expect("nobody panics") = [done, of];
            }
        };
        let swept: SweptHeat<Heat> = sweep
            .balances(&plates, &options, &check, &Work::alone().observed_by(&observe))
            .unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(
            *last.lock().expect("nobody panicked"),
            [sweep.values().len(); 2],
            "all are made in the end"
        );
        assert_eq!(swept.point, expected, "{text}");
        let checked = swept.largest.checked.as_ref().expect("it was checked");
        assert!(checked.finds_more(), "{text}: {checked}");
        let balances = swept.into_balances();
        assert_eq!(balances.len(), sweep.values().len());
        for (point, own) in balances.iter().enumerate() {
            assert_eq!(own.checked.is_some(), point == expected, "{text}: one alone is checked");
        }
    }
}

/// The ends of a range are values of a sweep.
#[test]
fn sweeps_are_read_or_told_with_what_is_expected() {
    let sweep: HeatSweep = "a.b.emissivity=0.9..0.3/3".parse().expect("it is a sweep");
    assert_eq!(sweep.setting().to_string(), "a.b.emissivity");
    assert_eq!((sweep.values()[0], sweep.values()[2]), (0.9, 0.3));
    assert_eq!(sweep.values()[1], 0.6);
    let sweep: HeatSweep = "a.temperature=-1e2..3e2/2".parse().expect("it is a sweep");
    assert_eq!(sweep.values(), [-100.0, 300.0]);
    for text in ["a", "a.emissivity", "a.emissivity=1..2", "a.emissivity=1/3", "a.emissivity=x..2/3"] {
        let told = text.parse::<HeatSweep>().expect_err(text);
        assert!(told.contains("panel.emissivity=0.1..0.9/17"), "{told}");
    }
    for (text, expected) in [
        ("a.emissivity=0.1..0.9/5", vec![0.1, 0.3, 0.5, 0.7, 0.9]),
        ("a.heat_flux=-1..1/6", vec![-1.0, -0.6, -0.2, 0.2, 0.6, 1.0]),
        ("a.temperature=300..1400/4", vec![300.0, 300.0 + 1100.0 / 3.0, 300.0 + 2200.0 / 3.0, 1400.0]),
        ("a.emissivity=1e-6..0.9/3", vec![1e-6, 0.4500005, 0.9]),
        ("a.heat_flux=0..0/3", vec![0.0; 3]),
    ] {
        let sweep: HeatSweep = text.parse().expect(text);
        for (own, other) in sweep.values().iter().zip(&expected) {
            assert!((own - other).abs() <= f64::EPSILON * other.abs(), "{own} of {text}");
            assert!(own.to_string().len() > 15 || own == other, "{own} of {text}");
        }
        assert!(!text.contains("emissivity") || sweep.values() == expected, "{:?}", sweep.values());
    }
    let told = "a.temperature=300...500/2".parse::<HeatSweep>().expect_err("three points");
    assert!(told.contains("300..500") && told.contains("300..0.500"), "{told}");
    let told = "up=0.1..0.2/3".parse::<HeatSweep>().expect_err("there is no key");
    assert!(told.contains("up.KEY") && told.contains("emissivity"), "{told}");
    let told = "a.emissivity=0..1/1".parse::<HeatSweep>().expect_err("one point is no sweep");
    assert!(told.contains("from 2 to"), "{told}");
    let told = "a.emisivity=0..1/9".parse::<HeatSweep>().expect_err("the key is misspelt");
    assert!(told.contains("emisivity") && told.contains("did you mean"), "{told}");
}

#[test]
fn what_does_not_fit_the_scene_is_refused_with_a_cure() {
    let fault = |text: &str| HeatSetting::named(text).expect_err("it is no setting");
    assert_eq!(fault("brick.reflectance").kind, FaultKind::UnknownKey);
    assert!(fault("brick").cure().is_some_and(|cure| cure.contains("temperature, heat_flux, emissivity")));
    assert_eq!(fault("brick").kind, FaultKind::MissingKey);
    let cube = typed(CUBE);
    let refused = |setting: &str, value: f64| {
        let setting = HeatSetting::named(setting).unwrap_or_else(|fault| panic!("{fault}"));
        cube.with_heat(&setting, value).expect_err("it does not fit")
    };
    let unknown = refused("flor.temperature", 300.0);
    assert!(unknown.cure().is_some_and(|cure| cure.contains("did you mean \"floor\"?")), "{unknown}");
    assert!(
        refused("floor:back.temperature", 300.0).cure().is_some_and(|cure| cure.contains("back = … (K)"))
    );
    assert!(refused("floor.temperature", -20.0).cure().is_some_and(|cure| cure.contains("273.15")));
    assert_eq!(refused("brick.emissivity", 0.0).fault.kind, FaultKind::OutOfRange);
    let shared = typed(&CUBE.replace("name = \"floor\"", "name = \"brick\""));
    let setting = HeatSetting::named("brick.emissivity").unwrap_or_else(|fault| panic!("{fault}"));
    let both = shared.with_heat(&setting, 0.5).expect_err("other surfaces have that material");
    assert_eq!(both.fault.kind, FaultKind::Conflict);
    let mut model = kept(&cube, &HeatOptions::default().options);
    let other = model.balance(&builtin("oven"), &Work::alone()).expect_err("it is another scene");
    assert!(matches!(other, HeatError::Solve(Failure::OtherSurface { .. })), "{other}");
}
