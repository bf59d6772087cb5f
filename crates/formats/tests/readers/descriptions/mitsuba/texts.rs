//! Texts: parameters, includes, files in folders, what is not known, what is too much.

use glam::DVec3;
use radiosity_formats::model::Shape;
use radiosity_photometry::file_place::FilePlace;

use super::{beside, inside, is_refused, notes, read, right};

fn radii(text: &str) -> Vec<f64> {
    let radius = |shape: &Shape| match shape {
        Shape::Sphere { radius, .. } => *radius,
        other => panic!("{other:?}"),
    };
    right(text).surfaces.iter().map(|surface| radius(&surface.shape)).collect()
}

fn sphere(radius: &str) -> String {
    format!("<shape type=\"sphere\"><float name=\"radius\" value=\"{radius}\"/></shape>")
}

#[test]
fn parameters_are_filled_in() {
    let defaults = "<default name=\"r\" value=\"2\"/><default name=\"r\" value=\"3\"/><default name=\"rr\" value=\"4$r\"/>";
    assert_eq!(
        radii(&format!("{defaults}{}{}{}", sphere("$r"), sphere("1$r.$r"), sphere("$rr"))),
        [2.0, 12.2, 42.0]
    );
    let text = format!("<default name=\"a\" value=\"1\"/>\n{}", sphere("$b"));
    is_refused(inside(&text), 3, "the parameter $b has no value");
    is_refused(inside("<default name=\"a\"/>"), 2, "a <default> has no name or no value");
}

#[test]
fn names_of_mitsuba_0_are_read() {
    let text = "<scene version=\"0.6.0\"><shape type=\"sphere\"><transform name=\"toWorld\"><lookAt origin=\"1 2 3\" target=\"0 0 0\"/>\
                </transform><boolean name=\"flipNormals\" value=\"true\"/><bsdf type=\"diffuse\"><srgb name=\"diffuseReflectance\" value=\"#ffffff\"/></bsdf></shape></scene>";
    let model = read(text).expect("the sphere is right");
    let center = DVec3::new(1.0, 2.0, 3.0);
    let Shape::Sphere { center: found, inward: true, .. } = model.surfaces[0].shape else {
        panic!("{model:?}")
    };
    assert_eq!((found, model.materials[0].reflectance.as_slice()), (center, &[1.0][..]));
    assert!(model.notes.is_empty(), "{:?}", model.notes);
}

#[test]
fn included_files_stand_in_the_place_of_their_includes() {
    let part = "<scene version=\"3.0.0\"><shape type=\"disk\" id=\"$name\"><ref id=\"white\"/></shape><include filename=\"white.xml\"/></scene>";
    let white = "<bsdf version=\"3.0.0\" type=\"diffuse\" id=\"white\"/>";
    let files = [("parts/disk.xml", part), ("parts/white.xml", white)];
    let text = "<default name=\"name\" value=\"plate\"/><include filename=\"parts/disk.xml\"/>";
    let model = beside(text, &files).expect("the parts are right");
    assert_eq!((model.surfaces[0].name.as_str(), model.materials[0].name.as_str()), ("plate", "white"));
    let text = "<path value=\"parts\"/><include filename=\"white.xml\"/><shape type=\"disk\"><ref id=\"white\"/></shape>";
    assert!(beside(text, &files).is_ok());
}

#[test]
fn broken_includes_are_refused() {
    is_refused(beside("\n<include filename=\"a.xml\"/>", &[]), 3, "the included file 'a.xml' cannot be read");
    is_refused(beside("\n<include/>", &[]), 3, "an <include> names no file");
    is_refused(beside("\n<include filename=\"room.xml\"/>", &[]), 3, "'room.xml' includes itself");
    let circle = "<scene version=\"3.0.0\">\n<include filename=\"b.xml\"/></scene>";
    let back = "<scene version=\"3.0.0\"><include filename=\"./a.xml\"/></scene>";
    let refusal = beside("<include filename=\"a.xml\"/>", &[("a.xml", circle), ("b.xml", back)])
        .expect_err("it is a circle");
    assert_eq!((refusal.file.as_str(), refusal.place), ("b.xml", Some(FilePlace::Line(1))));
    assert!(refusal.cause.contains("'a.xml' includes itself"));
    let fault = "<scene version=\"3.0.0\">\n\n<shape type=\"sphere\"><float name=\"radius\" value=\"x\"/></shape></scene>";
    let refusal =
        beside("<include filename=\"a.xml\"/>", &[("a.xml", fault)]).expect_err("the radius is none");
    assert_eq!((refusal.file.as_str(), refusal.place), ("a.xml", Some(FilePlace::Line(3))));
}

/// Thirty files, each of which includes the next twice, are given up.
#[test]
fn includes_do_not_grow_without_end() {
    let names: Vec<&'static str> =
        (0..30).map(|k| &*Box::leak(format!("{k}.xml").into_boxed_str())).collect();
    let text = |k: usize| {
        let next = format!("<include filename=\"{}.xml\"/>", k + 1);
        format!("<scene version=\"3.0.0\">{next}{next}</scene>")
    };
    let mut texts: Vec<String> = (0..29).map(text).collect();
    texts.push("<scene version=\"3.0.0\"/>".to_owned());
    let files: Vec<(&'static str, &str)> = names.into_iter().zip(texts.iter().map(String::as_str)).collect();
    let refusal = beside("<include filename=\"0.xml\"/>", &files).expect_err("it is too much");
    assert!(refusal.cause.contains("are followed"), "{refusal}");
}

#[test]
fn what_is_not_known_is_noted_once() {
    let model = right(
        "<shape type=\"disk\" colour=\"red\"><float name=\"mass\" value=\"1\"/><boolean name=\"face_normals\" value=\"true\"/></shape>\
         <shape type=\"disk\"><float name=\"mass\" value=\"1\"/><thing/></shape><thing><float name=\"a\" value=\"1\"/></thing>\
         <integrator name=\"how\" type=\"path\"/><bsdf type=\"diffuse\" id=\"unused\"/>",
    );
    let told = [
        ("the attribute 'colour' of <shape> is left out", 1),
        ("'mass' of <shape type=\"disk\"> is left out", 2),
        ("<thing> in <shape type=\"disk\"> is left out", 1),
        ("<thing> in <scene> is left out", 1),
    ];
    assert_eq!(notes(&model), told);
    let many: String = (0..3000).map(|k| format!("<thing-{k}/>")).collect();
    let model = right(&(many + "<shape type=\"disk\"/>"));
    assert_eq!(model.notes.len(), 101);
    assert_eq!(model.notes.iter().map(|note| note.count).sum::<usize>(), 3000);
}
