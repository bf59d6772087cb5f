//! Reciprocity of the blocks, from a sample of pairs that are integrated both ways.

use radiosity_kernel::Reciprocity;
use radiosity_work::ranks::PartName;

use crate::schedule::integrated::Integrated;
use crate::schedule::plan::{Planned, Source};
use crate::schedule::task::Schedule;

/// Pairs for each one that is integrated both ways, which costs a hundredth more.
const SAMPLED_SHARE: usize = 100;
/// Fewest pairs that are integrated both ways, in small scenes.
const FEWEST_SAMPLED: usize = 4;

impl Schedule<'_> {
    /// Integrates a sample of the pairs that were stored, one in a hundred, with the roles of the elements
    /// exchanged; none above mean cost.
    pub(super) fn reciprocity(
        &self,
        plan: &[Planned],
        is_stored: &dyn Fn(usize) -> bool,
        integrated: &Integrated,
    ) -> Reciprocity {
        let own = |(index, planned): (usize, &Planned)| match planned.source {
            Source::Own(place) if planned.task.row != planned.task.column && is_stored(index) => {
                Some((index, place))
            }
            _ => None,
        };
        let pairs: Vec<(usize, usize)> = plan.iter().enumerate().filter_map(own).collect();
        let cost = |place: usize| {
            let report = integrated.report(place).block;
            report.samples + report.rays
        };
        let mean = pairs.iter().map(|(_, place)| cost(*place)).sum::<u64>() / pairs.len().max(1) as u64;
        let step = (pairs.len() / (pairs.len() / SAMPLED_SHARE).max(FEWEST_SAMPLED)).max(1);
        let sample: Vec<(usize, usize)> =
            pairs.into_iter().filter(|(_, place)| cost(*place) <= mean).step_by(step).collect();
        let makers: Vec<usize> = sample.iter().map(|(_, place)| integrated.makers[*place]).collect();
        let differences: Vec<Option<f64>> =
            integrated.ranks.map_by(PartName::ExchangedBlocks, &makers, |number| {
                let (index, place) = sample[number];
                let Planned { task, goal, .. } = &plan[index];
                let [a, b] = task.pair().map(|element| self.list[element].area);
                let block = integrated.block(place);
                let again = *block.exchanged.get_or_init(|| {
                    let again = self.block(!self.is_turned(task), task, *goal);
                    (!again.report.untried).then(|| again.values[0])
                });
                again.map(|again| (again - block.block.values[0]).abs() * (a * b).sqrt() / a.min(b))
            });
        let mut reciprocity = Reciprocity::default();
        differences.into_iter().flatten().for_each(|difference| reciprocity.take(difference));
        reciprocity
    }
}
