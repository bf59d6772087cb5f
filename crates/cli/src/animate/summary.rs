//! Lines of a summary on frames: cost and warnings.

use radiosity_reading::accuracy_warning::missed;
use radiosity_solve::animation::follower::Follower;
use radiosity_solve::animation::sequence_report::{SequenceReport, WorstTransfer};
use radiosity_transport::RayCounts;

/// Lines on so many frames that were made in so many seconds: one on their cost, and one for each warning.
pub(super) fn lines(follower: &Follower<'_>, frames: usize, seconds: f64) -> Vec<String> {
    let report = follower.report();
    std::iter::once(cost(follower, frames, seconds)).chain(warnings(report)).collect()
}

fn cost(follower: &Follower<'_>, frames: usize, seconds: f64) -> String {
    let SequenceReport { moments, rays, noise, .. } = follower.report();
    let mut line = format!("{frames} frames in {seconds:.1} s, {:.2} a second; ", frames as f64 / seconds);
    line += &match follower.segments() {
        Some(segments @ 1..) => {
            format!("light solved {moments} times and interpolated in {segments} segments of the path")
        }
        Some(0) => format!("light solved {moments} times, nowhere interpolated"),
        None => format!("light solved {moments} times"),
    };
    if let Some(error) = follower.error() {
        let what = if follower.segments().is_some() { " to" } else { ", known to" };
        line += &format!("{what} {error:.1e}");
    }
    if follower.has_set_up() {
        let counted = if *noise > 0.0 { "rays" } else { "blocks" };
        line += &match follower.repaid() {
            None => format!(", set-up not repaid (counted in {counted})"),
            Some(frames) => format!(", set-up repaid after {frames} frames (counted in {counted})"),
        };
    }
    line += &ray_counts(rays);
    if *noise > 0.0 {
        line += &format!(", rays leave an error of {noise:.1e}");
    }
    line
}

/// Number of rays, and the share of them that was traced anew where others were recalled, in words.
fn ray_counts(RayCounts { traced, recalled }: &RayCounts) -> String {
    match traced + recalled {
        0 => String::new(),
        all if *recalled == 0 => format!(", {all} rays"),
        all => format!(", {all} rays, {:.1} % of them traced anew", 100.0 * *traced as f64 / all as f64),
    }
}

/// A line for each fault at any moment.
fn warnings(report: &SequenceReport) -> Vec<String> {
    let SequenceReport { moments, unconverged, missing, worst, .. } = report;
    let of_moments = |count: &usize| format!("warning: at {count} of {moments} moments");
    let mut lines = Vec::new();
    if unconverged.moments > 0 {
        lines.push(format!(
            "{} the solver did not converge, the relative residual is up to {:.1e}: the light is incomplete; raise \
             --max-iterations or take another --solver",
            of_moments(&unconverged.moments),
            unconverged.residual
        ));
    }
    if let Some(WorstTransfer { error, surfaces: [one, other] }) = worst {
        lines.push(format!("{} {}", of_moments(missing), missed(error, [one, other])));
    }
    lines
}
