//! The light of luminaires against closed forms: the law of inverse squares and cosines, downlights, shadows,
//! power.

use std::f64::consts::PI;

use radiosity::Work;
use radiosity::light::direct::DirectLight;
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::reading::grid::{Rates, grid};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::{Distribution, Luminaire, Material, Scene, SceneBuilder, Source, Strength};
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::solve::{Direct, Options, Transport};
use radiosity::visibility::{Shadows, Visibility};
use radiosity_geom::DVec3;
use radiosity_test_support::direct::ACCURACY;
use radiosity_test_support::scenes::{parsed, typed};
use radiosity_test_support::shapes::{disk, plate};
use radiosity_test_support::solved::{outcome_of, solved_of};
use radiosity_test_support::sources::Sources;

use crate::light::tables::ies;

/// A luminaire of the intensity `peak` at the height `h` above the origin, which aims down.
fn lamp(distribution: Distribution, h: f64, peak: f64) -> Luminaire {
    Luminaire::new("lamp", h * DVec3::Z, distribution, Strength::Intensity(vec![peak])).expect("a lamp")
}

/// A black square floor about the origin with sides of twice this length, and a luminaire.
fn floor(half: f64, luminaire: Luminaire) -> SceneBuilder {
    let mut scene = SceneBuilder::new("floor", ["grey"]);
    let black = scene.material("black", Material::black(1));
    let corner = DVec3::new(-half, -half, 0.0);
    let floor = plate(corner, 2.0 * half * DVec3::X, 2.0 * half * DVec3::Y);
    scene.surface("floor", floor, &black);
    scene.luminaire(luminaire);
    scene
}

/// Direct light at points of the floor, surface 0, or in the open, for their normals.
fn direct(scene: &Scene, points: &[(DVec3, DVec3)]) -> Vec<f64> {
    let visibility = Visibility::new(scene, Shadows::Rays, 3e-3);
    let sources = Sources::of(scene, &visibility);
    let direct = DirectLight::within(&sources.emitters(), &visibility, ACCURACY);
    let read = |(x, n): &(DVec3, DVec3)| {
        let receiver = if x.z == 0.0 { ReceiverPoint::on(0, *x, *n) } else { ReceiverPoint::free(*x, *n) };
        direct.irradiance(&receiver, &direct.around(&receiver.site()))[0]
    };
    points.iter().map(read).collect()
}

/// E(r) = I₀ hⁿ⁺¹ / (h² + r²)^((n + 3)/2) on a plane below, since cos γ = cos θ = h/√(h² + r²).
fn downlight(peak: f64, exponent: f64, h: f64, r: f64) -> f64 {
    peak * h.powf(exponent + 1.0) / (h * h + r * r).powf(0.5 * (exponent + 3.0))
}

#[test]
fn a_downlight_follows_inverse_squares_and_cosines() {
    let (h, peak) = (2.7, 900.0);
    for exponent in [0.0, 1.0, 2.0, 7.5, 60.0] {
        let distribution = Distribution::Power { exponent };
        let scene = floor(10.0, lamp(distribution, h, peak)).build().expect("a scene");
        let radii = [0.0, 0.3, 1.0, 4.0, 9.0];
        let points = radii.map(|r| (DVec3::new(0.6 * r, 0.8 * r, 1e-3), DVec3::Z));
        for (found, r) in direct(&scene, &points).into_iter().zip(radii) {
            let exact = downlight(peak, exponent, h - 1e-3, r);
            assert!((found - exact).abs() < 1e-12 * exact, "exponent {exponent}, {r}: {found}, not {exact}");
        }
    }
}

#[test]
fn a_sensor_that_faces_another_way_takes_its_own_cosine() {
    let scene = floor(3.0, lamp(Distribution::Point, 2.0, 100.0)).build().expect("a scene");
    let x = DVec3::new(1.0, 0.0, 0.5);
    let towards = (2.0 * DVec3::Z - x).normalize();
    let tilted = DVec3::new(-1.0, 0.0, 1.0).normalize();
    let square = (2.0 * DVec3::Z - x).length_squared();
    let found = direct(&scene, &[(x, towards), (x, tilted), (x, -towards)]);
    let exact = [100.0 / square, 100.0 / square * tilted.dot(towards), 0.0];
    assert!(
        found.iter().zip(exact).all(|(found, exact)| (found - exact).abs() < 1e-12 * square),
        "{found:?}"
    );
}

