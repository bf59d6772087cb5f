//! The light of skies and the sun through openings, against closed forms.

use std::f64::consts::PI;
use std::sync::Arc;

use radiosity::Work;
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::{Radiance, Scene};
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::solve::{Failure, Options, Transport, solve};
use radiosity::visibility::Shadows;
use radiosity_geom::DVec3 as V;
use radiosity_test_support::direct::in_the_open;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::outcome_of;

/// A point in the middle of a box of openings, under this sky. What the box has below is the ground.
fn open_air(sky: &str) -> Scene {
    let text = format!(
        "bands = [\"lm\"]\n[sky]\n{sky}\n[materials.air]\nreflectance = 0\n[[surfaces]]\nname = \"air\"\nmaterial = \"air\"\n\
         opening = true\nbox = {{ origin = [-1, -1, -1], size = [2, 2, 2], inward = true }}\n"
    );
    typed(&text)
}

/// Direct light at a point of the open for each normal, to this accuracy.
fn direct(scene: &Scene, x: V, normals: &[V], eps: f64) -> Vec<f64> {
    direct_by(scene, &Options::default(), x, normals, eps)
}

/// Direct irradiance as by [`direct`], with other options.
fn direct_by(scene: &Scene, options: &Options, x: V, normals: &[V], eps: f64) -> Vec<f64> {
    let points: Vec<(V, V)> = normals.iter().map(|normal| (x, *normal)).collect();
    in_the_open(scene, options, &points, eps)
}

#[track_caller]
fn close(found: f64, exact: f64, error: f64) {
    assert!((found - exact).abs() < error * exact.abs().max(1.0), "{found}, not {exact}");
}

const WAYS: [V; 4] = [V::Z, V::X, V::new(-0.6, 0.8, 0.0), V::new(0.0, 0.0, -1.0)];

/// A uniform sky of the radiance L gives level ground π L and a wall π L / 2, and the ground of the
/// reflectance ρ sends it ρ π L / 2 more, and the ceiling ρ π L.
#[test]
fn a_uniform_sky_gives_a_wall_half() {
    let scene = open_air("model = \"uniform\"\nilluminance = 1000\nground = 0.3");
    let found = direct(&scene, V::new(0.1, 0.2, 0.0), &WAYS, 1e-5);
    for (found, exact) in found.into_iter().zip([1000.0, 650.0, 650.0, 300.0]) {
        close(found, exact, 2e-5);
    }
}

/// Under L = L_z (1 + 2 sin γ)/3 level ground gets ∫ L sin γ dω = 7π L_z/9, and a wall
/// ∫∫ L cos²γ cos α dγ dα = 2 L_z/3 (π/4 + 2/3) = L_z (π/6 + 4/9)  (P. Moon, D. Spencer, 1942).
#[test]
fn an_overcast_sky_gives_level_ground_and_walls_their_closed_forms() {
    let scene = open_air("model = \"overcast\"\nilluminance = 1000\nground = 0");
    let zenith = 9.0 * 1000.0 / (7.0 * PI);
    let wall = zenith * (PI / 6.0 + 4.0 / 9.0);
    let found = direct(&scene, V::new(-0.2, 0.1, 0.0), &WAYS, 1e-5);
    for (found, exact) in found.into_iter().zip([1000.0, wall, wall, 0.0]) {
        close(found, exact, 2e-5);
    }
}

/// The sun adds E_n sin h to level ground, and the clear sky is the brighter on its side.
#[test]
fn the_sun_shines_by_its_height() {
    let sky = "model = \"clear\"\nilluminance = 1000\nground = 0\n\
        sun = { elevation = 30, azimuth = 90, illuminance = 5000 }";
    let scene = open_air(sky);
    let east = V::X;
    let found = direct(&scene, V::ZERO, &[V::Z, east, -east, V::Y, -V::Y], 1e-4);
    close(found[0], 1000.0 + 5000.0 * 0.5, 2e-4);
    let sun = 5000.0 * 30.0_f64.to_radians().cos();
    assert!(found[1] - sun > 1.5 * found[2] && found[2] > 50.0, "{found:?}");
    // North and south see the same half of the sky each.
    close(found[3], found[4], 5e-4);
}

