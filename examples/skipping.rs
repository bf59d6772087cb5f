//! What is not computed: pairs of elements by class, and rays cast against one ray per kernel sample.
//!
//! `cargo run --release --example skipping -- [SCENE[:NAME=VALUE] ...]` (cornell-box, two-boxes and teapot unless said;
//! `temple:bays=3` takes minutes, the whole `temple` three times as many).
//!
//! The first table counts unordered pairs, at the defaults of `radiosity solve`: those that face away, lie in one plane, are hidden wholly or send
//! nothing are skipped; of the others some equal an earlier pair up to similarity. "naive" is one ray per kernel sample of a run without
//! shadows, as a program casts that finds out by rays alone what is between (Zatz 1993): counted, not cast, and of large scenes
//! counted from one pair in 16.
//!
//! The second table, of pairs of planar elements where only planar surfaces stand between, compares visibility at equal error. The naive program multiplies each sample of an n⁴ tensor Gauss rule
//! over two patches by its visibility; n grows until its shadows are within 1 % of the exact ones:
//!
//! ```text
//! √Σ ‖S_naive − S‖²_F ≤ 1 % · √Σ ‖G‖²_F     over all pairs that anything is hidden of,
//! ```
//!
//! S = G⁰ − G what blockers take from a block, G⁰ and G by the exact rules. So only errors of visibility count. Its rays are
//! those of these pairs alone, as if the others were known to be free; they are traced one by one through the hierarchy over all
//! surfaces, on one thread, as our own blocks are made. Ours are by outlines and by rays, with `--shadow-eps` at the default and looser, all pairs;
//! their seconds of visibility are those of all blocks less those without shadows.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::collections::HashMap;
use std::time::Instant;

use radiosity::elements::patch::{Node, Patch};
use radiosity::elements::rule::UnitRule;
use radiosity::elements::{Element, Elements};
use radiosity::kernel::{Accuracy, Blocks, kernel};
use radiosity::scene::{Scene, SceneSurface};
use radiosity::solve::{Options, Outcome, in_threads, solve};
use radiosity::visibility::{Hiding, Shadows, Visibility};
use radiosity_geom::Ray;

/// Error that the naive program has to reach.
const GOAL: f64 = 1e-2;
/// Its rules, points a direction.
const POINTS: [usize; 13] = [2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24];
/// Our accuracies of shadows, in multiples of the default.
const LOOSER: [f64; 4] = [1.0, 3.0, 10.0, 30.0];
/// Accuracy of what counts as exact.
const EXACT: f64 = 1e-5;
/// Of scenes of more pairs than this, one in so many is asked for naive rays, a power of two; an odd number spreads them.
const MANY_PAIRS: usize = 10_000;
const SAMPLED: usize = 16;
const SPREAD: usize = 0x9E37_79B1;
/// A ray may touch surfaces within this part of its length at both ends.
const END: f64 = 1e-9;

fn main() {
    let named: Vec<String> = std::env::args().skip(1).collect();
    let usual = ["cornell-box", "two-boxes", "teapot"].map(str::to_owned);
    let names = if named.is_empty() { &usual[..] } else { &named[..] };
    println!(
        "| scene | pairs | face away | in a plane | wholly hidden | send nothing | repeated | wholly seen | partly hidden | samples | rays | naive rays | naive / rays |"
    );
    println!("|{}", " --- |".repeat(13));
    let solved: Vec<(&str, Scene, Outcome)> = names.iter().map(|name| solved(name)).collect();
    let planar: Vec<_> = solved.iter().filter(|(_, scene, _)| is_planar(scene)).collect();
    if planar.is_empty() {
        return;
    }
    println!("\n| scene | visibility | error, % | rays | seconds |");
    println!("|{}", " --- |".repeat(5));
    for (name, scene, outcome) in planar {
        let elements = outcome.solution.elements();
        in_threads(1, || at_equal_error(name, scene, elements)).expect("a thread can be started");
    }
}

/// Whether all that can cast a shadow is planar, walls that bend a little aside.
fn is_planar(scene: &Scene) -> bool {
    let curved = |surface: &SceneSurface| surface.shape.region().is_none();
    !scene.surfaces.iter().any(|surface| curved(surface) && surface.kind != "quad")
}

