//! Whole solutions with closed forms, or spectrally converged, through the command.
//!
//! The references of plates and disks were computed by a Nyström method to 1e-15; the others are exact: in a
//! sphere the irradiance is one number, in a closed room of one reflectance B = 1/(1 − ρ).

use radiosity_geom::DVec3;
use radiosity_test_support::folders::folder;

use crate::program::{fed, succeeded};

/// Radiosity at points with the normals of the surfaces they lie on, from the polynomials, by
/// `radiosity probe`.
fn radiosity(scene: &str, order: usize, eps: &str, places: &[(DVec3, DVec3)]) -> Vec<f64> {
    radiosity_with(&[], scene, order, eps, places)
}

/// Radiosity as by [`radiosity`], with further options of the command.
fn radiosity_with(
    options: &[&str],
    scene: &str,
    order: usize,
    eps: &str,
    places: &[(DVec3, DVec3)],
) -> Vec<f64> {
    let folder = folder(&[("case.toml", format!("bands = [\"grey\"]\n{scene}"))]);
    let order = order.to_string();
    let args = ["probe", "case.toml", "--points", "-", "--read", "basis", "--subdivide", "1", "--eps", eps];
    let lines = places.iter().map(|(x, n)| format!("{},{},{},{},{},{}\n", x.x, x.y, x.z, n.x, n.y, n.z));
    let args = [&args[..], &["--order", &order], options].concat();
    let [table, _] = succeeded(fed(folder.path(), &args, &lines.collect::<String>()));
    let last = |line: &str| line.rsplit(',').next().and_then(|number| number.parse().ok());
    let found: Vec<f64> = table.lines().skip(1).map(|line| last(line).expect("on a surface")).collect();
    assert_eq!(found.len(), places.len());
    found
}

#[track_caller]
fn assert_close(found: &[f64], exact: &[f64]) {
    for (found, exact) in found.iter().zip(exact) {
        assert!((found / exact - 1.0).abs() <= 1e-6, "{found} instead of {exact}");
    }
}

/// A point of a sphere about the origin and the normal of its inside.
fn inside(radius: f64, z: f64, angle: f64) -> (DVec3, DVec3) {
    let across = (1.0 - z * z).sqrt();
    let outward = DVec3::new(across * angle.cos(), across * angle.sin(), z);
    (radius * outward, -outward)
}

#[test]
fn zones_of_a_sphere_get_the_same_light() {
    let zones = |radius: f64, cut: f64, reflectance: [f64; 2], emission: [f64; 2], exact: [f64; 2]| {
        let scene = format!(
            "[materials.low]\nreflectance = {}\nemission = {}\n[materials.high]\nreflectance = {}\nemission = {}
             [[surfaces]]\nmaterial = 'low'\nflip = true
             sphere = {{ center = [0, 0, 0], radius = {radius}, z = [{}, {cut}] }}
             [[surfaces]]\nmaterial = 'high'\nflip = true
             sphere = {{ center = [0, 0, 0], radius = {radius}, z = [{cut}, {radius}] }}",
            reflectance[0], emission[0], reflectance[1], emission[1], -radius
        );
        let places = [-0.95, -0.3, 0.85, 0.99].map(|z| inside(radius, z, 2.0 + z));
        assert_close(&radiosity(&scene, 2, "1e-6", &places), &[exact[0], exact[0], exact[1], exact[1]]);
    };
    zones(1.0, 0.0, [0.5, 0.5], [1.0, 0.0], [1.5, 0.5]);
    zones(2.0, 1.6, [0.7, 0.2], [0.0, 10.0], [2.0, 74.0 / 7.0]);
}

#[test]
fn concentric_spheres_exchange_and_the_inner_one_blocks() {
    let scene = "[materials.inner]\nreflectance = 0.3\nemission = 1\n[materials.outer]\nreflectance = 0.6
                 [[surfaces]]\nmaterial = 'inner'\nsphere = { center = [0, 0, 0], radius = 0.5 }
                 [[surfaces]]\nmaterial = 'outer'\nflip = true\nsphere = { center = [0, 0, 0], radius = 1 }";
    let (position, inward) = inside(0.5, 0.2, 1.0);
    let places = [(position, -inward), inside(1.0, -0.4, 3.0)];
    assert_close(&radiosity(scene, 0, "1e-5", &places), &[1.089_108_910_891_089_2, 0.297_029_702_970_297]);
}