/// A room of this reflectance with a table in it and this opening in its ceiling or wall.
fn room(sky: &str, opening: &str) -> Scene {
    let text = format!(
        r#"
        bands = ["lm"]
        {sky}
        [materials.wall]
        reflectance = 0.5
        [materials.glass]
        reflectance = 0.1
        [materials.panel]
        reflectance = 0.1
        emission = 1000
        [[surfaces]]
        name = "room"
        material = "wall"
        box = {{ origin = [0, 0, 0], size = [4, 5, 3], inward = true, open = ["top", "left"] }}
        [[surfaces]]
        name = "ceiling"
        material = "wall"
        quad = {{ vertices = [[0, 0, 3], [0, 5, 3], [4, 5, 3], [4, 0, 3]], holes = [[[1, 1, 3], [1, 3, 3], [2, 3, 3], [2, 1, 3]]] }}
        [[surfaces]]
        name = "left"
        material = "wall"
        quad = {{ vertices = [[0, 0, 0], [0, 5, 0], [0, 5, 3], [0, 0, 3]], holes = [[[0, 1, 1], [0, 4, 1], [0, 4, 2.5], [0, 1, 2.5]]] }}
        [[surfaces]]
        name = "table"
        material = "wall"
        box = {{ origin = [1, 1, 0.5], size = [1, 1, 0.2] }}
        {opening}
        "#
    );
    typed(&text)
}

const SKYLIGHT: &str = "quad = { vertices = [[1, 1, 3], [1, 3, 3], [2, 3, 3], [2, 1, 3]] }\n[[surfaces]]\nname = \"window\"\n\
    material = \"wall\"\nquad = { vertices = [[0, 1, 1], [0, 4, 1], [0, 4, 2.5], [0, 1, 2.5]] }\n";

const WINDOW: &str = "quad = { vertices = [[0, 1, 1], [0, 4, 1], [0, 4, 2.5], [0, 1, 2.5]] }\n[[surfaces]]\nname = \"skylight\"\n\
    material = \"wall\"\nquad = { vertices = [[1, 1, 3], [1, 3, 3], [2, 3, 3], [2, 1, 3]] }\n";

/// Light at points of the room, and its balance: in, absorbed, lost.
fn readings(scene: &Scene, by: GatherMethod, options: &Options, eps: f64) -> (Vec<f64>, [f64; 3]) {
    let outcome = outcome_of(scene, options);
    let visibility = options.visibility(scene);
    let reader = Reader::by(by, &outcome.solution, &visibility, ReadMode::Gather, eps);
    let points = [
        (V::new(3.0, 3.5, 0.01), V::Z),
        (V::new(1.5, 1.5, 0.71), V::Z),
        (V::new(1.2, 1.2, 0.01), V::Z),
        (V::new(3.99, 2.0, 1.5), -V::X),
    ];
    let value = |(x, n)| reader.gathered(&ReceiverPoint::free(x, n)).expect("it gathers").irradiance[0];
    let checks = outcome.checks;
    let balance = [checks.energy_in, checks.energy_absorbed, checks.energy_lost];
    (points.into_iter().map(value).collect(), balance)
}

