//! Distances of solutions, series of runs and wanted accuracies, against closed forms and exact references.

use std::sync::{Mutex, OnceLock};
use std::time::Duration;

use proptest::prelude::*;
use radiosity::Work;
use radiosity::elements::cells::Layers;
use radiosity::elements::coating::Coating;
use radiosity::elements::rule::UnitRule;
use radiosity::elements::space::Space;
use radiosity::elements::{Discretization, Element, Elements, Subdivide};
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::scene::Scene;
use radiosity::solve::driver::memory_estimate::MemoryEstimate;
use radiosity::solve::gather::Gather;
use radiosity::solve::solution::{Band, Solution, SurfacePlace};
use radiosity::solve::solved::Solved;
use radiosity::solve::studies::adaptation::{Achieved, Aim, EndReason, Goal};
use radiosity::solve::studies::convergence::{Reference, convergence};
use radiosity::solve::studies::error_norm::{Incomparable, distance};
use radiosity::solve::system::Coefficients;
use radiosity::solve::{Options, Outcome};
use radiosity::work::ranks::Ranks;
use radiosity::work::{Progress, Stage};
use radiosity_geom::DVec3;
use radiosity_test_support::data::{number, table};
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::outcome_of;

const SHAPES: [&str; 4] = [
    "parallelogram = { origin = [0,0,0], edge1 = [1,0,0], edge2 = [0,1,0] }",
    "polygon = { vertices = [[0,0,0],[3,0,0],[2,2,0],[0,3,0]], holes = [[[0.5,0.5,0],[0.5,1,0],[1,0.5,0]]] }",
    "quad = { vertices = [[0,0,0],[1,0,0.5],[1,1,0],[0,1,0.3]] }",
    "sphere = { center = [0,0,0], radius = 1 }",
];

fn scene(shape: &str, bands: usize) -> Scene {
    let bands: Vec<String> = (0..bands).map(|k| format!("\"b{k}\"")).collect();
    let text = format!(
        "bands = [{}]\n[materials.grey]\nreflectance = 0.5\nemission = 7\n[[surfaces]]\nmaterial = \"grey\"\n{shape}",
        bands.join(", ")
    );
    typed(&text)
}

/// Coefficients of the projection of a function on an element.
fn projection(element: &Element, function: impl Fn(DVec3) -> f64) -> Vec<f64> {
    let count = element.basis.len();
    let (mut sums, mut raw) = (vec![0.0; count], vec![0.0; count]);
    let rule = UnitRule::of(24);
    for patch in &element.patches {
        for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
            let node = patch.node(s, t);
            element.basis.raw(element.basis.frame().coordinates(&node), &mut raw);
            for (sum, row) in sums.iter_mut().zip(element.basis.transform().chunks_exact(count)) {
                let value: f64 = row.iter().zip(&raw).map(|(t, l)| t * l).sum();
                *sum += ws * wt * node.area * value * function(node.position);
            }
        }
    }
    sums
}

