//! The summary of a run, in lines.

use radiosity_audit::Checked;
use radiosity_published::bases::Basis;
use radiosity_published::hierarchy::Counts;
use radiosity_reading::checkpoint::Checkpoint;
use radiosity_reading::rank_work::RanksWork;
use radiosity_reading::report::{NamedJump, Report, Transport};
use radiosity_reading::warning::Warning;
use radiosity_scene::LightGroup;
use radiosity_solve::checks::Checks;
use radiosity_solve::studies::adaptation::Aim;
use radiosity_solve::{Functional, Sampling, ShotLimit, Shots, Stages};
use radiosity_work::digits::decimals;
use radiosity_work::listed::{LONG, listed};

use super::Run;
use crate::loaded::remarks;

impl Run {
    /// Aim of the estimated error, where there is one.
    fn aim(&self) -> Option<Aim> {
        self.solved.achieved.map(|achieved| achieved.of)
    }

    /// Name of the estimated error by its aim.
    fn estimated(&self) -> &'static str {
        match self.aim() {
            Some(Aim::Gathered) => "gathered light",
            Some(Aim::Points) => "light at the points",
            Some(Aim::Seen) => "light in the picture",
            Some(Aim::Solution) | None => "the radiosity",
        }
    }

    /// The line about time.
    fn costs(&self) -> String {
        let Report { seconds, solver, residual, .. } = &self.report;
        let (load, total) = (seconds.stages["load"], seconds.total);
        if self.start.is_saved {
            return format!(
                "solution read in {load:.3} s ({solver}, residual {residual:.1e}), all {total:.3} s"
            );
        }
        let Stages { blocks, solve, .. } = self.solved.outcome.seconds;
        format!(
            "blocks {:.3} s ({}), {solver} {:.3} s (residual {residual:.1e}), all {total:.3} s",
            blocks.as_secs_f64(),
            self.counts(),
            solve.as_secs_f64()
        )
    }

    /// Counts of the work on blocks, in words.
    fn counts(&self) -> String {
        let Report { transport, kernel_samples, shadow_rays, .. } = &self.report;
        match transport {
            Transport { links: Some(counts), .. } => {
                let Counts { nodes, links, cluster_links, rounds, .. } = counts;
                format!("{links} links between {nodes} nodes, {cluster_links} of clusters, {rounds} rounds")
            }
            Transport { error: Some(error), rays, exact_pairs, .. } => {
                let seconds = self.solved.outcome.seconds.blocks.as_secs_f64();
                let rate = *rays as f64 / seconds.max(1e-9) / 1e6;
                let exact = match exact_pairs {
                    0 => String::new(),
                    pairs => format!(" and {pairs} pairs exactly"),
                };
                let planned = match self.solved.outcome.sampling {
                    Some(Sampling { rays, planned, .. }) if rays < planned => {
                        let why = if self.work().is_late_here() { "time was up" } else { "stopped" };
                        format!(" of {planned} ({why})")
                    }
                    _ => String::new(),
                };
                format!("{rays} rays{planned}{exact}, {rate:.1} M/s, rays leave an error of {error:.1e}")
            }
            _ => format!("{kernel_samples} kernel samples, {shadow_rays} shadow rays"),
        }
    }

    /// The functions on the elements in words.
    fn functions(&self) -> String {
        match (self.solved.options.basis, self.report.orders) {
            (Basis::Constant, _) => "constants".to_owned(),
            (Basis::Linear, _) => "tents".to_owned(),
            (Basis::Harmonic, _) => format!("cosines of degree {}", self.report.order),
            (Basis::Legendre, [lowest, highest]) if lowest == highest => format!("order {lowest}"),
            (Basis::Legendre, [lowest, highest]) => format!("orders {lowest} to {highest}"),
        }
    }

    /// Words on the number of reflections that the light was limited to; empty without a limit.
    fn bounces(&self) -> String {
        let limited = |bounces: usize| format!("; light of {bounces} reflections at the most");
        self.solved.options.bounces.map_or_else(String::new, limited)
    }

    /// The line about shots and the columns that were integrated for them.
    fn shots(&self, shots: &Shots) -> String {
        let Shots { count, columns, of, all_first, unshot, .. } = shots;
        let unshot = decimals(100.0 * unshot, 2);
        let columns = match all_first {
            None => format!("{columns} of {of} columns integrated, each when it was first shot"),
            Some(why) => format!("all {of} columns integrated before the first shot: {why}"),
        };
        let ambient = match self.solved.options.shots {
            Some(ShotLimit { ambient: true, .. }) => ", for which an ambient term stands",
            _ => "",
        };
        let made = if *count == 1 { "1 shot leaves".to_owned() } else { format!("{count} shots leave") };
        format!("{made} {unshot} % of the power to be shot{ambient}; {columns}")
    }

    /// Words on the largest jump between surfaces; empty where none go on smoothly.
    fn joint(&self) -> String {
        let words = |NamedJump { jump, surfaces: [first, second] }: &NamedJump| {
            format!(", across joints {jump:.2e} (\"{first}\", \"{second}\")")
        };
        self.report.joint_jump_max.as_ref().map_or_else(String::new, words)
    }

    /// The lines; the last names what was `written`.
    pub(super) fn lines(&self, written: Option<&str>) -> Vec<String> {
        let Report { surfaces, elements, unknowns, checks, .. } = &self.report;
        let mut lines = vec![
            format!(
                "{}: {surfaces} surfaces, {elements} elements, {}, {unknowns} unknowns a band{}",
                self.report.scene,
                self.functions(),
                self.bounces()
            ),
            self.costs(),
            self.start.progress.stages(),
        ];
        lines.extend(self.report.shots.as_ref().map(|shots| self.shots(shots)));
        lines.extend(self.report.ranks.as_ref().map(RanksWork::to_string));
        lines.extend(self.report.checkpoint.as_ref().map(Checkpoint::to_string));
        lines.push(balance(checks) + &row_sums(checks));
        lines.extend(groups(&self.report.light_groups));
        lines.extend(remarks(&self.solved.scene));
        // The error that rays leave in the radiosity of elements is told with the blocks.
        let is_told = self.report.transport.kind != "exact" && self.aim() == Some(Aim::Solution);
        let estimate = self.report.accuracy_estimate.filter(|_| !is_told);
        let told = |estimate| format!("estimated relative error of {} {estimate:.1e}", self.estimated());
        lines.extend(estimate.map(told));
        lines.extend(self.report.read_error.map(|error| error.to_string()));
        lines.extend(self.report.checked.as_ref().map(Checked::to_string));
        lines.extend(self.is_unchecked().then(|| "not checked by path tracing: time was up".to_owned()));
        if self.start.progress.verbose {
            lines.extend(self.report.functionals.iter().map(minimum));
            lines.push(format!("pairs: {:?}", self.report.pairs));
            lines.extend(self.report.masks.iter().map(|masks| format!("masked light of {masks}")));
            lines.push(smoothness(checks) + &self.joint());
        }
        lines.extend(self.report.planes.iter().flat_map(|plane| plane.lines(&self.report.unit)));
        lines.extend(self.report.warnings.iter().map(Warning::to_string));
        lines.extend(written.map(|path| format!("wrote {path}")));
        lines
    }
}

