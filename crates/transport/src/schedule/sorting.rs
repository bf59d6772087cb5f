//! Sorting of all pairs: into those that exchange nothing, by reasons, and those whose blocks are to be
//! found.

use radiosity_elements::Element;
use radiosity_geom::{Aabb, Plane};
use radiosity_kernel::PairCounts;
use radiosity_kernel::contact::planes;
use radiosity_kernel::contact::planes::Planes;
use radiosity_visibility::End;
use radiosity_work::interruption::check_interrupt;
use radiosity_work::ranks::{PartName, Ranks};

use crate::occlusion::outside_ball::lies_outside;
use crate::schedule::groups::{Group, Groups};
use crate::schedule::task::{Schedule, Task};
use crate::tolerances::BELOW_ESTIMATE;

/// Share of a pair assumed visible, for its lower bound, where blockers may hide some of it. An assumption:
/// with a larger value rows that are nearly all hidden get too coarse a scale, with a smaller one the blocks
/// of most rows get more digits than they need.
const VISIBLE_SHARE: f64 = 0.1;

/// Decisions of sorting about a pair.
enum Sorted {
    Behind,
    Coplanar,
    Hidden,
    Black,
    Task(Task),
}

/// The sorting of the pairs of one row.
struct RowSorting<'a> {
    schedule: &'a Schedule<'a>,
    row: usize,
    /// The element of the row as an end of segments, if surfaces may hide it from others.
    end: Option<End<'a>>,
    bounds: Aabb,
    tasks: Vec<Task>,
    counts: PairCounts,
}

impl<'a> RowSorting<'a> {
    fn new(schedule: &'a Schedule<'a>, row: usize) -> Self {
        let element = &schedule.list[row];
        let is_told = schedule.visibility.has_obstacles() && element.contact.is_none();
        let end = end(element).filter(|_| is_told);
        let bounds = Aabb::around(element.hull.iter().copied());
        Self { schedule, row, end, bounds, tasks: Vec::new(), counts: PairCounts::default() }
    }

    /// Sorts the pairs with a group of elements, if the row's plane is this.
    fn visit(&mut self, groups: &Groups, group: &Group, plane: &Plane) {
        if group.last < self.row {
            return;
        }
        let element = &self.schedule.list[self.row];
        if groups.are_behind(group, element, plane) {
            return self.take_all(groups.members(group), |_, _| Sorted::Behind);
        }
        if groups.are_coplanar(group, element, plane) {
            return self.take_all(groups.members(group), |_, _| Sorted::Coplanar);
        }
        let Some(halves) = group.halves else {
            return groups.members(group).iter().for_each(|column| self.tell(*column));
        };
        if !self.wants_any(groups.members(group)) {
            return self.take_all(groups.members(group), |_, _| Sorted::Black);
        }
        if self.is_hidden_from(group) {
            let schedule = self.schedule;
            let are_faced = groups.are_faced(group, element, plane);
            return self.take_all(groups.members(group), |row, column| match are_faced {
                true => Sorted::Hidden,
                false => schedule.planes_exchange_nothing(row, column).unwrap_or(Sorted::Hidden),
            });
        }
        halves.into_iter().for_each(|half| self.visit(groups, groups.group(half), plane));
    }

    /// Whether the pair of the row with one of `columns` is wanted.
    fn wants_any(&self, columns: &[usize]) -> bool {
        let row = self.row;
        columns.iter().any(|column| *column >= row && (self.schedule.wanted)(row, *column))
    }

    fn is_hidden_from(&self, group: &Group) -> bool {
        let is_apart = !group.bounds.overlaps(&self.bounds);
        let other = || group.bounds.corners();
        is_apart
            && self.end.is_some_and(|own| self.schedule.visibility.are_screened([own, End::within(&other())]))
    }

