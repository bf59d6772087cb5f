//! Transfers between two flat elements against exact ones, and what they cost.

use radiosity::kernel::BlockStatistics;
use radiosity_geom::DVec3;
use radiosity_test_support::compare::largest;
use radiosity_test_support::data::{list, point, table};
use serde_json::Value;

use crate::transport::flat::{Flat, Outline, block, blocks, elements, scene};

const PARALLELOGRAMS: &str = "transfers_planar.json";
const POLYGONS: &str = "transfers_polygons.json";
/// Accuracies at which every exact transfer is compared.
const EPS: [f64; 4] = [1e-2, 1e-4, 1e-8, 1e-12];
/// A count may exceed the one known to suffice by this factor.
const SLACK: f64 = 1.3;

/// The cases of a table.
fn cases(name: &str) -> Vec<Value> {
    list(&table(name)["cases"]).to_vec()
}

fn points(value: &Value) -> Vec<DVec3> {
    list(value).iter().map(point).collect()
}

/// F to 20 digits.
fn form_factor(case: &Value) -> f64 {
    case["F"].as_str().and_then(|text| text.parse().ok()).expect("F is a decimal string")
}

fn transfer(pair: &[Flat; 2], order: usize, eps: f64) -> (Vec<f64>, BlockStatistics) {
    let scene = scene(pair).expect("the shapes are valid");
    let elements = elements(&scene, order).expect("the shapes have area");
    let blocks = blocks(&scene, &elements, eps);
    let count = elements.list()[0].basis.len();
    (block(&blocks, 0, 1).unwrap_or_else(|| vec![0.0; count * count]), blocks.statistics)
}

/// A pair of the data files: its name, the surfaces, the first one's area and F.
pub(crate) type Exact = (String, [Flat; 2], f64, f64);

/// Pairs of parallelograms.
pub(crate) fn exact_parallelograms() -> Vec<Exact> {
    let pair = |case: &Value| {
        let [receiver, emitter] = ["receiver", "emitter"].map(|key| {
            let side = &case[key];
            let edges = [point(&side["edge_s"]), point(&side["edge_t"])];
            Flat::facing(
                Outline::Parallelogram { origin: point(&side["origin"]), edges },
                point(&side["normal"]),
            )
        });
        let area = receiver.outline.normal().length() / 2.0;
        (case["name"].to_string(), [receiver, emitter], area, form_factor(case))
    };
    cases(PARALLELOGRAMS).iter().map(pair).collect()
}

/// Pairs of polygons, partly behind each other some.
pub(crate) fn exact_polygons() -> Vec<Exact> {
    let pair = |case: &Value| {
        let sides = ["receiver", "emitter"].map(|key| {
            let outer = points(&case[key]);
            let outline = match outer[..] {
                [a, b, c] => Outline::Triangle([a, b, c]),
                _ => Outline::Polygon { outer, holes: Vec::new() },
            };
            Flat::facing(outline, point(&case[format!("{key}_normal")]))
        });
        let area = case["area"].as_f64().expect("a number");
        (case["name"].to_string(), sides, area, form_factor(case))
    };
    cases(POLYGONS).iter().map(pair).collect()
}

/// G of the parallelograms at order 4, row-major, in their order.
fn exact_blocks() -> Vec<Vec<f64>> {
    let block = |(case, (_, [receiver, emitter], ..)): (&Value, &Exact)| {
        let rows = case["K"].as_array().expect("K has rows");
        let entries = rows.iter().flat_map(|row| row.as_array().expect("a row has entries"));
        let areas = [receiver, emitter].map(|side| side.outline.normal().length());
        let scale = (areas[0] / areas[1]).sqrt();
        entries.map(|k| scale * k.as_f64().expect("a number")).collect::<Vec<f64>>()
    };
    cases(PARALLELOGRAMS).iter().zip(&exact_parallelograms()).map(block).collect()
}

