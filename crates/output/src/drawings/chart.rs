//! The chart of a convergence study: error against unknowns, or shots, and against time.

use radiosity_solve::studies::convergence::{ConvergenceRun, RunSeries};

use super::diagram::{COLOURS, Curve, Diagram, Dot, Panel, Spacing};

/// The diagram of `runs`, sorted by their way and by the number of layers; runs without an error above 0 are
/// not shown. The caption tells what the errors are measured against.
pub fn chart(title: String, caption: String, runs: &[ConvergenceRun]) -> Diagram {
    let unknowns = match runs.iter().any(|run| run.shots.is_some()) {
        true => panel(runs, "shots", |run| run.shots.unwrap_or(0) as f64),
        false => panel(runs, "unknowns per band", |run| run.unknowns as f64),
    };
    let time = panel(runs, "time, s", |run| run.seconds.max(1e-6));
    Diagram { title, caption, columns: 2, panels: vec![unknowns, time] }
}

fn panel(runs: &[ConvergenceRun], label: &str, abscissa: impl Fn(&ConvergenceRun) -> f64) -> Panel {
    let groups = runs.chunk_by(|a, b| a.layers == b.layers && a.series == b.series);
    // A dot, with the order next to it where that is what changes.
    let dot = |run: &ConvergenceRun| {
        // No shots have no place on a logarithmic axis.
        let error = run.error.filter(|error| *error > 0.0 && run.shots != Some(0))?;
        let is_by_order = matches!(run.series, RunSeries::Uniform | RunSeries::Harmonic);
        let text = if is_by_order { run.order.to_string() } else { String::new() };
        Some(Dot { place: [abscissa(run), error], text })
    };
    let curve = |(runs, colour): (&[ConvergenceRun], &[u8; 3])| Curve {
        label: name(&runs[0]),
        colour: *colour,
        dots: runs.iter().filter_map(dot).collect(),
        others: Vec::new(),
    };
    let axes = [label, "relative error of the radiosity"].map(str::to_owned);
    let curves = groups.zip(COLOURS.iter().cycle()).map(curve).collect();
    Panel { title: String::new(), axes, along: Spacing::Logarithmic, curves }
}

fn name(run: &ConvergenceRun) -> String {
    match (run.series, run.layers) {
        (RunSeries::Hierarchical, _) => "hierarchical, constants".to_owned(),
        (RunSeries::Hp, _) => "refined for gathered light".to_owned(),
        (RunSeries::Constant, _) => "constants on cells".to_owned(),
        (RunSeries::Linear, _) => "tents on cells".to_owned(),
        (RunSeries::Harmonic, _) => "cosines over surfaces".to_owned(),
        (RunSeries::Shots, _) => "columns as they are shot".to_owned(),
        (RunSeries::ShotsOfAll, _) => "all columns first".to_owned(),
        (RunSeries::Sampled, _) => format!("order {} by rays", run.order),
        (RunSeries::Uniform, 0) => "whole elements".to_owned(),
        (RunSeries::Uniform, 1) => "1 layer".to_owned(),
        (RunSeries::Uniform, layers) => format!("{layers} layers"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(order: usize, unknowns: usize, error: Option<f64>) -> ConvergenceRun {
        let seconds = 1e-4 * unknowns as f64;
        ConvergenceRun {
            series: RunSeries::Uniform,
            order,
            layers: 0,
            elements: 1,
            unknowns,
            shots: None,
            columns: None,
            samples: 1,
            rays: 0,
            seconds,
            error,
            rate: None,
            energy: None,
        }
    }

    #[test]
    fn both_kinds_show_the_runs_that_have_errors() {
        let runs = [run(0, 6, Some(0.3)), run(1, 18, Some(0.1)), run(2, 36, None)];
        let drawing = |runs| chart("room".into(), "against the finest".into(), runs).drawing();
        let svg = drawing(&runs).svg();
        let circles = svg.matches("<circle").count();
        assert_eq!(circles, 5, "two runs in two panels, and one in the legend");
        assert!(svg.contains(">room<") && svg.contains(">0.1<"));
        assert_ne!(drawing(&runs).picture(), drawing(&[]).picture());
    }
}
