//! Bsdfs, colours and emitters.

use std::f64::consts::PI;

use radiosity_formats::model::{Material, Model, Sides};

use super::{inside, is_refused, notes, right};

/// A disk of a bsdf.
fn disk(bsdf: &str) -> String {
    format!("<shape type=\"disk\">{bsdf}</shape>")
}

/// The material of the only surface.
fn material(model: &Model) -> &Material {
    assert_eq!(model.surfaces.len(), 1);
    &model.materials[model.surfaces[0].material.expect("it has a material")]
}

/// The reflectance of a bsdf of a type with properties, and the notes.
fn reflectance(kind: &str, properties: &str) -> (Vec<f64>, usize) {
    let model = right(&disk(&format!("<bsdf type=\"{kind}\">{properties}</bsdf>")));
    (material(&model).reflectance.clone(), model.notes.len())
}

fn near(found: &[f64], expected: &[f64]) {
    let is_near =
        found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(is_near, "{found:?} instead of {expected:?}");
}

#[test]
fn colours_are_written_in_many_ways() {
    let told: [(&str, &[f64]); 12] = [
        ("<rgb name=\"reflectance\" value=\"0.1, 0.2, 0.3\"/>", &[0.1, 0.2, 0.3]),
        ("<rgb name=\"reflectance\" value=\"0.1 0.2 0.3\"/>", &[0.1, 0.2, 0.3]),
        ("<rgb name=\"reflectance\" value=\"0.4\"/>", &[0.4]),
        ("<rgb name=\"reflectance\" value=\"#808080\"/>", &[0.215_860_500_113_8]),
        ("<srgb name=\"reflectance\" value=\"0.5, 0.02, 1\"/>", &[0.214_041_140_482_2, 0.02 / 12.92, 1.0]),
        ("<float name=\"reflectance\" value=\"0.3\"/>", &[0.3]),
        ("<spectrum name=\"reflectance\" value=\"0.6\"/>", &[0.6]),
        ("<spectrum name=\"reflectance\" value=\"300:0.2, 900:0.2\"/>", &[0.2]),
        ("<spectrum name=\"reflectance\" value=\"400:0, 700:0.6\"/>", &[0.5, 0.3, 0.1]),
        (
            "<spectrum name=\"reflectance\" type=\"uniform\"><float name=\"value\" value=\"0.7\"/></spectrum>",
            &[0.7],
        ),
        (
            "<spectrum name=\"reflectance\" type=\"irregular\"><string name=\"wavelengths\" value=\"400, 700\"/>\
             <string name=\"values\" value=\"0, 0.6\"/></spectrum>",
            &[0.5, 0.3, 0.1],
        ),
        ("<texture name=\"reflectance\" type=\"checkerboard\"/>", &[0.3]),
    ];
    for (text, expected) in told {
        near(&reflectance("diffuse", text).0, expected);
    }
    near(&reflectance("diffuse", "").0, &[0.5]);
}

#[test]
fn broken_colours_are_refused() {
    let told = [
        ("<rgb name=\"reflectance\" value=\"0.1, 0.2\"/>", "value of <rgb> has 2 numbers"),
        ("<rgb name=\"reflectance\" value=\"#12345\"/>", "'#12345' is no colour"),
        ("<rgb name=\"reflectance\" value=\"#é2345\"/>", "'#é2345' is no colour"),
        ("<rgb name=\"reflectance\" value=\"+.5 -.5 0\"/>", "reflectance is below 0"),
        ("<rgb name=\"reflectance\"/>", "<rgb> has no value"),
        ("<spectrum name=\"reflectance\" value=\"400:0.5 0.6\"/>", "the spectrum holds '0.6'"),
        ("<spectrum name=\"reflectance\" value=\"500:1 400:1\"/>", "its wavelengths do not grow"),
        ("<spectrum name=\"reflectance\" value=\"400:x\"/>", "a value is 'x'"),
        ("<ref name=\"reflectance\" id=\"none\"/>", "nothing has the id 'none'"),
        (
            "<texture name=\"reflectance\" type=\"checkerboard\" id=\"a\"><ref name=\"color0\" id=\"a\"/></texture>",
            "or in a circle",
        ),
    ];
    for (text, cause) in told {
        is_refused(inside(&disk(&format!("<bsdf type=\"diffuse\">\n{text}</bsdf>"))), 3, cause);
    }
}

