//! Hierarchical radiosity: push-pull, clusters, and the light of rooms whose light is known.

use std::f64::consts::PI;

use proptest::prelude::*;
use radiosity::Work;
use radiosity::elements::rule::UnitRule;
use radiosity::elements::space::Space;
use radiosity::elements::{Discretization, Element, Elements};
use radiosity::geom::DVec3;
use radiosity::geom::shapes::{Polygon, Sphere};
use radiosity::kernel::{Accuracy, Blocks, PlacedBlock};
use radiosity::published::hierarchy::harmonics::{HARMONICS, clamped_cosine, harmonics};
use radiosity::published::hierarchy::linked_blocks::{LevelElement, LinkedBlocks};
use radiosity::published::hierarchy::two_scale::TwoScale;
use radiosity::published::hierarchy::{
    BandSystem, Counts, Fields, Hierarchical, HierarchyError, HierarchyOptions, solve_hierarchically,
};
use radiosity::scene::{NamedMaterial, Scene, SceneBuilder};
use radiosity::solve::solved::Solved;
use radiosity::solve::studies::adaptation::{Aim, Goal};
use radiosity::solve::{LightMethod, Options, Outcome, in_threads};
use radiosity::visibility::{Shadows, Visibility};
use radiosity_core::legendre::{Half, two_scale};
use radiosity_test_support::scenes::grey;
use radiosity_test_support::scenes::{builtin, material};
use radiosity_test_support::shapes::faces;
use radiosity_test_support::shapes::{ball, plate};
use radiosity_test_support::solved::{blocks_of, outcome_of, solved_of};

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
    let solved = solved(&builtin("cornell-box"), &HierarchyOptions::default());
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
    let solved = solved(&scene, &HierarchyOptions::default());
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
    assert!(outcome.residual < 1e-6 && outcome.checks.reciprocity_max == 0.0);
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

