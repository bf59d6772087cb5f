//! Links of polynomials: error against links and time for rising orders, beside blocks between all pairs.

use std::error::Error;
use std::fs;
use std::time::Instant;

use radiosity::Scene;
use radiosity::elements::cells::Layers;
use radiosity::elements::{Discretization, Element};
use radiosity::output::drawings::diagram::{COLOURS, Curve, Diagram, Dot, Panel, Spacing};
use radiosity_test_support::scenes::typed;

use crate::judge::{Judge, Point};
use crate::levels::{Levels, Linked, form_factor};

/// Errors that a link may have, in parts of the power that the scene emits.
const FALLING: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-5];
/// Elements of the runs by all pairs.
const ALL_PAIRS: [AllPairs; 12] = [
    AllPairs { order: 0, cuts: 4, layers: 0 },
    AllPairs { order: 1, cuts: 2, layers: 0 },
    AllPairs { order: 1, cuts: 4, layers: 0 },
    AllPairs { order: 2, cuts: 2, layers: 0 },
    AllPairs { order: 3, cuts: 1, layers: 0 },
    AllPairs { order: 3, cuts: 2, layers: 0 },
    AllPairs { order: 5, cuts: 1, layers: 0 },
    AllPairs { order: 5, cuts: 2, layers: 0 },
    AllPairs { order: 0, cuts: 8, layers: 0 },
    AllPairs { order: 2, cuts: 1, layers: 1 },
    AllPairs { order: 3, cuts: 1, layers: 1 },
    AllPairs { order: 4, cuts: 1, layers: 2 },
];
/// The first of them, for the scene with a bent sheet.
const FEW: usize = 8;
/// A bent sheet, two-sided, below a disk.
const BENT: &str = r#"
bands = ["grey"]
materials.wall = { reflectance = 0.6 }
materials.lamp = { reflectance = 0, emission = 100 }
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [0, 0, 0], size = [4, 4, 3], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
disk = { center = [2, 2, 2.7], normal = [0, 0, -1], radius = 0.3 }
[[surfaces]]
name = "sheet"
material = "wall"
two_sided = true
quad = { vertices = [[1, 1, 1], [2, 1, 1.3], [2, 2, 1], [1, 2, 1.4]] }
"#;

/// A scene, and what is made of it.
struct Subject {
    name: &'static str,
    scene: Scene,
    /// Levels of elements of the orders 0, 1 and 2, from whole surfaces on.
    levels: [usize; 3],
    falling: &'static [f64],
    all_pairs: &'static [AllPairs],
    /// Order of the solution whose light is gathered for the truth, and the accuracy of its shadows.
    truth: (usize, f64),
}

/// Order, cuts along each side of a surface, and graded layers.
#[derive(Clone, Copy)]
struct AllPairs {
    order: usize,
    cuts: usize,
    layers: usize,
}

/// A run.
struct Run {
    /// Order by links, or none by all pairs.
    order: Option<usize>,
    links: usize,
    seconds: f64,
    error: f64,
}

/// Two rooms of flat surfaces, and one with a bent sheet, whose shadows take fifty times as long.
fn subjects() -> [Subject; 3] {
    let flat = |name| Subject {
        name,
        scene: radiosity::builtin(name).expect("the scene is built in"),
        levels: [5, 4, 4],
        falling: &FALLING,
        all_pairs: &ALL_PAIRS,
        truth: (5, 1e-3),
    };
    let bent = Subject {
        name: "a bent sheet",
        scene: typed(BENT),
        levels: [4, 3, 3],
        falling: &FALLING[..2],
        all_pairs: &ALL_PAIRS[..FEW],
        truth: (3, 3e-3),
    };
    [flat("empty-box"), flat("two-boxes"), bent]
}

/// Prints the tables of all scenes and draws their curves.
pub(crate) fn orders(path: &str) -> Result<(), Box<dyn Error>> {
    let mut panels = Vec::new();
    for Subject { name, scene, levels, falling, all_pairs, truth: (order, shadow_eps) } in &subjects() {
        println!("| {name} | order | eps | unknowns | links | numbers | row sums | error | seconds |");
        println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- |");
        let judge = Judge::new(scene, *order, *shadow_eps);
        let mut runs = Vec::new();
        for (order, count) in levels.iter().enumerate() {
            by_links(scene, [order, *count], falling, &judge, &mut runs);
        }
        for how in *all_pairs {
            by_all_pairs(scene, *how, &judge, &mut runs);
        }
        println!();
        panels.push(panel(name, "links", &runs, |run| run.links as f64));
        panels.push(panel(name, "seconds", &runs, |run| run.seconds));
        draw(path, &panels)?;
    }
    Ok(())
}

fn draw(path: &str, panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    let diagram = Diagram {
        title: "Links of polynomials beside blocks between all elements".to_owned(),
        caption: "relative error of the irradiance at points, against links and against time".to_owned(),
        columns: 2,
        panels: panels.to_vec(),
    };
    Ok(fs::write(path, diagram.drawing().svg())?)
}