#[test]
fn every_entry_of_exact_parallelogram_transfers_is_met() {
    let mut failures = Vec::new();
    for ((name, pair, ..), exact) in exact_parallelograms().into_iter().zip(exact_blocks()) {
        for eps in EPS {
            let (values, cost) = transfer(&pair, 4, eps);
            let error = values.iter().zip(&exact).map(|(g, k)| (g - k).abs()).fold(0.0, f64::max);
            let allowed = eps * largest(&exact) + 1e-13;
            let line = format!(
                "{name}, eps {eps:e}: error {error:.1e} of {allowed:.1e}, {} samples, {} distinct, {} unresolved",
                cost.samples, cost.distinct, cost.pairs.unresolved
            );
            println!("{line}");
            if error.is_nan() || error > allowed {
                failures.push(line);
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn form_factors_of_exact_polygon_transfers_are_met() {
    let mut failures = Vec::new();
    for (name, pair, area, exact) in exact_polygons() {
        let scale = (0.5 * pair[1].outline.normal().length() / area).sqrt();
        for (order, eps) in [0, 4].into_iter().flat_map(|order| EPS.map(|eps| (order, eps))) {
            let (values, cost) = transfer(&pair, order, eps);
            let error = (scale * values[0] - exact).abs();
            let allowed = eps * largest(&values) * scale + 1e-13;
            let line = format!(
                "{name}, order {order}, eps {eps:e}: error {error:.1e} of {allowed:.1e}, {} samples, {} distinct",
                cost.samples, cost.distinct
            );
            println!("{line}");
            if error.is_nan() || error > allowed {
                failures.push(line);
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Angular or tensor points for N = 4 and N = 8 at ε = 1e-2, 1e-4, 1e-8.
type Points = [[u64; 3]; 2];

const ORDERS: [usize; 2] = [4, 8];

/// A pair with the samples, and where the kernel repeats the distinct kernel values, that are known to do.
struct Cost {
    name: String,
    pair: [Flat; 2],
    samples: Points,
    distinct: Option<Points>,
}

/// Parallelograms of unit width along x: one of depth `depths[0]` in z = 0, one hinged to its edge y = 0.
fn hinge(degrees: f64, depths: [f64; 2]) -> [Flat; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let side = |across: DVec3, front: DVec3| {
        let outline = Outline::Parallelogram { origin: DVec3::ZERO, edges: [DVec3::X, across] };
        Flat::facing(outline, front)
    };
    [
        side(DVec3::Y * depths[0], DVec3::Z),
        side(DVec3::new(0.0, cos, sin) * depths[1], DVec3::new(0.0, sin, -cos)),
    ]
}

fn unit_square(origin: DVec3, edges: [DVec3; 2], front: DVec3) -> Flat {
    Flat::facing(Outline::Parallelogram { origin, edges }, front)
}

/// 6 n_x² n_a² terms, 6 n_a² kernel values, n_x = N + 1 exact.
fn hinge_cost(name: &str, pair: [Flat; 2], angular: Points) -> Cost {
    let map =
        |f: &dyn Fn(u64, u64) -> u64| std::array::from_fn(|k| angular[k].map(|n| f(ORDERS[k] as u64 + 1, n)));
    let (samples, distinct) = (map(&|x, n| 6 * x * x * n * n), map(&|_, n| 6 * n * n));
    Cost { name: name.into(), pair, samples, distinct: Some(distinct) }
}

/// Cost of two parallel unit squares: n⁴ terms.
fn parallel_cost(distance: f64, points: Points) -> Cost {
    let square = |z: f64, front| unit_square(DVec3::Z * z, [DVec3::X, DVec3::Y], front);
    Cost {
        name: format!("parallel, distance {distance}"),
        pair: [square(0.0, DVec3::Z), square(distance, -DVec3::Z)],
        samples: points.map(|row| row.map(|n| n.pow(4))),
        distinct: None,
    }
}

/// 4 n_x n_a³ terms, 4 n_a³ kernel values.
fn vertex_cost(name: &str, pair: [Flat; 2], angular: Points) -> Cost {
    let samples = std::array::from_fn(|k| angular[k].map(|n| 4 * (ORDERS[k] as u64 + 1) * n.pow(3)));
    Cost { name: name.into(), pair, samples, distinct: None }
}

fn measured_costs() -> Vec<Cost> {
    let triangle = |tip: DVec3, front| Flat::facing(Outline::Triangle([DVec3::ZERO, DVec3::X, tip]), front);
    let triangles =
        [triangle(DVec3::new(0.4, 0.9, 0.0), DVec3::Z), triangle(DVec3::new(0.6, 0.0, 0.8), DVec3::Y)];
    let floor = unit_square(DVec3::ZERO, [DVec3::X, DVec3::Y], DVec3::Z);
    let corner = unit_square(DVec3::ZERO, [-DVec3::Y, DVec3::Z], DVec3::X);
    // The same square leaning outward by 30°: it sees all of the floor still.
    let lean = DVec3::new(-0.5, 0.0, 0.75f64.sqrt());
    let tilted = unit_square(DVec3::ZERO, [-DVec3::Y, lean], DVec3::new(0.75f64.sqrt(), 0.0, 0.5));
    let collapsed = [[4u64, 5, 9], [5, 7, 11]];
    vec![
        hinge_cost("hinge 90°", hinge(90.0, [1.0, 1.0]), [[4, 5, 9], [6, 7, 10]]),
        hinge_cost("hinge 60°", hinge(60.0, [1.0, 1.0]), [[4, 6, 9], [6, 7, 11]]),
        hinge_cost("hinge 30°", hinge(30.0, [1.0, 1.0]), [[4, 7, 12], [6, 9, 13]]),
        hinge_cost("hinge 120°", hinge(120.0, [1.0, 1.0]), [[4, 5, 8], [6, 7, 10]]),
        hinge_cost("hinge 150°", hinge(150.0, [1.0, 1.0]), [[4, 6, 8], [6, 8, 10]]),
        hinge_cost("depth 4 × edge", hinge(90.0, [4.0, 4.0]), [[5, 8, 15], [6, 9, 15]]),
        hinge_cost("depths 1 and ¼", hinge(90.0, [1.0, 0.25]), [[6, 9, 16], [7, 11, 18]]),
        Cost {
            name: "triangles 90°".into(),
            pair: triangles,
            samples: std::array::from_fn(|k| collapsed[k].map(|n| 6 * (ORDERS[k] as u64 + 5).pow(2) * n * n)),
            distinct: None,
        },
        parallel_cost(1.0, [[4, 6, 9], [6, 8, 11]]),
        parallel_cost(0.5, [[6, 8, 12], [7, 10, 14]]),
        parallel_cost(0.3, [[6, 10, 18], [10, 13, 20]]),
        parallel_cost(0.1, [[17, 28, 56], [17, 29, 56]]),
        vertex_cost("corner, upright", [floor.clone(), corner], [[4, 5, 8], [6, 7, 10]]),
        vertex_cost("corner, tilted", [floor, tilted], [[4, 6, 9], [6, 7, 10]]),
    ]
}

/// Kernel samples against the counts measured to suffice, which an independent program found by raising one
/// number of points until the error against exact transfers fell below ε.
#[test]
fn costs_stay_near_the_counts_that_suffice() {
    let mut failures = Vec::new();
    for Cost { name, pair, samples, distinct } in measured_costs() {
        for (index, order) in ORDERS.into_iter().enumerate() {
            for (step, eps) in [1e-2, 1e-4, 1e-8].into_iter().enumerate() {
                let (_, cost) = transfer(&pair, order, eps);
                let known = samples[index][step];
                let known_distinct = distinct.map_or(known, |distinct| distinct[index][step]);
                let line = format!(
                    "{name}, order {order}, eps {eps:e}: {} samples of {known}, {} distinct of {known_distinct}",
                    cost.samples, cost.distinct
                );
                println!("{line}");
                // Within the slack, or one point more in each of the (at most four) directions that carry the
                // accuracy.
                let more = |known: u64| {
                    let points = (known as f64).powf(0.25);
                    (SLACK * known as f64).max((points + 1.0).powi(4))
                };
                let above = |count: u64, known: u64| count as f64 > more(known);
                if above(cost.samples, known) || above(cost.distinct, known_distinct) {
                    failures.push(line);
                }
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