#[test]
fn the_diffuse_part_of_bsdfs_is_taken() {
    let told: [(&str, &str, &[f64]); 9] = [
        ("plastic", "<rgb name=\"diffuse_reflectance\" value=\"0.1, 0.2, 0.3\"/>", &[0.1, 0.2, 0.3]),
        ("roughplastic", "<float name=\"alpha\" value=\"0.1\"/>", &[0.5]),
        ("dielectric", "<float name=\"int_ior\" value=\"1.5\"/>", &[0.0]),
        ("roughconductor", "<string name=\"material\" value=\"Au\"/>", &[0.0]),
        (
            "principled",
            "<rgb name=\"base_color\" value=\"0.8\"/><float name=\"metallic\" value=\"0.5\"/>",
            &[0.4],
        ),
        ("mask", "<float name=\"opacity\" value=\"0.3\"/><bsdf type=\"diffuse\"/>", &[0.5]),
        (
            "blendbsdf",
            "<float name=\"weight\" value=\"0.25\"/><bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0.9\"/></bsdf>",
            &[0.6],
        ),
        (
            "diffuse",
            "<texture name=\"reflectance\" type=\"bitmap\"><string name=\"filename\" value=\"a.png\"/></texture>",
            &[0.5],
        ),
        ("no_such_bsdf", "", &[0.0]),
    ];
    for (kind, properties, expected) in told {
        let (found, notes) = reflectance(kind, properties);
        near(&found, expected);
        assert_eq!(notes, usize::from(kind != "blendbsdf"), "{kind}");
    }
}

#[test]
fn sides_and_names_come_from_bsdfs() {
    let model = right(
        "<bsdf type=\"twosided\" id=\"both\"><ref id=\"white\"/></bsdf>\n<bsdf type=\"diffuse\" id=\"white\">\
         <rgb name=\"reflectance\" value=\"0.9\"/></bsdf><alias id=\"white\" as=\"paint\"/>\n\
         <shape type=\"disk\"><ref id=\"both\"/></shape><shape type=\"disk\"><ref name=\"bsdf\" id=\"white\"/></shape>\
         <shape type=\"disk\"><ref id=\"paint\"/></shape><shape type=\"disk\"><bsdf type=\"twosided\"><bsdf type=\"diffuse\"/></bsdf></shape>",
    );
    let sides: Vec<Sides> = model.surfaces.iter().map(|surface| surface.sides).collect();
    assert_eq!(sides, [Sides::Both, Sides::Front, Sides::Front, Sides::Both]);
    let names: Vec<&str> = model.materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["both", "white", "diffuse"]);
    assert!(model.notes.is_empty(), "{:?}", model.notes);
}

#[test]
fn void_shapes_are_left_out() {
    let model = right("<shape type=\"disk\"/><shape type=\"sphere\"><bsdf type=\"null\"/></shape>");
    assert_eq!(model.surfaces.len(), 1);
    assert_eq!(notes(&model), [("shapes with a bsdf of type 'null' are left out", 1)]);
}