#[test]
fn a_can_is_a_furnace() {
    for (reflectance, exact) in [(0.5, 2.0), (0.9, 10.0)] {
        let scene = format!(
            "[materials.white]\nreflectance = {reflectance}\nemission = 1
             [[surfaces]]\nmaterial = 'white'\nflip = true
             cylinder = {{ base = [0, 0, 0], axis = [0, 0, 1], radius = 1 }}
             [[surfaces]]\nmaterial = 'white'\ndisk = {{ center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }}
             [[surfaces]]\nmaterial = 'white'\ndisk = {{ center = [0, 0, 1], normal = [0, 0, -1], radius = 1 }}"
        );
        let places = [
            (DVec3::new(0.6, 0.8, 0.3), DVec3::new(-0.6, -0.8, 0.0)),
            (DVec3::new(0.3, 0.1, 0.0), DVec3::Z),
            (DVec3::new(-0.2, 0.7, 1.0), -DVec3::Z),
        ];
        // Nothing stands in a can: rays would be cast to --shadow-eps only.
        assert_close(&radiosity_with(&["--shadows", "off"], &scene, 1, "1e-8", &places), &[exact; 3]);
    }
}

/// The points (x, y) of two surfaces that face each other across a distance of 1.
fn opposed(points: &[[f64; 2]]) -> Vec<(DVec3, DVec3)> {
    let at = |z: f64, n: DVec3| points.iter().map(move |[x, y]| (DVec3::new(*x, *y, z), n));
    at(0.0, DVec3::Z).chain(at(1.0, -DVec3::Z)).collect()
}

#[test]
fn parallel_plates_have_the_radiosity_of_the_reference() {
    let scene = "[materials.warm]\nreflectance = 0.5\nemission = 1\n[materials.cold]\nreflectance = 0.5
         [[surfaces]]\nmaterial = 'warm'\nparallelogram = { origin = [0, 0, 0], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }
         [[surfaces]]\nmaterial = 'cold'\nflip = true
         parallelogram = { origin = [0, 0, 1], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }";
    let points = [[0.0, 0.0], [0.5, 0.0], [0.5, 0.5], [1.0, 1.0], [0.25, 1.0 / 3.0]];
    let exact = [
        1.007_006_348_356_019,
        1.009_191_215_807_359,
        1.012_326_762_963_578_4,
        1.007_006_348_356_019,
        1.011_076_387_159_194,
        0.069_975_044_789_025_66,
        0.091_115_016_656_157_84,
        0.120_976_802_028_842_37,
        0.069_975_044_789_025_64,
        0.109_177_051_541_376_47,
    ];
    assert_close(&radiosity(scene, 12, "1e-8", &opposed(&points)), &exact);
}

#[test]
fn coaxial_disks_have_the_radiosity_of_the_reference() {
    let scene = "[materials.warm]\nreflectance = 0.5\nemission = 1\n[materials.cold]\nreflectance = 0.8
         [[surfaces]]\nmaterial = 'warm'\ndisk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }
         [[surfaces]]\nmaterial = 'cold'\ndisk = { center = [0, 0, 1], normal = [0, 0, -1], radius = 1 }";
    let points = [0.0, 0.25, 0.5, 0.75, 1.0].map(|radius| [0.6 * radius, 0.8 * radius]);
    let exact = [
        1.087_019_715_346_179,
        1.083_735_825_796_408_7,
        1.074_363_380_852_882_5,
        1.060_481_337_343_447_2,
        1.044_878_249_226_698_6,
        0.427_571_610_132_654,
        0.414_016_160_686_808_8,
        0.373_879_936_523_440_3,
        0.310_759_963_724_044_6,
        0.235_223_548_052_253_98,
    ];
    assert_close(&radiosity(scene, 12, "1e-8", &opposed(&points)), &exact);
}
