//! Visibility at equal error: the library's and the naive program's.

use cpu_time::ProcessTime;
use radiosity::kernel::Accuracy;
use radiosity::solve::Options;
use radiosity::visibility::{Shadows, Visibility};

use crate::judged::{Judged, Table};
use crate::naive;
use crate::subject::Subject;

/// Error that both have to reach.
const GOAL: f64 = 1e-2;
/// The naive program's rules, points a direction.
const POINTS: [usize; 15] = [2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 28, 32];
/// Our accuracies of shadows, in multiples of the default, and where some pairs are judged.
const LOOSER: [f64; 5] = [1.0 / 3.0, 1.0, 3.0, 10.0, 30.0];
const LOOSER_SOME: [f64; 6] = [0.1, 0.2, 1.0 / 3.0, 2.0 / 3.0, 1.0, 3.0];
/// Kernel eps there.
const EPS_SOME: f64 = 1e-4;
/// The naive program gives up before it needs more rays than this (about a minute).
const MOST_RAYS: u64 = 50_000_000;
/// Seconds less than this part of those they are a difference of are noise.
const NOISE: f64 = 0.1;

/// Cost and error of a way to find shadows.
#[derive(Clone)]
struct Run {
    way: String,
    error: f64,
    rays: u64,
    seconds: f64,
    /// Whether the time is no more than this.
    at_most: bool,
}

/// The best of either side on a scene.
pub(crate) struct Race<'a> {
    subject: &'a Subject,
    every: usize,
    pairs: usize,
    ours: Option<Run>,
    naive: Run,
}

impl<'a> Race<'a> {
    /// Runs both on the pairs of a scene, and prints their rows.
    pub(crate) fn run(subject: &'a Subject) -> Self {
        let judged = Judged::of(subject);
        let ours = library(&judged);
        let naive = naive_program(&judged);
        Self { subject, every: judged.every, pairs: judged.shaded.len(), ours, naive }
    }
}

/// Prints a run's row.
fn told(subject: &Subject, run: Run) -> Run {
    println!(
        "| {} | {} | {:.2} | {} | {} |",
        subject.name,
        run.way,
        100.0 * run.error,
        run.rays,
        seconds(&run)
    );
    run
}

fn seconds(run: &Run) -> String {
    let sign = if run.at_most { "< " } else { "" };
    format!("{sign}{:.3}", run.seconds)
}

/// The library's cheapest run that reaches the goal.
fn library(judged: &Judged) -> Option<Run> {
    let Options { eps, shadow_eps, .. } = Options::default();
    let [mostly_planar, _] = judged.subject.is_planar();
    let (eps, looser) = if judged.all { (eps, &LOOSER[..]) } else { (EPS_SOME, &LOOSER_SOME[..]) };
    let open = judged.blocks(Shadows::Off, Accuracy { eps, shadow_eps });
    let plain = open.seconds;
    let run = |(way, hiding): (&str, Shadows), looser: f64| {
        let asked = looser * shadow_eps;
        let found = judged.blocks(hiding, Accuracy { eps, shadow_eps: asked });
        let [more, noise] = [found.seconds - plain, NOISE * plain];
        told(
            judged.subject,
            Run {
                way: format!("{way} {asked:.0e}"),
                error: judged.error(&found, &open),
                rays: found.rays,
                seconds: more.max(noise),
                at_most: more < noise,
            },
        )
    };
    let ways = [("outlines", Shadows::Auto), ("rays", Shadows::Rays)];
    // Blockers that bend have no outlines: both ways are the same.
    let ways = if mostly_planar { &ways[..] } else { &ways[1..] };
    let runs: Vec<Run> = ways.iter().flat_map(|way| looser.iter().map(|looser| run(*way, *looser))).collect();
    runs.into_iter().filter(|run| run.error <= GOAL).min_by(|a, b| a.seconds.total_cmp(&b.seconds))
}

/// The naive program's first run that reaches the goal, or its last.
fn naive_program(judged: &Judged) -> Run {
    let visibility = Visibility::new(&judged.subject.scene, Shadows::Rays, GOAL);
    let mut last = naive_run(judged, &visibility, POINTS[0]);
    for pair in POINTS.windows(2) {
        let growth = (pair[1] as f64 / pair[0] as f64).powi(4);
        if last.error <= GOAL || last.rays as f64 * growth > MOST_RAYS as f64 {
            break;
        }
        last = naive_run(judged, &visibility, pair[1]);
    }
    last
}

fn naive_run(judged: &Judged, visibility: &Visibility, points: usize) -> Run {
    let list = judged.subject.elements.list();
    let mut rays = 0;
    let start = ProcessTime::now();
    let shade = |pair: &(usize, usize)| {
        (*pair, naive::shade([&list[pair.0], &list[pair.1]], visibility, points, &mut rays))
    };
    let shades: Table = judged.shaded.iter().map(shade).collect();
    let seconds = start.elapsed().as_secs_f64();
    let error = judged.error_of(|pair| shades[pair].clone());
    told(judged.subject, Run { way: format!("n = {points}"), error, rays, seconds, at_most: false })
}

/// Prints the third table.
pub(crate) fn print(races: &[Race]) {
    println!(
        "\n| scene | judged | of them shaded | ours within 1 % | rays | seconds | naive | error, % | rays | seconds | naive / ours, seconds |"
    );
    println!("|{}", " --- |".repeat(11));
    for Race { subject, every, pairs, ours, naive } in races {
        let judged = if *every == 1 { "all pairs".to_owned() } else { format!("1 pair in {every}") };
        let [ours, ratio] = ours.as_ref().map_or(["none | | ".to_owned(), String::new()], |ours| {
            let least = if ours.at_most || naive.error > GOAL { "> " } else { "" };
            let ratio = format!("{least}{:.1}", naive.seconds / ours.seconds);
            [format!("{} | {} | {}", ours.way, ours.rays, seconds(ours)), ratio]
        });
        println!(
            "| {} | {judged} | {pairs} | {ours} | {} | {:.2} | {} | {} | {ratio} |",
            subject.name,
            naive.way,
            100.0 * naive.error,
            naive.rays,
            seconds(naive)
        );
    }
}
