//! Shapes and what transforms make of them.

use glam::DVec3;
use radiosity_formats::model::Shape;

use super::{beside, inside, is_refused, notes, right, shape, to_world};
use crate::measures::{named, polygon};

/// The only shape of a scene.
fn only(kind: &str, content: &str) -> Shape {
    let model = right(&shape(kind, content));
    assert_eq!(model.surfaces.len(), 1);
    model.surfaces[0].shape.clone()
}

/// The corners of a rectangle after steps.
fn corners(steps: &str) -> Vec<DVec3> {
    match only("rectangle", &to_world(steps)) {
        Shape::Polygon { outline, holes } if holes.is_empty() => outline,
        other => panic!("{other:?}"),
    }
}

fn near(found: &[DVec3], expected: [[f64; 3]; 4]) {
    let is_near = |(a, b): (&DVec3, [f64; 3])| a.distance(b.into()) < 1e-12;
    assert!(found.len() == 4 && found.iter().zip(expected).all(is_near), "{found:?}");
}

#[test]
fn steps_are_done_in_their_order() {
    near(&corners(""), [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]]);
    near(
        &corners("<translate x=\"1\"/><scale x=\"2\" y=\"3\"/>"),
        [[0.0, -3.0, 0.0], [4.0, -3.0, 0.0], [4.0, 3.0, 0.0], [0.0, 3.0, 0.0]],
    );
    near(
        &corners("<scale value=\"2\"/><translate value=\"1 0 5\"/>"),
        [[-1.0, -2.0, 5.0], [3.0, -2.0, 5.0], [3.0, 2.0, 5.0], [-1.0, 2.0, 5.0]],
    );
    near(
        &corners("<rotate z=\"2\" angle=\"90\"/>"),
        [[1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, -1.0, 0.0]],
    );
    // About the diagonal x to y, y to z.
    near(
        &corners("<rotate x=\"1\" y=\"1\" z=\"1\" angle=\"120\"/>"),
        [[0.0, -1.0, -1.0], [0.0, 1.0, -1.0], [0.0, 1.0, 1.0], [0.0, -1.0, 1.0]],
    );
}

#[test]
fn matrices_are_written_row_after_row() {
    let expected = [[-2.0, 4.0, -3.0], [4.0, 4.0, -3.0], [4.0, 4.0, 3.0], [-2.0, 4.0, 3.0]];
    let rows = "3 0 0 1  0 0 1 4  0 3 0 0  0 0 0 1";
    // This matrix mirrors, and the outline is turned: seen from the front it stays counter-clockwise.
    let mut found = corners(&format!("<matrix value=\"{rows}\"/>"));
    found.reverse();
    near(&found, expected);
    let nine = corners("<matrix value=\"3,0,0, 0,0,-1, 0,3,0\"/><translate x=\"1\" y=\"4\"/>");
    near(&nine, expected);
    let doubled = corners("<matrix value=\"6 0 0 2  0 0 -2 8  0 6 0 0  0 0 0 2\"/>");
    near(&doubled, expected);
}

#[test]
fn a_view_turns_z_to_its_target() {
    let found = corners("<lookat origin=\"1 2 3\" target=\"1 2 13\" up=\"0 7 0\"/>");
    near(&found, [[0.0, 1.0, 3.0], [2.0, 1.0, 3.0], [2.0, 3.0, 3.0], [0.0, 3.0, 3.0]]);
    let down = right(&shape("rectangle", &to_world("<lookat origin=\"0 0 3\" target=\"0 0 0\"/>")));
    assert!((polygon(&down.surfaces[0]) - DVec3::new(0.0, 0.0, -4.0)).length() < 1e-12);
}

