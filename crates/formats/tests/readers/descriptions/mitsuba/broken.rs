//! Texts that are no scenes, attacks, and broken copies of right scenes.

use radiosity_formats::mitsuba;
use radiosity_photometry::files::NoFiles;
use radiosity_test_support::mutations::break_often;

use super::{is_refused, read};
use crate::memory::Memory;
use crate::promises::assert_promised;

#[test]
fn what_is_no_scene_is_refused() {
    let told = [
        ("", 1, "this is no XML"),
        ("o cube\nv 1 2 3", 1, "this is no XML"),
        (
            "<scene version=\"3.0.0\">\n<shape type=\"disk\">\n</scene>",
            3,
            "expected 'shape' tag, not 'scene'",
        ),
        ("<scene>\n<shape type=\"disk\" type=\"disk\"/></scene>", 2, "this is no XML"),
        ("<scene>\n<shape type=\"&x;\"/></scene>", 2, "this is no XML"),
        ("\n<html/>", 2, "the file begins with <html>, not with <scene>"),
    ];
    for (text, line, cause) in told {
        is_refused(read(text), line, cause);
    }
    let binary = mitsuba::read("a.xml", b"<scene>\0", &NoFiles).expect_err("it is no text");
    assert!(binary.cause.contains("zero byte"));
}

/// Ten entities, each ten times the one before.
#[test]
fn entities_are_refused() {
    let laughs: String =
        (1..10).map(|k| format!("<!ENTITY l{k} \"{}\">\n", format!("&l{};", k - 1).repeat(10))).collect();
    let text = format!(
        "<?xml version=\"1.0\"?>\n<!DOCTYPE scene [\n<!ENTITY l0 \"ha\">\n{laughs}]>\n<scene version=\"&l9;\"/>"
    );
    let refusal = read(&text).expect_err("entities are not followed");
    assert!(refusal.cause.contains("entities") && !refusal.cure.is_empty(), "{refusal}");
}

#[test]
fn parameters_do_not_grow_without_end() {
    let laughs: String = (1..10)
        .map(|k| format!("<default name=\"l{k}\" value=\"{}\"/>\n", format!("$l{}", k - 1).repeat(10)))
        .collect();
    let text = format!("<scene version=\"3.0.0\">\n<default name=\"l0\" value=\"1\"/>\n{laughs}</scene>");
    is_refused(read(&text), 7, "is longer than 100 or its value than 10000 bytes");
}

#[test]
fn elements_deep_in_one_another_are_refused() {
    for tag in ["scene", "shape type=\"shapegroup\"", "bsdf type=\"twosided\""] {
        let name = tag.split(' ').next().unwrap_or_default();
        let text = format!(
            "<scene>\n{}{}</scene>",
            format!("<{tag}>").repeat(100_000),
            format!("</{name}>").repeat(100_000)
        );
        is_refused(read(&text), 2, "in one another more than 64 deep");
    }
    let open = format!("<scene>\n{}", "<shape>".repeat(100_000));
    is_refused(read(&open), 1, "this is no XML");
}

#[test]
fn what_would_take_long_is_refused() {
    let attributes: String = (0..100_000).map(|k| format!(" a{k}=\"\"")).collect();
    let refusal = read(&format!("<scene{attributes}/>")).expect_err("these are too many");
    assert!(refusal.cause.contains("more than 1000 quotes"));
    let spaces: String = (0..10_000).map(|k| format!("<a xmlns:a{k}=\"{k}\">")).collect();
    let refusal = read(&format!("<scene>{spaces}")).expect_err("these are too many");
    assert!(refusal.cause.contains("more than 100 namespaces"));
    let instances = "<shape type=\"instance\"><ref id=\"a\"/></shape>\n".repeat(10_000);
    let shapes = "<shape type=\"nothing\"/>".repeat(10_000);
    let text = format!("<scene>\n<shape type=\"shapegroup\" id=\"a\">{shapes}</shape>\n{instances}</scene>");
    is_refused(read(&text), 2, "are followed");
}

/// The room with what it does not have: files, groups, textures, old words.
const MORE: &str = "<scene version=\"3.0.0\">\n<default name=\"s\" value=\"0.5\"/>\n<path value=\"parts\"/>\n\
    <include filename=\"part.xml\"/>\n<alias id=\"group\" as=\"other\"/>\n<shape type=\"instance\"><ref id=\"other\"/>\
    <transform name=\"to_world\"><matrix value=\"0 1 0 0 1 0 0 $s 0 0 1 0 0 0 0 1\"/></transform></shape>\n\
    <shape type=\"obj\"><string name=\"filename\" value=\"a.obj\"/><transform name=\"to_world\"><rotate x=\"1\" y=\"2\" angle=\"30\"/>\
    <scale value=\"$s\"/></transform><bsdf type=\"blendbsdf\"><float name=\"weight\" value=\"$s\"/><bsdf type=\"principled\">\
    <rgb name=\"base_color\" value=\"#804020\"/></bsdf><bsdf type=\"mask\"><bsdf type=\"diffuse\"><spectrum name=\"reflectance\" type=\"regular\">\
    <float name=\"wavelength_min\" value=\"400\"/><float name=\"wavelength_max\" value=\"700\"/><string name=\"values\" value=\"0.1, 0.2, 0.3\"/>\
    </spectrum></bsdf></bsdf></bsdf><emitter type=\"area\"><spectrum name=\"radiance\" type=\"d65\"/></emitter></shape>\n</scene>";

const PART: &str = "<scene version=\"0.6.0\"><shape type=\"shapegroup\" id=\"group\"><shape type=\"sphere\"><float name=\"radius\" value=\"$s\"/>\
    <boolean name=\"flipNormals\" value=\"true\"/></shape></shape></scene>";

const MESH: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nf 1 2 3 4\nf 1 3 2\n";

/// Replacements of words of XML.
const WORDS: [&str; 6] = ["<", "\"", "$", "&lt;", "&x;", "]]"];

fn break_scenes(cases: u32) {
    let files = |part: &[u8]| Memory::of([("parts/part.xml", part), ("a.obj", MESH.as_bytes())]);
    let whole = files(PART.as_bytes());
    for text in [include_str!("../../../fixtures/room.xml"), MORE] {
        let right = mitsuba::read("right", text.as_bytes(), &whole);
        assert!(right.is_ok(), "{right:?}");
        break_often(cases, text.as_bytes(), &WORDS, |bytes| {
            assert_promised(&mitsuba::read("broken", bytes, &whole))
        });
    }
    break_often(cases, PART.as_bytes(), &WORDS, |part| {
        assert_promised(&mitsuba::read("broken", MORE.as_bytes(), &files(part)));
    });
}

#[test]
fn broken_mitsuba_scenes_are_read_or_refused() {
    break_scenes(256);
}

#[test]
#[ignore = "a longer hunt: seconds"]
fn ten_thousand_broken_mitsuba_scenes_are_read_or_refused() {
    break_scenes(10_000);
}
