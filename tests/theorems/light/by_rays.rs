//! Light gathered by rays: right in furnaces and beside curved lamps, as by cells, with an error that is
//! true.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use radiosity::audit::{Effort, Estimate, Referee, Spot};
use radiosity::elements::rule::UnitRule;
use radiosity::geom::shapes::Parallelogram;
use radiosity::geom::{DVec3, Encounter};
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::reading::grid::{Cell, Rates, grid};
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Camera;
use radiosity::solve::gather::Gather;
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::solve::gather::ray_gather::{Beyond, RayGather};
use radiosity::solve::gather::read_irradiance::ReadIrradiance;
use radiosity::solve::gather::receiver::Receiver;
use radiosity::solve::gather::standpoint::Standpoint;
use radiosity::solve::{Options, Outcome};
use radiosity::visibility::Visibility;
use radiosity::{Scene, SceneBuilder, Work};
use radiosity_test_support::given::even;
use radiosity_test_support::scenes::{builtin, builtin_with, material, typed};
use radiosity_test_support::shapes::{ball, inside};
use radiosity_test_support::solved::outcome_of;

pub(super) fn solved(scene: &Scene) -> (Outcome, Visibility) {
    let options = Options::default();
    let outcome = outcome_of(scene, &options);
    (outcome, options.visibility(scene))
}

/// Places and normals in the middle of a unit cube and beside its corners.
fn places() -> impl Iterator<Item = (DVec3, DVec3)> {
    let normals = [DVec3::X, -DVec3::Y, DVec3::ONE.normalize(), DVec3::new(0.3, -0.5, 0.7).normalize()];
    [0.5, 0.03, 0.97].into_iter().flat_map(move |at| normals.map(|normal| (DVec3::splat(at), normal)))
}

/// Relative standard deviation of what rays found.
fn deviation(found: &ReadIrradiance) -> f64 {
    found.uncertainty.deviation.expect("rays know it").relative
}

#[test]
fn every_point_of_a_furnace_is_as_bright() {
    let scene = builtin("furnace-cube");
    let (outcome, visibility) = solved(&scene);
    for beyond in [Beyond::Polynomials, Beyond::Trusted, Beyond::Gathered, Beyond::Walked] {
        let gather = RayGather::new(&outcome.solution, &visibility, 1e-2, beyond);
        for (position, normal) in places() {
            let position = position - scene.middle;
            let found = gather.read(&Receiver::Point(ReceiverPoint::free(position, normal)));
            // Half of the light is emitted, half of that half is reflected once, and so on.
            let error = (found.irradiance[0] / 2.0 - 1.0).abs();
            // Walks end where eight sequences agree, which some do by chance.
            let by_chance = if beyond == Beyond::Walked { 1e-2 } else { 1e-3 };
            assert!(error <= 4.0 * deviation(&found) + by_chance, "{position} {normal}: {found:?}");
        }
    }
}

/// In a furnace E = M/(1 − ρ) everywhere, of which walks of hundreds of surfaces bring the most.
#[test]
fn walks_of_white_furnaces_are_right_in_the_mean() {
    for (name, reflectance) in [("furnace-cube", 0.95), ("furnace-cube", 0.99), ("furnace-sphere", 0.95)] {
        let scene = builtin_with(name, &[("reflectance", reflectance)]);
        let (outcome, visibility) = solved(&scene);
        let gather = RayGather::new(&outcome.solution, &visibility, 2e-2, Beyond::Walked);
        let exact = 1.0 / (1.0 - reflectance);
        let (center, size) = (visibility.bounds().center(), visibility.bounds().diagonal());
        let errors: Vec<[f64; 2]> = places()
            .map(|(position, normal)| {
                let position = center + 0.4 * size / 3.0f64.sqrt() * (2.0 * position - 1.0) / 3.0f64.sqrt();
                let found = gather.read(&Receiver::Point(ReceiverPoint::free(position, normal)));
                [found.irradiance[0] / exact - 1.0, deviation(&found)]
            })
            .collect();
        let sum = |of: usize| errors.iter().map(|pair| pair[of] * pair[of]).sum::<f64>();
        assert!(sum(0) < 2.5 * sum(1), "{name} {reflectance}: {errors:?}");
        let mean = errors.iter().map(|[error, _]| error).sum::<f64>() / errors.len() as f64;
        let of_mean = sum(1).sqrt() / errors.len() as f64;
        assert!(mean.abs() < 4.0 * of_mean, "{name} {reflectance}: {mean} ± {of_mean}");
    }
}