/// On a disk of radius R below a downlight arrives 2π I₀ / (n + 1) · (1 − cosⁿ⁺¹ γ_R).
#[test]
fn the_flux_on_a_disk_below_a_downlight_is_its_closed_form() {
    let (h, radius, peak) = (2.0, 3.0, 50.0);
    for exponent in [0.0, 1.0, 8.0] {
        let mut scene = SceneBuilder::new("disk", ["grey"]);
        let black = scene.material("black", Material::black(1));
        let disk = disk(DVec3::ZERO, DVec3::Z, radius);
        scene.surface("disk", disk, &black);
        scene.luminaire(lamp(Distribution::Power { exponent }, h, peak));
        let scene = scene.build().expect("a scene");
        let outcome = outcome_of(&scene, &Options::default());
        let found = outcome.solution.mean_irradiance(0, 0) * PI * radius * radius;
        let cosine: f64 = h / f64::hypot(h, radius);
        let exact = 2.0 * PI * peak / (exponent + 1.0) * (1.0 - cosine.powf(exponent + 1.0));
        assert!((found - exact).abs() < 1e-4 * exact, "exponent {exponent}: {found}, not {exact}");
        // What misses the disk is lost.
        let checks = outcome.checks;
        let flux = 2.0 * PI * peak / (exponent + 1.0);
        assert!((checks.energy_in - flux).abs() < 1e-12 * flux, "{checks:?}");
        assert!((checks.energy_lost - (flux - found)).abs() < 1e-9 * flux, "{checks:?}");
    }
}

/// Means over cells are read where the direct light is computed anew, too: by points and by rays.
#[test]
fn means_over_cells_are_those_of_the_closed_form() {
    let (h, peak, half) = (1.5, 10.0, 2.0);
    let scene = floor(half, lamp(Distribution::Power { exponent: 1.0 }, h, peak)).build().expect("a scene");
    let outcome = outcome_of(&scene, &Options::default());
    let visibility = Visibility::new(&scene, Shadows::Rays, 3e-3);
    for (read, by, error) in
        [(ReadMode::Direct, GatherMethod::Cells, 1e-5), (ReadMode::Gather, GatherMethod::Rays, 3e-3)]
    {
        let reader = Reader::by(by, &outcome.solution, &visibility, read, 1e-3);
        for cell in grid(&reader, [8, 8], Rates::default(), &Work::alone()) {
            // The mean by a Gauss rule of 3 × 3 points on 4 × 4 parts.
            let side = 2.0 * half / 8.0;
            let (nodes, weights) =
                ([-(0.6_f64.sqrt()), 0.0, 0.6_f64.sqrt()], [5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0]);
            let place = |k: usize| {
                let part = (k / 3) as f64;
                (side * ((part + 0.5 + 0.5 * nodes[k % 3]) / 4.0 - 0.5), weights[k % 3] / 4.0)
            };
            let mut exact = 0.0;
            for ((x, wx), (y, wy)) in
                (0..12).flat_map(|i| (0..12).map(move |j| (i, j))).map(|(i, j)| (place(i), place(j)))
            {
                exact +=
                    wx * wy * downlight(peak, 1.0, h, f64::hypot(cell.position.x + x, cell.position.y + y));
            }
            let found = cell.irradiance[0];
            // Rays are as exact as asked beside the usual light.
            let told = cell.uncertainty.deviation.map_or(0.0, |deviation| 3.0 * deviation.absolute);
            let most = f64::max(error * exact, told);
            assert!((found - exact).abs() < most, "{read:?} {:?}: {found}, not {exact}", cell.index);
        }
    }
}

