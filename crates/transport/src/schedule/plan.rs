//! The plan of blocks: tasks with the accuracy that each has to reach, and where its block comes from.

use std::borrow::Cow;
use std::collections::HashMap;

use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use crate::schedule::congruent::Pose;
use crate::schedule::goal::Goal;
use crate::schedule::task::{Schedule, Task};

/// A task of the plan.
pub(super) struct Planned {
    pub(super) task: Task,
    /// The accuracy that it has to reach.
    pub(super) goal: Goal,
    pub(super) source: Source,
}

/// Where the block of a task comes from.
#[derive(Clone, Copy, Debug)]
pub(super) enum Source {
    /// Integrated for this task, at this place among all integrated blocks.
    Own(usize),
    /// Equal to the block of the earlier task of these elements, which is at this `place`.
    Copy { first: [usize; 2], place: usize },
}

impl Source {
    /// Whether the block is integrated for this task.
    pub(super) fn is_own(&self) -> bool {
        matches!(self, Self::Own(_))
    }

    /// The place of its block among all integrated blocks.
    pub(super) fn place(&self) -> usize {
        let (Source::Own(place) | Source::Copy { place, .. }) = self;
        *place
    }
}

impl Schedule<'_> {
    /// The plan of these tasks.
    pub(super) fn plan(&self, tasks: Vec<Task>) -> Vec<Planned> {
        let goals = self.goals(&tasks);
        let sources = self.share(&tasks, &goals);
        let planned = tasks.into_iter().zip(goals).zip(sources);
        planned.map(|((task, goal), source)| Planned { task, goal, source }).collect()
    }

    /// Finds tasks that are congruent to an earlier one and need the same accuracy.
    fn share(&self, tasks: &[Task], goals: &[Goal]) -> Vec<Source> {
        let mut first: HashMap<(u64, u64), usize> = HashMap::new();
        let candidates: Vec<Option<usize>> = tasks
            .iter()
            .zip(goals)
            .enumerate()
            .map(|(index, (task, goal))| {
                let found = *first.entry((task.hash?, goal.accuracy.eps.to_bits())).or_insert(index);
                (found != index).then_some(found)
            })
            .collect();
        let confirmed: Vec<Option<usize>> = (0..tasks.len())
            .into_par_iter()
            .map(|index| {
                check_interrupt();
                let first = candidates[index]?;
                self.pose(&tasks[index])?.equals(&self.pose(&tasks[first])?).then_some(first)
            })
            .collect();
        let mut places = vec![0; tasks.len()];
        let mut own = 0;
        let mut source = |(index, copied): (usize, Option<usize>)| {
            if let Some(first) = copied {
                return Source::Copy { first: tasks[first].pair(), place: places[first] };
            }
            places[index] = own;
            own += 1;
            Source::Own(places[index])
        };
        confirmed.into_iter().enumerate().map(&mut source).collect()
    }

    /// The block of the elements `pair`, from the `values` of that of the congruent elements `first`.
    pub(super) fn copied<'b>(
        &self,
        pair: [usize; 2],
        first: [usize; 2],
        values: &'b [f64],
    ) -> Cow<'b, [f64]> {
        // A single constant has neither sign nor order.
        if values.len() == 1 {
            return Cow::Borrowed(values);
        }
        let pose = |[row, column]: [usize; 2]| self.pose_of(row, column).expect("it was hashed");
        let [pose, other] = [pair, first].map(pose);
        Cow::Owned(pose.block_from(&other, values))
    }

    pub(super) fn pose_of(&self, row: usize, column: usize) -> Option<Pose> {
        Pose::of(self.panels[row].as_ref()?, self.panels[column].as_ref()?)
    }

    fn pose(&self, task: &Task) -> Option<Pose> {
        self.pose_of(task.row as usize, task.column as usize)
    }
}