/// Exitance is π times radiance; shapes that shine and have no bsdf are black.
#[test]
fn area_emitters_have_exitance() {
    let lamp = |emitter: &str| {
        let model = right(&disk(emitter));
        (material(&model).reflectance.clone(), material(&model).emission.clone())
    };
    let (reflectance, emission) =
        lamp("<emitter type=\"area\"><rgb name=\"radiance\" value=\"2\"/></emitter>");
    near(&[reflectance, emission].concat(), &[0.0, 2.0 * PI]);
    near(&lamp("<emitter type=\"area\"/>").1, &[PI]);
    let d65 = "<emitter type=\"area\"><spectrum name=\"radiance\" type=\"d65\"><float name=\"scale\" value=\"3\"/></spectrum></emitter>";
    near(&lamp(d65).1, &[3.0 * PI]);
    let (reflectance, emission) = lamp(
        "<bsdf type=\"diffuse\"/><emitter type=\"area\"><rgb name=\"radiance\" value=\"1 0 0\"/></emitter>",
    );
    near(&[reflectance, emission].concat(), &[0.5, 0.5, 0.5, PI, 0.0, 0.0]);
}

#[test]
fn lamps_are_named_by_themselves() {
    let white = "<bsdf type=\"diffuse\" id=\"white\"/>";
    let lamp = "<ref id=\"white\"/><emitter type=\"area\"/></shape>";
    let text = format!(
        "{white}<shape type=\"disk\" id=\"light\">{lamp}<shape type=\"disk\">{lamp}<shape type=\"disk\"><ref id=\"white\"/></shape>"
    );
    let model = right(&text);
    let names: Vec<&str> = model.materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["light", "lamp", "white"]);
}

#[test]
fn what_shines_on_both_sides_shines_on_its_front() {
    let model =
        right(&disk("<bsdf type=\"twosided\"><bsdf type=\"diffuse\"/></bsdf><emitter type=\"area\"/>"));
    assert_eq!(model.surfaces[0].sides, Sides::Front);
    assert_eq!(notes(&model).len(), 1);
}

#[test]
fn emitters_that_are_not_known_are_noted_or_refused() {
    let model = right(
        "<shape type=\"disk\"><emitter type=\"directionalarea\"/></shape><emitter type=\"point\"/><emitter type=\"point\"/>",
    );
    let told = [
        ("emitters of type 'directionalarea' are left out", 1),
        ("emitters of type 'point' are left out", 2),
    ];
    assert_eq!(notes(&model), told);
    let text = "<shape type=\"disk\">\n<emitter type=\"area\"><texture type=\"bitmap\" name=\"radiance\"/></emitter></shape>";
    is_refused(inside(text), 3, "the radiance is of type 'bitmap'");
}

#[test]
fn broken_bsdfs_are_refused() {
    let told = [
        ("<bsdf type=\"twosided\"/>", "the bsdf of type 'twosided' has no bsdf in it"),
        ("<bsdf type=\"blendbsdf\"><bsdf type=\"diffuse\"/></bsdf>", "the blend has one bsdf"),
        ("<bsdf type=\"twosided\" id=\"a\"><ref id=\"a\"/></bsdf>", "or in a circle"),
        ("<ref id=\"none\"/>", "nothing has the id 'none'"),
        ("<ref/>", "<ref> has no id"),
        ("<bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"/>", "the shape has two of <bsdf>"),
        ("<bsdf type=\"diffuse\" id=\"a\"/><emitter type=\"area\" id=\"a\"/>", "the id 'a' is given twice"),
        ("<alias id=\"b\" as=\"c\"/>", "nothing has the id 'b'"),
        (
            "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"1e60\"/></bsdf>",
            "has a value beyond 1e50",
        ),
    ];
    for (text, cause) in told {
        let line = if cause.contains("1e50") { 2 } else { 3 };
        is_refused(inside(&format!("<shape type=\"disk\">\n{text}\n</shape>")), line, cause);
    }
}

/// A chain of bsdfs that is longer than any stack is refused.
#[test]
fn long_chains_of_bsdfs_are_refused() {
    let chain: String = (0..100_000)
        .map(|k| format!("<bsdf type=\"twosided\" id=\"b{k}\"><ref id=\"b{}\"/></bsdf>\n", k + 1))
        .collect();
    let text = chain + "<bsdf type=\"diffuse\" id=\"b100000\"/><shape type=\"disk\"><ref id=\"b0\"/></shape>";
    is_refused(inside(&text), 18, "more than 16 deep");
}