/// Where nearly nothing is absorbed walks do not end, and what is read by them tells no accuracy.
#[test]
fn walks_without_an_end_tell_no_accuracy() {
    let mut builder = SceneBuilder::new("mirror", ["grey"]);
    let white = builder.material("white", material(1.0 - 1e-12, 1.0));
    builder.surface("ball", inside(ball(DVec3::ZERO, 1.0)), &white);
    let scene = builder.build().expect("a scene");
    let solution = even(&scene, 0, 1.0, 1.0);
    let visibility = Options::default().visibility(&scene);
    let gather = RayGather::new(&solution, &visibility, 0.1, Beyond::Walked);
    let found = gather.read(&Receiver::Point(ReceiverPoint::free(DVec3::ZERO, DVec3::Z)));
    assert!(deviation(&found).is_infinite(), "{found:?}");
}

#[test]
fn a_round_lamp_lights_points_near_and_far() {
    // E = M (r/d)² cos θ where all of the ball of radius r is above the horizon.
    let mut builder = SceneBuilder::new("lamp", ["grey"]);
    let glow = builder.material("glow", material(0.0, 3.0));
    let black = builder.material("black", material(0.0, 0.0));
    let radius = 0.5;
    let ball = ball(DVec3::ZERO, radius);
    builder.surface("lamp", ball, &glow);
    let floor = Parallelogram::new(DVec3::new(-9.0, -9.0, -9.0), 18.0 * DVec3::X, 18.0 * DVec3::Y);
    builder.surface("floor", floor.expect("a square"), &black);
    let scene = builder.build().expect("a scene");
    let (outcome, visibility) = solved(&scene);
    let gather = RayGather::new(&outcome.solution, &visibility, 3e-3, Beyond::Polynomials);
    for distance in [0.51, 0.6, 1.0, 5.0] {
        for (normal, cosine) in [(DVec3::X, 1.0), ((DVec3::X + DVec3::Y) * FRAC_1_SQRT_2, FRAC_1_SQRT_2)] {
            let is_above = radius < distance * cosine;
            let position = -distance * DVec3::X - scene.middle;
            let found = gather.read(&Receiver::Point(ReceiverPoint::free(position, normal)));
            let exact = 3.0 * (radius / distance).powi(2) * cosine;
            let error = (found.irradiance[0] / exact - 1.0).abs();
            assert!(!is_above || error <= 4.0 * deviation(&found), "{distance} {cosine}: {error} {found:?}");
        }
    }
}

#[test]
fn rays_and_cells_agree_and_the_error_told_is_true() {
    let scene = builtin("two-boxes");
    let (outcome, visibility) = solved(&scene);
    let cells = Reader::by(GatherMethod::Cells, &outcome.solution, &visibility, ReadMode::Gather, 1e-4);
    let rays = Reader::by(GatherMethod::Rays, &outcome.solution, &visibility, ReadMode::Gather, 1e-2);
    let (mut told, mut squares, mut count) = (0.0, 0.0, 0.0);
    let bounds = visibility.bounds();
    for k in 0..200 {
        let share = [0.618, 0.755, 0.570].map(|step: f64| 0.05 + 0.9 * (f64::from(k) * step).fract());
        let position = bounds.min + (bounds.max - bounds.min) * DVec3::from_array(share);
        let normal = DVec3::new((f64::from(k)).sin(), (2.0 * f64::from(k)).cos(), 0.4).normalize();
        let receiver = ReceiverPoint::free(position, normal);
        let [exact, found] =
            [&cells, &rays].map(|reader| reader.gathered(&receiver).expect("it is gathered"));
        let sum = |values: &[f64]| values.iter().sum::<f64>();
        let exact = sum(&exact.irradiance);
        // Within the boxes there is none but for rounding.
        if exact > 1e-6 {
            told += found.uncertainty.deviation.expect("rays know it").relative.powi(2);
            squares += (sum(&found.irradiance) / exact - 1.0).powi(2);
            count += 1.0;
        }
    }
    let [told, found] = [told, squares].map(|sum: f64| (sum / count).sqrt());
    assert!(told <= 1e-2 && found <= 1.5e-2, "{found} is found, {told} told");
    assert!(found <= 3.0 * told && told <= 3.0 * found, "{found} is found, {told} told");
}

