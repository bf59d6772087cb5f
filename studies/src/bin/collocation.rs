//! Galerkin's method beside collocation: polynomials (`--method collocation`), then tents by Ritz's method and
//! by collocation at the corners of cells, which the variational source takes for them.
//!
//! Polynomials are compared by order in a box, in one with an obstacle, and in a can. Tents stand on two unit
//! squares of reflectance ½, of which one emits: parallel, or with a common edge at a right angle. There the
//! corners on the edge see the other square edge-on, where its irradiance has no value: collocation takes 0.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;

use cpu_time::ProcessTime;
use radiosity::elements::cells::Layers;
use radiosity::elements::rule::UnitRule;
use radiosity::geom::DVec3;
use radiosity::scene::Source;
use radiosity::solve::solution::SurfacePlace;
use radiosity::solve::studies::error_norm::distance;
use radiosity::solve::{Direct, LightMethod, Options, Outcome, Transport, solve};
use radiosity::{Basis, Solution, Work};
use radiosity_solvers::method::Method;
use radiosity_solvers::{Dense, Partition, Settings};

/// Reflectance of both squares.
const REFLECTANCE: f64 = 0.5;

/// Points per direction on each cell.
const POINTS: usize = 32;

/// A can whose bottom shines.
const CAN: &str = "
materials.grey = { reflectance = 0.5 }
materials.lamp = { reflectance = 0.5, emission = 1 }
[[surfaces]]
material = 'lamp'
disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }
[[surfaces]]
material = 'grey'
disk = { center = [0, 0, 2], normal = [0, 0, -1], radius = 1 }
[[surfaces]]
material = 'grey'
flip = true
cylinder = { base = [0, 0, 0], axis = [0, 0, 2], radius = 1 }
";

/// A unit square with its origin, sides and normal; the first of two emits 1.
struct Square {
    origin: DVec3,
    sides: [DVec3; 2],
    normal: DVec3,
}

impl Square {
    fn new(origin: DVec3, sides: [DVec3; 2]) -> Self {
        Self { origin, sides, normal: sides[0].cross(sides[1]).normalize() }
    }

    fn at(&self, u: f64, v: f64) -> DVec3 {
        self.origin + self.sides[0] * u + self.sides[1] * v
    }

    fn toml(&self, material: &str) -> String {
        let list = |x: DVec3| format!("[{}, {}, {}]", x.x, x.y, x.z);
        let [a, b] = self.sides.map(list);
        let origin = list(self.origin);
        format!(
            "[[surfaces]]\nmaterial = \"{material}\"\nparallelogram = {{ origin = {origin}, edge1 = {a}, edge2 = {b} }}\n"
        )
    }
}

/// The values of a sum of tents at the corners of n × n cells of both squares.
struct Tents {
    cells: usize,
    corners: Vec<f64>,
}

impl Tents {
    fn place(&self, square: usize, i: usize, j: usize) -> usize {
        (square * (self.cells + 1) + i) * (self.cells + 1) + j
    }

    fn value(&self, square: usize, u: f64, v: f64) -> f64 {
        self.hats(square, u, v).iter().map(|(corner, hat)| hat * self.corners[*corner]).sum()
    }

    /// The tents that are not zero at a place.
    fn hats(&self, square: usize, u: f64, v: f64) -> [(usize, f64); 4] {
        let [(i, s), (j, t)] = [u, v].map(|x| {
            let cell = ((x * self.cells as f64) as usize).min(self.cells - 1);
            (cell, x * self.cells as f64 - cell as f64)
        });
        [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(a, b)| {
            let along = if a == 1 { s } else { 1.0 - s };
            let across = if b == 1 { t } else { 1.0 - t };
            (self.place(square, i + a, j + b), along * across)
        })
    }
}

/// κ of two points of two squares.
fn kernel(x: DVec3, from: &Square, y: DVec3, to: &Square) -> f64 {
    let r = y - x;
    let cosines = from.normal.dot(r).max(0.0) * (-to.normal.dot(r)).max(0.0);
    if cosines == 0.0 { 0.0 } else { cosines / (std::f64::consts::PI * r.length_squared().powi(2)) }
}

/// A point of the unit square with its weight.
struct WeightedPoint {
    u: f64,
    v: f64,
    weight: f64,
}

/// Points of n × n cells of the unit square.
fn points(cells: usize, count: usize) -> Vec<WeightedPoint> {
    let rule = UnitRule::of(count);
    let line: Vec<(f64, f64)> = (0..cells)
        .flat_map(|cell| rule.iter().map(move |(x, w)| ((cell as f64 + x) / cells as f64, w / cells as f64)))
        .collect();
    let along = |(u, a): &(f64, f64)| {
        let (u, a) = (*u, *a);
        line.iter().map(move |(v, b)| WeightedPoint { u, v: *v, weight: a * b })
    };
    line.iter().flat_map(along).collect()
}

/// The matrix of the vertex-patch form factors, I − ρ P, column by column, and its solution.
fn collocated(squares: &[Square; 2], cells: usize) -> Result<(Vec<f64>, Tents), Box<dyn Error>> {
    let count = (cells + 1) * (cells + 1);
    let dim = 2 * count;
    let mut tents = Tents { cells, corners: vec![0.0; dim] };
    let mut values = vec![0.0; dim * dim];
    values.iter_mut().step_by(dim + 1).for_each(|one| *one = 1.0);
    let points = points(cells, POINTS);
    for (square, other) in [(0, 1), (1, 0)] {
        for corner in 0..count {
            let (i, j) = (corner / (cells + 1), corner % (cells + 1));
            let row = tents.place(square, i, j);
            let x = squares[square].at(i as f64 / cells as f64, j as f64 / cells as f64);
            for WeightedPoint { u, v, weight } in &points {
                let k = kernel(x, &squares[square], squares[other].at(*u, *v), &squares[other]);
                for (column, hat) in tents.hats(other, *u, *v) {
                    values[column * dim + row] -= REFLECTANCE * weight * k * hat;
                }
            }
        }
    }
    let mut emitted = vec![0.0; dim];
    emitted[..count].fill(1.0);
    let matrix = Dense::new(Partition::points(dim), values.clone(), false)?;
    let lu = Method::named("lu")?.solver;
    lu.solve(&matrix, &emitted, &mut tents.corners, &Settings::default(), &mut |_| ())?;
    Ok((values, tents))
}