    /// Takes the decision about each of `columns` from the row on whose pair is wanted.
    fn take_all(&mut self, columns: &[usize], sorted: impl Fn(usize, usize) -> Sorted) {
        check_interrupt();
        let row = self.row;
        for column in columns.iter().copied().filter(|column| *column >= row) {
            let is_wanted = (self.schedule.wanted)(row, column);
            self.take(column, if is_wanted { sorted(row, column) } else { Sorted::Black });
        }
    }

    /// Sorts a single pair.
    fn tell(&mut self, column: usize) {
        let (schedule, row) = (self.schedule, self.row);
        let sorted = schedule.told_by_planes(row, column).unwrap_or_else(|| match self.is_screened(column) {
            true => Sorted::Hidden,
            false => schedule.told_by_blockers(row, column),
        });
        self.take(column, sorted);
    }

    /// Whether joined surfaces hide an element from the row.
    fn is_screened(&self, column: usize) -> bool {
        let ends = || Some([self.end?, end(&self.schedule.list[column])?]);
        column != self.row && ends().is_some_and(|ends| self.schedule.visibility.are_screened(ends))
    }

    fn take(&mut self, column: usize, sorted: Sorted) {
        let (other, counts) = (self.row != column, &mut self.counts);
        counts.total += usize::from(other || matches!(sorted, Sorted::Task(_) | Sorted::Black));
        match sorted {
            Sorted::Coplanar => counts.skipped_coplanar += usize::from(other),
            Sorted::Behind => counts.skipped_behind += 1,
            Sorted::Hidden => counts.skipped_hidden += 1,
            Sorted::Black => counts.skipped_black += 1,
            Sorted::Task(task) => self.tasks.push(task),
        }
    }
}

/// A planar element as an end of segments.
fn end(element: &Element) -> Option<End<'_>> {
    element.plane.map(|plane| End::on(element.surface, plane, &element.hull))
}

