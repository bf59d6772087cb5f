//! Variables: formulas in place of numbers, set from outside, and the faults of both.

use radiosity::reading::files::solution_file::{SolutionFile, read};
use radiosity::scene::{FaultKind, Scene, SceneError, Source};
use radiosity::solve::Options;
use radiosity_test_support::scenes::{parsed, typed};
use radiosity_test_support::solved::solved_of;

const ROOM: &str = r#"title = "= a room ="
[variables]
width = 4
half = "=width/2"
lamps = 2
[camera]
eye = ["=half", "=-width", 1.5]
target = ["=half", 0, 1]
[materials.white]
reflectance = "=0.25 + 1/4"
[[surfaces]]
name = "=floor"
material = "white"
order = "=lamps"
parallelogram = { origin = [0, 0, 0], edge1 = ["=width", 0, 0], edge2 = [0, "=half + 0.5", 0] }
[[surfaces]]
name = "lamp"
material = "white"
flux = "=100 * lamps"
group = "ceiling"
disk = { center = ["=half", "=half", 2.5], normal = [0, 0, -1], radius = "=sqrt(half) / 10" }
"#;

fn area(scene: &Scene) -> f64 {
    scene.surfaces[0].shape.area()
}

#[test]
fn formulas_stand_for_numbers() {
    let json = serde_json::to_string(&toml::from_str::<toml::Value>(ROOM).unwrap()).unwrap();
    for scene in [typed(ROOM), radiosity::language::read(&Source::new("room", &json)).unwrap()] {
        assert_eq!(scene.title.as_deref(), Some("= a room ="), "a text stays one");
        assert_eq!(scene.surfaces[0].name, "=floor");
        assert_eq!(scene.surfaces[0].order, Some(2));
        assert_eq!(scene.surfaces[0].material.reflectance, [0.5]);
        assert!((area(&scene) - 10.0).abs() < 1e-12);
        assert_eq!(scene.camera.as_ref().unwrap().eye.to_array(), [2.0, -4.0, 1.5]);
        assert!((scene.surfaces[1].flux.as_ref().unwrap()[0] - 200.0).abs() < 1e-9);
        let value = |name: &str| scene.variables.iter().find(|(own, _)| own == name).unwrap().1;
        assert_eq!(["width", "half", "lamps"].map(value), [4.0, 2.0, 2.0]);
    }
}

#[test]
fn a_formula_of_many_variables_that_stand_below_it_is_read_at_once() {
    const COUNT: usize = 20_000;
    let names: Vec<String> = (0..COUNT).map(|k| format!("a{k}")).collect();
    let sum = format!("[variables]\nwidth = \"={}\"\n", names.join("+"));
    // Each is a half of the next one's double.
    let parts: Vec<String> = (0..COUNT)
        .map(|k| match k + 1 < COUNT {
            true => format!("a{k} = \"=a{} / 2 * 2\"\n", k + 1),
            false => format!("a{k} = 0.5\n"),
        })
        .collect();
    let text = ROOM.replace("[variables]\nwidth = 4\n", &(sum + &parts.concat()));
    let scene = typed(&text);
    let width = scene.variables.iter().find(|(name, _)| name == "width").unwrap().1;
    assert_eq!(width, 0.5 * COUNT as f64);
}

#[test]
fn variables_are_set_from_outside() {
    let source = || Source::new("room.toml", ROOM);
    let scene = parsed(&source().set([("width", 6.0)]));
    assert!((area(&scene) - 6.0 * 3.5).abs() < 1e-12, "what is made of it changes with it");
    let scene = parsed(&source().set([("half", 1.0), ("half", 7.0)]));
    assert!((area(&scene) - 4.0 * 7.5).abs() < 1e-12, "the last one counts");
    let scene = radiosity::language::read_with(&source(), &[("width", 6.0), ("ceiling", 0.5)]).unwrap();
    assert!((area(&scene) - 6.0 * 3.5).abs() < 1e-12);
    assert_eq!(scene.surfaces[1].factor(), 0.5);
    let fault = |settings: &[(&str, f64)]| radiosity::language::read_with(&source(), settings).unwrap_err();
    let error = fault(&[("widht", 1.0)]);
    assert!(
        error.to_string().starts_with("room.toml: there is no variable or light group \"widht\""),
        "{error}"
    );
    let cure = "did you mean \"width\"? variables of this scene: width, half, lamps; light groups: ceiling";
    assert_eq!(error.cure().as_deref(), Some(cure));
    assert_eq!(fault(&[("width", f64::NAN)]).fault.kind, FaultKind::NotFinite);
    assert_eq!(fault(&[("ceiling", -1.0)]).fault.kind, FaultKind::OutOfRange);
    let both = Source::new("room.toml", &ROOM.replace("\"ceiling\"", "\"lamps\""));
    let error = radiosity::language::read_with(&both, &[("lamps", 1.0)]).unwrap_err();
    assert!(error.to_string().contains("a variable and a light group are both called \"lamps\""), "{error}");
    assert!(radiosity::language::read(&both).is_ok(), "only a setting could mean either");
    let error = radiosity::language::read(&source().set([("ceiling", 1.0)])).unwrap_err();
    let known = "variables of this scene: width, half, lamps";
    assert!(error.cure().is_some_and(|cure| cure.ends_with(known)), "{:?}", error.cure());
}

