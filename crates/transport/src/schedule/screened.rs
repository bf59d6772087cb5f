//! The columns that a row is wholly hidden from, many at once where it is hidden from a box around them.

use radiosity_elements::Element;
use radiosity_geom::{Aabb, DVec3};
use radiosity_visibility::End;

use crate::schedule::task::Schedule;

/// Fewest columns that are tried together: for fewer a box takes as long as they do.
const FEWEST: usize = 3;

impl Schedule<'_> {
    /// Of the `columns`, those from which joined surfaces hide the row, ascending.
    pub(super) fn screened(&self, row: usize, mut columns: Vec<usize>) -> Vec<usize> {
        let mut found = Vec::new();
        let list = self.list;
        columns.retain(|column| *column != row && list[*column].plane.is_some());
        if let Some(end) = end(&list[row]).filter(|_| self.visibility.has_obstacles()) {
            self.add_screened(end, &mut columns, &mut found);
        }
        found.sort_unstable();
        found
    }

    /// Adds those of the `columns` from which an end is hidden.
    fn add_screened(&self, own: End, columns: &mut [usize], found: &mut Vec<usize>) {
        if columns.len() < FEWEST {
            let is_hidden = |column: &&usize| {
                end(&self.list[**column]).is_some_and(|other| self.visibility.are_screened([own, other]))
            };
            found.extend(columns.iter().filter(is_hidden));
            return;
        }
        let all = columns.iter().flat_map(|column| self.list[*column].hull.iter().copied());
        let bounds = Aabb::around(all);
        if self.visibility.are_screened([own, End::within(&bounds.corners())]) {
            found.extend_from_slice(columns);
            return;
        }
        let axis = (bounds.max - bounds.min).max_position();
        let middle = columns.len() / 2;
        columns.select_nth_unstable_by(middle, |a, b| {
            let place = |column: &usize| center(&self.list[*column])[axis];
            place(a).total_cmp(&place(b)).then(a.cmp(b))
        });
        let (low, high) = columns.split_at_mut(middle);
        self.add_screened(own, low, found);
        self.add_screened(own, high, found);
    }
}

/// A planar element as an end of segments.
fn end(element: &Element) -> Option<End<'_>> {
    element.plane.map(|plane| End::on(element.surface, plane, &element.hull))
}

fn center(element: &Element) -> DVec3 {
    element.hull.iter().sum::<DVec3>() / element.hull.len() as f64
}