/// A solution whose irradiance is the projection of `function` in every band.
fn given(
    scene: &Scene,
    order: usize,
    cuts: usize,
    layers: usize,
    function: impl Fn(DVec3) -> f64,
) -> Solution {
    let layers = Layers { count: layers, ratio: 0.3 };
    let how = Discretization { order, space: Space::Total, subdivide: Subdivide::Uniform(cuts), layers };
    let elements = Elements::new(scene, &how).expect("the surface has area");
    let irradiance: Vec<f64> = elements.list().iter().flat_map(|e| projection(e, &function)).collect();
    let count = elements.list().len();
    let band = |name: &String| {
        let coating = Coating::constant(vec![0.5; count], vec![7.0; count]);
        let direct = vec![0.0; irradiance.len()];
        let coefficients = Coefficients {
            irradiance: irradiance.clone(),
            radiosity: direct.clone(),
            direct,
            residual: 0.0,
            waiting: None,
        };
        Band::new(name.clone(), &elements, coating, coefficients)
    };
    let bands = scene.bands.iter().map(band).collect();
    Solution::new(elements, bands)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn constants_differ_by_their_ratio_whatever_the_elements(
        shape in 0..SHAPES.len(), orders in prop::array::uniform2(0..4usize),
        cuts in prop::array::uniform2(1..4usize), layers in prop::array::uniform2(0..3usize),
    ) {
        let scene = scene(SHAPES[shape], 2);
        let [one, three] = [(0, 1.0), (1, 3.0)]
            .map(|(k, value)| given(&scene, orders[k], cuts[k], layers[k], |_| value));
        let far = distance(&one, &three).expect("one scene");
        prop_assert!((far - 2.0 / 3.0).abs() < 1e-12, "{far}");
        let back = distance(&three, &one).expect("one scene");
        prop_assert!((back - 2.0).abs() < 1e-12, "{back}");
    }

    #[test]
    fn a_linear_function_is_the_same_on_all_elements(
        orders in prop::array::uniform2(1..5usize), cuts in prop::array::uniform2(1..4usize), shape in 0..2usize,
    ) {
        let scene = scene(SHAPES[shape], 1);
        let [a, b] = [0, 1].map(|k| given(&scene, orders[k], cuts[k], k, |x| 1.0 + x.x - 2.0 * x.y));
        prop_assert!(distance(&a, &b).expect("one scene") < 1e-13);
    }
}

#[test]
fn means_miss_the_slope_of_a_linear_function() {
    let scene = scene(SHAPES[0], 1);
    let slope = |x: DVec3| 1.0 + x.x + 2.0 * x.y;
    let exact = given(&scene, 1, 1, 0, slope);
    for cuts in [1, 2, 4] {
        let far = distance(&given(&scene, 0, cuts, 0, slope), &exact).expect("one scene");
        // Variance (1 + 4)/12 of a unit square, a mean of 5/2.
        let expected = f64::sqrt(5.0 / 12.0 / (6.25 + 5.0 / 12.0)) / cuts as f64;
        assert!((far - expected).abs() < 1e-13, "{cuts} cuts: {far} instead of {expected}");
    }
}

#[test]
fn solutions_of_different_scenes_are_refused() {
    let [one, two] = [1, 2].map(|bands| given(&scene(SHAPES[0], bands), 0, 1, 0, |_| 1.0));
    assert_eq!(distance(&one, &two), Err(Incomparable::Bands(1, 2)));
    let back = scene(&format!("two_sided = true\n{}", SHAPES[0]), 1);
    let back = given(&back, 0, 1, 0, |_| 1.0);
    assert_eq!(distance(&back, &one), Err(Incomparable::Surfaces(2, 1)));
}

/// Errors of whole walls of the empty box at orders 4 and 6, of the radiosity less what is emitted: measured
/// with exact matrices.
const WHOLE_WALLS: [(usize, f64); 2] = [(4, 0.020), (6, 0.0105)];

#[test]
fn a_series_finds_the_known_errors_of_the_empty_box() {
    let scene = builtin("empty-box");
    let layers = Layers { count: 2, ratio: 0.25 };
    let fine = Options { order: 5, layers, threads: 2, ..Options::default() };
    let fine = outcome_of(&scene, &fine).solution;
    let error = |solution: &Solution| distance(solution, &fine).expect("one scene");
    let reports = Mutex::new(vec![0]);
    let solves = Mutex::new([0; 2]);
    let count = |end: usize| solves.lock().expect("nobody panics")[end] += 1;
    let observe = |progress| match progress {
        Progress::Done { stage: Stage::Runs, done, of: 1000 } => {
            reports.lock().expect("nobody panics").push(done);
        }
        Progress::Began { stage: Stage::Solve } => count(0),
        Progress::Ended { stage: Stage::Solve } => count(1),
        Progress::Began { .. } | Progress::Ended { .. } => {}
        other => panic!("{other:?}"),
    };
    let work = Work::alone().observed_by(&observe);
    let options = Options { order: 6, threads: 2, ..Options::default() };
    let runs =
        convergence(&scene, &options, &[], &Reference::Given(&error), &work).expect("it can be solved");
    assert_eq!(runs.iter().map(|run| run.order).collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5, 6]);
    for (order, known) in WHOLE_WALLS {
        let error = runs[order].error.expect("there is a reference");
        assert!((error / known - 1.0).abs() < 0.1, "order {order}: {error} instead of {known}");
    }
    assert_eq!(solves.into_inner().expect("nobody panicked"), [7; 2], "all stages of all runs are told");
    let reports = reports.into_inner().expect("nobody panicked");
    assert!(reports.is_sorted() && reports.last() == Some(&1000), "progress rises to the end");
}

