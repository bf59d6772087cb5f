//! Schemas of the shapes.

use serde_json::{Value, json};

use crate::schema::terms::{exactly, list, of, or, positive, ranged, table, text, truth, whole, with};

const HOLES: &str = "Outlines of holes, in the plane and inside the outline";
const ANGLE: &str = "From and to about the axis, degrees, at most once round";
const AXIS: &str = "Direction and, where it has one, height of the axis";

/// Every shape key with the schema of its value.
pub(super) fn all() -> Vec<(&'static str, Value)> {
    vec![
        ("parallelogram", parallelogram()),
        ("quad", table("Four corners, in a plane or not", &["vertices"], vec![corners(4), holes()])),
        ("triangle", table("Three corners", &["vertices"], vec![corners(3)])),
        ("polygon", polygon()),
        ("box", cuboid()),
        ("disk", disk()),
        ("cylinder", cylinder()),
        ("cone", cone()),
        ("sphere", sphere()),
        ("torus", torus()),
        (
            "bezier",
            table("A bicubic Bézier patch", &["points"], vec![net("points", "row", "control points")]),
        ),
        ("patches", patches()),
        ("rational", rational()),
        ("extrusion", extrusion()),
        ("revolution", revolution()),
    ]
}

fn corners(count: usize) -> (&'static str, Value) {
    ("vertices", exactly(count, "point", "Corners in order around the outline"))
}

fn holes() -> (&'static str, Value) {
    ("holes", list("outline", HOLES, 0))
}

fn angle(key: &'static str) -> (&'static str, Value) {
    (key, or(json!([0, 360]), exactly(2, "number", ANGLE)))
}

fn net(key: &'static str, row: &str, what: &str) -> (&'static str, Value) {
    (key, exactly(4, row, &format!("Four rows of four {what}")))
}

fn parallelogram() -> Value {
    let keys = vec![
        ("origin", of("point", "A corner")),
        ("edge1", of("vector", "From the corner along u")),
        ("edge2", of("vector", "From the corner along v")),
        holes(),
    ];
    table("A parallelogram; its front is edge1 × edge2", &["origin", "edge1", "edge2"], keys)
}

fn polygon() -> Value {
    let outline = of("outline", "Corners in order around the outline, counter-clockwise seen from the front");
    table("A flat polygon", &["vertices"], vec![("vertices", outline), holes()])
}

fn cuboid() -> Value {
    let face = json!({ "enum": ["left", "right", "front", "back", "bottom", "top"] });
    let keys = vec![
        ("origin", of("point", "The corner of the lowest coordinates")),
        ("size", with(exactly(3, "number", "Lengths along x, y and z"), "items", positive("A length"))),
        ("corners", exactly(2, "point", "Two opposite corners, instead of origin and size")),
        ("inward", truth("Fronts inside, as in a room")),
        ("open", json!({ "description": "Faces that are left out", "type": "array", "items": face })),
    ];
    let cuboid = table("A cuboid along the axes, six surfaces", &[], keys);
    let none_of = |key: &str| json!({ "not": { "required": [key] } });
    with(
        cuboid,
        "oneOf",
        json!([
            { "required": ["origin", "size"], "not": { "required": ["corners"] } },
            { "required": ["corners"], "allOf": [none_of("origin"), none_of("size")] },
        ]),
    )
}

fn disk() -> Value {
    let inner = ranged(json!({ "minimum": 0 }), "Radius of a round hole in the middle");
    let keys = vec![
        ("center", of("point", "The middle")),
        ("normal", of("vector", "Direction of the front")),
        ("radius", positive("Radius")),
        ("inner_radius", or(json!(0), inner)),
        angle("angle"),
    ];
    table("A disk, a ring or a sector", &["center", "normal", "radius"], keys)
}

fn cylinder() -> Value {
    let keys = vec![
        ("base", of("point", "The middle of one end")),
        ("axis", of("vector", "From the base to the other end")),
        ("radius", positive("Radius")),
        angle("angle"),
    ];
    table("The side of a cylinder, its front outside", &["base", "axis", "radius"], keys)
}

fn cone() -> Value {
    let radius =
        |which: &str| ranged(json!({ "minimum": 0 }), &format!("Radius at the {which}; not both are 0"));
    let keys = vec![
        ("base", of("point", "The middle of one end")),
        ("axis", of("vector", "From the base to the other end")),
        ("radius1", radius("base")),
        ("radius2", radius("other end")),
        angle("angle"),
    ];
    table(
        "The side of a cone or a part of it, its front outside",
        &["base", "axis", "radius1", "radius2"],
        keys,
    )
}

fn sphere() -> Value {
    let keys = vec![
        ("center", of("point", "The middle")),
        ("radius", positive("Radius")),
        ("axis", or(json!([0, 0, 1]), of("vector", AXIS))),
        ("z", exactly(2, "number", "Lowest and highest height along the axis, from the middle")),
        angle("angle"),
    ];
    table("A sphere or a zone of it, its front outside", &["center", "radius"], keys)
}

fn torus() -> Value {
    let keys = vec![
        ("center", of("point", "The middle")),
        ("axis", of("vector", AXIS)),
        ("major", positive("Radius of the circle along which the tube runs")),
        ("minor", positive("Radius of the tube")),
        angle("angle"),
        angle("tube_angle"),
    ];
    table("A torus or a part of it, its front outside", &["center", "axis", "major", "minor"], keys)
}

fn patches() -> Value {
    let keys = vec![
        ("points", list("point", "Control points, shared by the patches", 0)),
        ("patches", list("patch", "The patches, each of 16 points", 1)),
    ];
    table("Bicubic Bézier patches, each a surface", &["points", "patches"], keys)
}

fn rational() -> Value {
    let keys = vec![net("points", "row", "control points"), net("weights", "weights", "weights")];
    table("A rational bicubic Bézier patch", &["points", "weights"], keys)
}

fn curve() -> (&'static str, Value) {
    ("curve", exactly(4, "point", "Control points of a cubic Bézier curve"))
}

fn extrusion() -> Value {
    let keys = vec![curve(), ("direction", of("vector", "By this the curve is moved"))];
    table("A curve moved along a straight line", &["curve", "direction"], keys)
}

fn revolution() -> Value {
    let keys = vec![
        curve(),
        ("center", of("point", "A point of the axis")),
        ("axis", of("vector", AXIS)),
        angle("angle"),
    ];
    table("A curve turned about an axis", &["curve", "center", "axis"], keys)
}

/// Parts that the schemas of several shapes refer to, by name.
pub(super) fn parts() -> Vec<(&'static str, Value)> {
    let index = whole(0, u32::MAX as usize, "An index");
    let patch = with(exactly(16, "number", "Indices of control points, from 0, row by row"), "items", index);
    let weights = with(exactly(4, "number", "Four weights, each above 0"), "items", positive("A weight"));
    vec![
        ("outline", list("point", "Corners in order", 3)),
        ("row", exactly(4, "point", "Four control points")),
        ("weights", weights),
        ("patch", patch),
        ("name", text("A name")),
    ]
}
