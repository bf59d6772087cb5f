//! Every shape key of a scene file makes the surface it promises: area by closed form, place and front at the
//! middle of the parameters; moved, turned over, from TOML and from JSON. Wrong fields are refused where they
//! stand.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4, PI};

use radiosity::scene::{SceneError, SceneSurface, Source};
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::typed;

/// A shape as typed, and what it must be.
struct Case {
    shape: &'static str,
    area: f64,
    /// Point and unit normal at the middle of the parameters.
    middle: [f64; 3],
    front: [f64; 3],
}

fn case(shape: &'static str, area: f64, middle: [f64; 3], front: [f64; 3]) -> Case {
    let length = DVec3::from_array(front).length();
    Case { shape, area, middle, front: front.map(|x| x / length) }
}

fn cases() -> Vec<Case> {
    let mut cases = flat();
    cases.extend(turned());
    cases.extend(splines());
    cases
}

fn flat() -> Vec<Case> {
    // ∬ √(1 + x² + y²) over |x|, |y| ≤ 1, the area of z = xy.
    let saddle = 4.0 * (3.0_f64.sqrt() / 3.0 + 4.0 / 3.0 * 0.5_f64.sqrt().asinh() - PI / 18.0);
    let up = [0.0, 0.0, 1.0];
    vec![
        case(
            "parallelogram = { origin = [0,0,0], edge1 = [2,0,0], edge2 = [1,1,0], holes = [[[1,0.2,0],[2,0.2,0],[2,0.7,0]]] }",
            2.0 - 0.25,
            [1.5, 0.5, 0.0],
            up,
        ),
        case("quad = { vertices = [[-1,-1,1],[1,-1,-1],[1,1,1],[-1,1,-1]] }", saddle, [0.0; 3], up),
        case("triangle = { vertices = [[0,0,0],[1,0,0],[0,1,0]] }", 0.5, [0.5, 0.5, 0.0], up),
        case(
            "polygon = { vertices = [[0,0,0],[2,0,0],[2,2,0],[0,2,0]], holes = [[[0.5,0.5,0],[1,0.5,0],[1,1,0]]] }",
            4.0 - 0.125,
            [1.0, 1.0, 0.0],
            up,
        ),
    ]
}