/// The line about the least value of the variational functional.
fn minimum(Functional { band, group, value }: &Functional) -> String {
    let group = group.as_ref().map_or_else(String::new, |group| format!(", light group '{group}'"));
    format!("variational functional of band '{band}'{group}: {value:.9e}")
}

/// Words on the sums of rows, behind the balance of power.
fn row_sums(checks: &Checks) -> String {
    if checks.row_sum_max == 0.0 {
        return String::new();
    }
    let [least, most] = [checks.row_sum_min, checks.row_sum_max].map(|sum| decimals(sum, 4));
    format!("; row sums {least} to {most}")
}

/// The line about what a solution misses of the constant 1 and of being continuous.
fn smoothness(checks: &Checks) -> String {
    // No bound is known where columns are missing.
    let bound = match checks.spectral_bound {
        0.0 => String::new(),
        bound => format!("spectral bound {bound:.4}, "),
    };
    format!("closure {:.2e}, {bound}largest seam jump {:.2e}", checks.closure_max, checks.seam_jump_max)
}

/// The line about the balance of power.
fn balance(checks: &Checks) -> String {
    if checks.energy_in == 0.0 {
        return "all lights are off".to_owned();
    }
    format!(
        "of the emitted power {} % is absorbed, {} % lost",
        decimals(100.0 * checks.energy_absorbed / checks.energy_in, 2),
        decimals(100.0 * checks.energy_lost / checks.energy_in, 2)
    )
}

/// The line about light groups, where there are any.
fn groups(groups: &[LightGroup]) -> Option<String> {
    let list: Vec<String> = groups.iter().map(|group| format!("{} × {}", group.name, group.factor)).collect();
    (!list.is_empty()).then(|| format!("light groups: {}", listed(&list, LONG)))
}
