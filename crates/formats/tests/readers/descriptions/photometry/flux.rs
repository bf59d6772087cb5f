//! Flux against closed forms, and against the table that is integrated otherwise.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use radiosity_photometry::Photometry;
use radiosity_photometry::{eulumdat, ies};

use super::direction;
use super::texts::{Eulumdat, Ies, Intensity, steps};

const TEST: &str = "IESNA:LM-63-2002\n[TEST] 1\n[LUMINAIRE] Test lamp\nTILT=NONE";

/// A plain downward table of 100 cd straight down.
fn plain(gammas: Vec<f64>, planes: Vec<f64>, intensity: Intensity) -> Ies {
    let (lumens, multiplier, divisor, ballast) = (1000.0, 1.0, 1.0, [1.0, 1.0]);
    Ies { header: TEST, lumens, multiplier, ballast, gammas, planes, intensity, divisor }
}

fn read(text: &str) -> Photometry {
    ies::read("lamp.ies", text.as_bytes()).unwrap_or_else(|refusal| panic!("{refusal}: {text}"))
}

/// Relative difference of `found` from `expected`.
fn off(found: f64, expected: f64) -> f64 {
    (found - expected).abs() / expected
}

fn lambertian(direction: DVec3) -> f64 {
    -100.0 * direction.z
}

/// I = I₀ cos γ has the flux π I₀; linear interpolation is of second order.
#[test]
fn a_lambertian_table_tends_to_its_flux_by_the_square_of_the_step() {
    let found =
        [9, 18, 36, 72].map(|count| read(&plain(steps(0.0, 90.0, count), vec![0.0], lambertian).text()));
    let errors = found.map(|lamp| off(lamp.flux(), 100.0 * PI));
    assert!(errors[1] < 1e-3, "{errors:?}");
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.02, "{errors:?}");
    }
}

/// A zone of I₀ cos γ sends π I₀ (sin² γ₂ − sin² γ₁), also where the zone ends between angles of the table,
/// and zones add up.
#[test]
fn zones_have_their_part_of_the_flux() {
    let lamp = read(&plain(steps(0.0, 90.0, 900), vec![0.0], lambertian).text());
    for [least, most] in [[0.0_f64, 90.0_f64], [0.0, 33.33], [33.33, 33.37], [33.33, 71.0], [71.0, 180.0]] {
        let [low, high] = [least, most.min(90.0)].map(|gamma| gamma.to_radians().sin().powi(2));
        assert!(off(lamp.flux_between(least, most), 100.0 * PI * (high - low)) < 1e-6, "{least} {most}");
    }
    let parts: f64 =
        [[0.0, 12.3], [12.3, 45.0], [45.0, 180.0]].map(|[a, b]| lamp.flux_between(a, b)).iter().sum();
    assert!(off(parts, lamp.flux()) < 1e-13);
    assert_eq!(lamp.flux_between(90.0, 180.0), 0.0);
}

/// The range of a table over a zone holds every intensity in it; its scale is what the steepest step says:
/// from 100 to 50 cd within 10°.
#[test]
fn ranges_hold_what_is_between_and_scales_the_steepest_step() {
    let text =
        "TILT=NONE\n1 -1 1 4 3 1 2 0 0 0 1 1 1 0 10 60 90 0 90 180 100 50 40 0 100 80 60 20 100 70 60 10";
    let web = read(text).web;
    for (least, most) in [(0.0, 5.0), (3.0, 42.0), (10.0, 10.0), (61.0, 90.0), (80.0, 130.0)] {
        let [low, high] = web.range(least, most);
        for (c, part) in
            (0..36).flat_map(|c| (0..=20).map(move |part| (f64::from(10 * c), f64::from(part) / 20.0)))
        {
            let value = web.at(c, least + part * (most - least));
            assert!(low <= value && value <= high, "{least} {most} {c}: {value}");
        }
    }
    assert!(off(web.scale(0.0, 90.0), 20.0) < 1e-12, "{}", web.scale(0.0, 90.0));
    // Cut off at its end, where it is not dark.
    assert_eq!(web.scale(0.0, 180.0), 0.0);
}

/// Intensities are exact at nodes, within h²/8 of the cosine between them, and 0 above.
#[test]
fn intensities_follow_the_cosine() {
    let lamp = read(&plain(steps(0.0, 90.0, 90), vec![0.0], lambertian).text());
    for index in 0..=360 {
        let (c, gamma) = (f64::from(index * 37), f64::from(index) / 4.0);
        let exact = 100.0 * gamma.to_radians().cos();
        let allowed = if index % 4 == 0 { 1e-8 } else { 100.0 * 1f64.to_radians().powi(2) / 8.0 };
        let found = lamp.intensity(3.0 * direction(c, gamma));
        assert!((found - exact).abs() <= allowed, "{gamma}: {found} instead of {exact}");
    }
    assert_eq!(lamp.intensity(direction(0.0, 90.1)), 0.0);
    assert!((lamp.largest() - 100.0).abs() < 1e-8);
}