impl Schedule<'_> {
    /// Sorts all pairs and counts those that need no block.
    pub(super) fn sort(&self, ranks: &Ranks) -> (Vec<Task>, PairCounts) {
        let lengths: Vec<f64> = (1..=self.list.len()).rev().map(|length| length as f64).collect();
        let groups = Groups::new(self.list);
        let rows: Vec<(Vec<Task>, PairCounts)> =
            ranks.map(PartName::SortedPairs, &lengths, |row| self.sort_row(row, &groups));
        let mut tasks = Vec::with_capacity(rows.iter().map(|(row, _)| row.len()).sum());
        let mut pairs = PairCounts::default();
        for (row, counts) in rows {
            tasks.extend(row);
            pairs.total += counts.total;
            pairs.skipped_behind += counts.skipped_behind;
            pairs.skipped_coplanar += counts.skipped_coplanar;
            pairs.skipped_hidden += counts.skipped_hidden;
            pairs.skipped_black += counts.skipped_black;
        }
        (tasks, pairs)
    }

    /// The elements some of whose pairs are not wanted.
    pub(super) fn open_rows(&self) -> Vec<usize> {
        let all = 0..self.list.len();
        let is_open = |i: &usize| {
            check_interrupt();
            all.clone().any(|j| !(self.wanted)(*i.min(&j), *i.max(&j)))
        };
        all.clone().filter(is_open).collect()
    }

    fn sort_row(&self, row: usize, groups: &Groups) -> (Vec<Task>, PairCounts) {
        let mut sorting = RowSorting::new(self, row);
        match (self.list[row].plane, groups.root()) {
            (Some(plane), Some(root)) => {
                sorting.visit(groups, root, &plane);
                let is_curved = |column: &usize| self.list[*column].plane.is_none();
                (row..self.list.len()).filter(is_curved).for_each(|column| sorting.tell(column));
            }
            _ => (row..self.list.len()).for_each(|column| sorting.tell(column)),
        }
        sorting.tasks.sort_unstable_by_key(|task| task.column);
        (sorting.tasks, sorting.counts)
    }

    /// The decision about a pair as far as its planes and contacts tell.
    fn told_by_planes(&self, row: usize, column: usize) -> Option<Sorted> {
        check_interrupt();
        if !(self.wanted)(row, column) {
            return Some(Sorted::Black);
        }
        if let Some(skipped) = self.planes_exchange_nothing(row, column) {
            return Some(skipped);
        }
        let (receiver, emitter) = (&self.list[row], &self.list[column]);
        if receiver.contact != emitter.contact {
            return Some(Sorted::Hidden);
        }
        receiver.contact.map(|_| Sorted::Task(Task::of_contact(row, column)))
    }

    /// The decision about a pair that its planes leave open.
    fn told_by_blockers(&self, row: usize, column: usize) -> Sorted {
        let (receiver, emitter) = (&self.list[row], &self.list[column]);
        let surfaces = [receiver.surface, emitter.surface];
        let mut blockers = self.visibility.candidates(&receiver.hull, &emitter.hull, surfaces);
        // The wall of a can lies behind its lid.
        let visibility = self.visibility;
        blockers
            .retain(|own| visibility.frustum(*own).is_none() || !visibility.hides_nothing(*own, surfaces));
        let is_hidden = || {
            self.visibility.hidden(&blockers, &receiver.hull, &emitter.hull)
                || self.are_parted([receiver, emitter], &blockers)
        };
        if row != column && is_hidden() {
            return Sorted::Hidden;
        }
        let estimate = if self.is_estimated { self.estimate(row, column) } else { 0.0 };
        let own = self.visibility.hiding_themselves(surfaces, [&receiver.hull, &emitter.hull]);
        let entries = self.entries(row, column, estimate, !blockers.is_empty());
        let is_posed = row != column && blockers.is_empty();
        let hash = is_posed.then(|| self.pose_of(row, column)).flatten().map(|pose| pose.hash());
        let (row, column) = (row as u32, column as u32);
        Sorted::Task(Task { row, column, entries, estimate, hash, blockers, own })
    }

    /// Whether one of two elements lies in a whole ball among `blockers`, and the other outside.
    fn are_parted(&self, pair: [&Element; 2], blockers: &[usize]) -> bool {
        let parts = |blocker: &usize| {
            let Some((center, radius)) = self.visibility.ball(*blocker) else { return false };
            let [first, second] = pair.map(|own| self.visibility.encloses(*blocker, own.surface));
            first && lies_outside(pair[1], center, radius) || second && lies_outside(pair[0], center, radius)
        };
        blockers.iter().any(parts)
    }

    /// Bounds of the entries of a block from below and above, given the coarse estimate of its first one.
    fn entries(&self, row: usize, column: usize, estimate: f64, may_be_hidden: bool) -> [f64; 2] {
        if row == column {
            return [0.0, f64::INFINITY];
        }
        let [mut least, most] = self.bounds[row].entries(&self.bounds[column]);
        if [row, column].iter().any(|element| self.list[*element].plane.is_none()) {
            least = BELOW_ESTIMATE * estimate;
        }
        [if may_be_hidden { VISIBLE_SHARE * least } else { least }, most]
    }

    /// Coarse estimate of the first entry of the block of two elements, without blockers.
    fn estimate(&self, row: usize, column: usize) -> f64 {
        let [first, other] = if self.comes_later(row, column) { [column, row] } else { [row, column] };
        self.estimate_of(first).entry(self.estimate_of(other))
    }

    /// Whether the first of two elements is the inner one ([`crate::schedule::order`]).
    pub(super) fn comes_later(&self, first: usize, other: usize) -> bool {
        self.precedence[first].order(&self.precedence[other]).is_gt()
    }

    /// Why the planes of the two elements leave nothing to exchange, if they do.
    fn planes_exchange_nothing(&self, row: usize, column: usize) -> Option<Sorted> {
        match planes::of(&self.list[row], &self.list[column]) {
            Planes::Exchanging => None,
            Planes::Behind => Some(Sorted::Behind),
            Planes::Coplanar => Some(Sorted::Coplanar),
        }
    }
}