#[test]
fn rays_from_all_of_a_cell_give_its_mean() {
    let scene = builtin("two-boxes");
    let (outcome, visibility) = solved(&scene);
    let read = |by, eps| {
        let reader = Reader::by(by, &outcome.solution, &visibility, ReadMode::Gather, eps);
        grid(&reader, [2, 2], Rates { direct: 8, indirect: 4 }, &Work::alone())
    };
    let (exact, found) = (read(GatherMethod::Cells, 1e-3), read(GatherMethod::Rays, 5e-3));
    let sum = |values: &[f64]| values.iter().sum::<f64>();
    let off = exact.iter().zip(&found).map(|(exact, found)| {
        let [exact, found] = [exact, found].map(|cell| sum(&cell.irradiance));
        found / exact - 1.0
    });
    let off: Vec<f64> = off.collect();
    let rms = (off.iter().map(|off| off * off).sum::<f64>() / off.len() as f64).sqrt();
    let largest = off.iter().fold(0.0, |most: f64, off| most.max(off.abs()));
    // 8 × 8 points leave as much where a shadow's edge crosses a cell.
    assert!(rms < 1.5e-2 && largest < 0.08, "{rms} and {largest}");
}

/// A room with a table under a lamp: over cells of its floor, in light and in shadow, the grid has the mean of what
/// probes read there, and of what a picture shows.
#[test]
fn cells_have_the_mean_of_probes_and_of_pixels() {
    const CELLS: usize = 4;
    const SIDE: usize = 10;
    let scene = typed(
        "bands = [\"grey\"]\n[materials.wall]\nreflectance = 0.6\n[materials.wood]\nreflectance = 0.4\n\
         [materials.lamp]\nreflectance = 0.5\nemission = 1000\n\
         [[surfaces]]\nname = \"room\"\nmaterial = \"wall\"\nbox = { origin = [0, 0, 0], size = [4, 4, 3] }\nflip = true\n\
         [[surfaces]]\nname = \"table\"\nmaterial = \"wood\"\nbox = { origin = [0.6, 0.8, 0.7], size = [1.2, 0.8, 0.1] }\n\
         [[surfaces]]\nname = \"lamp\"\nmaterial = \"lamp\"\n\
         parallelogram = { origin = [1.4, 1.4, 2.8], edge1 = [0, 0.6, 0], edge2 = [0.6, 0, 0] }\n",
    );
    let (outcome, visibility) = solved(&scene);
    let solution = &outcome.solution;
    let reader = Reader::by(GatherMethod::Rays, solution, &visibility, ReadMode::Gather, 5e-3);
    let cells = grid(&reader, [CELLS; 2], Rates::default(), &Work::alone());
    let camera = Camera {
        width: 128,
        height: 128,
        up: DVec3::Y,
        fov: 90.0,
        ..Camera::new(DVec3::new(2.0, 2.0, 2.7), DVec3::new(2.0, 2.0, 0.0)).about(scene.middle)
    };
    let (read, shown) = (ReadMode::Gather, Quantity::Irradiance);
    let raster = PictureRequest {
        solution,
        visibility: &visibility,
        camera: &camera,
        samples: 1,
        read,
        shown,
        is_preview: false,
    }
    .picture(&Work::alone());
    let view = Pinhole::new(&camera);
    let is_floor = |x: DVec3, normal: DVec3| normal == DVec3::Z && (x + scene.middle).z.abs() < 1e-9;
    let cell_of = |x: DVec3| {
        let [i, j] = [x.x + scene.middle.x, x.y + scene.middle.y].map(|at| at.floor() as usize);
        [i, j]
    };
    let mut pixels = vec![(0.0, 0.0); CELLS * CELLS];
    for (index, values) in raster.pixels().enumerate() {
        let ray = view.ray((index % 128) as f64 + 0.5, (index / 128) as f64 + 0.5);
        let Some(Encounter { surface, hit, front: true, .. }) = visibility.nearest(&ray) else { continue };
        let jet = solution.elements().shape(surface).jet(hit.u, hit.v);
        if is_floor(jet.position, jet.normal) {
            let [i, j] = cell_of(jet.position);
            // Pixels are spread evenly over what is seen square on.
            pixels[i * CELLS + j].0 += values[0];
            pixels[i * CELLS + j].1 += 1.0;
        }
    }
    let mut compared = [0; 2];
    let floor: Vec<&Cell> = cells
        .iter()
        .filter(|cell| {
            let jet = solution.elements().shape(cell.surface).jet(0.0, 0.0);
            is_floor(jet.position, jet.normal)
        })
        .collect();
    assert_eq!(floor.len(), CELLS * CELLS);
    for cell in floor {
        let [i, j] = cell_of(cell.position);
        let told = cell.uncertainty.deviation.expect("rays know it").absolute;
        if (i + j) % 2 == 0 {
            let corner = DVec3::new(i as f64, j as f64, 0.0) - scene.middle;
            let place = |k: usize| (k as f64 + 0.5) / SIDE as f64;
            let places = (0..SIDE * SIDE).map(|k| corner + DVec3::new(place(k / SIDE), place(k % SIDE), 0.0));
            let probes: f64 = places
                .map(|at| {
                    let on = Standpoint::find(solution.elements(), &visibility, at, DVec3::Z);
                    reader.gathered(&on.receiver_point(DVec3::Z)).expect("it gathers").irradiance[0]
                })
                .sum();
            let probes = probes / (SIDE * SIDE) as f64;
            // Midpoints miss as much of a shadow's edge.
            assert!(
                (cell.irradiance[0] - probes).abs() < 3.0 * told + 5e-3 * probes,
                "{i} {j}: {} ± {told}, probes {probes}",
                cell.irradiance[0]
            );
            compared[0] += 1;
        }
        let (sum, count) = pixels[i * CELLS + j];
        // Of some cells the table hides a part.
        if count > 0.95 * 128.0 * 128.0 / (5.4 * 5.4) {
            let shown = sum / count;
            assert!(
                (cell.irradiance[0] - shown).abs() < 3.0 * told + 1e-2 * shown,
                "{i} {j}: {} ± {told}, pixels {shown}",
                cell.irradiance[0]
            );
            compared[1] += 1;
        }
    }
    assert!(compared[0] == 8 && compared[1] >= 8, "{compared:?}");
}