/// Solves a scene, given as `NAME` or `NAME:PARAMETER=VALUE`, and prints its row of the first table.
fn solved(name: &str) -> (&str, Scene, Outcome) {
    let (source, setting) = name.split_once(':').map_or((name, None), |(a, b)| (a, b.split_once('=')));
    let setting = setting.map(|(parameter, value)| (parameter, value.parse().expect("a number after =")));
    let scene = Scene::load_with(source, setting.as_slice()).unwrap_or_else(|error| panic!("{error}"));
    let outcome = solve(&scene, &Options::default(), &|_| {}).expect("the scene can be solved");
    println!("| {name} {}", counts(&scene, &outcome));
    (name, scene, outcome)
}

/// Samples of the blocks without shadows; of scenes of many pairs told from some of them.
fn naive_samples(scene: &Scene, elements: &Elements, pairs: usize) -> u64 {
    let sends = |element: usize| scene.surfaces[elements.list()[element].surface].material.sends();
    let every = if pairs > MANY_PAIRS { SAMPLED } else { 1 };
    // Multiplied by an odd number, the pairs taken are spread over all rows.
    let is_taken =
        |i: usize, j: usize| (i * elements.list().len() + j).wrapping_mul(SPREAD) >> 20 & (every - 1) == 0;
    let wanted = |i, j| (sends(i) || sends(j)) && is_taken(i, j);
    let open = Visibility::new(scene, Shadows::Off);
    let accuracy = Options::default().accuracy();
    every as u64 * Blocks::assemble_pairs(elements, &wanted, &open, accuracy, &|_, _| {}).samples
}

/// The rest of a row of the first table.
fn counts(scene: &Scene, outcome: &Outcome) -> String {
    let pairs = &outcome.pairs;
    let naive = naive_samples(scene, outcome.solution.elements(), pairs.total);
    let skipped = pairs.skipped_facing + pairs.skipped_coplanar + pairs.skipped_hidden + pairs.skipped_black;
    let ratio = match outcome.rays {
        0 => "no rays".to_owned(),
        rays => format!("{:.1}", naive as f64 / rays as f64),
    };
    format!(
        "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {naive} | {ratio} |",
        pairs.total,
        pairs.skipped_facing,
        pairs.skipped_coplanar,
        pairs.skipped_hidden,
        pairs.skipped_black,
        pairs.repeated,
        pairs.total - skipped - pairs.partly_hidden,
        pairs.partly_hidden,
        outcome.samples,
        outcome.rays,
    )
}

/// Blocks by pair, receiver before emitter.
type Table = HashMap<(usize, usize), Vec<f64>>;

/// Blocks with their shadows, the rays they took and the seconds.
fn blocks(
    scene: &Scene,
    elements: &Elements,
    hiding: Hiding,
    [eps, shadow_eps]: [f64; 2],
) -> (Table, u64, f64) {
    let accuracy = Accuracy { eps, shadow_eps };
    let visibility = Visibility::new(scene, hiding.shadows(accuracy.shadow_eps));
    let start = Instant::now();
    let list = elements.list();
    let wanted = |i: usize, j: usize| list[i].plane.is_some() && list[j].plane.is_some();
    let blocks = Blocks::assemble_pairs(elements, &wanted, &visibility, accuracy, &|_, _| {});
    let seconds = start.elapsed().as_secs_f64();
    (blocks.iter().map(|(i, j, values)| ((i, j), values.to_vec())).collect(), blocks.rays, seconds)
}