#[test]
fn mirrors_keep_fronts() {
    let vector =
        |steps: &str, flip: &str| polygon(&right(&shape("rectangle", &(to_world(steps) + flip))).surfaces[0]);
    let flip = "<boolean name=\"flip_normals\" value=\"True\"/>";
    assert_eq!(vector("<scale x=\"-1\"/>", ""), DVec3::new(0.0, 0.0, 4.0));
    assert_eq!(vector("<scale x=\"-1\"/>", flip), DVec3::new(0.0, 0.0, -4.0));
    assert_eq!(vector("<scale z=\"-1\"/>", ""), DVec3::new(0.0, 0.0, -4.0));
    assert_eq!(vector("<scale z=\"0\"/>", ""), DVec3::new(0.0, 0.0, 4.0));
    assert_eq!(vector("", flip), DVec3::new(0.0, 0.0, -4.0));
}

#[test]
fn round_shapes_stay_round() {
    let like = "<scale value=\"2\"/><rotate y=\"1\" angle=\"90\"/><translate z=\"1\"/>";
    let disk = Shape::Disk { center: DVec3::Z, normal: DVec3::X, radius: 2.0, inner: 0.0 };
    assert_eq!(only("disk", &to_world(like)), disk);
    let Shape::Disk { normal, .. } = only("disk", "<boolean name=\"flip_normals\" value=\"true\"/>") else {
        panic!()
    };
    assert_eq!(normal, -DVec3::Z);
    let cylinder = Shape::Cylinder { base: DVec3::Z, axis: 2.0 * DVec3::X, radius: 2.0, inward: false };
    assert_eq!(only("cylinder", &to_world(like)), cylinder);
    let sphere = Shape::Sphere { center: DVec3::Z, radius: 2.0, inward: false };
    assert_eq!(only("sphere", &to_world(like)), sphere);
    // Along its axis a cylinder may be stretched, across its plane a disk.
    let long = Shape::Cylinder { base: DVec3::ZERO, axis: 5.0 * DVec3::Z, radius: 1.0, inward: false };
    assert_eq!(only("cylinder", &to_world("<scale z=\"5\"/>")), long);
    assert!(inside(&shape("disk", &to_world("<scale x=\"-3\" y=\"3\" z=\"0.1\"/>"))).is_ok());
}

#[test]
fn distorted_round_shapes_are_refused() {
    let oblong = to_world("<scale x=\"2\"/>");
    let oblique = to_world("<matrix value=\"1 0 0.5 0 1 0 0 0 1\"/>");
    is_refused(inside(&shape("disk", &oblong)), 2, "the transform makes the disk an ellipse");
    is_refused(
        inside(&shape("cylinder", &oblong)),
        2,
        "the transform makes the cylinder oblique or not round",
    );
    is_refused(
        inside(&shape("cylinder", &oblique)),
        2,
        "the transform makes the cylinder oblique or not round",
    );
    is_refused(inside(&shape("sphere", &oblong)), 2, "the transform makes the sphere an ellipsoid");
    let flat = to_world("<scale z=\"0\"/>");
    is_refused(inside(&shape("cube", &flat)), 2, "the transform makes the cube flat");
    is_refused(inside(&shape("sphere", &flat)), 2, "the transform makes the sphere an ellipsoid");
    is_refused(
        inside(&shape("disk", &to_world("<scale value=\"0\"/>"))),
        2,
        "the transform makes the disk an ellipse",
    );
    is_refused(inside(&shape("sphere", "<float name=\"radius\" value=\"0\"/>")), 2, "a sphere has no radius");
    is_refused(
        inside(&shape("cylinder", "<point name=\"p1\" value=\"0\"/>")),
        2,
        "the cylinder has no length",
    );
    is_refused(inside(&shape("rectangle", &to_world("<scale value=\"1e60\"/>"))), 2, "is beyond 1e50");
}