/// Tables of two angles, by hand: 4π; 2π (1 − 2/π); and twice the same over half the planes.
#[test]
fn small_tables_have_the_flux_of_the_closed_form() {
    let two = |angles: &str, planes: &str, values: &str| {
        let count = planes.split_whitespace().count();
        read(&format!("TILT=NONE\n1 -1 1 2 {count} 1 2 0 0 0 1 1 1 {angles} {planes} {values}")).flux()
    };
    assert!(off(two("0 180", "0", "1 1"), 4.0 * PI) < 1e-14);
    assert!(off(two("0 90", "0", "1 0"), TAU * (1.0 - 2.0 / PI)) < 1e-14);
    // From 1 in the plane C0 to 0 in C180 and back: half on the mean.
    assert!(off(two("0 180", "0 180", "1 1 0 0"), 2.0 * PI) < 1e-14);
    assert!(off(two("0 90", "0 90", "1 0 1 0"), TAU * (1.0 - 2.0 / PI)) < 1e-14);
}

/// The flux is the integral of the intensity, whatever the spacing: midpoints of fine cells agree with it.
#[test]
fn the_flux_is_the_integral_of_the_intensity() {
    let text = "TILT=NONE\n1 -1 1 4 5 1 2 0 0 0 1 1 1\n0 13 71.5 125\n0 17 101 220.5 301\n\
                5 7 1 0\n5 9 0 2\n5 3 3 3\n5 11 4 1\n5 1 8 0\n";
    let lamp = read(text);
    let (rows, columns) = (1800, 720);
    let (along, across) = (180.0 / f64::from(rows), 360.0 / f64::from(columns));
    let mut sum = 0.0;
    for row in 0..rows {
        let gamma = (f64::from(row) + 0.5) * along;
        let ring: f64 = (0..columns)
            .map(|column| lamp.intensity(direction((f64::from(column) + 0.5) * across, gamma)))
            .sum();
        sum += ring * gamma.to_radians().sin();
    }
    let integral = sum * along.to_radians() * across.to_radians();
    assert!(off(lamp.flux(), integral) < 1e-5, "{} instead of {integral}", lamp.flux());
}

/// Planes stand where their angles say, from x over y: the frame's own axes rotate C only.
#[test]
fn planes_stand_around_the_vertical_from_x_over_y() {
    let text = "TILT=NONE\n1 -1 1 2 4 1 2 0 0 0 1 1 1\n0 90\n0 90 180 270\n0 1\n0 2\n0 3\n0 4\n";
    let lamp = read(text);
    for (axis, value) in [(DVec3::X, 1.0), (DVec3::Y, 2.0), (-DVec3::X, 3.0), (-DVec3::Y, 4.0)] {
        assert!((lamp.intensity(axis) - value).abs() < 1e-12, "{axis}");
    }
    assert!((lamp.intensity(DVec3::new(1.0, -1.0, 0.0)) - 2.5).abs() < 1e-12);
    assert_eq!(lamp.intensity(-DVec3::Z), 0.0);
}

/// A fourth power of the cosine: 2π I₀ / 5.
fn spot(direction: DVec3) -> f64 {
    2000.0 * direction.z.min(0.0).powi(4)
}

/// I₀ cos γ (1 + 4 sin² γ): 2π I₀ (½ + 4 · ¼).
fn batwing(direction: DVec3) -> f64 {
    200.0 * -direction.z * (1.0 + 4.0 * direction.truncate().length_squared())
}

/// I₀ cos γ (1 + 0.8 sin γ cos C): π I₀, the rest cancels around the vertical.
fn street(direction: DVec3) -> f64 {
    500.0 * -direction.z * (1.0 + 0.8 * direction.x)
}

fn wall_washer(direction: DVec3) -> f64 {
    500.0 * -direction.z * (1.0 + 0.8 * direction.y)
}

fn askew(direction: DVec3) -> f64 {
    500.0 * -direction.z * (1.0 + 0.5 * direction.x + 0.6 * direction.y)
}

/// I₀ |cos γ| upwards: π I₀.
fn uplight(direction: DVec3) -> f64 {
    300.0 * direction.z
}

/// A thin tube along x: I₀ times the sine of the angle to it, π² I₀.
fn tube(direction: DVec3) -> f64 {
    250.0 * (1.0 - direction.x * direction.x).sqrt()
}

