//! Figures 4 and 5: two unit squares, one of exitance 1, the other receiving with reflectance 1.
//!
//! Metric (30) is the mean of |B_Galerkin − B_exact| / B_exact over the centres of 500 × 500 cells of the
//! receiver, in percent. The paper says that it takes N + 1 points per direction; its numbers fit N + 2.
//! Curves go to docs/zatz-figure-4.svg and docs/zatz-figure-5.svg, the numbers that the paper prints as marks.

use std::error::Error;
use std::io::{self, Write};

use radiosity::Work;
use radiosity::elements::{Discretization, Elements};
use radiosity::kernel::irradiance::visible_polygon::irradiance;
use radiosity::kernel::{Accuracy, Blocks};
use radiosity::published::zatz1993::transfers::{HybridReading, PaperRules, assemble};
use radiosity::scene::Source;
use radiosity::transport;
use radiosity::visibility::Visibility;
use radiosity_geom::DVec3;

use crate::curves::{self, OfOrder};

/// Cells of the receiver along each side.
pub(crate) const CELLS: usize = 500;
/// Orders from 0 on.
pub(crate) const ORDERS: usize = 10;

/// The emitter's corners over the receiver [0, 1]² in z = 0, in order about its front.
#[derive(Clone, Copy)]
pub(crate) struct Emitter([[f64; 3]; 4]);

impl Emitter {
    /// At the distance `d`.
    pub(crate) fn parallel(d: f64) -> Self {
        Self([[0.0, 0.0, d], [0.0, 1.0, d], [1.0, 1.0, d], [1.0, 0.0, d]])
    }

