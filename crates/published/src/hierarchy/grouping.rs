//! Grouping of surfaces into clusters: a binary tree over their bounding boxes.
//!
//! Surfaces longer than half of a group part from the rest of it: the walls of a room would make every group
//! large. A group of similar surfaces parts at the median of their centres, along the longest side of the box
//! of these.

use radiosity_geom::Aabb;

/// Part of a group's diagonal above which a surface counts as long. An arbitrary choice: with a smaller value
/// groups fall into single surfaces, with a larger one walls make groups large.
const LONG: f64 = 0.5;

/// A group of surfaces.
pub(crate) enum Group {
    /// One surface, by its index.
    One(usize),
    /// Two groups.
    Two(Box<[Group; 2]>),
}

/// Groups the surfaces `members` with these `boxes`; None without members.
pub(crate) fn group(members: &mut [usize], boxes: &[Aabb]) -> Option<Group> {
    match members {
        [] => None,
        [only] => Some(Group::One(*only)),
        _ => {
            let middle = part(members, boxes);
            let (low, high) = members.split_at_mut(middle);
            Some(Group::Two(Box::new([group(low, boxes)?, group(high, boxes)?])))
        }
    }
}

/// Sorts at least two members into two groups; returns the size of the first.
fn part(members: &mut [usize], boxes: &[Aabb]) -> usize {
    let bounds = members.iter().fold(Aabb::EMPTY, |all, member| all.union(boxes[*member]));
    let is_long = |member: &usize| boxes[*member].diagonal() > LONG * bounds.diagonal();
    members.sort_by_key(|member| (is_long(member), *member));
    let short = members.partition_point(|member| !is_long(member));
    if short > 0 && short < members.len() {
        return short;
    }
    let sides = Aabb::around(members.iter().map(|member| boxes[*member].center()));
    let sides = sides.max - sides.min;
    let axis = (0..3).fold(0, |best, axis| if sides[axis] > sides[best] { axis } else { best });
    let place = |member: &usize| boxes[*member].center()[axis];
    members.sort_by(|a, b| place(a).total_cmp(&place(b)).then(a.cmp(b)));
    members.len() / 2
}
