//! Views that are chosen of scenes without a camera.

use radiosity::geom::DVec3;
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::request::view::{View, ViewRequest};
use radiosity::scene::{Camera, Scene};
use radiosity::visibility::Visibility;
use radiosity_test_support::scenes::typed;

/// A room of 6 × 4 × 3, or a box of that size, with `more`.
fn scene(shape: &str, more: &str) -> Scene {
    typed(&format!(
        "materials.wall = {{ reflectance = 0.5 }}\n[[surfaces]]\nname = \"walls\"\nmaterial = \"wall\"\n\
         box = {{ origin = [0, 0, 0], size = [6, 4, 3], {shape} }}\n{more}"
    ))
}

/// A cupboard at the corner where most is seen of the empty room.
const CUPBOARD: &str = "[[surfaces]]\nname = \"cupboard\"\nmaterial = \"wall\"\n\
                        box = { origin = [4.4, 0, 0], size = [1.6, 1.2, 2.6] }\n";

/// The camera of the view, and its eye in the coordinates of the file.
fn chosen(scene: &Scene) -> (Camera, DVec3) {
    let view = View::usual(scene);
    let eye = view.camera.eye + scene.middle;
    assert!(view.told.expect("it is told").starts_with("no camera in the scene: seen from eye "));
    (view.camera, eye)
}

/// Part of 64 rays through a picture that meet fronts.
fn fronts(scene: &Scene, camera: &Camera) -> f64 {
    let (visibility, pinhole) = (Visibility::open(scene), Pinhole::new(camera));
    let place = |k: u32| (f64::from(k) + 0.5) / 8.0 * f64::from(camera.width);
    let rays = (0..64).map(|k| pinhole.ray(place(k % 8), place(k / 8)));
    rays.filter(|ray| visibility.nearest(ray).is_some_and(|met| met.front)).count() as f64 / 64.0
}

#[test]
fn rooms_are_seen_from_a_corner_at_eye_height() {
    let room = scene("inward = true", "");
    let (camera, eye) = chosen(&room);
    assert!((eye - DVec3::new(5.5, 0.3, 1.8)).length() < 0.2, "{eye}");
    let far = camera.target + room.middle;
    assert!(far.x < 1.0 && far.y > 3.0, "it looks to the far corner: {far}");
    assert_eq!(fronts(&room, &camera), 1.0);
}

/// A room that lies on its side is seen as it stands with --view-up.
#[test]
fn up_may_be_another_axis() {
    let room = scene("inward = true", "");
    for (up, axis, sign) in [("0,1,0", 1, 1.0), ("-2,0.1,0", 0, -1.0), ("0,0,-1", 2, -1.0)] {
        let view = ViewRequest { view_up: Some(up.parse().expect("numbers")), ..ViewRequest::default() };
        let View { camera, told } = view.of(&room).expect("there is a view");
        let middle = DVec3::new(3.0, 2.0, 1.5) - room.middle;
        assert!(sign * (camera.eye - middle)[axis] > 0.0, "the eye is above the middle: {}", camera.eye);
        assert_eq!(fronts(&room, &camera), 1.0);
        assert!(told.expect("it is told").contains(", view-up "));
    }
}

#[test]
fn rooms_with_a_missing_wall_are_seen_from_inside() {
    for side in ["left", "right", "front", "back", "top"] {
        let room = scene(&format!("inward = true, open = [\"{side}\"]"), "");
        let (camera, eye) = chosen(&room);
        assert!(eye.cmpgt(DVec3::ZERO).all() && eye.cmplt(DVec3::new(6.0, 4.0, 3.0)).all(), "{side}: {eye}");
        assert!(fronts(&room, &camera) > 0.7, "{side}");
    }
}

#[test]
fn a_cupboard_in_the_corner_is_seen_from_another() {
    let room = scene("inward = true", CUPBOARD);
    let (camera, eye) = chosen(&room);
    assert!(eye.x < 4.4 || eye.y > 1.2, "{eye}");
    assert_eq!(fronts(&room, &camera), 1.0);
}

#[test]
fn things_are_seen_whole_from_above_and_outside() {
    let floor = "[[surfaces]]\nname = \"floor\"\nmaterial = \"wall\"\n\
                 polygon = { vertices = [[-5, -5, 0], [11, -5, 0], [11, 9, 0], [-5, 9, 0]] }\n";
    for more in ["", floor] {
        let thing = scene("inward = false", more);
        let (camera, eye) = chosen(&thing);
        assert!(eye.z > 3.0 && fronts(&thing, &camera) > 0.2, "{eye}");
        let pinhole = Pinhole::new(&camera);
        for corner in 0..8 {
            let part = |axis: usize| f64::from(corner >> axis & 1);
            let corner = DVec3::new(6.0 * part(0), 4.0 * part(1), 3.0 * part(2)) - thing.middle;
            let place = pinhole.place(corner).expect("it lies before the eye");
            assert!(place.iter().all(|x| (0.0..=f64::from(camera.width)).contains(x)), "{place:?}");
        }
    }
}
