//! Cameras.

use glam::DVec3;
use radiosity_formats::model::Camera;

use super::{inside, is_refused, notes, right, to_world};

/// The camera with properties in a scene.
fn camera(properties: &str) -> Camera {
    let model = right(&format!("<sensor type=\"perspective\">{properties}</sensor><shape type=\"disk\"/>"));
    assert!(model.notes.is_empty(), "{:?}", model.notes);
    model.camera.expect("there is a camera")
}

fn film(width: u32, height: u32) -> String {
    format!(
        "<film type=\"hdrfilm\"><integer name=\"width\" value=\"{width}\"/><integer name=\"height\" value=\"{height}\"/></film>"
    )
}

#[test]
fn a_camera_looks_at_its_target() {
    let view = "<lookat origin=\"1, -2, 3\" target=\"1, 8, 3\" up=\"0, 1, 1\"/>";
    let found = camera(&to_world(view));
    assert_eq!((found.eye, found.target), (DVec3::new(1.0, -2.0, 3.0), DVec3::new(1.0, -1.0, 3.0)));
    assert!((found.up - DVec3::Z).length() < 1e-12 && found.size.is_none());
    let plain = camera("");
    assert_eq!((plain.eye, plain.target, plain.up), (DVec3::ZERO, DVec3::Z, DVec3::Y));
}

/// tan of half the angle over that of the other axis is the aspect; 36 mm × 24 mm at 50 mm is 46.8° on the
/// diagonal.
#[test]
fn angles_become_those_from_the_lower_to_the_upper_border() {
    let fov = |properties: &str, width, height| camera(&(film(width, height) + properties)).fov;
    let axis = |name: &str| {
        format!("<float name=\"fov\" value=\"90\"/><string name=\"fov_axis\" value=\"{name}\"/>")
    };
    let angle = |half: f64| 2.0 * half.atan().to_degrees();
    let told = [
        ("x", 200, 100, angle(0.5)),
        ("y", 200, 100, 90.0),
        ("smaller", 200, 100, 90.0),
        ("larger", 200, 100, angle(0.5)),
        ("smaller", 100, 200, angle(2.0)),
        ("larger", 100, 200, 90.0),
        ("diagonal", 300, 400, angle(0.8)),
        ("X", 100, 100, 90.0),
    ];
    for (name, width, height, expected) in told {
        let found = fov(&axis(name), width, height);
        assert!((found - expected).abs() < 1e-9, "{name}: {found} instead of {expected}");
    }
    let usual = fov("<float name=\"fov\" value=\"90\"/>", 400, 300);
    assert!((usual - angle(0.75)).abs() < 1e-9);
    for length in ["", "<string name=\"focal_length\" value=\"50mm\"/>"] {
        assert!((fov(length, 36, 24) - angle(12.0 / 50.0)).abs() < 1e-9);
    }
    // Without a film a picture has 768 × 576 pixels.
    assert!((camera("<float name=\"fov\" value=\"90\"/>").fov - angle(0.75)).abs() < 1e-9);
    assert_eq!(camera(&film(640, 480)).size, Some([640, 480]));
}

#[test]
fn other_sensors_are_noted() {
    let model = right(
        "<sensor type=\"orthographic\"/><sensor type=\"thinlens\"><float name=\"aperture_radius\" value=\"1\"/></sensor>\
                       <sensor type=\"perspective\"/><shape type=\"disk\"/>",
    );
    assert!(model.camera.is_some());
    let told = [
        ("sensors of type 'orthographic' are left out", 1),
        ("the lens of the camera is left out", 1),
        ("cameras after the first are left out", 1),
    ];
    assert_eq!(notes(&model), told);
}

#[test]
fn broken_cameras_are_refused() {
    let told = [
        ("<float name=\"fov\" value=\"180\"/>", "fov is 180"),
        ("<float name=\"fov\" value=\"-1\"/>", "fov is -1"),
        ("<float name=\"fov\" value=\"9\"/><string name=\"fov_axis\" value=\"z\"/>", "fov_axis is 'z'"),
        ("<string name=\"focal_length\" value=\"0mm\"/>", "focal_length is not above 0"),
        ("<string name=\"focal_length\" value=\"far\"/>", "focal_length is 'far'"),
        ("<film type=\"hdrfilm\"><integer name=\"width\" value=\"0\"/></film>", "the width of the film is 0"),
        (
            "<film type=\"hdrfilm\"><integer name=\"height\" value=\"1.5\"/></film>",
            "the height of the film is 1.5",
        ),
        ("<transform name=\"to_world\"><scale z=\"0\"/></transform>", "leaves the camera no direction"),
    ];
    for (text, cause) in told {
        is_refused(
            inside(&format!("<sensor type=\"perspective\">{text}</sensor><shape type=\"disk\"/>")),
            2,
            cause,
        );
    }
}
