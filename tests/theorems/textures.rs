//! Patterns of materials: how cells and polynomials lie on surfaces, their means and ranges, and what is
//! refused.

use proptest::prelude::*;
use radiosity::scene::{Pattern, Placement, Polynomial, Scene, Source, Term, Wrap};
use radiosity_test_support::scenes::{parsed, typed};

/// A scene with a floor of this material, and a lamp.
pub(crate) fn room(material: &str) -> String {
    format!(
        r#"
camera = {{ eye = [1, -3, 2], target = [1, 1, 0] }}
[materials.lamp]
reflectance = 0
emission = 10
[materials.floor]
{material}
[[surfaces]]
name = "floor"
material = "floor"
parallelogram = {{ origin = [0, 0, 0], edge1 = [2, 0, 0], edge2 = [0, 2, 0] }}
[[surfaces]]
name = "lamp"
material = "lamp"
disk = {{ center = [1, 1, 1], normal = [0, 0, -1], radius = 0.2 }}
"#
    )
}

pub(crate) fn reflectance(scene: &Scene) -> &Pattern {
    let floor = scene.surface_named("floor").expect("it is there");
    scene.surfaces[floor].material.reflectance_pattern.as_deref().expect("it varies")
}

pub(crate) const CORNERS: [[f64; 2]; 4] = [[-0.5, 0.5], [0.5, 0.5], [-0.5, -0.5], [0.5, -0.5]];

#[test]
fn cells_are_typed_as_one_reads_a_picture() {
    let scene = typed(&room("reflectance = { cells = [[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]] }"));
    let at = |u: f64, v: f64| reflectance(&scene).at(0, [u, v]);
    assert_eq!([-0.8, 0.0, 0.8].map(|u| at(u, 0.5)), [0.1, 0.2, 0.3]);
    assert_eq!([-0.8, 0.0, 0.8].map(|u| at(u, -0.5)), [0.4, 0.5, 0.6]);
    let scene = typed(&room("reflectance = { cells = [[[0.1]], [[0.2]], [[0.3]]], factor = [1, 2, 3] }"));
    assert_eq!(scene.bands.len(), 3, "lists for each band make three");
    let found = [0, 1, 2].map(|band| reflectance(&scene).at(band, [0.0; 2]));
    assert_eq!(found, [0.1, 2.0 * 0.2, 3.0 * 0.3]);
}

#[test]
fn polynomials_are_sums_of_their_terms() {
    let scene = typed(&room(
        "reflectance = { polynomial = [[0, 0, 0.5], [1, 2, 0.25], [0, 1, -0.125]], factor = 0.5 }",
    ));
    for [u, v] in CORNERS {
        let expected = 0.5 * (0.5 + 0.25 * u * v * v - 0.125 * v);
        assert!((reflectance(&scene).at(0, [u, v]) - expected).abs() < 1e-15);
    }
    assert_eq!(reflectance(&scene).degree(), Some(3));
    assert_eq!(scene.surfaces[0].material.reflectance, [0.25]);
    let scene = typed(&room("reflectance = 0\nemission = { polynomial = [[[0, 0, 1]], [[2, 0, 3]], []] }"));
    assert_eq!(scene.surfaces[0].material.emission, [1.0, 1.0, 0.0]);
}

#[test]
fn numbers_of_patterns_may_be_formulas() {
    let text = format!(
        "{}\n[variables]\nwhite = 0.5\nodd = 1\n",
        room(
            r#"reflectance = { cells = [["=white", "=white/2"]], scale = ["=odd", 1], offset = [0, "=odd - 1"], factor = "=odd" }
emission = { polynomial = [["=odd", 0, "=white"], [0, 0, 1]] }"#
        )
    );
    let source = Source::new("room", &text);
    for (white, set) in [(0.5, &[][..]), (0.25, &[("white", 0.25)])] {
        let scene = parsed(&source.clone().set(set.iter().copied()));
        let material = &scene.surfaces[0].material;
        assert_eq!(reflectance(&scene).at(0, [-0.5, 0.0]), white);
        assert_eq!(reflectance(&scene).at(0, [0.5, 0.0]), white / 2.0);
        let emission = material.emission_pattern.as_deref().expect("it varies");
        assert_eq!(emission.at(0, [1.0, 0.0]), 1.0 + white);
    }
}

/// The place on a line of grids, 0 to 1 in the grid, by the definition of each wrap.
fn wrapped(s: f64, wrap: Wrap) -> f64 {
    match wrap {
        Wrap::Repeat => s - s.floor(),
        Wrap::Mirror => {
            let t = (s / 2.0 - (s / 2.0).floor()) * 2.0;
            if t < 1.0 { t } else { 2.0 - t }
        }
        Wrap::Clamp => s.clamp(0.0, 1.0),
    }
}