/// A spot of a sharp edge lights a disk of the radius h tan(angle / 2), and nothing else.
#[test]
fn a_spot_ends_at_its_edge() {
    let cone = Distribution::Cone { angle: 60.0, edge: 0.0 };
    let scene = floor(3.0, lamp(cone, 2.0, 7.0)).build().expect("a scene");
    let rim = 2.0 * 30.0_f64.to_radians().tan();
    let at = |r: f64| (DVec3::new(r, 0.0, 0.0), DVec3::Z);
    let found = direct(&scene, &[at(rim * (1.0 - 1e-9)), at(rim * (1.0 + 1e-9))]);
    let exact = downlight(7.0, 0.0, 2.0, rim);
    assert!((found[0] - exact).abs() < 1e-7 * exact && found[1] == 0.0, "{found:?}");
}

/// The umbra of a disk at the height a under a point at the height h has the radius R h / (h − a).
#[test]
fn the_umbra_of_a_disk_is_exact() {
    let (h, a, radius) = (3.0, 1.0, 0.4);
    let mut scene = floor(3.0, lamp(Distribution::Point, h, 100.0));
    let black = scene.material("black disk", Material::black(1));
    let disk = disk(a * DVec3::Z, DVec3::Z, radius);
    scene.surface("disk", disk, &black);
    let scene = scene.build().expect("a scene");
    let rim = radius * h / (h - a);
    let at = |factor: f64, turn: f64| (DVec3::new(turn.cos(), turn.sin(), 0.0) * factor * rim, DVec3::Z);
    for turn in [0.0, 1.0, 2.0, 4.5] {
        let found = direct(&scene, &[at(1.0 - 1e-9, turn), at(1.0 + 1e-9, turn)]);
        let exact = downlight(100.0, 0.0, h, rim);
        assert!(found[0] == 0.0 && (found[1] - exact).abs() < 1e-6 * exact, "{found:?} {exact}");
    }
}

/// A room of this reflectance with a crate in it, and what else `more` says.
fn room(reflectance: f64, more: &str) -> Scene {
    let text = format!(
        r#"
        bands = ["grey"]
        [materials.wall]
        reflectance = {reflectance}
        [materials.lamp]
        reflectance = 0
        [[surfaces]]
        name = "room"
        material = "wall"
        box = {{ origin = [0, 0, 0], size = [4, 5, 3], inward = true }}
        [[surfaces]]
        name = "crate"
        material = "wall"
        box = {{ origin = [1, 1, 0.5], size = [1, 1, 0.7] }}
        {more}
        "#
    );
    typed(&text)
}

const BULB: &str = "[[luminaires]]\nposition = [2, 2, 2.2]\nflux = 1000\npoint = {}\n";

#[test]
fn a_closed_room_absorbs_what_a_point_emits() {
    for (direct, transport) in [
        (Direct::Auto, Transport::Exact),
        (Direct::Split, Transport::Exact),
        (Direct::Projected, Transport::Exact),
        (Direct::Auto, Transport::Sampled),
    ] {
        let options = Options { direct, transport, shadow_eps: 1e-3, ..Options::default() };
        let checks = outcome_of(&room(0.5, BULB), &options).checks;
        assert!((checks.energy_in - 1000.0).abs() < 1e-9, "{direct:?} {checks:?}");
        let balance = checks.energy_absorbed + checks.energy_lost - checks.energy_in;
        assert!(balance.abs() < 1e-6, "{direct:?} {transport:?} {checks:?}");
        assert!(checks.energy_lost.abs() < 5.0, "{direct:?} {transport:?} {checks:?}");
    }
}

/// Light at points of the room: on the floor in light and in the shadow of the crate, on a wall, under the
/// ceiling.
fn readings(scene: &Scene, options: &Options, read: ReadMode, by: GatherMethod, eps: f64) -> Vec<f64> {
    let outcome = outcome_of(scene, options);
    let visibility = options.visibility(scene);
    let reader = Reader::by(by, &outcome.solution, &visibility, read, eps);
    let points = [
        (DVec3::new(3.0, 3.5, 0.01), DVec3::Z),
        (DVec3::new(1.2, 1.2, 0.01), DVec3::Z),
        (DVec3::new(0.01, 2.0, 1.5), DVec3::X),
        (DVec3::new(2.5, 4.0, 2.99), -DVec3::Z),
    ];
    let value = |(x, n)| reader.gathered(&ReceiverPoint::free(x, n)).expect("it gathers").irradiance[0];
    points.into_iter().map(value).collect()
}

