//! The light of luminaires that are areas, against closed forms.

use std::f64::consts::PI;

use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::{Scene, Source};
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::solve::{Options, Transport};
use radiosity_geom::DVec3 as V;
use radiosity_test_support::compare::assert_close;
use radiosity_test_support::direct::in_the_open;
use radiosity_test_support::scenes::parsed;
use radiosity_test_support::solved::outcome_of;

use crate::light::tables::ies;

/// A far black ball, and these luminaires, with the photometric file `lamp.ies`.
fn alone(luminaires: &str, table: &str) -> Scene {
    let text = format!(
        "bands = [\"lm\"]\n[materials.black]\nreflectance = 0\n[[surfaces]]\nname = \"ball\"\nmaterial = \"black\"\n\
         sphere = {{ center = [0, 0, -200], radius = 1 }}\n{luminaires}"
    );
    parsed(&Source::new("alone", &text).including("lamp.ies", table))
}

/// An IES file of I₀ cos γ every 1/40 degree, bilinear to 2.4e-8 of I₀, with the flux 1000 lm and this
/// opening: width, length, height in metres.
fn lambertian(opening: &str) -> String {
    let gammas: Vec<f64> = (0..=3600).map(|k| f64::from(k) / 40.0).collect();
    ies(opening, &gammas, |gamma| 1000.0 / PI * gamma.cos().max(0.0))
}

/// Lambert's formula: E of a polygon of exitance 1, all of it above the horizon, its corners clockwise as
/// seen from x.
fn lambert(x: V, n: V, corners: &[V]) -> f64 {
    let side = |k: usize| {
        let [a, b] = [corners[k], corners[(k + 1) % corners.len()]].map(|corner| (corner - x).normalize());
        let across = a.cross(b);
        across.length().atan2(a.dot(b)) * n.dot(across) / across.length()
    };
    ((0..corners.len()).map(side).sum::<f64>() / (2.0 * PI)).abs()
}

/// A Lambertian table on a rectangle is a Lambertian rectangle, also near it: x is along its length of 1.2 m.
#[test]
fn a_lambertian_table_on_a_rectangle_is_a_lambertian_rectangle() {
    let by_file = "[[luminaires]]\nposition = [0, 0, 2]\nphotometry = \"lamp.ies\"\nextent = \"file\"\n";
    let typed = by_file.replace("\"file\"", "[1.2, 0.3]");
    let points = [
        (V::new(0.0, 0.0, 1.0), V::Z),
        (V::new(0.1, -0.05, 1.98), V::Z),
        (V::new(0.55, 0.1, 1.999), V::Z),
        (V::new(0.7, 0.2, 1.5), V::Z),
        (V::new(2.0, 1.0, 0.0), V::new(-2.0, -1.0, 2.0)),
        (V::new(-3.0, 0.0, 1.0), V::X),
    ];
    let corners = [(-0.6, -0.15), (0.6, -0.15), (0.6, 0.15), (-0.6, 0.15)].map(|(x, y)| V::new(x, y, 2.0));
    for entry in [by_file, &typed] {
        let scene = alone(entry, &lambertian("0.3 1.2 0"));
        for (found, (x, n)) in in_the_open(&scene, &Options::default(), &points, 1e-6).into_iter().zip(points)
        {
            assert_close(found, 1000.0 / (1.2 * 0.3) * lambert(x, n.normalize(), &corners), 1e-6);
        }
        // It shines down only, and has no back.
        assert_eq!(in_the_open(&scene, &Options::default(), &[(V::new(0.0, 0.0, 3.0), -V::Z)], 1e-6), [0.0]);
        assert_eq!(scene.surfaces.len(), 2);
    }
}

/// On its axis, a disk of the radius R gives a plane across it at the distance h what its rings of the area
/// 2π ρ dρ give: E = ∫ I₀ cosⁿ⁺¹ γ / r² · 2ρ dρ/R² = 2 I₀ (1 − cosⁿ⁺¹ γ_R) / ((n + 1) R²), cos
/// γ_R = h/√(h² + R²).
fn on_axis(peak: f64, exponent: f64, radius: f64, h: f64) -> f64 {
    let cosine = h / h.hypot(radius);
    2.0 * peak * (1.0 - cosine.powf(exponent + 1.0)) / ((exponent + 1.0) * radius * radius)
}

#[test]
fn disks_give_their_axis_the_closed_form() {
    let radius = 0.3;
    let heights = [0.01, 0.1, 0.5, 2.0, 10.0];
    let points = heights.map(|h| (V::new(0.0, 0.0, 2.0 - h), V::Z));
    for exponent in [0.0, 0.5, 1.0, 2.0, 10.0, 1000.0] {
        let entry = format!(
            "[[luminaires]]\nposition = [0, 0, 2]\nspot = {{ exponent = {exponent} }}\nintensity = 100\nextent = 0.6\n"
        );
        let scene = alone(&entry, "");
        assert_eq!(scene.surfaces.len(), 2, "it has no back");
        let found = in_the_open(&scene, &Options::default(), &points, 1e-5);
        for (found, h) in found.into_iter().zip(heights) {
            let exact = on_axis(100.0, exponent, radius, h);
            assert!((found - exact).abs() < 2e-5 * exact, "exponent {exponent}, {h}: {found}, not {exact}");
        }
    }
}