#[test]
fn a_solution_keeps_what_was_set() {
    let source = Source::new("room.toml", ROOM);
    let scene = radiosity::language::read_with(&source, &[("width", 6.0), ("ceiling", 0.5)]).unwrap();
    let solved = solved_of(scene, Options { eps: 0.3, ..Options::default() });
    let text = serde_json::to_string(&SolutionFile::new(&solved)).unwrap();
    let again = read(&Source::new("a.json", &text)).unwrap();
    assert!((area(&again.scene) - 6.0 * 3.5).abs() < 1e-12);
    assert_eq!(again.scene.surfaces[1].factor(), 0.5);
    assert_eq!(serde_json::to_string(&SolutionFile::new(&again)).unwrap(), text);
    let error = again.scene.dimmed(&[("width", 5.0)]).unwrap_err();
    assert!(
        error.to_string().contains("\"width\" is a variable, which is set when the scene is read"),
        "{error}"
    );
    assert!(error.cure().unwrap_or_default().contains("--set width="));
}

#[test]
fn long_chains_of_variables_are_followed() {
    let count = 20_000;
    let chain: String = (0..count).map(|k| format!("v{k} = \"=v{} + 1\"\n", k + 1)).collect();
    let text = format!("{}{chain}v{count} = 0\n[camera]", ROOM.split_once("width").unwrap().0);
    let rest = ROOM.split_once("[camera]").unwrap().1;
    let text = text + &rest.replace("=half", "=v0").replace("width", "v0").replace("=lamps", "=v19998");
    let text = text.replace("* lamps", "* 2").replace("sqrt(half)", "v1");
    let scene = typed(&text);
    assert_eq!(scene.variables[0], ("v0".to_owned(), f64::from(count)));
}

fn refused(old: &str, new: &str) -> SceneError {
    assert!(ROOM.contains(old), "{old}");
    radiosity::language::read(&Source::new("room.toml", &ROOM.replacen(old, new, 1))).expect_err(new)
}

#[test]
fn faults_of_formulas_are_placed_within_them() {
    for (old, new, message, cure) in [
        (
            "=half + 0.5",
            "=halve + 0.5",
            "room.toml:15:79: surface \"=floor\": there is no variable \"halve\"",
            "did you mean \"half\"? variables of this scene: width, half, lamps",
        ),
        (
            "=width/2",
            "=2*(width",
            "room.toml:4:18: variable \"half\": the formula cannot be read: a closing",
            "such as",
        ),
        (
            "=width/2",
            "=1/(width-4)",
            "room.toml:4:11: variable \"half\": the formula divides by zero",
            "change the",
        ),
        (
            "=width/2",
            "=half",
            "room.toml:4:8: variable \"half\": it needs its own value: half → half",
            "give one of",
        ),
        (
            "width = 4",
            "width = \"=depth\"\ndepth = \"=half + lamps\"",
            "room.toml:5:8: variable \"width\": it needs its own value: width → depth → half → width",
            "give one of them a number",
        ),
        ("=width/2", "=x", "variable \"half\": there is no variable \"x\"", "variables of this scene: width"),
        (
            "=width/2",
            "",
            "room.toml:4:8: variable \"half\": expected a number, found a text",
            "without quotes",
        ),
        (
            "=width/2",
            "=2*1e30",
            "room.toml:4:8: variable \"half\": the number is 2e30, outside",
            "choose a value",
        ),
        ("=width/2", "=1e300*1e300", "inf is not a finite number", "finite"),
        ("=lamps", "=lamps/4", "room.toml:14:9: surface \"=floor\": 0.5 is not a whole number", "give 0, 1"),
        (
            "=sqrt(half)",
            "=sqr(half)",
            "there is no function \"sqr\"",
            "did you mean \"sqrt\"? functions: sin",
        ),
        ("width = 4", "\"wi-dth\" = 4", "room.toml:3:1: \"wi-dth\" is not a word of letters", "another name"),
        ("width = 4", "pi = 4", "room.toml:3:1: \"pi\" means something else in formulas", "another name"),
        ("width = 4", "width = [4]", "variable \"width\": expected a number, found a list", "without quotes"),
        ("[variables]", "variables = 3\n[other]", "expected a table, found a number", ""),
        ("name = \"lamp\"", "name = 3", "expected a text in quotes", "in quotes"),
    ] {
        let error = refused(old, new);
        assert!(error.to_string().contains(message), "{new}: {error}");
        assert!(error.cure().unwrap_or_default().contains(cure), "{new}: {:?}", error.cure());
    }
    // Escapes make a text longer than it reads: then all of it is meant.
    let error = refused("\"=width/2\"", "\"\\u003dx\"");
    assert!(
        error.to_string().starts_with("room.toml:4:8: variable \"half\": there is no variable"),
        "{error}"
    );
    let bare =
        radiosity::language::read(&Source::new("a.toml", "camera = { eye = [\"=n\", 0, 0] }")).unwrap_err();
    assert_eq!(bare.cure().as_deref(), Some("define it: [variables] with n = 2.5"));
}