/// The first bounce and all others are those of a Lambertian emitter that is small: a spot of the exponent 1
/// with the same flux.
#[test]
fn a_cosine_spot_is_the_limit_of_a_small_diffuse_emitter() {
    let spot = "[[luminaires]]\nposition = [2, 2, 2.2]\nflux = 1000\nspot = { exponent = 1 }\n";
    let panel = "[[surfaces]]\nmaterial = \"lamp\"\nflux = 1000\n\
        parallelogram = { origin = [1.995, 1.995, 2.2], edge1 = [0, 0.01, 0], edge2 = [0.01, 0, 0] }\n";
    let options = Options { shadow_eps: 1e-3, direct: Direct::Split, ..Options::default() };
    let [spot, panel] = [spot, panel]
        .map(|more| readings(&room(0.5, more), &options, ReadMode::GatherTwice, GatherMethod::Cells, 3e-4));
    for (spot, panel) in spot.iter().zip(&panel) {
        assert!((spot - panel).abs() < 2e-3 * panel, "{spot} {panel}");
    }
}

#[test]
fn readings_by_cells_and_by_rays_agree_however_light_entered() {
    let scene = room(0.6, BULB);
    let fine = Options { shadow_eps: 3e-4, direct: Direct::Split, ..Options::default() };
    let exact = readings(&scene, &fine, ReadMode::GatherTwice, GatherMethod::Cells, 1e-4);
    let sampled = Options { transport: Transport::Sampled, ..Options::default() };
    let projected = Options { direct: Direct::Projected, ..Options::default() };
    for (options, by) in
        [(&fine, GatherMethod::Rays), (&sampled, GatherMethod::Rays), (&projected, GatherMethod::Cells)]
    {
        let found = readings(&scene, options, ReadMode::Gather, by, 1e-3);
        let close = found.iter().zip(&exact).all(|(found, exact)| (found - exact).abs() < 0.015 * exact);
        assert!(close, "{by:?} {:?}: {found:?}, not {exact:?}", options.direct);
    }
}

#[test]
fn luminaires_are_dimmed_with_their_group() {
    let more = |a: f64, b: f64| {
        format!(
            "[[luminaires]]\nposition = [2, 2, 2.2]\nflux = {a}\npoint = {{}}\ngroup = \"bulb\"\n\
             [[luminaires]]\nposition = [3, 4, 2.9]\nflux = 500\ndimming = {b}\nspot = {{ angle = 60, edge = 20 }}\n"
        )
    };
    let options = Options::default();
    let solved = solved_of(room(0.5, &more(1000.0, 0.5)), options);
    let relit = solved.relight(&[("bulb", 0.25)]).expect("the group is there");
    let anew = solved_of(room(0.5, &more(250.0, 0.5)), options);
    for surface in 0..relit.scene.surfaces.len() {
        let [relit, anew] = [&relit, &anew].map(|own| own.outcome.solution.mean_irradiance(0, surface));
        assert!((relit - anew).abs() < 1e-9 * anew, "{surface}: {relit} {anew}");
    }
    let [x, n] = [DVec3::new(3.0, 1.0, 0.4), DVec3::Z];
    let [a, b] = [&relit, &anew].map(|own| own.irradiance_at(x, n)[0]);
    assert!((a - b).abs() < 1e-6 * b, "{a} {b}");
    assert!((relit.outcome.checks.energy_in - 500.0).abs() < 1e-9, "{:?}", relit.outcome.checks);
}

/// The room with a table of intensities in the place of the bulb.
fn room_with_table(table: &str) -> Scene {
    let spot = "spot = { exponent = 1 }\nflux = 1\n";
    let scene = room(0.5, &format!("[[luminaires]]\nposition = [2, 2, 2.2]\n{spot}"));
    let text = scene.source.expect("it was read").text().replace(spot, "photometry = \"lamp.ies\"\n");
    parsed(&Source::new("room", &text).including("lamp.ies", table))
}