#[test]
fn the_finest_run_has_no_error_of_its_own() {
    let scene = builtin("furnace-cube");
    let layers = Layers { count: 1, ratio: 0.25 };
    let options = Options { order: 1, layers, threads: 2, ..Options::default() };
    let runs =
        convergence(&scene, &options, &[], &Reference::FinestRun, &Work::alone()).expect("it can be solved");
    let places: Vec<(usize, usize)> = runs.iter().map(|run| (run.layers, run.order)).collect();
    assert_eq!(places, [(0, 0), (0, 1), (1, 0), (1, 1)]);
    assert_eq!(runs[3].error, None);
    // B = 2 exactly, in every space: what is left is what the transfers miss.
    assert!(runs[..3].iter().all(|run| run.error.is_some_and(|error| error < 1e-2)));
}

fn adapted(name: &str, goal: Goal) -> Solved {
    let scene = builtin(name);
    let options = Options { order: 0, threads: 2, ..Options::default() };
    Solved::to_accuracy(scene, &options, &goal, &Work::alone()).expect("it can be solved")
}

fn achieved(adapted: &Solved) -> Achieved {
    adapted.achieved.expect("an accuracy was wanted")
}

fn radiosity(adapted: &Solved, surface: usize, position: [f64; 3]) -> f64 {
    let solution = &adapted.outcome.solution;
    let position = DVec3::from_array(position);
    let hit = |element: &&usize| {
        let element = &solution.elements().list()[**element];
        let bounds = element.bounds();
        position.cmpge(bounds.min - 1e-12).all() && position.cmple(bounds.max + 1e-12).all()
    };
    let elements: Vec<usize> = solution.elements().of_surface(surface).collect();
    let element = *elements.iter().find(hit).expect("the point lies on the surface");
    solution.radiosity(0, element, &SurfacePlace { surface, parameters: [0.0; 2], position })
}

#[test]
fn the_furnace_is_met_to_the_accuracy_wanted() {
    for accuracy in [1e-2, 1e-4] {
        let adapted = adapted("furnace-cube", Goal::new(accuracy, Aim::Solution));
        assert!(achieved(&adapted).reached() && achieved(&adapted).estimate.unwrap() <= accuracy);
        for surface in 0..6 {
            let element = &adapted.outcome.solution.elements().list()
                [adapted.outcome.solution.elements().of_surface(surface).start];
            let middle = element.patches[0].node(0.3, 0.4).position.to_array();
            let found = radiosity(&adapted, surface, middle);
            assert!((found - 2.0).abs() <= accuracy, "{found} at {middle:?}");
        }
    }
}

#[test]
fn the_empty_box_is_met_to_the_accuracy_wanted() {
    let file = table("box_radiosity.json");
    let points = file["scenes"][0]["points"].as_array().expect("points are listed");
    for accuracy in [3e-2, 1e-2, 3e-3] {
        let adapted = adapted("empty-box", Goal::new(accuracy, Aim::Solution));
        assert!(achieved(&adapted).reached() && achieved(&adapted).estimate.unwrap() <= accuracy);
        let squares: Vec<[f64; 2]> = points
            .iter()
            .map(|point| {
                let (a, b, exact) = (number(&point[1][0]), number(&point[1][1]), number(&point[2]));
                let (surface, place, emitted) = match point[0].as_str() {
                    Some("floor") => (0, [a, b, 0.0], 0.0),
                    Some("ceiling") => (1, [a, b, 1.0], 1.0),
                    _ => (2, [0.0, a, b], 0.0),
                };
                [(radiosity(&adapted, surface, place) - exact).powi(2), (exact - emitted).powi(2)]
            })
            .collect();
        let sum = |k: usize| squares.iter().map(|s| s[k]).sum::<f64>();
        let error = (sum(0) / sum(1)).sqrt();
        assert!(error <= accuracy, "error {error} at the points, {accuracy} wanted");
    }
}