#[test]
fn a_reading_depends_on_nothing_but_its_point() {
    let scene = builtin("two-boxes");
    let (outcome, visibility) = solved(&scene);
    let gather = RayGather::new(&outcome.solution, &visibility, 2e-2, Beyond::Polynomials);
    let read = |at: f64| {
        let receiver = ReceiverPoint::free(visibility.bounds().center() + at * DVec3::X, DVec3::Z);
        gather.read(&Receiver::Point(receiver))
    };
    let first = read(0.1);
    let _ = read(0.2);
    assert_eq!(first, read(0.1));
    assert_ne!(first, read(0.2));
}

/// Mean square of differences from what a referee finds at points, over their standard errors; of light read from one
/// constant a wall.
fn differences(beyond: Beyond) -> f64 {
    const POINTS: usize = 24;
    let scene = builtin("cornell-box");
    let solution = outcome_of(&scene, &Options { order: 0, ..Options::default() }).solution;
    let visibility = Options::default().visibility(&scene);
    let gather = RayGather::new(&solution, &visibility, 2e-2, beyond);
    let referee = Referee::of_light(&scene);
    let spots: Vec<Spot> = referee.sample(POINTS, 3).into_iter().map(|point| point.spot).collect();
    let estimates = referee.estimates(&spots, &Effort::of_walks(16384.0), &Work::alone());
    let difference = |(spot, found): (&Spot, &Estimate)| {
        let Spot::Point { position, normal } = *spot else { unreachable!("samples are points") };
        let read = gather.read(&Receiver::Point(ReceiverPoint::free(position + 1e-6 * normal, normal)));
        let error = deviation(&read) * read.irradiance[1];
        (read.irradiance[1] - found.bands[1].value).powi(2) / (error.powi(2) + found.bands[1].error.powi(2))
    };
    spots.iter().zip(&estimates).map(difference).sum::<f64>() / POINTS as f64
}