/// A table of I₀ cos γ every 1/40 degree is bilinear to 2.4e-8 of I₀.
#[test]
fn a_lambertian_table_is_a_lambertian_emitter() {
    let gammas: Vec<f64> = (0..=3600).map(|k| f64::from(k) / 40.0).collect();
    let table = ies("0 0 0", &gammas, |gamma| 1000.0 / PI * gamma.cos().max(0.0));
    let spot = "[[luminaires]]\nposition = [2, 2, 2.2]\nflux = 1000\nspot = { exponent = 1 }\n";
    let options = Options { direct: Direct::Split, ..Options::default() };
    let scenes = [room_with_table(&table), room(0.5, spot)];
    for scene in &scenes {
        let flux = scene.luminaires[0].flux(0);
        assert!((flux - 1000.0).abs() < 1e-6 * flux, "{flux}");
    }
    let [table, spot] =
        scenes.each_ref().map(|scene| readings(scene, &options, ReadMode::Gather, GatherMethod::Cells, 1e-3));
    for (table, spot) in table.iter().zip(&spot) {
        assert!((table - spot).abs() < 1e-6 * spot, "{table} {spot}");
    }
}

/// An IES file of 100, 200, 300 and 400 cd at C = 0, 90, 180 and 270, at all γ up to 90°.
const QUARTERS: &str = "IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] none\nTILT=NONE\n1 -1 1 3 5 1 2 0 0 0\n1 1 10\n0 45 90\n\
    0 90 180 270 360\n100 100 100\n200 200 200\n300 300 300\n400 400 400\n100 100 100\n";

/// E of the luminaire of the table at the distance d before p, and aside by d towards the planes C = 0, 90,
/// 180 and 270 where `aim` and `along` are what the scene should make of its frame: γ = 45°, r² = 2d², E = I
/// √½ / (2d²).
#[track_caller]
fn check_quarters(entry: &str, p: DVec3, aim: DVec3, along: DVec3) {
    let text = format!(
        "bands = [\"lm\"]\n[materials.black]\nreflectance = 0\n[[surfaces]]\nmaterial = \"black\"\n\
         sphere = {{ center = [0, 0, -20], radius = 1 }}\n{entry}"
    );
    let scene = parsed(&Source::new("web", &text).including("lamp.ies", QUARTERS));
    let d = 1.5;
    let c90 = along.cross(aim);
    let points = [along, c90, -along, -c90].map(|side| (p + d * (aim + side), -aim));
    for (found, candela) in direct(&scene, &points).into_iter().zip([100.0, 200.0, 300.0, 400.0]) {
        let exact = candela * 0.5_f64.sqrt() / (2.0 * d * d);
        assert!((found - exact).abs() < 1e-9 * exact, "{entry}: {found}, not {exact}");
    }
}

/// Photometric webs keep their sense: seen from above a luminaire that aims down, C runs counter-clockwise
/// from x to y.
#[test]
fn photometric_webs_are_turned_with_their_luminaires() {
    let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z];
    assert_eq!(x.cross(-z), y);
    let lamp = |list: &str, more: &str| {
        format!("[[{list}]]\nposition = [1, 2, 3]\nphotometry = \"lamp.ies\"\n{more}\n")
    };
    let p = DVec3::new(1.0, 2.0, 3.0);
    check_quarters(&lamp("luminaires", ""), p, -z, x);
    check_quarters(&lamp("luminaires", "along = [0, 5, 1]"), p, -z, y);
    check_quarters(&lamp("luminaires", "aim = [0, 3, 0]\nalong = [0, 1, -1]"), p, y, -z);
    // By 90° about x, y becomes z, and z becomes −y; then C = 90 is towards z.
    let turned = |more: &str, rotate: &str| {
        lamp("parts.lamp.luminaires", more)
            + &format!(
                "[[instances]]\npart = \"lamp\"\ntransform = {{ rotate = {rotate}, translate = [0, 0, 5] }}\n"
            )
    };
    check_quarters(&turned("", "[1, 0, 0, 90]"), DVec3::new(1.0, -3.0, 7.0), y, x);
    // By 90° about z, x becomes y, and y becomes −x.
    check_quarters(&turned("", "[0, 0, 1, 90]"), DVec3::new(-2.0, 1.0, 8.0), -z, y);
    check_quarters(&turned("along = [0, 1, 0]", "[0, 0, 1, 90]"), DVec3::new(-2.0, 1.0, 8.0), -z, -x);
}