/// The error that is told of gathered light is that against polynomials of order 5, within a factor of three.
#[test]
fn runs_by_links_tell_the_error_of_gathered_light() {
    let scene = builtin("two-boxes");
    let options = Options { method: LightMethod::Hierarchical, ..Options::default() };
    let goal = Goal::new(2e-2, Aim::Gathered);
    let rough =
        Solved::to_accuracy(scene.clone(), &options, &goal, &Work::alone()).expect("it can be solved");
    let told = rough.achieved.and_then(|achieved| achieved.estimate).expect("it is told");
    let exact = Options { order: 5, eps: 1e-4, shadow_eps: 1e-3, ..Options::default() };
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

fn cut(scene: &Scene, order: usize, space: Space, parts: usize) -> Elements {
    let how = Discretization { space, ..Discretization::uniform(order, parts) };
    Elements::new(scene, &how).expect("surfaces have area")
}

/// A scene of one surface of any shape.
fn single(shape: impl radiosity::geom::Surface + 'static) -> Scene {
    let (mut room, grey) = grey();
    room.surface("single", shape, &grey);
    room.build().expect("it has an area")
}

/// On a parallelogram H is ½ of the product of the matrices of the Legendre basis.
#[test]
fn parallelograms_have_the_two_scale_matrix_of_legendre_polynomials() {
    const COUNT: usize = 5;
    let halves = [Half::Left, Half::Right].map(two_scale::<COUNT>);
    let side = DVec3::new(0.7, 1.3, 0.2);
    let shape = plate(DVec3::ZERO, 3.0 * DVec3::X, side);
    let scene = single(shape);
    for space in [Space::Total, Space::Tensor] {
        let [coarse, fine] = [1, 2].map(|parts| cut(&scene, COUNT - 1, space, parts));
        let parent = &coarse.list()[0];
        let degrees: Vec<(usize, usize)> = parent.basis.degrees().collect();
        for child in fine.list() {
            let [u, v] = child.rect.center().map(|middle| &halves[usize::from(middle > 0.0)]);
            let scale = TwoScale::new(parent, child);
            for (m, row) in scale.values().chunks_exact(degrees.len()).enumerate() {
                for (k, h) in row.iter().enumerate() {
                    let ((i, j), (p, q)) = (degrees[k], degrees[m]);
                    let exact = 0.5 * u[i][p] * v[j][q];
                    assert!((h - exact).abs() < 1e-13, "{space:?} {k} {m}: {h} {exact}");
                }
            }
        }
    }
}

/// B at a point of an element, from its coefficients in the orthonormal basis.
fn value(element: &Element, coefficients: &[f64], position: DVec3, parameters: [f64; 2]) -> f64 {
    element.evaluate(&element.basis.to_raw(coefficients), position, parameters)
}

/// Push keeps values at points and ∫ B²; pull undoes it and is its transpose.
fn check_two_scale(scene: &Scene, order: usize, tolerance: f64) -> Result<(), TestCaseError> {
    let [coarse, fine] = [1, 2].map(|parts| cut(scene, order, Space::Total, parts));
    let parent = &coarse.list()[0];
    let b = scattered(parent.basis.len(), order);
    let (mut back, mut energy) = (vec![0.0; b.len()], 0.0);
    for (index, child) in fine.list().iter().enumerate() {
        let scale = TwoScale::new(parent, child);
        let mut own = vec![0.0; child.basis.len()];
        scale.push(&b, &mut own);
        scale.pull(&own, &mut back);
        energy += dot(&own, &own);
        for patch in &child.patches {
            let node = patch.node(0.3, 0.6);
            let parameters = node.parameters.to_array();
            let [above, below] = [(parent, &b), (child, &own)]
                .map(|(element, b)| value(element, b, node.position, parameters));
            prop_assert!((above - below).abs() < tolerance * norm(&b) / child.area.sqrt(), "{above} {below}");
        }
        let y = scattered(own.len(), index + 50);
        let mut pulled = vec![0.0; b.len()];
        scale.pull(&y, &mut pulled);
        prop_assert!((dot(&pulled, &b) - dot(&y, &own)).abs() < 1e-14 * norm(&y) * norm(&b) * 10.0);
    }
    prop_assert!(distance(&back, &b) < tolerance * norm(&b), "pull undoes push: {back:?} {b:?}");
    prop_assert!((energy / dot(&b, &b) - 1.0).abs() < tolerance, "{energy}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn push_and_pull_keep_polynomials_on_any_quadrilateral(
        order in 0..=4usize, corner in (0.6..1.5, 0.6..1.5), turn in -3.0..3.0, stretch in 0.2..5.0,
    ) {
        let turned = |x: f64, y: f64| {
            let (sin, cos) = f64::sin_cos(turn);
            stretch * DVec3::new(cos * x - sin * y, sin * x + cos * y, 0.3 * x)
        };
        let ring = vec![turned(0.0, 0.0), turned(1.0, 0.0), turned(corner.0, corner.1), turned(0.0, 1.0)];
        let shape = Polygon::new(ring, Vec::new()).expect("it is convex");
        check_two_scale(&single(shape), order, 1e-12)?;
    }
}

#[test]
fn push_and_pull_keep_polynomials_on_curved_surfaces_and_around_holes() {
    let ball =
        Sphere::new(DVec3::ONE, 2.0, DVec3::Z, [-1.0, 1.5], [0.3, 2.0]).expect("it is a part of a ball");
    let at = |x: f64, y: f64| DVec3::new(x, y, 1.0);
    let outer = vec![at(0.0, 0.0), at(4.0, 0.0), at(4.0, 3.0), at(0.0, 3.0)];
    let hole = vec![at(0.5, 0.7), at(2.5, 0.7), at(2.0, 2.2)];
    let holed = Polygon::new(outer, vec![hole]).expect("the hole lies inside");
    for order in 0..=4 {
        check_two_scale(&single(ball.clone()), order, 1e-11).expect("a part of a ball");
        check_two_scale(&single(holed.clone()), order, 1e-12).expect("a polygon with a hole");
    }
}

fn blocks(scene: &Scene, elements: &Elements, eps: f64) -> Blocks {
    let accuracy = Accuracy { eps, shadow_eps: 3e-3 };
    blocks_of(elements, &Visibility::new(scene, Shadows::Auto, 3e-3), accuracy)
}

#[test]
fn blocks_linked_at_the_leaves_are_the_flat_operator() {
    for (name, order) in [("cornell-box", 0), ("furnace-cube", 0), ("furnace-cube", 2)] {
        let scene = builtin(name);
        let [whole, halves, quarters] = [1, 2, 4].map(|parts| cut(&scene, order, Space::Total, parts));
        let flat = blocks(&scene, &quarters, 1e-3);
        let mut linked = LinkedBlocks::new(&[&whole, &halves, &quarters]);
        for PlacedBlock { row, column, values } in flat.iter() {
            linked.link([row, column].map(|index| LevelElement { level: 2, index }), &values);
        }
        let x = scattered(flat.dim(), 3);
        let (ours, theirs) = (linked.apply(&x), flat.apply(&x));
        assert!(distance(&ours, &theirs) < 1e-13 * norm(&theirs), "{name}, order {order}");
    }
}

/// The polynomials of an element are among those of its parts: its block is that of the parts, pulled from
/// both sides.
#[test]
fn blocks_of_larger_elements_are_pulled_from_those_of_their_parts() {
    let scene = builtin("furnace-cube");
    let [coarse, fine] = [1, 2].map(|parts| cut(&scene, 2, Space::Total, parts));
    let [large, small] = [&coarse, &fine].map(|elements| blocks(&scene, elements, 1e-9));
    let levels = LinkedBlocks::new(&[&coarse, &fine]);
    let b = scattered(large.dim(), 5);
    let above = |coarse: Vec<f64>| [coarse, vec![0.0; small.dim()]].concat();
    let restricted = levels.push(above(b.clone()));
    let pulled = levels.pull(&small.apply(&restricted));
    let direct = large.apply(&b);
    assert!(distance(&pulled[..large.dim()], &direct) < 1e-7 * norm(&direct));
    // Links between whole faces send the same polynomials as the blocks of these do.
    let mut linked = LinkedBlocks::new(&[&coarse, &fine]);
    for PlacedBlock { row, column, values } in large.iter() {
        linked.link([row, column].map(|index| LevelElement { level: 0, index }), &values);
    }
    let received = levels.push(above(direct));
    assert!(distance(&linked.apply(&restricted), &received) < 1e-13 * norm(&received));
}