/// Reflected light gathered to `eps` at some of the middles of a grid on three walls of the empty box.
fn gathered(solution: &Solution, options: &Options, eps: f64) -> Vec<f64> {
    const CELLS: usize = 20;
    // Coprime to the cells of a row: some lie at each border.
    const EVERY: usize = 3;
    let visibility = options.visibility(&builtin("empty-box"));
    let gather = Gather::new(solution, &visibility, eps);
    let middle = |k: usize| (k as f64 + 0.5) / CELLS as f64;
    let mut light = Vec::new();
    for (a, b) in (0..CELLS * CELLS).step_by(EVERY).map(|k| (middle(k / CELLS), middle(k % CELLS))) {
        let floor = ReceiverPoint::on(0, DVec3::new(a, b, 0.0), DVec3::Z);
        let ceiling = ReceiverPoint::on(1, DVec3::new(a, b, 1.0), DVec3::NEG_Z);
        let wall = ReceiverPoint::on(2, DVec3::new(0.0, a, b), DVec3::X);
        // There are four walls.
        light.extend(
            [(floor, 1.0), (ceiling, 1.0), (wall, 2.0)].map(|(point, root)| root * gather.at(&point)[0]),
        );
    }
    light
}

/// The empty box in a run that is known to be right to 1e-4 (`light::gather`), and its options.
fn right() -> &'static (Solution, Options) {
    static RIGHT: OnceLock<(Solution, Options)> = OnceLock::new();
    RIGHT.get_or_init(|| {
        let layers = Layers { count: 2, ratio: 0.25 };
        let options =
            Options { order: 8, layers, eps: 1e-6, shadow_eps: 1e-6, threads: 2, ..Options::default() };
        (outcome_of(&builtin("empty-box"), &options).solution, options)
    })
}

#[test]
fn gathered_light_of_the_empty_box_is_met_to_the_accuracy_wanted_with_fewer_unknowns() {
    let (solution, options) = right();
    let exact = gathered(solution, options, 3e-5);
    for accuracy in [1e-2, 1e-3, 3e-4] {
        let adapted = |of| adapted("empty-box", Goal::new(accuracy, of));
        let gathered_to = adapted(Aim::Gathered);
        let (achieved, Solved { outcome, options, .. }) = (achieved(&gathered_to), gathered_to);
        assert!(achieved.reached() && achieved.of == Aim::Gathered);
        let found = gathered(&outcome.solution, &options, 3e-5);
        let squares = |value: &dyn Fn(usize) -> f64| (0..exact.len()).map(|k| value(k).powi(2)).sum::<f64>();
        let error = (squares(&|k| found[k] - exact[k]) / squares(&|k| exact[k])).sqrt();
        let estimate = achieved.estimate.expect("it was estimated");
        assert!(error <= accuracy, "error {error}, {accuracy} wanted");
        // The noise of the rays hides errors below a tenth of that of the polynomials.
        let most = (3.0 * error).max(0.5 * accuracy);
        assert!(error / 2.0 <= estimate && estimate <= most, "error {error}, estimated {estimate}");
        let unknowns = |outcome: &Outcome| outcome.solution.elements().coefficients();
        let [few, many] = [unknowns(&outcome), unknowns(&adapted(Aim::Solution).outcome)];
        assert!(few < many, "{few} unknowns for gathered light, {many} for polynomials");
    }
}