fn turned() -> Vec<Case> {
    // The middle of a full turn is half way round, at −x.
    vec![
        case(
            "disk = { center = [0,0,1], normal = [0,0,2], radius = 2 }",
            4.0 * PI,
            [-1.0, 0.0, 1.0],
            [0.0, 0.0, 1.0],
        ),
        case(
            "disk = { center = [0,0,1], normal = [0,0,1], radius = 2, inner_radius = 1, angle = [0, 90] }",
            FRAC_PI_4 * 3.0,
            [1.5 * FRAC_1_SQRT_2, 1.5 * FRAC_1_SQRT_2, 1.0],
            [0.0, 0.0, 1.0],
        ),
        case(
            "cylinder = { base = [0,0,0], axis = [0,0,3], radius = 2 }",
            12.0 * PI,
            [-2.0, 0.0, 1.5],
            [-1.0, 0.0, 0.0],
        ),
        case(
            "cylinder = { base = [0,0,0], axis = [0,0,3], radius = 2, angle = [90, 180] }",
            3.0 * PI,
            [-2.0 * FRAC_1_SQRT_2, 2.0 * FRAC_1_SQRT_2, 1.5],
            [-1.0, 1.0, 0.0],
        ),
        case(
            "cone = { base = [0,0,0], axis = [0,0,4], radius1 = 3, radius2 = 0 }",
            15.0 * PI,
            [-1.5, 0.0, 2.0],
            [-4.0, 0.0, 3.0],
        ),
        case("sphere = { center = [1,0,0], radius = 2 }", 16.0 * PI, [-1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]),
        // About the x axis the angle 0 is at +y, and 90° at +z.
        case(
            "sphere = { center = [1,0,0], radius = 2, axis = [1,0,0], z = [-1, 1], angle = [0, 180] }",
            4.0 * PI,
            [1.0, 0.0, 2.0],
            [0.0, 0.0, 1.0],
        ),
        // Half way round the tube is its inner equator, which faces the axis.
        case(
            "torus = { center = [0,0,0], axis = [0,0,1], major = 3, minor = 1 }",
            12.0 * PI * PI,
            [-2.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
        ),
        case(
            "torus = { center = [0,0,0], axis = [0,0,1], major = 3, minor = 1, angle = [0, 180], tube_angle = [-90, 90] }",
            PI * (3.0 * PI + 2.0),
            [0.0, 4.0, 0.0],
            [0.0, 1.0, 0.0],
        ),
        // The paraboloid z = x² + y² up to z = 1.
        case(
            "revolution = { curve = [[0,0,0],[0.3333333333333333,0,0],[0.6666666666666667,0,0.3333333333333333],[1,0,1]], \
             center = [0,0,0], axis = [0,0,1] }",
            PI / 6.0 * (5.0 * 5.0_f64.sqrt() - 1.0),
            [-0.5, 0.0, 0.25],
            [-1.0, 0.0, -1.0],
        ),
    ]
}

fn splines() -> Vec<Case> {
    // The length of z = x² from 0 to 1.
    let parabola = 0.5 * 5.0_f64.sqrt() + 0.25 * 2.0_f64.asinh();
    vec![
        case(
            "bezier = { points = [\
             [[0,0,0],[0,1,0],[0,2,0],[0,3,0]], \
             [[0.3333333333333333,0,0],[0.3333333333333333,1,0],[0.3333333333333333,2,0],[0.3333333333333333,3,0]], \
             [[0.6666666666666667,0,0.3333333333333333],[0.6666666666666667,1,0.3333333333333333],\
              [0.6666666666666667,2,0.3333333333333333],[0.6666666666666667,3,0.3333333333333333]], \
             [[1,0,1],[1,1,1],[1,2,1],[1,3,1]]] }",
            3.0 * parabola,
            [0.5, 1.5, 0.25],
            [-1.0, 0.0, 1.0],
        ),
        // A quarter of the unit cylinder, one high: the rational quadratic arc raised to degree three.
        case(
            "rational = { points = [\
             [[1,0,0],[1,0,0.3333333333333333],[1,0,0.6666666666666667],[1,0,1]], \
             [[1,0.585786437626905,0],[1,0.585786437626905,0.3333333333333333],\
              [1,0.585786437626905,0.6666666666666667],[1,0.585786437626905,1]], \
             [[0.585786437626905,1,0],[0.585786437626905,1,0.3333333333333333],\
              [0.585786437626905,1,0.6666666666666667],[0.585786437626905,1,1]], \
             [[0,1,0],[0,1,0.3333333333333333],[0,1,0.6666666666666667],[0,1,1]]], \
             weights = [[1,1,1,1],[0.804737854124365,0.804737854124365,0.804737854124365,0.804737854124365],\
             [0.804737854124365,0.804737854124365,0.804737854124365,0.804737854124365],[1,1,1,1]] }",
            0.5 * PI,
            [FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.5],
            [1.0, 1.0, 0.0],
        ),
        case(
            "extrusion = { curve = [[0,0,0],[0.3333333333333333,0,0],[0.6666666666666667,0,0.3333333333333333],[1,0,1]], \
             direction = [0,2,0] }",
            2.0 * parabola,
            [0.5, 1.0, 0.25],
            [-1.0, 0.0, 1.0],
        ),
    ]
}

/// Two patches over the unit square, one beside the other, and their common points.
const PATCHES: &str = "patches = { points = [\
    [0,0,0],[0,1,0],[0,2,0],[0,3,0],[1,0,0],[1,1,0],[1,2,0],[1,3,0],[2,0,0],[2,1,0],[2,2,0],[2,3,0],[3,0,0],[3,1,0],[3,2,0],[3,3,0],\
    [4,0,0],[4,1,0],[4,2,0],[4,3,0],[5,0,0],[5,1,0],[5,2,0],[5,3,0],[6,0,0],[6,1,0],[6,2,0],[6,3,0]], \
    patches = [[0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15], [12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27]] }";

fn toml(options: &str, shape: &str) -> String {
    format!("[[surfaces]]\n{options}\n{shape}\n")
}

#[track_caller]
fn surfaces(options: &str, shape: &str) -> Vec<SceneSurface> {
    typed(&toml(options, shape)).surfaces
}

#[track_caller]
fn assert_is(surface: &SceneSurface, case: &Case, area: f64, middle: DVec3, front: DVec3) {
    let found = surface.shape.area();
    assert!((found - area).abs() < 1e-12 * area, "area {found} instead of {area}: {}", case.shape);
    let jet = surface.shape.jet(0.0, 0.0);
    assert!(jet.position.distance(middle) < 1e-14 * (1.0 + middle.length()), "{jet:?}: {}", case.shape);
    assert!(jet.normal.distance(front) < 1e-14, "{jet:?}: {}", case.shape);
}

#[test]
fn every_key_makes_its_surface() {
    for case in cases() {
        let [surface] = &surfaces("", case.shape)[..] else { panic!("one surface: {}", case.shape) };
        assert_eq!(surface.kind, case.shape.split(' ').next().unwrap());
        assert_is(surface, &case, case.area, case.middle.into(), case.front.into());
    }
}

#[test]
fn every_shape_can_be_scaled_turned_and_moved() {
    let options = "transform = { scale = 2, rotate = [0, 0, 3, 90], translate = [0, 0, 5] }";
    let quarter = |x: DVec3| DVec3::new(-x.y, x.x, x.z);
    for case in cases() {
        let surface = &surfaces(options, case.shape)[0];
        let middle = 2.0 * quarter(case.middle.into()) + 5.0 * DVec3::Z;
        assert_is(surface, &case, 4.0 * case.area, middle, quarter(case.front.into()));
    }
}

#[test]
fn every_shape_can_be_turned_over_and_have_two_sides() {
    for case in cases() {
        let [front, back] = &surfaces("name = \"s\"\nflip = true\ntwo_sided = true", case.shape)[..] else {
            panic!("two sides: {}", case.shape)
        };
        assert_eq!((front.name.as_str(), back.name.as_str()), ("s", "s:back"));
        let normal = DVec3::from_array(case.front);
        assert_is(front, &case, case.area, case.middle.into(), -normal);
        assert_is(back, &case, case.area, case.middle.into(), normal);
    }
}

#[test]
fn json_says_the_same() {
    for case in cases() {
        let text = toml("", case.shape);
        let tree: toml::Value = toml::from_str(&text).unwrap();
        let json = serde_json::to_string(&tree).unwrap();
        let (a, b) = (typed(&text), radiosity::language::read(&Source::new("", &json)).unwrap());
        let [a, b] = [a, b].map(|scene| scene.surfaces[0].shape.jet(0.3, -0.6));
        assert_eq!(a, b, "{}", case.shape);
    }
}

#[test]
fn patches_become_numbered_surfaces() {
    let options = "name = \"pot\"\ntwo_sided = true\norder = 5\nsubdivide = [3, 2]";
    let found = surfaces(options, PATCHES);
    let names: Vec<&str> = found.iter().map(|surface| surface.name.as_str()).collect();
    assert_eq!(names, ["pot-0", "pot-0:back", "pot-1", "pot-1:back"]);
    for (k, surface) in found.iter().enumerate() {
        assert_eq!((surface.order, surface.subdivide), (Some(5), Some([3, 2])));
        assert!((surface.shape.area() - 9.0).abs() < 1e-13);
        let jet = surface.shape.jet(0.0, 0.0);
        assert!(jet.position.distance(DVec3::new([1.5, 4.5][k / 2], 1.5, 0.0)) < 1e-14);
        assert_eq!(jet.normal, [DVec3::Z, -DVec3::Z][k % 2]);
    }
    let found = surfaces("", PATCHES);
    assert_eq!([&found[0].name, &found[1].name], ["surface-1-0", "surface-1-1"]);
}

#[test]
fn numbered_names_are_unique_too() {
    let text =
        format!("{}\n[[surfaces]]\nname = \"pot-1\"\n{}", toml("name = \"pot\"", PATCHES), flat()[0].shape);
    let error = radiosity::language::read(&Source::new("case", &text)).unwrap_err();
    assert_eq!(error.fault.to_string(), "the name \"pot-1\" is given twice");
    assert_eq!(error.cure().as_deref(), Some("rename this one or the first, which stands on line 2"));
}

/// The error of a surface whose shape is wrong, and the text its place underlines.
#[track_caller]
fn refused(shape: &str) -> (SceneError, String) {
    let error = radiosity::language::read(&Source::new("case", &toml("", shape))).map(|_| shape).unwrap_err();
    let place = error.place.as_ref().expect("shapes have a place");
    assert_eq!(error.owner.as_deref(), Some("surface \"surface-1\""));
    let meant = place.text.chars().skip(place.column - 1).take(place.width).collect();
    (error, meant)
}

/// Case `k` with `old` replaced by `new` is refused at `at`, saying `message`.
#[track_caller]
fn refused_at(cases: &[Case], k: usize, old: &str, new: &str, at: &str, message: &str) {
    let shape = cases[k].shape;
    assert!(shape.contains(old), "{old:?} is not in {shape}");
    let (error, meant) = refused(&shape.replacen(old, new, 1));
    assert_eq!(meant, at, "{error}");
    assert!(error.fault.to_string().contains(message), "{error}");
}

#[test]
fn wrong_fields_of_turned_shapes_are_refused_where_they_stand() {
    let turned = turned();
    let at = |k, old, new, at, message| refused_at(&turned, k, old, new, at, message);
    at(0, "normal = [0,0,2], ", "", "{ center = [0,0,1], radius = 2 }", "the key \"normal\" is missing");
    at(0, "radius = 2", "radius = -2", "-2", "`radius` is -2; it must be greater than zero");
    at(0, "[0,0,2]", "[0,0,0]", "[0,0,0]", "`normal` has no length");
    at(1, "inner_radius = 1", "inner_radius = 2", "2", "`inner_radius` (2) must be less than `radius` (2)");
    at(1, "[0, 90]", "[90, 90]", "[90, 90]", "`angle` (90) must be less than its second number (90)");
    at(1, "[0, 90]", "[0, 361]", "[0, 361]", "`angle` = [0, 361] leaves [0, 360]");
    at(1, "[0, 90]", "90", "90", "expected a list, found a number");
    at(2, "[0,0,3]", "[0,0,0]", "[0,0,0]", "`axis` has no length");
    at(4, "radius1 = 3", "radius1 = 0", "0", "`radius1` is 0; it must be greater than zero");
    at(4, "radius2 = 0", "radius2 = -1", "-1", "`radius2` is -1; it must not be negative");
    at(6, "[-1, 1]", "[-1, 3]", "[-1, 3]", "`z` = [-1, 3] leaves [-2, 2]");
    at(6, "[-1, 1]", "[1]", "[1]", "z takes 2 heights, lowest first, found 1");
    at(7, "minor = 1", "minor = 3", "3", "`minor` (3) must be less than `major` (3)");
    at(8, "[-90, 90]", "[-900, 90]", "[-900, 90]", "`tube_angle` = [-900, 90] leaves [-900, -540]");
    let curve = "[[0,0,0],[0.3333333333333333,0,0],[-2,0,0.3333333333333333],[1,0,1]]";
    at(9, "[0.6666666666666667,", "[-2,", curve, "`curve` crosses the axis");
}

#[test]
fn wrong_fields_of_splines_are_refused_where_they_stand() {
    let splines = splines();
    let at = |k, old, new, at, message| refused_at(&splines, k, old, new, at, message);
    at(0, ",[0,3,0]", "", "[[0,0,0],[0,1,0],[0,2,0]]", "a row takes 4 control points, found 3");
    at(0, "points", "point", "point", "unknown key \"point\"");
    let weights = "[[0,1,1,1],[0.80";
    let (error, meant) = refused(&splines[1].shape.replace("[[1,1,1,1],[0.80", weights));
    assert!(meant.starts_with(weights) && error.to_string().contains("`weights` is 0"), "{error}");
    at(2, "[0,2,0]", "[0,0,0]", "[0,0,0]", "`direction` has no length");
    at(
        2,
        "[1,0,1]]",
        "[1,0,1],[2,0,2]]",
        "[[0,0,0],[0.3333333333333333,0,0],[0.6666666666666667,0,0.3333333333333333],[1,0,1],[2,0,2]]",
        "a curve takes 4 control points, found 5",
    );
}

#[test]
fn wrong_patches_are_refused_where_they_stand() {
    let (error, meant) = refused(&PATCHES.replace("26,27]", "26,28]"));
    assert_eq!(
        (error.fault.to_string().as_str(), meant.as_str()),
        ("there is no point 28: the list has 28", "28")
    );
    let (error, meant) = refused(&PATCHES.replace("26,27]", "26]"));
    assert!(
        meant.starts_with("[12,13") && error.to_string().contains("16 indices of points, found 15"),
        "{error}"
    );
    let (error, meant) = refused(&PATCHES.replace("26,27]", "26,-1]"));
    assert_eq!((error.fault.to_string().as_str(), meant.as_str()), ("-1 is not a whole number", "-1"));
    let flat = "[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]";
    let (error, meant) = refused(&PATCHES.replace("[0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15]", flat));
    assert!(meant == flat && error.to_string().contains("`patches[0]` spans no area"), "{error}");
    let (error, meant) = refused("patches = { points = [[0,0,0]], patches = [] }");
    assert!(meant == "[]" && error.to_string().contains("takes at least one patch, found 0"), "{error}");
}