    /// Over the edge y = 0 of the receiver.
    pub(crate) fn perpendicular() -> Self {
        Self([[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    }
}

/// The centre of a cell along a side of the receiver, in its parameter.
pub(crate) fn centre(k: usize) -> f64 {
    (2 * k + 1) as f64 / CELLS as f64 - 1.0
}

/// Centres of the cells of the receiver, in its parameters.
pub(crate) fn centres() -> impl Iterator<Item = [f64; 2]> {
    (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| [centre(i), centre(j)]))
}

fn position([s, t]: [f64; 2]) -> DVec3 {
    DVec3::new(0.5 * (1.0 + s), 0.5 * (1.0 + t), 0.0)
}

/// Lambert's closed form of the irradiance at places of the receiver.
pub(crate) fn exact(emitter: Emitter, places: impl Iterator<Item = [f64; 2]>) -> Vec<f64> {
    let polygon = emitter.0.map(DVec3::from_array);
    places.map(|place| irradiance(position(place), DVec3::Z, &polygon)).collect()
}

/// Metric (30) in percent.
fn metric(exact: &[f64], galerkin: impl Fn([f64; 2]) -> f64) -> f64 {
    let sum: f64 = centres().zip(exact).map(|(place, e)| (galerkin(place) - e).abs() / e).sum();
    100.0 * sum / exact.len() as f64
}

/// The metric of the polynomial that arrives by `blocks`.
fn of_blocks(
    emitter: Emitter,
    exact: &[f64],
    order: usize,
    blocks: impl Fn(transport::Demand<'_>) -> Blocks,
) -> f64 {
    let scene = format!(
        "[materials.white]\nreflectance = 0.5\n\
         [[surfaces]]\nname = \"receiver\"\nmaterial = \"white\"\nquad = {{ vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }}\n\
         [[surfaces]]\nname = \"emitter\"\nmaterial = \"white\"\nquad = {{ vertices = {:?} }}\n",
        emitter.0
    );
    let scene =
        radiosity::language::read(&Source::new("section 6.1", &scene)).expect("two squares are a scene");
    let how = Discretization::uniform(order, 1);
    let elements = Elements::new(&scene, &how).expect("squares have area");
    let visibility = Visibility::open(&scene);
    let accuracy = Accuracy { eps: 1e-6, shadow_eps: 1e-3 };
    let blocks = blocks(transport::Demand::all(&elements, &visibility, accuracy));
    let [receiver, source] = elements.list() else { panic!("one element a square") };
    let emitted = [vec![0.0; receiver.basis.len()], source.constant.clone()].concat();
    let raw = receiver.basis.to_raw(&blocks.apply(&emitted)[..receiver.basis.len()]);
    metric(exact, |place| receiver.evaluate(&raw, position(place), place))
}

/// The metric of the paper's rules.
fn paper(emitter: Emitter, exact: &[f64], order: usize, rules: PaperRules) -> f64 {
    of_blocks(emitter, exact, order, |demand| assemble(demand, rules, rules.extra_points(), &Work::alone()))
}

/// The metric of this library's rules.
fn ours(emitter: Emitter, exact: &[f64], order: usize) -> f64 {
    of_blocks(emitter, exact, order, |demand| transport::assemble(demand, None, &Work::alone()))
}

/// Writes a row of a table, for the orders 0 to 9, and returns what it says.
pub(crate) fn row(
    out: &mut impl Write,
    name: &str,
    quoted: &str,
    value: impl Fn(usize) -> f64,
) -> io::Result<Vec<f64>> {
    write!(out, "| {name} |")?;
    let values: Vec<f64> = (0..ORDERS).map(value).collect();
    for value in &values {
        let digits = if *value >= 100.0 { 0 } else { 2 - (value.log10().floor() as i32).clamp(-2, 1) };
        write!(out, " {value:.0$} |", digits.max(0) as usize)?;
    }
    writeln!(out, " {quoted} |")?;
    Ok(values)
}

/// Writes the head of such a table.
pub(crate) fn header(out: &mut impl Write, title: &str, last: &str) -> io::Result<()> {
    write!(out, "| {title} |")?;
    (0..ORDERS).try_for_each(|order| write!(out, " N = {order} |"))?;
    writeln!(out, " {last} |")?;
    writeln!(out, "| --- |{} --- |", " --- |".repeat(ORDERS))
}

/// Figure 4: parallel squares of side l.
pub(crate) fn figure_4(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    header(out, "figure 4, error in %", "paper")?;
    let mut lines = Vec::new();
    for (d, quoted) in [(1.0, "0.04 (N = 4)"), (0.3, ""), (0.1, "16.9 (N = 7)")] {
        let emitter = Emitter::parallel(d);
        let exact = exact(emitter, centres());
        let name = |rules: &str| format!("distance {d} l, {rules}");
        let theirs = row(out, &name("rules of 1993"), quoted, |order| {
            paper(emitter, &exact, order, PaperRules::Legendre)
        })?;
        let ours = row(out, &name("ours"), "", |order| ours(emitter, &exact, order))?;
        lines.push(OfOrder { label: name("rules of 1993"), values: theirs });
        lines.push(OfOrder { label: name("ours"), values: ours });
    }
    let marks = [(4, 0.04), (7, 16.9)];
    curves::write("docs/zatz-figure-4.svg", "Figure 4: two parallel squares of side l", lines, &marks)
}

/// Figure 5: perpendicular squares with a common edge.
pub(crate) fn figure_5(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    header(out, "figure 5, error in %", "paper")?;
    let emitter = Emitter::perpendicular();
    let exact = exact(emitter, centres());
    let hybrid = PaperRules::Hybrid;
    let mut lines = Vec::new();
    for (name, rules, quoted) in [
        ("Legendre", PaperRules::Legendre, "33.2 (N = 7)"),
        ("hybrid H1", hybrid(HybridReading::H1), "1.4 (N = 4, 5)"),
        ("hybrid H2, N + 3 points", hybrid(HybridReading::H2), "1.4 (N = 4, 5)"),
        ("hybrid H3", hybrid(HybridReading::H3), ""),
        ("eq. 27 as printed", hybrid(HybridReading::Literal), ""),
    ] {
        let values = row(out, name, quoted, |order| paper(emitter, &exact, order, rules))?;
        lines.push(OfOrder { label: name.to_owned(), values });
    }
    let values = row(out, "ours", "", |order| ours(emitter, &exact, order))?;
    lines.push(OfOrder { label: "ours".to_owned(), values });
    let marks = [(7, 33.2), (4, 1.4), (5, 1.4)];
    curves::write("docs/zatz-figure-5.svg", "Figure 5: two squares with a common edge", lines, &marks)
}