/// A skylight sees nothing but sky: under a uniform one it is a diffuse emitter of the exitance E. Direct light has
/// the same closed form. The first bounce takes more cells where there are openings, so that what is reflected agrees
/// as far as the accuracy asked of it goes.
#[test]
fn a_skylight_under_a_uniform_sky_is_a_diffuse_emitter() {
    let sky = "[sky]\nmodel = \"uniform\"\nilluminance = 1000\n";
    let opening =
        format!("[[surfaces]]\nname = \"opening\"\nmaterial = \"glass\"\nopening = true\n{SKYLIGHT}");
    let panel = format!("[[surfaces]]\nname = \"opening\"\nmaterial = \"panel\"\n{SKYLIGHT}");
    let options = Options { shadow_eps: 1e-5, ..Options::default() };
    let rooms = [room(sky, &opening), room("", &panel)];
    let [in_sky, in_panel] = rooms.each_ref().map(|room| {
        let places = [V::new(3.0, 3.5, 0.01), V::new(1.2, 1.2, 0.01), V::new(1.6, 2.4, 2.9)];
        places.map(|x| direct(room, x, &[V::Z, V::new(0.6, 0.0, 0.8)], 1e-4)).concat()
    });
    in_sky.iter().zip(&in_panel).for_each(|(sky, panel)| close(*sky, *panel, 1e-9));
    let [(sky, in_sky), (panel, in_panel)] =
        rooms.each_ref().map(|room| readings(room, GatherMethod::Cells, &options, 1e-3));
    sky.iter().zip(&panel).for_each(|(sky, panel)| close(*sky, *panel, 1e-5));
    in_sky.iter().zip(&in_panel).for_each(|(sky, panel)| close(sky / in_sky[0], panel / in_panel[0], 1e-5));
}

/// Light that comes in through a window is absorbed, and read alike by cells and by rays; so is the sun's.
#[test]
fn a_window_keeps_power_and_its_light_is_read_by_cells_and_by_rays() {
    let sky = "[sky]\nmodel = \"clear\"\nilluminance = 10000\nsun = { elevation = 35, azimuth = 250, illuminance = 50000 }\n";
    let opening = format!(
        "[[surfaces]]\nname = \"opening\"\nmaterial = \"glass\"\nglass = {{ panes = 2, transmittance = 0.78 }}\n{WINDOW}"
    );
    let scene = room(sky, &opening);
    let options = Options::default();
    let (exact, [emitted, absorbed, lost]) = readings(&scene, GatherMethod::Cells, &options, 3e-4);
    close(absorbed + lost, emitted, 1e-9);
    assert!(lost.abs() < 0.01 * emitted, "{lost} of {emitted}");
    // Rays that carry the light err by themselves, where little arrives.
    for (transport, error) in [(Transport::Exact, 0.01), (Transport::Sampled, 0.04)] {
        let (found, _) = readings(&scene, GatherMethod::Rays, &Options { transport, ..options }, 2e-3);
        found.iter().zip(&exact).for_each(|(found, exact)| close(*found, *exact, error));
    }
}

/// The sun lights a patch of the floor, the window moved along its rays, by E_n sin h τ; beside it there is
/// none of it.
#[test]
fn the_patch_of_the_sun_has_sharp_borders() {
    let sky = |sun: f64| {
        format!(
            "[sky]\nmodel = \"overcast\"\nilluminance = 1000\nsun = {{ elevation = 45, azimuth = 270, illuminance = {sun} }}\n"
        )
    };
    let opening = format!("[[surfaces]]\nname = \"opening\"\nmaterial = \"glass\"\nopening = true\n{WINDOW}");
    let at = |sun: f64, x: V| direct(&room(&sky(sun), &opening), x, &[V::Z], 1e-4)[0];
    // The sun is in the west: light from the height z comes down z further east; the window is 1 to 2.5 above
    // the floor.
    let height = 1e-3;
    for (x, lit) in [(0.999, 0.0), (1.001, 1.0), (2.499, 1.0), (2.501, 0.0)] {
        let x = V::new(x - height, 3.5, height);
        // The ground outside reflects the sun as well: it is seen from below the horizon only, and not from
        // the floor.
        close(at(60000.0, x) - at(0.0, x), lit * 60000.0 * 0.5_f64.sqrt(), 1e-3);
    }
}