#[test]
fn light_by_walks_owes_nothing_to_the_solution() {
    let [walks, polynomials] = [Beyond::Walked, Beyond::Polynomials].map(differences);
    // Both errors are known by 7 degrees of freedom, so that the mean is 1.4 and not 1.
    assert!(walks < 2.5, "{walks}");
    assert!(polynomials > 10.0, "constants are far off: {polynomials}");
}

/// A room of one lamp, with a bench close to a wall; polynomials of degree 3 on whole walls and floors follow no light
/// under it.
fn room_with_a_bench() -> Scene {
    typed(
        "bands = [\"grey\"]\n[materials.wall]\nreflectance = 0.7\n[materials.wood]\nreflectance = 0.5\n\
         [materials.lamp]\nreflectance = 0\nemission = 1000\n\
         [[surfaces]]\nname = \"room\"\nmaterial = \"wall\"\nbox = { origin = [0, 0, 0], size = [4, 3, 2.5] }\nflip = true\n\
         [[surfaces]]\nname = \"bench\"\nmaterial = \"wood\"\nbox = { origin = [0.3, 0.05, 0.25], size = [3, 0.5, 0.2] }\n\
         [[surfaces]]\nname = \"lamp\"\nmaterial = \"lamp\"\nquad = { vertices = [[3.4, 2.4, 2.4], [3.4, 2.7, 2.4], \
         [3.7, 2.7, 2.4], [3.7, 2.4, 2.4]] }\n",
    )
}

#[test]
fn what_is_read_in_shadow_is_right_where_polynomials_are_not() {
    let scene = room_with_a_bench();
    // With the first order light under the bench is up to 22 % too bright, as cells alone find it.
    let options = Options { order: 1, ..Options::default() };
    let solution = outcome_of(&scene, &options).solution;
    let visibility = options.visibility(&scene);
    let reader = Reader::new(&solution, &visibility, ReadMode::Gather, 1.25e-3);
    let cells = Gather::new(&solution, &visibility, 1.25e-3);
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0) - scene.middle;
    let places = [at(0.8, 0.1), at(1.2, 0.3), at(1.8, 0.15), at(2.4, 0.3), at(2.9, 0.1), at(2.0, 1.5)];
    let spots = places.map(|position| Spot::Point { position, normal: DVec3::Z });
    let right = Referee::of_light(&scene).estimates(&spots, &Effort::of_walks(131072.0), &Work::alone());
    let usual = right[5].bands[0].value;
    let worst = |read: &dyn Fn(&ReceiverPoint) -> f64| {
        let missed = places[..5].iter().zip(&right).map(|(position, right)| {
            let on = Standpoint::find(solution.elements(), &visibility, *position, DVec3::Z);
            let (value, error) = (right.bands[0].value, right.bands[0].error);
            let allowed = 0.05 * value + 0.005 * usual + 3.0 * error;
            (read(&on.receiver_point(DVec3::Z)) - value).abs() / allowed
        });
        missed.fold(0.0, f64::max)
    };
    let anew = worst(&|receiver| reader.gathered(receiver).expect("it gathers").irradiance[0]);
    let by_cells = worst(&|receiver| cells.at(receiver)[0]);
    assert!(anew < 1.0, "{anew} of what is allowed");
    assert!(by_cells > 1.5, "polynomials are far off: {by_cells}");
}

/// Largest relative difference of readings at these places, with these normals, from what a referee finds, as far
/// as it exceeds three of its standard errors.
fn worst_beside_referee(scene: &Scene, eps: f64, places: &[(DVec3, DVec3)]) -> f64 {
    let (outcome, visibility) = solved(scene);
    let solution = &outcome.solution;
    let reader = Reader::new(solution, &visibility, ReadMode::Gather, eps);
    let centred: Vec<(DVec3, DVec3)> =
        places.iter().map(|(place, normal)| (*place - scene.middle, *normal)).collect();
    let spots: Vec<Spot> = centred
        .iter()
        .map(|(position, normal)| Spot::Point { position: *position, normal: *normal })
        .collect();
    let right = Referee::of_light(scene).estimates(&spots, &Effort::of_walks(131072.0), &Work::alone());
    let off = |((position, normal), right): (&(DVec3, DVec3), &Estimate)| {
        let on = Standpoint::find(solution.elements(), &visibility, *position, *normal);
        let read = reader.gathered(&on.receiver_point(*normal)).expect("it gathers").irradiance[0];
        let (value, error) = (right.bands[0].value, right.bands[0].error);
        ((read - value).abs() - 3.0 * error) / value
    };
    centred.iter().zip(&right).map(off).fold(0.0, f64::max)
}