/// Rows of the second table.
fn at_equal_error(name: &str, scene: &Scene, elements: &Elements) {
    let (exact, ..) = blocks(scene, elements, Hiding::Auto, [EXACT; 2]);
    let (open, ..) = blocks(scene, elements, Hiding::Off, [EXACT; 2]);
    let Options { eps, shadow_eps, .. } = Options::default();
    let (_, _, plain) = blocks(scene, elements, Hiding::Off, [eps, shadow_eps]);
    let norm = |block: &[f64]| block.iter().map(|x| x * x).sum::<f64>();
    let zero = |block: &[f64]| vec![0.0; block.len()];
    let shade = |pair: &(usize, usize), all: &[f64]| {
        let left = exact.get(pair).cloned().unwrap_or_else(|| zero(all));
        all.iter().zip(left).map(|(g, v)| g - v).collect::<Vec<f64>>()
    };
    let shades: Table = open.iter().map(|(pair, all)| (*pair, shade(pair, all))).collect();
    // What differs by more than the rules may: something is hidden.
    let is_shaded = |pair: &(usize, usize)| norm(&shades[pair]) > (10.0 * EXACT).powi(2) * norm(&open[pair]);
    let mut shaded: Vec<(usize, usize)> = open.keys().copied().filter(is_shaded).collect();
    shaded.sort_unstable();
    let scale: f64 = shaded.iter().filter_map(|pair| exact.get(pair)).map(|block| norm(block)).sum();
    let off = |other: &dyn Fn(&(usize, usize)) -> Vec<f64>| {
        let square = |pair: &(usize, usize)| {
            let difference: Vec<f64> = other(pair).iter().zip(&shades[pair]).map(|(a, b)| a - b).collect();
            norm(&difference)
        };
        (shaded.iter().map(square).sum::<f64>() / scale).sqrt()
    };
    for (who, hiding) in [("outlines", Hiding::Auto), ("rays", Hiding::Rays)] {
        for looser in LOOSER {
            let asked = looser * shadow_eps;
            let (found, rays, seconds) = blocks(scene, elements, hiding, [eps, asked]);
            let own = |pair: &(usize, usize)| {
                let left = found.get(pair).cloned().unwrap_or_else(|| zero(&open[pair]));
                open[pair].iter().zip(left).map(|(g, v)| g - v).collect()
            };
            let who = format!("{who} {asked:.0e}");
            println!("| {name} | {who} | {:.2} | {rays} | {:.3} |", 100.0 * off(&own), seconds - plain);
        }
    }
    let visibility = Visibility::new(scene, Shadows::Rays(EXACT));
    for points in POINTS {
        let mut rays = 0;
        let start = Instant::now();
        let naive: Table = shaded
            .iter()
            .map(|pair| {
                let [receiver, emitter] = [pair.0, pair.1].map(|index| &elements.list()[index]);
                (*pair, naive_shade([receiver, emitter], &visibility, points, &mut rays))
            })
            .collect();
        let seconds = start.elapsed().as_secs_f64();
        let error = off(&|pair| naive[pair].clone());
        println!("| {name} | n = {points} | {:.2} | {rays} | {seconds:.3} |", 100.0 * error);
        if error <= GOAL {
            break;
        }
    }
}

/// S by an n⁴ rule, each sample times what is hidden there.
fn naive_shade(
    [receiver, emitter]: [&Element; 2],
    visibility: &Visibility,
    n: usize,
    rays: &mut u64,
) -> Vec<f64> {
    let (rows, columns) = (receiver.basis.len(), emitter.basis.len());
    let mut moments = vec![0.0; rows * columns];
    let points = |element: &Element| -> Vec<(Node, f64)> {
        element.patches.iter().flat_map(|patch| nodes(patch, n)).collect()
    };
    let (xs, ys) = (points(receiver), points(emitter));
    let raw = |element: &Element, node: &Node| element.raw_values(node.position, node.parameters.to_array());
    let rights: Vec<_> = ys.iter().map(|(y, _)| raw(emitter, y)).collect();
    for (x, wx) in &xs {
        let left = raw(receiver, x);
        for ((y, wy), right) in ys.iter().zip(&rights) {
            let value = wx * wy * kernel(x, y);
            if value == 0.0 {
                continue;
            }
            *rays += 1;
            let direction = y.position - x.position;
            let ray = Ray { origin: x.position, direction, range: [END, 1.0 - END] };
            if visibility.nearest(&ray).is_some() {
                for (row, l) in moments.chunks_exact_mut(columns).zip(&left) {
                    row.iter_mut().zip(right).for_each(|(sum, r)| *sum += value * l * r);
                }
            }
        }
    }
    transformed(&moments, receiver.basis.transform(), emitter.basis.transform())
}

/// T_i M T_jᵀ, T lower triangular.
fn transformed(moments: &[f64], receiver: &[f64], emitter: &[f64]) -> Vec<f64> {
    let columns = (emitter.len() as f64).sqrt() as usize;
    let rows = moments.len() / columns;
    let entry = |k: usize, l: usize| -> f64 {
        let terms = (0..rows).flat_map(|a| (0..columns).map(move |b| (a, b)));
        terms.map(|(a, b)| receiver[k * rows + a] * moments[a * columns + b] * emitter[l * columns + b]).sum()
    };
    (0..rows * columns).map(|index| entry(index / columns, index % columns)).collect()
}

/// Nodes of the n × n Gauss rule on a patch, with their weights.
fn nodes(patch: &Patch, n: usize) -> Vec<(Node, f64)> {
    let rule = UnitRule::of(n);
    let product = rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t)));
    let node = |((s, ws), (t, wt)): ((f64, f64), (f64, f64))| {
        let node = patch.node(s, t);
        let weight = ws * wt * node.area;
        (node, weight)
    };
    product.map(node).collect()
}