/// All around the same intensity: both sides shine, each as the closed form of the exponent 0 says.
#[test]
fn both_sides_of_an_area_shine_where_the_intensity_is_all_around() {
    let entry =
        "[[luminaires]]\nname = \"sheet\"\nposition = [0, 0, 2]\npoint = {}\nintensity = 100\nextent = 0.6\n";
    let scene = alone(entry, "");
    let names: Vec<&str> = scene.surfaces.iter().map(|surface| surface.name.as_str()).collect();
    assert_eq!(names, ["ball", "sheet", "sheet:back"]);
    let found = in_the_open(
        &scene,
        &Options::default(),
        &[(V::new(0.0, 0.0, 1.5), V::Z), (V::new(0.0, 0.0, 2.5), -V::Z)],
        1e-5,
    );
    found.into_iter().for_each(|found| assert_close(found, on_axis(100.0, 0.0, 0.3, 0.5), 2e-5));
    let balance = outcome_of(&scene, &Options::default()).checks;
    assert_close(balance.energy_in, 400.0 * PI, 1e-12);
}

/// Irradiance at a point on the axis of a disk, from a spot seen within its rim, is ∫ d cos θ / r² dA = ∫ d
/// sin γ dγ dC: E = I₀ Ω / A, at any distance from which the rim is farther than the edge of the spot.
/// Between the edges it does so off the axis as well.
#[test]
fn the_edge_of_a_spot_is_seen_within_the_area() {
    for extent in ["0.6", "[0.6, 0.6]"] {
        let entry = format!(
            "[[luminaires]]\nposition = [0, 0, 2]\nspot = {{ angle = 20, edge = 1 }}\nintensity = 100\nextent = {extent}\n"
        );
        let scene = alone(&entry, "");
        let factor = scene.luminaires[0].distribution.flux_factor();
        let area = scene.surfaces[1].shape.area();
        let points = [(0.0, 0.0, 0.2), (0.1, 0.03, 0.6), (0.05, 0.0, 1.2), (0.0, 0.0, 1.5)];
        let points = points.map(|(x, y, h)| (V::new(x, y, 2.0 - h), V::Z));
        for (eps, error) in [(1e-3, 3e-3), (1e-4, 3e-4)] {
            for found in in_the_open(&scene, &Options::default(), &points, eps) {
                assert_close(found, 100.0 * factor / area, error);
            }
        }
    }
}

/// A narrow beam meets a point from a small part of a large panel, wherever that is: from all of it comes
/// I₀/A ∫ cosⁿ⁺¹ γ/r² dA, within 1e-6 of that of the whole plane, 2π I₀ / ((n + 1) A).
#[test]
fn narrow_beams_are_not_missed() {
    let entry = "[[luminaires]]\nposition = [0, 0, 2]\nspot = { exponent = 3000 }\nintensity = 100\nextent = [2, 2]\n";
    let scene = alone(entry, "");
    let points =
        [(0.0, 0.0), (0.31, 0.07), (-0.52, 0.43), (0.123, -0.678)].map(|(x, y)| (V::new(x, y, 1.0), V::Z));
    let exact = 2.0 * PI * 100.0 / (3001.0 * 4.0);
    for found in in_the_open(&scene, &Options::default(), &points, 1e-4) {
        assert_close(found, exact, 3e-4);
    }
}

/// Far away an area is a point, with an error that falls like the square of its size over the distance.
#[test]
fn far_away_an_area_is_a_point() {
    let error = |distance: f64| {
        let entry = |extent: &str| {
            format!("[[luminaires]]\nposition = [0, 0, 2]\nphotometry = \"lamp.ies\"\n{extent}\n")
        };
        let table = lambertian("0.6 0.6 0");
        let x = (V::new(0.0, 0.0, 2.0 - distance), V::Z);
        let [area, point] = ["extent = \"file\"", ""]
            .map(|extent| in_the_open(&alone(&entry(extent), &table), &Options::default(), &[x], 1e-7)[0]);
        area / point - 1.0
    };
    let [near, far] = [error(3.0), error(6.0)];
    // E = M/π ∫ h²/r⁴ dA: the mean of 1 − 2 ρ²/h², ρ² = (0.6² + 0.6²)/12 on the mean.
    assert_close(near, -2.0 * 0.06 / 9.0, 0.05);
    assert_close(near / far, 4.0, 0.03);
}