fn wraps() -> impl Strategy<Value = Wrap> {
    prop::sample::select(vec![Wrap::Repeat, Wrap::Mirror, Wrap::Clamp])
}

proptest! {
    #[test]
    fn grids_lie_as_their_placement_says(
        [columns, rows] in prop::array::uniform2(1usize..6),
        scale in prop::array::uniform2(0.1..5.0f64),
        offset in prop::array::uniform2(-3.0..3.0f64),
        wrap in wraps(),
        [u, v] in prop::array::uniform2(-1.0..1.0f64),
    ) {
        let values: Vec<f64> = (0..columns * rows).map(|k| k as f64).collect();
        let placement = Placement { offset, scale, wrap };
        let pattern = Pattern::texels(columns, vec![values.clone()], placement).unwrap();
        let place = |axis: usize, x: f64, count: usize| {
            wrapped(offset[axis] + scale[axis] * (x + 1.0) / 2.0, wrap) * count as f64
        };
        let (s, t) = (place(0, u, columns), place(1, v, rows));
        // On a border either side may be meant.
        prop_assume!([s, t].iter().all(|x| (x - x.round()).abs() > 1e-9 || wrap == Wrap::Clamp));
        let [i, j] = [(s, columns), (t, rows)].map(|(x, count)| (x as usize).min(count - 1));
        prop_assert_eq!(pattern.at(0, [u, v]), values[i + columns * j]);
    }

    #[test]
    fn between_breaks_nothing_changes_and_the_mean_is_that_of_the_pieces(
        columns in 1usize..5,
        values in prop::collection::vec(0.0..1.0f64, 4 * 3),
        scale in prop::array::uniform2(0.1..4.0f64),
        offset in prop::array::uniform2(-2.0..2.0f64),
        wrap in wraps(),
    ) {
        let values = values[..3 * columns].to_vec();
        let pattern = Pattern::texels(columns, vec![values], Placement { offset, scale, wrap }).unwrap();
        let pieces = pattern.breaks().map(|breaks| {
            let ends: Vec<f64> = [-1.0].into_iter().chain(breaks).chain([1.0]).collect();
            ends.windows(2).map(|ends| [ends[0], ends[1]]).collect::<Vec<_>>()
        });
        let mut mean = 0.0;
        for [u0, u1] in &pieces[0] {
            for [v0, v1] in &pieces[1] {
                let at = |a: f64, b: f64| pattern.at(0, [u0 + a * (u1 - u0), v0 + b * (v1 - v0)]);
                let middle = at(0.5, 0.5);
                for (a, b) in [(0.01, 0.01), (0.99, 0.01), (0.3, 0.99)] {
                    prop_assert_eq!(at(a, b), middle);
                }
                mean += 0.25 * (u1 - u0) * (v1 - v0) * middle;
            }
        }
        prop_assert!((pattern.mean(0) - mean).abs() < 1e-12);
    }
}

#[test]
fn ranges_of_polynomials_are_those_of_their_extremes() {
    let terms =
        |list: &[(u32, u32, f64)]| Polynomial::new(list.iter().map(|&(u, v, factor)| Term { u, v, factor }));
    // 3 u² − u⁴ − v: from −1 at u = 0, v = 1 to 3 at |u| = 1, v = −1.
    let pattern = Pattern::polynomial(vec![terms(&[(2, 0, 3.0), (4, 0, -1.0), (0, 1, -1.0)])]);
    let [least, most] = pattern.range(0);
    assert!((least + 1.0).abs() < 1e-7 && (most - 3.0).abs() < 1e-7, "{least} {most}");
    assert!(least <= -1.0 && most >= 3.0, "they are bounds");
}

/// The message and the cure of a wrong material.
fn refused(material: &str) -> (String, String) {
    let source = Source::new("room.toml", &room(material)).with_picture("any.png", *b"no picture");
    let error = radiosity::language::read(&source).expect_err(material);
    (error.to_string(), error.cure().unwrap_or_default())
}

