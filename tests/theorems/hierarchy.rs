//! Hierarchical radiosity: push-pull, clusters, and the light of rooms whose light is known.

use std::f64::consts::PI;

use radiosity::Work;
use radiosity::elements::rule::UnitRule;
use radiosity::elements::sampling::kronecker;
use radiosity::geom::{DVec3, RayTree};
use radiosity::published::hierarchy::harmonics::{HARMONICS, clamped_cosine, harmonics};
use radiosity::published::hierarchy::{
    BandSystem, Counts, Fields, Hierarchical, HierarchyError, HierarchyOptions, Leaf, LinkMeasure,
    solve_hierarchically,
};
use radiosity::scene::{NamedMaterial, Scene, SceneBuilder};
use radiosity::solve::solved::Solved;
use radiosity::solve::studies::adaptation::{Aim, Goal};
use radiosity::solve::{LightMethod, Options, Outcome, in_threads};
use radiosity_test_support::scenes::{builtin, material};
use radiosity_test_support::shapes::faces;
use radiosity_test_support::shapes::{ball, plate};
use radiosity_test_support::solved::{outcome_of, solved_of};

fn solved(scene: &Scene, options: &HierarchyOptions) -> Hierarchical {
    solve_hierarchically(scene, options, &|_| {}).expect("the scene can be solved")
}

/// The six faces of a box between two corners, fronts outside, or inside if the corners are exchanged.
fn add_box(room: &mut SceneBuilder, name: &str, [low, high]: [DVec3; 2], material: &NamedMaterial) {
    let edges = DVec3::AXES.map(|axis| (low - high).dot(axis) * axis);
    for (index, face) in faces(high, edges).into_iter().enumerate() {
        room.surface(format!("{name}-{index}"), face, material);
    }
}

/// A closed room in which boxes hover; everything reflects one half and emits 1, or only the room does.
fn hall(boxes: usize, all_emit: bool) -> Scene {
    let mut room = SceneBuilder::new("hall", ["grey"]);
    let glow = room.material("glow", material(0.5, 1.0));
    let dark = material(0.5, 0.0);
    let dark = room.material("dark", dark);
    add_box(&mut room, "room", [DVec3::splat(boxes as f64), DVec3::ZERO], &glow);
    for k in 0..boxes.pow(3) {
        let at = DVec3::from_array([k % boxes, k / boxes % boxes, k / boxes / boxes].map(|x| x as f64));
        let ends = [at + DVec3::splat(0.3), at + DVec3::new(0.6, 0.7, 0.65)];
        add_box(&mut room, &format!("box-{k}"), ends, if all_emit { &glow } else { &dark });
    }
    room.build().expect("the boxes keep apart")
}