/// Steps in what walls reflect where a shelf hangs on one and a partition stands before another, in the middle of
/// elements: polynomials of degree 3 smear them.
#[test]
fn what_is_read_beside_a_step_is_right() {
    let scene = typed(
        "bands = [\"grey\"]\n[materials.wall]\nreflectance = 0.7\n[materials.wood]\nreflectance = 0.5\n\
         [materials.lamp]\nreflectance = 0\nemission = 1000\n\
         [[surfaces]]\nname = \"room\"\nmaterial = \"wall\"\nbox = { origin = [0, 0, 0], size = [8, 4, 3.4] }\nflip = true\n\
         [[surfaces]]\nname = \"shelf\"\nmaterial = \"wood\"\ntwo_sided = true\nquad = { vertices = [[7.7, 1.4, 0.56], \
         [8, 1.4, 0.56], [8, 2.3, 0.56], [7.7, 2.3, 0.56]] }\n\
         [[surfaces]]\nname = \"partition\"\nmaterial = \"wood\"\ntwo_sided = true\nquad = { vertices = [[2.7, 0, 0], \
         [2.7, 1.6, 0], [2.7, 1.6, 1.7], [2.7, 0, 1.7]] }\n\
         [[surfaces]]\nname = \"lamp\"\nmaterial = \"lamp\"\nquad = { vertices = [[3.7, 1.9, 3.1], [3.7, 2.7, 3.1], \
         [4, 2.7, 3.1], [4, 1.9, 3.1]] }\n",
    );
    let at = DVec3::new;
    let places = [
        (at(7.9, 1.8, 0.56), DVec3::Z),
        (at(7.9, 1.8, 0.56), -DVec3::Z),
        (at(2.7, 0.15, 1.38), DVec3::X),
        (at(2.7, 0.3, 0.6), -DVec3::X),
        (at(2.7, 0.1, 0.8), DVec3::X),
    ];
    // By the polynomials alone the light is off by 1.5, 5.5, 2.5, 11 and 4.5 %.
    let worst = worst_beside_referee(&scene, 1.25e-3, &places);
    assert!(worst < 0.015, "{worst}");
}

/// The inside of a lampshade, which is seen at grazing angles, brings a fifteenth of the light, along one ray in two
/// thousand.
#[test]
fn rays_find_the_inside_of_a_lampshade() {
    let scene = typed(
        "bands = [\"grey\"]\n[materials.wall]\nreflectance = 0.5\n[materials.lamp]\nreflectance = 0.3\nemission = 4000\n\
         [[surfaces]]\nname = \"room\"\nmaterial = \"wall\"\nbox = { origin = [0, 0, 0], size = [4, 4, 3] }\nflip = true\n\
         [[surfaces]]\nname = \"shade\"\nmaterial = \"wall\"\ntwo_sided = true\n\
         cone = { base = [2, 3, 1.6], axis = [0, 0, 0.25], radius1 = 0.3, radius2 = 0.18 }\n\
         [[surfaces]]\nname = \"bulb\"\nmaterial = \"lamp\"\nsphere = { center = [2, 3, 1.7], radius = 0.05 }\n",
    );
    // Without rays that are aimed at it 7 and 5 % are missing, of which rays tell nothing.
    let places = [(DVec3::ONE, DVec3::Z), (DVec3::new(0.0, 3.0, 1.5), DVec3::X)];
    let worst = worst_beside_referee(&scene, 5e-3, &places);
    assert!(worst < 0.015, "{worst}");
}