/// Radiosity of a solution at (u, v) ∈ [0, 1]² of a square.
fn radiosity(solution: &Solution, squares: &[Square; 2], square: usize, u: f64, v: f64) -> f64 {
    let parameters = [2.0 * u - 1.0, 2.0 * v - 1.0];
    let element = solution.elements().at(square, parameters).expect("squares have no holes");
    let place = SurfacePlace { surface: square, parameters, position: squares[square].at(u, v) };
    solution.radiosity(0, element, &place)
}

/// ‖B − B′‖/‖B′ − E₀‖ of two functions of square and place.
fn error(found: impl Fn(usize, f64, f64) -> f64, exact: impl Fn(usize, f64, f64) -> f64) -> f64 {
    let (mut difference, mut size) = (0.0, 0.0);
    for square in [0, 1] {
        for WeightedPoint { u, v, weight } in points(16, 4) {
            let truth = exact(square, u, v);
            difference += weight * (found(square, u, v) - truth).powi(2);
            size += weight * (truth - if square == 0 { 1.0 } else { 0.0 }).powi(2);
        }
    }
    f64::sqrt(difference / size)
}

/// Largest |a_kl − a_lk| over the largest entry off the diagonal.
fn asymmetry(values: &[f64]) -> f64 {
    let dim = values.len().isqrt();
    let pairs = || (0..dim).flat_map(|k| (0..k).map(move |l| (values[k * dim + l], values[l * dim + k])));
    let largest = pairs().map(|(a, b)| a.abs().max(b.abs())).fold(0.0, f64::max);
    pairs().map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
}

/// Prints errors and lost power of polynomials on whole surfaces, by order.
fn polynomials() -> Result<(), Box<dyn Error>> {
    println!(
        "| scene | order | Galerkin: error | power lost | seconds | collocation: error | power lost | seconds |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    let can = radiosity::language::read(&Source::new("can", CAN))?;
    let scenes = [
        ("empty-box", radiosity::builtin("empty-box")?),
        ("occluder-box", radiosity::builtin("occluder-box")?),
        ("can", can),
    ];
    for (name, scene) in scenes {
        let options = |order, method| Options {
            order,
            method,
            direct: Direct::Projected,
            transport: Transport::Exact,
            subdivide: Some(1),
            eps: 1e-4,
            shadow_eps: 1e-4,
            ..Options::default()
        };
        let finest = Options { subdivide: Some(4), ..options(4, LightMethod::Galerkin) };
        let exact = solve(&scene, &finest, &Work::alone())?.solution;
        for order in 0..=6 {
            print!("| {name} | {order} |");
            for method in [LightMethod::Galerkin, LightMethod::Collocation] {
                let start = ProcessTime::now();
                let outcome = solve(&scene, &options(order, method), &Work::alone())?;
                let seconds = start.elapsed().as_secs_f64();
                let lost = 100.0 * outcome.checks.energy_lost / outcome.checks.energy_in;
                print!(" {:.1e} | {lost:.2} % | {seconds:.3} |", distance(&outcome.solution, &exact)?);
            }
            println!();
        }
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    polynomials()?;
    tents()
}

/// Prints errors of tents by both methods.
fn tents() -> Result<(), Box<dyn Error>> {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let scenes = [
        ("parallel", [Square::new(DVec3::ZERO, [x, y]), Square::new(0.7 * z, [y, x])]),
        ("common edge", [Square::new(DVec3::ZERO, [x, y]), Square::new(DVec3::ZERO, [y, z])]),
    ];
    println!("\n| tents | cells | unknowns | Ritz: error | collocation: error | asymmetry |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for (name, squares) in scenes {
        let text = format!(
            "materials.lamp = {{ reflectance = {REFLECTANCE}, emission = 1 }}\nmaterials.wall = {{ reflectance = {REFLECTANCE} }}\n{}{}",
            squares[0].toml("lamp"),
            squares[1].toml("wall")
        );
        let scene = radiosity::language::read(&Source::new(name, &text))?;
        let solved = |options: Options| -> Result<Outcome, Box<dyn Error>> {
            let options = Options { direct: Direct::Projected, eps: 1e-7, ..options };
            Ok(solve(&scene, &options, &Work::alone())?)
        };
        let layers = Layers { count: 4, ratio: 0.2 };
        let exact = solved(Options { order: 6, layers, subdivide: Some(1), ..Options::default() })?.solution;
        let truth = |square, u, v| radiosity(&exact, &squares, square, u, v);
        for cells in [1, 2, 4, 8] {
            let ritz = solved(Options {
                basis: Basis::Linear,
                order: 1,
                subdivide: Some(cells),
                ..Options::default()
            })?;
            let (values, tents) = collocated(&squares, cells)?;
            let by_ritz = error(|square, u, v| radiosity(&ritz.solution, &squares, square, u, v), truth);
            let by_corners = error(|square, u, v| tents.value(square, u, v), truth);
            println!(
                "| {name} | {cells} | {} | {by_ritz:.1e} | {by_corners:.1e} | {:.2} |",
                ritz.unknowns,
                asymmetry(&values)
            );
        }
    }
    Ok(())
}