#[test]
fn wrong_patterns_are_refused_with_a_cure() {
    for (material, message, cure) in [
        ("reflectance = { }", "\"image\" is missing", "cells"),
        (
            "reflectance = { cells = [[0.5]], polynomial = [] }",
            "\"cells\" and \"polynomial\" are both given",
            "leave one",
        ),
        ("reflectance = { cells = [[0.5]], encoding = \"srgb\" }", "\"cells\" and \"encoding\"", "leave one"),
        ("reflectance = { polynomial = [], scale = 2 }", "\"polynomial\" and \"scale\"", "leave one"),
        ("reflectance = { cells = [[0.5, 0.5], [0.5]] }", "a row of cells takes 2 numbers", "give 2"),
        ("reflectance = { cells = [] }", "the list of cells takes rows", "give rows"),
        ("reflectance = { cells = [[]] }", "the list of cells takes rows", "give rows"),
        (
            "reflectance = { cells = [[0.5, 1]] }",
            "the reflectance is 1 in the texel of column 2, row 1 from the top, outside 0 ≤ ρ < 1",
            "factor = 0.90",
        ),
        (
            "reflectance = { cells = [[0.5], [-0.1]] }",
            "is -0.1 in the texel of column 1, row 2 from the top",
            "nowhere below 0",
        ),
        ("reflectance = { cells = [[0.5]], factor = 2 }", "the reflectance is 1 in", "times the factor"),
        ("reflectance = { cells = [[0.5]], factor = -1 }", "the factor is -1", "factor ≥ 0"),
        (
            "reflectance = { cells = [[0.5]], factor = [1, 1] }",
            "the factor takes one for all bands or 3",
            "give one",
        ),
        (
            "reflectance = { cells = [[[0.5]], [[0.5]]] }",
            "the list of cells takes one for all bands or 3",
            "give one",
        ),
        ("reflectance = { cells = [[0.5]], scale = 0 }", "the scale is 0", "scale > 0"),
        ("reflectance = { cells = [[0.5]], scale = [1, -1] }", "the scale is -1", "scale > 0"),
        (
            "reflectance = { cells = [[0.5]], scale = 1e7 }",
            "the number of texels across the surface is 10000000",
            "10⁶",
        ),
        (
            "reflectance = { cells = [[0.5]], wrap = \"tile\" }",
            "there is no wrap \"tile\"",
            "repeat, mirror, clamp",
        ),
        (
            "reflectance = { image = \"any.png\", encoding = \"sRGB\" }",
            "there is no encoding \"sRGB\"",
            "did you mean \"srgb\"?",
        ),
        (
            "reflectance = { image = \"a.png\" }",
            "\"a.png\" cannot be included: the text is not that of a file",
            "read the scene from its file",
        ),
        ("reflectance = { polynomial = [[0, 0]] }", "a term takes three numbers", "give three numbers"),
        ("reflectance = { polynomial = [[0.5, 0, 1]] }", "0.5 is not a whole number", "give 0, 1, 2"),
        ("reflectance = { polynomial = [[21, 0, 0.1]] }", "the power is 21", "0 ≤ power ≤ 20"),
        (
            "reflectance = { polynomial = [[0, 0, 0.5], [1, 0, 0.5]] }",
            "at u = 1.0000",
            "scale the pattern down",
        ),
        (
            "reflectance = 0.5\nemission = { polynomial = [[1, 1, 1]] }",
            "the emission is -1",
            "nowhere below 0",
        ),
        ("reflectance = 0.5\nemission = { cells = [[-2]] }", "the emission is -2", "nowhere below 0"),
        (
            "reflectance = { cells = [[0.5]] }\ntransmittance = 0.5",
            "outside ρ + τ < 1",
            "scale the pattern down",
        ),
        (
            "reflectance = 0.5\ntransmittance = 0.5",
            "the sum of reflectance and transmittance is 1",
            "ρ + τ < 1",
        ),
        ("reflectance = 0.5\ntransmittance = -0.1", "the transmittance is -0.1", "0 ≤ τ < 1"),
        (
            "reflectance = 0.5\ntransmittance = [0.1, 0.2]",
            "the transmittance takes",
            "give one number for all bands",
        ),
    ] {
        let (found, mended) = refused(material);
        assert!(found.contains(message), "{material}: {found}");
        assert!(mended.contains(cure), "{material}: {mended}");
        assert!(found.starts_with("room.toml:"), "{found} has a place");
    }
}

#[test]
fn a_flux_and_a_pattern_of_emission_are_refused() {
    let text = room("reflectance = 0.1\nemission = { cells = [[1, 2]] }");
    let text = text.replace("name = \"floor\"", "name = \"floor\"\nflux = 10");
    let error = radiosity::language::read(&Source::new("room", &text)).expect_err("both are given");
    assert!(error.to_string().contains("a flux is given"), "{error}");
    assert!(error.cure().is_some_and(|cure| cure.contains("`factor`")));
}

#[test]
fn all_copies_of_a_part_share_a_pattern() {
    let text = r#"
[materials.tile]
reflectance = { cells = [[0.2, 0.4], [0.4, 0.2]] }
[[parts.cube.surfaces]]
name = "side"
material = "tile"
box = { origin = [0, 0, 0], size = [1, 1, 1] }
[[instances]]
part = "cube"
name = "cube"
array = { count = 3, step = [2, 0, 0] }
"#;
    let scene = typed(text);
    assert_eq!(scene.surfaces.len(), 18);
    let patterns: Vec<_> =
        scene.surfaces.iter().map(|own| own.material.reflectance_pattern.clone().unwrap()).collect();
    assert!(patterns.iter().all(|own| std::sync::Arc::ptr_eq(own, &patterns[0])));
}