fn by_links(scene: &Scene, [order, count]: [usize; 2], falling: &[f64], judge: &Judge, runs: &mut Vec<Run>) {
    let levels = Levels::nested(scene, order, count);
    let brightness = judge.brightness(scene);
    let estimate = |p: &Element, q: &Element| {
        let [sent, nearness] = form_factor(p, q);
        let power = |element: &Element| brightness[element.surface] * element.area;
        let back = sent * q.area / p.area;
        (sent * power(q)).max(back * power(p)) * nearness.powi(order as i32 + 1)
    };
    for &eps in falling {
        let linked = levels.linked(eps, estimate);
        let title = format!("links | {order} | {eps:.0e}");
        runs.push(Run { order: Some(order), ..judged(scene, &title, &levels, &linked, judge) });
    }
}

/// Solves by these links, and prints a row of the table.
fn judged(scene: &Scene, title: &str, levels: &Levels, linked: &Linked, judge: &Judge) -> Run {
    let begun = Instant::now();
    let irradiance = solved(scene, levels, linked);
    let seconds = linked.seconds + begun.elapsed().as_secs_f64();
    let (least, most) = row_sums(levels, linked);
    let error = error(judge, levels, &irradiance);
    let Linked { links, numbers, .. } = *linked;
    println!(
        "| {title} | {} | {links} | {numbers} | {least:.3} to {most:.3} | {error:.2e} | {seconds:.2} |",
        levels.leaves().coefficients()
    );
    Run { order: None, links, seconds, error }
}

/// The coefficients of the irradiance, by gathering until nothing changes.
fn solved(scene: &Scene, levels: &Levels, linked: &Linked) -> Vec<f64> {
    let list = levels.leaves().list();
    let spread = |of: &dyn Fn(usize) -> f64| -> Vec<f64> {
        list.iter().flat_map(|own| vec![of(own.surface); own.basis.len()]).collect()
    };
    let reflectance = spread(&|surface| scene.surfaces[surface].material.reflectance[0]);
    let exitance = spread(&|surface| scene.surfaces[surface].exitance(0));
    let ones = levels.leaves().constant();
    let emitted: Vec<f64> = exitance.iter().zip(&ones).map(|(exitance, one)| exitance * one).collect();
    let (mut radiosity, mut irradiance) = (emitted.clone(), Vec::new());
    for _ in 0..60 {
        irradiance = linked.apply(levels, &radiosity);
        for (k, own) in radiosity.iter_mut().enumerate() {
            *own = emitted[k] + reflectance[k] * irradiance[k];
        }
    }
    irradiance
}

/// The least and the greatest row sum of the leaves.
fn row_sums(levels: &Levels, linked: &Linked) -> (f64, f64) {
    let ones = levels.leaves().constant();
    let sent = linked.apply(levels, &ones);
    let starts = levels.leaves().starts();
    let sum = |(k, own): (usize, &Element)| ones[starts[k]] * sent[starts[k]] / own.area;
    let sums = levels.leaves().list().iter().enumerate().map(sum);
    sums.fold((f64::INFINITY, 0.0), |(least, most), sum| (f64::min(least, sum), f64::max(most, sum)))
}

fn by_all_pairs(scene: &Scene, how: AllPairs, judge: &Judge, runs: &mut Vec<Run>) {
    let AllPairs { order, cuts, layers } = how;
    let graded = Layers { count: layers, ..Layers::NONE };
    let how = Discretization { layers: graded, ..Discretization::uniform(order, cuts) };
    let levels = Levels::new(scene, &[how]);
    let linked = levels.linked(0.0, |_, _| 0.0);
    let title = format!("all pairs, {cuts} × {cuts}, {layers} layers | {order} |");
    runs.push(Run { order: None, ..judged(scene, &title, &levels, &linked, judge) });
}

/// The error of the irradiance with these coefficients.
fn error(judge: &Judge, levels: &Levels, irradiance: &[f64]) -> f64 {
    let (elements, starts) = (levels.leaves(), levels.leaves().starts());
    judge.error(|Point { surface, parameters, position, .. }| {
        let index = elements.at(*surface, *parameters)?;
        let element = &elements.list()[index];
        let raw = element.basis.to_raw(&irradiance[starts[index]..starts[index + 1]]);
        Some(element.evaluate(&raw, *position, *parameters))
    })
}

fn panel(title: &str, axis: &str, runs: &[Run], along: impl Fn(&Run) -> f64) -> Panel {
    let [blue, red, green, purple, ..] = COLOURS;
    let curve = |(order, colour, label): (Option<usize>, [u8; 3], &str)| {
        let own = runs.iter().filter(|run| run.order == order);
        let place = |run: &Run| [along(run), run.error];
        let is_line = order.is_some();
        Curve {
            label: label.to_owned(),
            colour,
            dots: own
                .clone()
                .filter(|_| is_line)
                .map(|run| Dot { place: place(run), text: String::new() })
                .collect(),
            others: own.filter(|_| !is_line).map(place).collect(),
        }
    };
    let curves = [
        (Some(0), blue, "links, order 0"),
        (Some(1), red, "links, order 1"),
        (Some(2), green, "links, order 2"),
        (None, purple, "all pairs, orders 0 to 5"),
    ];
    Panel {
        title: title.to_owned(),
        axes: [axis.to_owned(), "relative error".to_owned()],
        along: Spacing::Logarithmic,
        curves: curves.map(curve).into(),
    }
}