/// A thin tube along y, as EULUMDAT has it: I₀ times the sine of the angle to it, π² I₀.
fn tube_along_y(direction: DVec3) -> f64 {
    250.0 * (1.0 - direction.y * direction.y).sqrt()
}

fn agrees(lamp: &Photometry, intensity: Intensity, flux: f64) {
    assert!(off(lamp.flux(), flux) < 1e-3, "{}: {} instead of {flux}", lamp.name, lamp.flux());
    assert!(lamp.notes.is_empty(), "{:?}", lamp.notes);
    for (c, gamma) in
        [(0.0, 30.0), (30.0, 60.0), (120.0, 45.0), (210.0, 120.0), (315.0, 150.0), (60.0, 105.0)]
    {
        let (found, exact) = (lamp.intensity(direction(c, gamma)), intensity(direction(c, gamma)).max(0.0));
        assert!((found - exact).abs() < 1e-4 * lamp.largest(), "{}: {found} instead of {exact}", lamp.name);
    }
}

/// Editions, ranges of angles and factors of LM-63: flux and intensities to the interpolation's error.
#[test]
fn tables_of_lm_63_keep_the_energy() {
    let down = || steps(0.0, 90.0, 36);
    let all = || steps(0.0, 180.0, 72);
    let around = |end: f64| steps(0.0, end, (end / 15.0) as usize);
    let absolute = Ies {
        header: "IES:LM-63-2019\n[TEST] 2\n[LUMINAIRE] LED spot\nTILT=NONE",
        lumens: -1.0,
        ballast: [1.0, 1.1],
        ..plain(steps(0.0, 90.0, 90), vec![0.0], spot)
    };
    let batwings = Ies {
        header: "IESNA:LM-63-1995\n[LUMINAIRE] Batwing\nTILT=NONE",
        multiplier: 3.0,
        divisor: 3.0,
        ..plain(down(), around(90.0), batwing)
    };
    let uplights = Ies {
        header: "IESNA91\n[LUMINAIRE] Uplight\nTILT=NONE",
        ballast: [0.9, 0.5],
        divisor: 0.45,
        ..plain(steps(90.0, 180.0, 36), vec![0.0], uplight)
    };
    let tubes = Ies { header: "A tube of 1987\nTILT=NONE", ..plain(all(), around(90.0), tube) };
    for (file, flux) in [
        (absolute, 2000.0 * TAU / 5.0),
        (batwings, 200.0 * TAU * 1.5),
        (plain(down(), around(180.0), street), 500.0 * PI),
        (uplights, 300.0 * PI),
        (tubes, 250.0 * PI * PI),
        (plain(down(), steps(90.0, 270.0, 12), wall_washer), 500.0 * PI),
        (plain(down(), around(360.0), askew), 500.0 * PI),
        (plain(down(), steps(0.0, 345.0, 23), askew), 500.0 * PI),
    ] {
        let lamp = read(&file.text());
        agrees(&lamp, file.intensity, flux);
        assert_eq!(lamp.lamp_flux, (file.lumens > 0.0).then_some(file.lumens));
    }
}

/// The symmetries of EULUMDAT: flux is lamps' flux times output ratio.
#[test]
fn tables_of_eulumdat_keep_the_energy() {
    let all = steps(0.0, 345.0, 23);
    let quarter = steps(0.0, 90.0, 6);
    for (isym, stated, intensity, flux) in [
        (0, all.clone(), askew as Intensity, 500.0 * PI),
        (1, vec![0.0], spot, 2000.0 * TAU / 5.0),
        (2, steps(0.0, 180.0, 12), street, 500.0 * PI),
        (3, steps(-90.0, 90.0, 12), wall_washer, 500.0 * PI),
        (4, quarter.clone(), batwing, 300.0 * TAU),
        (4, quarter.clone(), tube_along_y, 250.0 * PI * PI),
    ] {
        let output_ratio = 0.72;
        let file = Eulumdat {
            isym,
            planes: all.clone(),
            stated,
            gammas: steps(0.0, 180.0, 144),
            flux: flux / output_ratio,
            output_ratio,
            intensity,
        };
        let lamp = eulumdat::read("lamp.ldt", file.text().as_bytes()).expect("the file is right");
        agrees(&lamp, intensity, flux);
        let stated = lamp.stated_flux.expect("lamps and ratio are stated");
        assert!(off(lamp.flux(), stated) < 1e-3, "{isym}");
        assert!(off(lamp.lamp_flux.expect("it is relative"), flux / output_ratio) < 1e-9);
    }
}