/// Without shadows the sun shines through the table, but through the window alone; of two windows in a row
/// only the nearer counts, whichever is lit as a group of its own.
#[test]
fn without_shadows_the_sun_passes_all_but_openings() {
    // The sky itself is next to dark.
    let sky = "[sky]\nmodel = \"uniform\"\nilluminance = 1e-4\nground = 0\n\
        sun = { elevation = 45, azimuth = 270, illuminance = 60000 }\n";
    let opening = format!(
        "[[surfaces]]\nname = \"opening\"\nmaterial = \"glass\"\nopening = true\n{WINDOW}[[surfaces]]\nname = \"outer\"\n\
         material = \"glass\"\ngroup = \"outer\"\nopening = true\n\
         quad = {{ vertices = [[-1, 0, 0], [-1, 5, 0], [-1, 5, 9], [-1, 0, 9]] }}\n"
    );
    let [shaded, unshaded] =
        [Shadows::Auto, Shadows::Off].map(|shadows| Options { shadows, ..Options::default() });
    let sunlight = |options: &Options, set: &[(&str, f64)], x: V| {
        let scene = room(sky, &opening).dimmed(set).expect("the group is there");
        direct_by(&scene, options, x, &[V::Z], 1e-3)[0]
    };
    let exact = 60000.0 * 0.5_f64.sqrt();
    let [below, before] = [V::new(1.8, 1.5, 1e-3), V::new(0.5, 3.5, 1e-3)];
    close(sunlight(&shaded, &[], below), 0.0, 1e-3);
    close(sunlight(&unshaded, &[], below), exact, 1e-6);
    close(sunlight(&unshaded, &[("outer", 0.0)], below), exact, 1e-6);
    // Below the window the ray to the sun leaves through the wall, and meets the outer opening.
    close(sunlight(&shaded, &[], before), 0.0, 1e-3);
    close(sunlight(&unshaded, &[], before), exact, 1e-6);
    close(sunlight(&unshaded, &[("outer", 0.0)], before), 0.0, 1e-3);
}

/// Openings of one sky, glass and normal share what they see.
#[test]
fn openings_that_look_alike_share_what_they_see() {
    let pane = |name: &str, y: f64, more: &str| {
        format!(
            "[[surfaces]]\nname = \"{name}\"\nmaterial = \"air\"\n{more}\n\
             parallelogram = {{ origin = [0, {y}, 3], edge1 = [0, 1, 0], edge2 = [1, 0, 0] }}\n"
        )
    };
    let text = format!(
        "bands = [\"lm\"]\n[sky]\nmodel = \"clear\"\nilluminance = 1000\nsun = {{ elevation = 40, azimuth = 10 }}\n\
         [materials.air]\nreflectance = 0\n{}{}{}{}",
        pane("a", 0.0, "opening = true"),
        pane("b", 2.0, "opening = true"),
        pane("glazed", 4.0, "glass = {}"),
        pane("turned", 6.0, "opening = true\nflip = true"),
    );
    let scene = typed(&text);
    let [a, b, glazed, turned] = [0, 1, 2, 3]
        .map(|k| scene.surfaces[k].radiance.as_ref().and_then(Radiance::outlook).expect("an opening"));
    assert!(Arc::ptr_eq(a, b));
    assert!(glazed.exitance()[0] < 0.95 * a.exitance()[0], "{glazed:?}");
    // The ground sends 0.2 of the 1000 lx that it gets up.
    close(a.exitance()[0], 1000.0, 1e-4);
    close(turned.exitance()[0], 200.0, 1e-4);
}

#[test]
fn what_takes_light_for_diffuse_is_refused() {
    let scene = open_air("model = \"overcast\"\nilluminance = 1000");
    let options = Options { direct: radiosity::solve::Direct::Projected, ..Options::default() };
    let refused = solve(&scene, &options, &Work::alone()).expect_err("it is refused");
    assert!(matches!(refused, Failure::NotDiffuse { .. }), "{refused}");
}