#[test]
fn light_at_points_is_met_with_fewer_unknowns_than_on_all_surfaces() {
    let scene = builtin("empty-box");
    let (exact, options) = right();
    let visibility = options.visibility(&scene);
    let places: Vec<DVec3> =
        (0..20).map(|k| DVec3::new(0.3 + 0.02 * f64::from(k), 0.6 - 0.01 * f64::from(k), 0.5)).collect();
    let read = |solution: &Solution| -> Vec<f64> {
        let gather = Gather::new(solution, &visibility, 1e-5);
        places.iter().map(|place| gather.at(&ReceiverPoint::free(*place, DVec3::Z))[0]).collect()
    };
    let known = read(exact);
    for accuracy in [3e-3, 1e-3] {
        let points = places.iter().map(|place| [*place - scene.middle, DVec3::Z]).collect();
        let here = adapted("empty-box", Goal::at(accuracy, points));
        assert!(achieved(&here).reached() && achieved(&here).of == Aim::Points);
        let found = read(&here.outcome.solution);
        let off = found.iter().zip(&known).map(|(found, known)| (found / known - 1.0).powi(2));
        let error = (off.sum::<f64>() / 20.0).sqrt();
        assert!(error <= accuracy, "error {error}, {accuracy} wanted");
        let everywhere = adapted("empty-box", Goal::new(accuracy, Aim::Gathered));
        let [few, many] = [&here, &everywhere].map(|run| run.outcome.solution.elements().coefficients());
        assert!(few < many, "{few} unknowns for the points, {many} for all surfaces");
    }
}

#[test]
fn what_cannot_be_reached_is_told() {
    let adapted = adapted("empty-box", Goal { most_unknowns: 200, ..Goal::new(1e-3, Aim::Solution) });
    assert_eq!(achieved(&adapted).end, EndReason::Unknowns);
    let estimate = achieved(&adapted).estimate.unwrap();
    assert!(estimate > 1e-3 && estimate < 0.1);
    assert!(adapted.outcome.solution.elements().coefficients() <= 200);
}

/// Walks show ten percent at once, so that the judge alone tells that the first run is right.
#[test]
fn the_time_of_a_judge_is_a_part_of_the_estimation() {
    let adapted = adapted("furnace-cube", Goal::new(0.1, Aim::Gathered));
    assert_eq!(achieved(&adapted).end, EndReason::Reached);
    assert!(adapted.outcome.seconds.estimate > Duration::ZERO);
}

#[test]
fn a_finer_run_that_fails_leaves_the_one_before() {
    // What order 3 needs is enough for order 2, the first, but not for order 4, the second.
    let scene = builtin("empty-box");
    let whole = |order| {
        MemoryEstimate::of(
            &scene,
            &Discretization::uniform(order, 1),
            Options::default().solver,
            Ranks::alone(),
        )
        .peak()
    };
    let memory = Some(whole(3));
    assert!(whole(2) < whole(3) && whole(3) < whole(4));
    let options = Options { order: 2, subdivide: Some(1), memory, ..Options::default() };
    let goal = Goal::new(1e-6, Aim::Solution);
    let adapted = Solved::to_accuracy(scene, &options, &goal, &Work::alone()).expect("the first run fits");
    let Achieved { estimate, end, .. } = achieved(&adapted);
    assert!(end == EndReason::Memory && estimate.is_some());
    assert_eq!(adapted.options.order, 2);
}

#[test]
fn runs_of_equal_size_have_no_rate() {
    // Both surfaces state their order: no run differs from another.
    let text = "[materials.grey]\nreflectance = 0.5\nemission = 7\n".to_owned()
        + &["0", "1"].map(|z| {
            format!("[[surfaces]]\nmaterial = \"grey\"\norder = 1\nparallelogram = {{ origin = [0,0,{z}], edge1 = [1,0,0], edge2 = [0,1,0] }}\n")
        }).concat();
    let scene = typed(&text);
    let against = |_: &Solution| 0.1;
    let options = Options { order: 2, ..Options::default() };
    let runs = convergence(&scene, &options, &[], &Reference::Given(&against), &Work::alone()).unwrap();
    assert!(runs.iter().all(|run| run.unknowns == runs[0].unknowns && run.rate.is_none()));
}