/// Numbers in [−1, 1) without structure.
fn scattered(count: usize, seed: usize) -> Vec<f64> {
    (1..=count).map(|k| 2.0 * ((k + 1000 * seed) as f64 * 0.754_877_666_246_692_8).fract() - 1.0).collect()
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

fn norm(x: &[f64]) -> f64 {
    dot(x, x).sqrt()
}

fn distance(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt()
}

/// Directions about `axis` with weights that integrate polynomials over the sphere, or over its upper half.
fn directions(axis: DVec3, lowest: f64) -> Vec<(DVec3, f64)> {
    let (along, across) = axis.any_orthonormal_pair();
    let turns = 12;
    let ring = move |(s, w): (f64, f64)| {
        let z = lowest + (1.0 - lowest) * s;
        (0..turns).map(move |k| {
            let (sin, cos) = (2.0 * PI * f64::from(k) / f64::from(turns)).sin_cos();
            let flat = (1.0 - z * z).sqrt();
            let direction = axis * z + (along * cos + across * sin) * flat;
            (direction, w * (1.0 - lowest) * 2.0 * PI / f64::from(turns))
        })
    };
    UnitRule::of(8).iter().flat_map(ring).collect()
}

#[test]
fn harmonics_are_orthonormal_and_hold_the_clamped_cosine() {
    let axis = DVec3::new(0.3, -0.5, 0.8).normalize();
    let mut products = [[0.0; HARMONICS]; HARMONICS];
    for (direction, weight) in directions(axis, -1.0) {
        let values = harmonics(direction);
        for (row, a) in products.iter_mut().zip(values) {
            row.iter_mut().zip(values).for_each(|(sum, b)| *sum += weight * a * b);
        }
    }
    let mut cosine = [0.0; HARMONICS];
    for (direction, weight) in directions(axis, 0.0) {
        let values = harmonics(direction);
        cosine.iter_mut().zip(values).for_each(|(sum, y)| *sum += weight * direction.dot(axis) * y);
    }
    for (k, row) in products.iter().enumerate() {
        for (l, product) in row.iter().enumerate() {
            assert!((product - f64::from(u8::from(k == l))).abs() < 1e-14, "{k} {l}: {product}");
        }
    }
    for (ours, integrated) in clamped_cosine(axis).iter().zip(cosine) {
        assert!((ours - integrated).abs() < 1e-14, "{ours} {integrated}");
    }
}

/// Cauchy: the mean projected area of a convex body is a quarter of its surface. Gauss: ∮ n dA = 0.
#[test]
fn closed_bodies_send_a_quarter_of_their_area_and_no_dipole() {
    let scene = hall(2, false);
    let solved = solved(&scene, &HierarchyOptions { eps: 1e-2, ..HierarchyOptions::default() });
    let ones = vec![1.0; solved.leaves().len()];
    let all = solved.hierarchy().pull(&ones).clusters[0];
    let area: f64 = scene.surfaces.iter().map(|surface| surface.shape.area()).sum();
    let mean = all[0] * harmonics(DVec3::Z)[0];
    assert!((mean - area / 4.0).abs() < 1e-13 * area, "{mean} {area}");
    assert!(all[1..4].iter().all(|dipole| dipole.abs() < 1e-13 * area), "{all:?}");
}

/// A field on all nodes of a hierarchy.
fn field(solved: &Hierarchical) -> Fields {
    let mut field = solved.hierarchy().pull(&vec![0.0; solved.leaves().len()]);
    field.faces = scattered(field.faces.len(), 1);
    for (k, cluster) in field.clusters.iter_mut().enumerate() {
        cluster.copy_from_slice(&scattered(HARMONICS, k + 2));
    }
    field
}

#[test]
fn push_is_the_transpose_of_pull_and_the_exchange_is_symmetric() {
    let solved = solved(&hall(3, false), &HierarchyOptions { eps: 1e-3, ..HierarchyOptions::default() });
    let counts = solved.counts();
    assert!(counts.cluster_links > 100 && counts.leaves > counts.surfaces, "{counts:?}");
    let (x, y) = (scattered(counts.leaves, 0), scattered(counts.leaves, 7));
    let (up, field) = (solved.hierarchy().pull(&x), field(&solved));
    let (above, below) = (up.dot(&field), dot(&x, &solved.hierarchy().push(field.clone())));
    let scale = up.dot(&up).sqrt() * field.dot(&field).sqrt();
    assert!((above - below).abs() < 1e-13 * scale && above.abs() > 1e-6 * scale, "{above} {below}");
    let [tx, ty] = [&x, &y].map(|x| solved.hierarchy().exchange(x));
    let error = (dot(&y, &tx) - dot(&x, &ty)).abs();
    assert!(error < 1e-13 * norm(&x) * norm(&ty) && norm(&ty) > 0.0, "{error:e}");
}

#[test]
fn pull_keeps_constants_and_push_keeps_power() {
    let options = HierarchyOptions { eps: 1e-3, ..HierarchyOptions::default() };
    let solved = solved(&builtin("cornell-box"), &options);
    let hierarchy = solved.hierarchy();
    let up = hierarchy.pull(&vec![1.0; solved.leaves().len()]);
    assert!(up.faces.iter().all(|mean| (mean - 1.0).abs() < 1e-13));
    // One unit of power on the whole of each surface, which is that of the node of its place.
    let mut whole = hierarchy.pull(&vec![0.0; solved.leaves().len()]);
    whole.faces[..solved.counts().surfaces].fill(1.0);
    let power = hierarchy.push(whole);
    for surface in 0..solved.counts().surfaces {
        let own = hierarchy.of_surface(surface);
        assert!((power[own.clone()].iter().sum::<f64>() - 1.0).abs() < 1e-13);
        // Irradiance is handed down unchanged.
        let rates: Vec<f64> = own.map(|leaf| power[leaf] / solved.leaves()[leaf].area).collect();
        assert!(rates.iter().all(|rate| (rate / rates[0] - 1.0).abs() < 1e-12));
    }
}

#[test]
fn leaves_are_found_by_their_parameters() {
    let scene = builtin("cornell-box");
    let solved = solved(&scene, &HierarchyOptions { eps: 1e-3, ..HierarchyOptions::default() });
    for (index, leaf) in solved.leaves().iter().enumerate() {
        // The middle of a cell that a hole cuts may belong to the hole; it is the cell's place all the same.
        assert_eq!(solved.hierarchy().leaf_at(leaf.surface, leaf.rect.center()), Some(index));
    }
    for (surface, own) in scene.surfaces.iter().enumerate() {
        let area: f64 = solved.hierarchy().of_surface(surface).map(|leaf| solved.leaves()[leaf].area).sum();
        assert!((area / own.shape.area() - 1.0).abs() < 1e-12, "{}", own.name);
    }
}

/// The exchanges of whole squares are exact: so is the furnace.
#[test]
fn furnace_of_whole_squares_is_two() {
    let options = HierarchyOptions { eps: 1.0, tolerance: 1e-13, ..HierarchyOptions::default() };
    let solved = solved(&builtin("furnace-cube"), &options);
    assert_eq!((solved.leaves().len(), solved.counts().links), (6, 15));
    assert!(solved.radiosity(0).iter().all(|b| (b - 2.0).abs() < 1e-12));
    assert!(solved.irradiance(0).iter().all(|e| (e - 2.0).abs() < 1e-12));
}

fn by_links(scene: &Scene, eps: f64) -> Outcome {
    let options = Options { method: LightMethod::Hierarchical, eps, ..Options::default() };
    outcome_of(scene, &options)
}

/// A run by links has an element on each leaf, and the light of the leaves.
#[test]
fn runs_by_links_have_the_light_of_their_hierarchy() {
    let scene = builtin("occluder-box");
    let outcome = by_links(&scene, 1e-3);
    let found =
        solved(&scene, &HierarchyOptions { eps: 1e-3, least_area: 1e-6, ..HierarchyOptions::default() });
    let elements = outcome.solution.elements().list();
    assert_eq!((elements.len(), outcome.links), (found.leaves().len(), Some(found.counts())));
    for surface in 0..scene.surfaces.len() {
        let [own, other] = [outcome.solution.mean_irradiance(0, surface), found.mean_irradiance(0, surface)];
        assert!((own - other).abs() <= 1e-6 * other, "{surface}: {own}, {other}");
    }
    assert!(outcome.residual < 1e-6);
    let checks = outcome.checks;
    let balance = checks.energy_in - checks.energy_absorbed - checks.energy_lost;
    assert!(balance.abs() < 1e-6 * checks.energy_in, "{balance}");
}

/// Whole squares have exact links: the furnace is one, and closed.
#[test]
fn a_run_by_links_of_whole_squares_is_the_furnace() {
    let checks = by_links(&builtin("furnace-cube"), 1.0).checks;
    assert!((checks.row_sum_min - 1.0).abs() < 1e-12 && (checks.row_sum_max - 1.0).abs() < 1e-12);
    assert!(checks.energy_lost.abs() < 1e-7 * checks.energy_in && (checks.spectral_bound - 0.5).abs() < 1e-9);
}

/// The error that is told of gathered light is that against polynomials of order 4, within a factor of three.
#[test]
fn runs_by_links_tell_the_error_of_gathered_light() {
    let scene = builtin("two-boxes");
    let options = Options { method: LightMethod::Hierarchical, ..Options::default() };
    let goal = Goal::new(2e-2, Aim::Gathered);
    let rough =
        Solved::to_accuracy(scene.clone(), &options, &goal, &Work::alone()).expect("it can be solved");
    let told = rough.achieved.and_then(|achieved| achieved.estimate).expect("it is told");
    let exact = Options { order: 4, eps: 3e-4, shadow_eps: 1e-3, ..Options::default() };
    let exact = solved_of(scene, exact);
    let (mut missed, mut size) = (0.0, 0.0);
    let elements =
        exact.outcome.solution.elements().list().iter().filter(|element| element.contact.is_none());
    for element in elements {
        let [u, v] = element.rect.center();
        let jet = exact.scene.surfaces[element.surface].shape.jet(u, v);
        let lifted = jet.position + 1e-6 * jet.normal;
        let [own, other] = [&rough, &exact].map(|solved| solved.irradiance_at(lifted, jet.normal)[0]);
        missed += element.area * (own - other).powi(2);
        size += element.area * other.powi(2);
    }
    let error = (missed / size).sqrt();
    assert!(told < 2e-2 && told / 3.0 < error && error < 3.0 * told, "{told} {error}");
}

/// Links at any levels carry exact exchanges of constants: in a closed room even light is as bright on each
/// wall.
#[test]
fn links_of_squares_keep_the_mean_of_even_light() {
    for eps in [1e-2, 1e-3] {
        let scene = builtin("furnace-cube");
        let solved = solved(&scene, &HierarchyOptions { eps, ..HierarchyOptions::default() });
        assert!(solved.leaves().len() > 6, "some walls are cut");
        let power = solved.hierarchy().exchange(&vec![1.0; solved.leaves().len()]);
        for surface in 0..scene.surfaces.len() {
            let received: f64 = solved.hierarchy().of_surface(surface).map(|leaf| power[leaf]).sum();
            assert!((received - 1.0).abs() < 1e-12, "{eps}, {surface}: {received}");
        }
        let mean = mean_radiosity(&solved);
        assert!((mean - 2.0).abs() < 0.03, "{eps}: {mean}");
    }
}

/// Greatest and least sum of the form factors of a leaf.
fn row_sums(solved: &Hierarchical) -> [f64; 2] {
    let power = solved.hierarchy().exchange(&vec![1.0; solved.leaves().len()]);
    let sums = solved.leaves().iter().zip(power).map(|(leaf, power)| power / leaf.area);
    sums.fold([f64::INFINITY, 0.0], |[least, most], sum| [least.min(sum), most.max(sum)])
}

/// In a closed room the form factors of every leaf add up to 1: the more nearly, the weaker links are. Without
/// links handed down the greatest sum grew, from 1.31 to 1.43 and from 1.19 to 1.32.
#[test]
fn form_factors_of_every_leaf_tend_to_add_up_to_one() {
    for (name, most) in [("empty-box", [0.3, 0.16]), ("two-boxes", [0.5, 0.3])] {
        let deviations = [1e-2, 1e-3].map(|eps| {
            let options = HierarchyOptions { eps, ..HierarchyOptions::default() };
            let [least, most] = row_sums(&solved(&builtin(name), &options));
            (1.0 - least).max(most - 1.0)
        });
        let [rough, fine] = deviations;
        assert!(rough < most[0] && fine < most[1] && fine < 0.7 * rough, "{name}: {deviations:?}");
    }
}

/// Part of the rays from a leaf, by the cosine, that meet the front of a surface.
fn met(scene: &Scene, rays: &RayTree, leaf: &Leaf, count: u64) -> f64 {
    let shape = &scene.surfaces[leaf.surface].shape;
    let (mut met, mut all) = (0.0, 0.0);
    for [a, b, c, d] in (0..count).map(kronecker::point::<4>) {
        let within = |[low, high]: [f64; 2], share: f64| low + (high - low) * share;
        let jet = shape.jet(within(leaf.rect.u, a), within(leaf.rect.v, b));
        let (along, across) = jet.normal.any_orthonormal_pair();
        let (sin, cos) = (2.0 * PI * c).sin_cos();
        let direction = (along * cos + across * sin) * d.sqrt() + jet.normal * (1.0 - d).sqrt();
        let area = jet.du.cross(jet.dv).length();
        all += area;
        let first = rays.nearest_from(leaf.surface, jet.position, direction);
        met += if first.is_some_and(|first| first.front) { area } else { 0.0 };
    }
    met / all
}

/// The teapot's room is open, and its surfaces are curved: rays tell what the form factors of a leaf add up to.
#[test]
fn form_factors_of_leaves_add_up_to_what_rays_meet() {
    let scene = builtin("teapot");
    let rays = RayTree::new(scene.surfaces.iter().map(|surface| surface.shape.clone()).collect());
    let deviations = [1e-2, 1e-3].map(|eps| {
        // Clusters, which this distance keeps apart from all, add up to an eighth on the neck of the pot.
        let usual = HierarchyOptions::default();
        let options = HierarchyOptions { eps, rays_per_link: 64, separation: 100.0, ..usual };
        let solved = solved(&scene, &options);
        let power = solved.hierarchy().exchange(&vec![1.0; solved.leaves().len()]);
        let (mut missed, mut areas, mut most) = (0.0, 0.0, 0.0f64);
        for (leaf, power) in solved.leaves().iter().zip(power) {
            let deviation = power / leaf.area - met(&scene, &rays, leaf, 1000);
            missed += leaf.area * deviation.powi(2);
            areas += leaf.area;
            most = most.max(power / leaf.area);
        }
        assert!(most < 1.08, "{eps}: {most}");
        f64::sqrt(missed / areas)
    });
    assert!(deviations[1] < deviations[0] && deviations[1] < 0.05, "{deviations:?}");
}

/// Every leaf of a furnace, not their mean alone, is as bright as the closed form says, by either measure.
#[test]
fn every_leaf_of_a_furnace_is_nearly_two() {
    for (measure, falling) in [(LinkMeasure::Power, [1e-2, 1e-3]), (LinkMeasure::FormFactor, [0.1, 0.03])] {
        let worst = falling.map(|eps| {
            let usual = HierarchyOptions::default();
            let options = HierarchyOptions { measure, eps, least_area: 1e-3, ..usual };
            let solved = solved(&hall(1, true), &options);
            solved.radiosity(0).iter().map(|b| (b - 2.0).abs()).fold(0.0, f64::max)
        });
        assert!(worst[1] < worst[0] && worst[1] < 0.3, "{measure:?}: {worst:?}");
    }
}

/// The mean by area.
fn mean_radiosity(solved: &Hierarchical) -> f64 {
    let areas: Vec<f64> = solved.leaves().iter().map(|leaf| leaf.area).collect();
    dot(&areas, solved.radiosity(0)) / areas.iter().sum::<f64>()
}

#[test]
fn furnace_of_clusters_is_nearly_two() {
    let scene = hall(3, true);
    let solved = solved(&scene, &HierarchyOptions { eps: 1e-3, ..HierarchyOptions::default() });
    assert!(solved.counts().cluster_links > 1000);
    let mean = mean_radiosity(&solved);
    assert!((mean - 2.0).abs() < 0.03, "{mean}");
}

/// Mean |E − 2| of the surfaces of a furnace, by area.
fn furnace_error(scene: &Scene, separation: f64) -> f64 {
    let options =
        HierarchyOptions { eps: 1e-3, separation, rays_per_link: 64, ..HierarchyOptions::default() };
    let solved = solved(scene, &options);
    let areas: Vec<f64> = scene.surfaces.iter().map(|surface| surface.shape.area()).collect();
    let errors = (0..areas.len()).map(|surface| (solved.mean_irradiance(0, surface) - 2.0).abs());
    dot(&areas, &errors.collect::<Vec<_>>()) / areas.iter().sum::<f64>()
}

#[test]
fn clusters_err_less_the_farther_they_are_apart() {
    let scene = hall(3, true);
    let [near, far] = [1.0, 4.0].map(|separation| furnace_error(&scene, separation));
    assert!(near < 0.1 && far < 0.7 * near, "{near} {far}");
}

#[test]
fn furnace_of_a_hollow_ball_is_nearly_two() {
    let mut room = SceneBuilder::new("ball", ["grey"]);
    let glow = room.material("glow", material(0.5, 1.0));
    let ball = ball(DVec3::ZERO, 1.0);
    room.surface("ball", ball, &glow).flip();
    let scene = room.build().expect("it is hollow");
    for eps in [3.0, 1e-2] {
        let solved = solved(&scene, &HierarchyOptions { eps, ..HierarchyOptions::default() });
        assert!(solved.radiosity(0).iter().all(|b| (b - 2.0).abs() < 0.02), "{eps}");
    }
}

#[test]
fn furnace_with_a_ball_in_a_box_is_nearly_two() {
    let mut room = SceneBuilder::new("ball in a box", ["grey"]);
    let glow = room.material("glow", material(0.5, 1.0));
    add_box(&mut room, "room", [DVec3::ONE, DVec3::ZERO], &glow);
    let ball = ball(DVec3::splat(0.5), 0.3);
    room.surface("ball", ball, &glow);
    let scene = room.build().expect("the ball fits into the box");
    let solved = solved(&scene, &HierarchyOptions { eps: 1e-3, ..HierarchyOptions::default() });
    let mean = mean_radiosity(&solved);
    assert!((mean - 2.0).abs() < 0.03, "{mean}");
    for surface in 0..scene.surfaces.len() {
        let irradiance = solved.mean_irradiance(0, surface);
        assert!((irradiance - 2.0).abs() < 0.06, "{surface}: {irradiance}");
    }
}

/// Of n surfaces in the same room there are n²/2 pairs, but links of the order of n.
#[test]
fn links_grow_like_the_surfaces() {
    let counts = [4, 8].map(|boxes| {
        let options = HierarchyOptions { eps: 1e-2, rays_per_link: 1, ..HierarchyOptions::default() };
        solved(&hall(boxes, false), &options).counts()
    });
    let growth = |of: fn(&Counts) -> usize| (of(&counts[1]) as f64 / of(&counts[0]) as f64).ln();
    let power = growth(|counts| counts.links) / growth(|counts| counts.surfaces);
    assert!(power < 1.25, "{power}: {counts:?}");
}

/// F of two opposite squares of side and distance 1: 2/π (ln √(4/3) + 2 √2 atan(1/√2) − π/2).
#[test]
fn parallel_squares_exchange_what_the_closed_form_says() {
    let exact = 2.0 / PI * ((4.0f64 / 3.0).sqrt().ln() + 2.0 * 2f64.sqrt() * 0.5f64.sqrt().atan() - 0.5 * PI);
    let mut room = SceneBuilder::new("squares", ["grey"]);
    let lamp = room.material("lamp", material(0.0, 1.0));
    let black = room.material("black", material(0.0, 0.0));
    let square = |origin, a, b| plate(origin, a, b);
    room.surface("lamp", square(DVec3::ZERO, DVec3::X, DVec3::Y), &lamp);
    room.surface("black", square(DVec3::Z, DVec3::Y, DVec3::X), &black);
    let scene = room.build().expect("they keep apart");
    for eps in [1.0, 1e-4] {
        let solved = solved(&scene, &HierarchyOptions { eps, ..HierarchyOptions::default() });
        let found = solved.mean_irradiance(0, 1);
        assert!((found - exact).abs() < 1e-12, "{eps}: {found} {exact}");
        assert_eq!(solved.mean_irradiance(0, 0), 0.0);
    }
}

#[test]
fn gathering_and_conjugate_gradients_agree() {
    let solved =
        solved(&hall(2, false), &HierarchyOptions { tolerance: 1e-12, ..HierarchyOptions::default() });
    let scene = hall(2, false);
    let reflectance: Vec<f64> = scene.surfaces.iter().map(|own| own.material.reflectance[0]).collect();
    let exitance: Vec<f64> = scene.surfaces.iter().map(|own| own.exitance(0)).collect();
    let system = BandSystem::new(solved.hierarchy(), &reflectance, &exitance);
    let (radiosity, count) = system.gathered(1e-13, 200);
    assert!(count < 200, "errors halve in each gathering");
    assert!(distance(&radiosity, solved.radiosity(0)) < 1e-10 * norm(&radiosity));
}

#[test]
fn light_agrees_with_that_of_polynomials() {
    let scene = builtin("cornell-box");
    let options = Options { order: 4, shadow_eps: 1e-3, ..Options::default() };
    let exact = outcome_of(&scene, &options).solution;
    let solved = solved(&scene, &HierarchyOptions { eps: 3e-4, ..HierarchyOptions::default() });
    let means: Vec<f64> = (0..scene.surfaces.len()).map(|k| exact.mean_irradiance(0, k)).collect();
    let largest = means.iter().copied().fold(0.0, f64::max);
    for (surface, mean) in means.iter().enumerate() {
        let found = solved.mean_irradiance(0, surface);
        assert!((found - mean).abs() < 0.02 * largest, "{}: {found} {mean}", scene.surfaces[surface].name);
    }
}

#[test]
fn threads_change_no_bit() {
    let run = |threads| {
        let options = HierarchyOptions { eps: 1e-3, ..HierarchyOptions::default() };
        let solved = in_threads(threads, || solved(&hall(2, false), &options)).expect("threads start");
        let bits: Vec<u64> = solved.radiosity(0).iter().map(|b| b.to_bits()).collect();
        (solved.counts(), bits)
    };
    assert_eq!(run(1), run(2));
}

#[test]
fn options_out_of_range_are_refused() {
    let good = HierarchyOptions::default();
    let wrong = [
        HierarchyOptions { eps: 0.0, ..good },
        HierarchyOptions { least_area: f64::NAN, ..good },
        HierarchyOptions { separation: 0.5, ..good },
        HierarchyOptions { rounds: 0, ..good },
        HierarchyOptions { rays_per_link: 0, ..good },
    ];
    for options in wrong {
        let refused = solve_hierarchically(&builtin("furnace-cube"), &options, &|_| {});
        assert!(matches!(refused, Err(HierarchyError::Option { .. })), "{options:?}");
    }
}
