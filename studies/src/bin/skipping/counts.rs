//! Pairs by class, and the rays of a program that casts one per kernel sample.

use radiosity::Work;
use radiosity::solve::{Failure, Options, Outcome, solve};
use radiosity::transport;
use radiosity::visibility::Visibility;

use crate::judged::is_taken;
use crate::subject::Subject;

/// Pairs of a scene above which one pair in so many is asked for naive rays, a power of two.
const MANY_PAIRS: usize = 10_000;
const SAMPLED: usize = 16;

/// Prints the first table.
pub(crate) fn print(subjects: &[Subject]) -> Result<(), Failure> {
    println!(
        "| scene | pairs | face away | in a plane | wholly hidden | send nothing | repeated | wholly seen | partly hidden | samples | rays | naive rays | naive / rays |"
    );
    println!("|{}", " --- |".repeat(13));
    for subject in subjects {
        let outcome = solve(&subject.scene, &Options::default(), &Work::alone())?;
        println!("| {} {}", subject.name, row(subject, &outcome));
    }
    Ok(())
}

/// Samples of the blocks without shadows; of scenes of many pairs told from some of them.
fn naive_samples(subject: &Subject, pairs: usize) -> u64 {
    let Subject { scene, elements, .. } = subject;
    let sends = |element: usize| scene.surfaces[elements.list()[element].surface].material.sends();
    let every = if pairs > MANY_PAIRS { SAMPLED } else { 1 };
    let wanted = |i, j| (sends(i) || sends(j)) && is_taken([i, j], elements.list().len(), every);
    let open = Visibility::open(scene);
    let accuracy = Options::default().accuracy();
    every as u64
        * transport::assemble(
            transport::Demand::all(elements, &open, accuracy).of(&wanted),
            None,
            &Work::alone(),
        )
        .statistics
        .samples
}

/// A row of the table, less its name.
fn row(subject: &Subject, outcome: &Outcome) -> String {
    let pairs = &outcome.pairs;
    let naive = naive_samples(subject, pairs.total);
    let skipped = pairs.skipped_behind + pairs.skipped_coplanar + pairs.skipped_hidden + pairs.skipped_black;
    let ratio = match outcome.rays {
        0 => "no rays".to_owned(),
        rays => format!("{:.1}", naive as f64 / rays as f64),
    };
    format!(
        "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {naive} | {ratio} |",
        pairs.total,
        pairs.skipped_behind,
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