/// A closed room with a crate and a panel of a table with the batwings of an office luminaire.
fn room(extent: &str) -> Scene {
    let gammas: Vec<f64> = (0..=18).map(|k| 5.0 * f64::from(k)).collect();
    let wings = |gamma: f64| 200.0 * (1.0 + 1.5 * (2.0 * gamma).sin().max(0.0)) * gamma.cos().max(0.0);
    let table = ies("0.3 1.2 0", &gammas, wings);
    let text = format!(
        r#"
        bands = ["lm"]
        [materials.wall]
        reflectance = 0.5
        [[surfaces]]
        name = "room"
        material = "wall"
        box = {{ origin = [0, 0, 0], size = [4, 5, 3], inward = true }}
        [[surfaces]]
        name = "crate"
        material = "wall"
        box = {{ origin = [1, 1, 0.5], size = [1, 1, 0.7] }}
        [[luminaires]]
        name = "panel"
        position = [2, 2.5, 2.5]
        photometry = "lamp.ies"
        group = "panel"
        {extent}
        "#
    );
    parsed(&Source::new("room", &text).including("lamp.ies", &table))
}

/// A closed room absorbs what the table states.
#[test]
fn a_closed_room_absorbs_the_flux_of_an_area() {
    let scene = room("extent = \"file\"");
    let flux = scene.luminaires[0].flux(0);
    for transport in [Transport::Exact, Transport::Sampled] {
        let options = Options { transport, shadow_eps: 1e-3, ..Options::default() };
        let checks = outcome_of(&scene, &options).checks;
        assert_close(checks.energy_in, flux, 1e-12);
        assert_close(checks.energy_absorbed + checks.energy_lost, flux, 1e-9);
        assert!(checks.energy_lost.abs() < 5e-3 * flux, "{transport:?} {checks:?}");
    }
}

/// Cells and rays read the same light, in sun and shade, and a group dims it.
#[test]
fn readings_by_cells_and_by_rays_agree() {
    let read = |scene: &Scene, by: GatherMethod| {
        let options = Options::default();
        let outcome = outcome_of(scene, &options);
        let visibility = options.visibility(scene);
        let reader = Reader::by(by, &outcome.solution, &visibility, ReadMode::Gather, 3e-4);
        let points = [
            (V::new(3.0, 3.5, 0.01), V::Z),
            (V::new(1.5, 1.5, 0.01), V::Z),
            (V::new(0.01, 2.0, 1.5), V::X),
            (V::new(2.0, 2.6, 2.4), V::Z),
        ];
        points.map(|(x, n)| reader.gathered(&ReceiverPoint::free(x, n)).expect("it gathers").irradiance[0])
    };
    let scene = room("extent = \"file\"");
    let exact = read(&scene, GatherMethod::Cells);
    for (found, exact) in read(&scene, GatherMethod::Rays).into_iter().zip(exact) {
        assert_close(found, exact, 0.01);
    }
    let dimmed = scene.dimmed(&[("panel", 0.25)]).expect("the group is there");
    for (found, exact) in read(&dimmed, GatherMethod::Cells).into_iter().zip(exact) {
        assert_close(found, 0.25 * exact, 1e-3);
    }
}

/// In motion a luminaire and its area go together, whichever is named: at frame 2 it is where another scene
/// has it at rest.
#[test]
fn areas_move_with_their_luminaires() {
    let entry = |x: f64, more: &str| {
        format!(
            "[[luminaires]]\nname = \"panel\"\nposition = [{x}, 0, 2]\n{more}\nspot = {{ exponent = 4 }}\nintensity = 100\n\
             extent = [0.8, 0.3]\n"
        )
    };
    let still = alone(&entry(0.0, ""), "").source.expect("it was read").text().into_owned();
    // About y by -90 degrees, −z becomes x, and x becomes z.
    let turn = "rotate = { center = [0, 0, 2], axis = [0, 1, 0], angles = [0, -90] }\n";
    let point = [(V::new(1.6, 0.2, 1.9), V::new(-1.0, 0.0, 1.0))];
    for (turn, more) in [("", ""), (turn, "aim = [1, 0, 0]\nalong = [0, 0, 1]")] {
        let exact = in_the_open(&alone(&entry(1.0, more), ""), &Options::default(), &point, 1e-5)[0];
        for named in ["luminaires", "surfaces"] {
            let text = format!(
                "frames = 3\n{still}[[motion]]\n{named} = [\"panel\"]\n{turn}translate = {{ points = [[0, 0, 0], [1, 0, 0]] }}\n"
            );
            let scene = radiosity::language::read(&Source::new("moving", &text))
                .and_then(|own| own.at_frame(2))
                .expect("a frame");
            assert_close(in_the_open(&scene, &Options::default(), &point, 1e-5)[0], exact, 1e-6);
            assert!(exact > 0.0 && scene.luminaires[0].position.distance(V::new(1.0, 0.0, 2.0)) < 1e-12);
        }
    }
}