#[test]
fn broken_transforms_are_refused() {
    let told = [
        ("<scale x=\"a\"/>", "x is 'a', which is no number"),
        ("<scale value=\"1 2\"/>", "value of <scale> has 2 numbers"),
        ("<rotate x=\"1\"/>", "<rotate> has no angle"),
        ("<rotate angle=\"90\"/>", "the axis of the rotation is 0"),
        ("<rotate x=\"1\" angle=\"90 2\"/>", "the angle is not one number"),
        ("<matrix value=\"1 2 3\"/>", "a matrix has 3 numbers"),
        ("<matrix value=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1\"/>", "the matrix is a perspective"),
        ("<lookat origin=\"1 1 1\" target=\"1 1 1\"/>", "the view has no direction"),
        ("<lookat origin=\"0 0 0\" target=\"1 1 1\" up=\"2 2 2\"/>", "the view looks along its up"),
        ("<lookat target=\"1 1 1\"/>", "<lookat> has no origin"),
        ("<skew x=\"1\"/>", "<skew> is no step of a transform"),
        ("<translate x=\"1e999\"/>", "x is 1e999"),
    ];
    for (step, cause) in told {
        let text =
            format!("<shape type=\"rectangle\"><transform name=\"to_world\">\n{step}\n</transform></shape>");
        is_refused(inside(&text), 3, cause);
    }
    let no_transform = "<shape type=\"rectangle\">\n<float name=\"to_world\" value=\"1\"/></shape>";
    is_refused(inside(no_transform), 3, "to_world is a <float>");
}

#[test]
fn groups_are_placed_by_instances() {
    let text = "<shape type=\"instance\" id=\"i\"><ref id=\"group\"/><transform name=\"to_world\"><translate z=\"1\"/></transform></shape>\n\
                <shape type=\"shapegroup\" id=\"group\">\n<shape type=\"sphere\" id=\"ball\"><float name=\"radius\" value=\"2\"/>\
                <transform name=\"to_world\"><translate x=\"1\"/></transform></shape><shape type=\"disk\"/></shape>\n\
                <shape type=\"instance\"><ref id=\"group\"/></shape>";
    let model = right(text);
    let names: Vec<&str> = model.surfaces.iter().map(|surface| surface.name.as_str()).collect();
    assert_eq!(names, ["ball", "disk-2", "ball-2", "disk-4"]);
    let center = DVec3::new(1.0, 0.0, 1.0);
    assert_eq!(named(&model, "ball").shape, Shape::Sphere { center, radius: 2.0, inward: false });
    assert!(model.notes.is_empty(), "{:?}", model.notes);
    is_refused(
        inside("<shape type=\"instance\"><ref id=\"a\"/></shape>\n<shape type=\"disk\" id=\"a\"/>"),
        2,
        "something else than a shapegroup",
    );
    let inner = "<shape type=\"shapegroup\" id=\"a\">\n<shape type=\"instance\"><ref id=\"a\"/></shape></shape><shape type=\"instance\"><ref id=\"a\"/></shape>";
    is_refused(inside(inner), 3, "a shapegroup holds an instance");
}

#[test]
fn shapes_that_are_not_known_are_noted() {
    let model = right(
        "<shape type=\"disk\"/><shape type=\"serialized\"><integer name=\"shape_index\" value=\"1\"/></shape>\
                       <shape type=\"serialized\"/><shape type=\"sdfgrid\"/>",
    );
    let told =
        [("shapes of type 'serialized' are left out", 2), ("shapes of type 'sdfgrid' are left out", 1)];
    assert_eq!(notes(&model), told);
    let lone = inside("<shape type=\"serialized\"/>").expect_err("there is no known shape");
    assert!(lone.cause.contains("no shapes") && !lone.cure.is_empty());
}

#[test]
fn meshes_are_named_by_their_files() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
               element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
    let text = "<shape type=\"ply\"><string name=\"filename\" value=\"a/square.ply\"/></shape>\n\
                <shape type=\"ply\"><string name=\"filename\" value=\"a/square.ply\"/><boolean name=\"flip_normals\" value=\"true\"/></shape>";
    let model = beside(text, &[("a/square.ply", ply)]).expect("the squares are right");
    assert_eq!(polygon(named(&model, "square")), DVec3::Z);
    assert_eq!(polygon(named(&model, "square-2")), -DVec3::Z);
    is_refused(beside(text, &[]), 2, "the mesh 'a/square.ply' cannot be read");
    is_refused(beside("\n<shape type=\"obj\"/>", &[]), 3, "the shape names no file");
    let broken = beside(text, &[("a/square.ply", "ply\nfor")]).expect_err("the mesh is broken");
    assert_eq!(broken.file, "a/square.ply");
}