/// A lit plate that fills a thousandth of the view and reflects 2 to 4 times what most surfaces receive, in a
/// glimmering dome: most of 512 rays miss it, and their sequences agree on that. The plate is lit by a lamp below the
/// sensors, and
///
/// ```text
/// E = e (1 − F) + ρ ∫ ( I cos θ / |y − p|² + e ) κ(x, y) dA_y ,     F = ∫ κ(x, y) dA_y
/// ```
///
/// over the plate, with the exitance e of the dome and the intensity I of the lamp at p.
#[test]
fn rays_find_what_reflects_more_than_most_and_is_seen_small() {
    const GLIMMER: f64 = 0.04;
    const FLUX: f64 = 400.0;
    const REFLECTANCE: f64 = 0.8;
    const SIDE: f64 = 0.1;
    let scene = typed(&format!(
        "bands = [\"grey\"]\n[materials.plate]\nreflectance = {REFLECTANCE}\n[materials.dome]\nreflectance = 0\n\
         emission = {GLIMMER}\n[[luminaires]]\nposition = [-0.5, 0, -1]\nflux = {FLUX}\npoint = {{}}\n\
         [[surfaces]]\nname = \"dome\"\nmaterial = \"dome\"\nflip = true\n\
         sphere = {{ center = [0, 0, 0], radius = 5 }}\n\
         [[surfaces]]\nname = \"plate\"\nmaterial = \"plate\"\n\
         parallelogram = {{ origin = [0.85, -0.05, 0.45], edge1 = [0, {SIDE}, 0], edge2 = [{SIDE}, 0, 0] }}\n",
    ));
    let [origin, lamp] = [DVec3::new(0.85, -0.05, 0.45), DVec3::new(-0.5, 0.0, -1.0)];
    let intensity = FLUX / (4.0 * PI);
    let right = |x: DVec3, normal: DVec3| {
        let rule = UnitRule::of(4);
        let at = |[(s, a), (t, b)]: [(f64, f64); 2]| {
            let y = origin + SIDE * DVec3::new(t, s, 0.0);
            let (step, from_lamp) = (y - x, y - lamp);
            let kernel =
                a * b * SIDE * SIDE * normal.dot(step) * step.z / (PI * step.length_squared().powi(2));
            let lit = intensity * from_lamp.z / from_lamp.length().powi(3) + GLIMMER;
            kernel * (REFLECTANCE * lit - GLIMMER)
        };
        GLIMMER + rule.iter().flat_map(|own| rule.iter().map(move |other| at([own, other]))).sum::<f64>()
    };
    let (outcome, visibility) = solved(&scene);
    let gather = RayGather::new(&outcome.solution, &visibility, 1e-2, Beyond::Polynomials);
    for k in 0..8 {
        let (x, normal) = (DVec3::new(0.0, 0.04 * f64::from(k), 0.0), DVec3::Z);
        let exact = right(x, normal);
        let receiver = ReceiverPoint::free(x - scene.middle, normal);
        let found = gather.read(&Receiver::Point(receiver));
        let error = (found.irradiance[0] / exact - 1.0).abs();
        // Of this light the plate sends 7 %.
        assert!(error <= 3.0 * deviation(&found), "{k}: {error}, {found:?}");
    }
}

#[test]
fn a_strip_of_wall_beside_a_block_is_gathered_by_cells_as_by_rays() {
    // From these points the back wall shows in a strip between the tall block and the wall on the right,
    // which is twisted and counts as curved: lines along the strip all miss it, and half a percent of the
    // light was lost.
    let scene = builtin("cornell-box");
    let options = Options { order: 2, ..Options::default() };
    let solution = outcome_of(&scene, &options).solution;
    let visibility = options.visibility(&scene);
    let cells = Gather::new(&solution, &visibility, 1e-3);
    let rays = RayGather::new(&solution, &visibility, 1e-3, Beyond::Polynomials);
    for x in [380.0, 388.0, 396.0] {
        let point = ReceiverPoint::free(DVec3::new(x, 109.6, 100.0), DVec3::Z);
        let (by_cells, by_rays) = (cells.at(&point)[0], rays.read(&Receiver::Point(point)).irradiance[0]);
        assert!((by_cells / by_rays - 1.0).abs() < 2.5e-3, "at {x}: {by_cells} by cells, {by_rays} by rays");
    }
}
