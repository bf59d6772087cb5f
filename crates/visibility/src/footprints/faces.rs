//! The faces of a planar map.
//!
//! Segments are cut where they meet, and pieces with a free end are dropped. Each piece is then passed once
//! in either direction, turning clockwise into the next piece at each end: that goes once around each face,
//! with the face on the left. A face is bounded if its ring encloses a positive area.

use std::collections::{BTreeSet, HashMap};

use radiosity_geom::{DVec2, DVec3};

use super::segments::Segments;

/// A point where segments end or meet.
#[derive(Clone, Copy, Debug)]
struct Node {
    point: DVec3,
    place: DVec2,
}

/// The points of the map, without duplicates.
struct Nodes {
    list: Vec<Node>,
    tolerance: f64,
    /// The nodes in each square cell; the side of a cell is the tolerance.
    cells: HashMap<[i64; 2], Vec<usize>>,
}

impl Nodes {
    fn new(tolerance: f64) -> Self {
        Nodes { list: Vec::new(), tolerance, cells: HashMap::new() }
    }

    /// The first node within the tolerance of `node`, which is added if there is none.
    fn index(&mut self, node: Node) -> usize {
        let [column, row] = (node.place / self.tolerance).to_array().map(|x| x.floor() as i64);
        let around = (-1..=1).flat_map(|i| (-1..=1).map(move |j| [column + i, row + j]));
        let near = around.filter_map(|cell| self.cells.get(&cell)).flatten().copied();
        let known = near.filter(|k| self.list[*k].place.distance(node.place) <= self.tolerance).min();
        known.unwrap_or_else(|| {
            self.list.push(node);
            self.cells.entry([column, row]).or_default().push(self.list.len() - 1);
            self.list.len() - 1
        })
    }
}

/// The bounded faces, counter-clockwise, of the map that `segments` draw in a plane with the coordinates
/// `to_plane`. Points closer than `tolerance` are one.
pub(super) fn faces(
    segments: &Segments,
    to_plane: &dyn Fn(DVec3) -> DVec2,
    tolerance: f64,
) -> Vec<Vec<DVec3>> {
    let ends: Vec<[Node; 2]> =
        segments.list.iter().map(|ends| ends.map(|point| Node { point, place: to_plane(point) })).collect();
    let mut nodes = Nodes::new(tolerance);
    let mut edges = BTreeSet::new();
    for (index, own) in ends.iter().enumerate() {
        // Across and along each may differ by the tolerance.
        let near = segments.near(segments.list[index], 2.0 * tolerance).into_iter();
        let others = near.filter(|other| *other != index).map(|other| &ends[other]);
        let places = places_on(own, others, tolerance);
        let indices: Vec<usize> = places.into_iter().map(|node| nodes.index(node)).collect();
        for pair in indices.windows(2).filter(|pair| pair[0] != pair[1]) {
            edges.insert([pair[0].min(pair[1]), pair[0].max(pair[1])]);
        }
    }
    drop_blind(nodes.list.len(), &mut edges);
    let rings = ways(&nodes.list, &edges);
    let points = |ring: Vec<usize>| ring.into_iter().map(|node| nodes.list[node].point).collect();
    rings.into_iter().filter(|ring| enclosed(&nodes.list, ring) > tolerance.powi(2)).map(points).collect()
}

/// The nodes along a segment: its ends, and the points where others end on it or cross it.
fn places_on<'a>(own: &[Node; 2], others: impl Iterator<Item = &'a [Node; 2]>, tolerance: f64) -> Vec<Node> {
    let [a, b] = own.map(|end| end.place);
    let (direction, length) = ((b - a).normalize_or_zero(), a.distance(b));
    let mut found = vec![(0.0, own[0]), (length, own[1])];
    for other in others {
        let on_own = |end: &&Node| {
            let (along, across) = (direction.dot(end.place - a), direction.perp_dot(end.place - a));
            across.abs() <= tolerance && (-tolerance..=length + tolerance).contains(&along)
        };
        let touching: Vec<&Node> = other.iter().filter(on_own).collect();
        if touching.is_empty() {
            found.extend(crossing(own, other, direction, tolerance));
        }
        found.extend(touching.into_iter().map(|end| (direction.dot(end.place - a), *end)));
    }
    found.sort_by(|x, y| x.0.total_cmp(&y.0));
    found.into_iter().map(|(_, node)| node).collect()
}

/// Where two segments cross away from their ends, with the distance along the first.
fn crossing(own: &[Node; 2], other: &[Node; 2], direction: DVec2, tolerance: f64) -> Option<(f64, Node)> {
    let [c, d] = other.map(|end| direction.perp_dot(end.place - own[0].place));
    if c * d >= 0.0 || c.abs().min(d.abs()) <= tolerance {
        return None;
    }
    let t = c / (c - d);
    let node =
        Node { point: other[0].point.lerp(other[1].point, t), place: other[0].place.lerp(other[1].place, t) };
    let along = direction.dot(node.place - own[0].place);
    let length = own[0].place.distance(own[1].place);
    (tolerance < along && along < length - tolerance).then_some((along, node))
}

/// Drops edges with a free end, repeatedly, from a map of so many nodes.
fn drop_blind(nodes: usize, edges: &mut BTreeSet<[usize; 2]>) {
    let mut neighbours: Vec<Vec<usize>> = vec![Vec::new(); nodes];
    for [a, b] in edges.iter() {
        neighbours[*a].push(*b);
        neighbours[*b].push(*a);
    }
    let mut free: Vec<usize> = (0..nodes).filter(|node| neighbours[*node].len() == 1).collect();
    while let Some(node) = free.pop() {
        // The other end may have been the free one.
        let Some(other) = neighbours[node].pop() else { continue };
        edges.remove(&[node.min(other), node.max(other)]);
        neighbours[other].retain(|end| *end != node);
        if neighbours[other].len() == 1 {
            free.push(other);
        }
    }
}

/// The rings around the faces, those of the unbounded face included.
fn ways(nodes: &[Node], edges: &BTreeSet<[usize; 2]>) -> Vec<Vec<usize>> {
    let mut neighbours: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
    for [a, b] in edges {
        neighbours[*a].push(*b);
        neighbours[*b].push(*a);
    }
    for (node, around) in neighbours.iter_mut().enumerate() {
        let angle = |other: &usize| (nodes[*other].place - nodes[node].place).to_angle();
        around.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    }
    let next = |[from, to]: [usize; 2]| {
        let around = &neighbours[to];
        let place = around.iter().position(|node| *node == from).expect("edges are known at both ends");
        [to, around[(place + around.len() - 1) % around.len()]]
    };
    let mut done = BTreeSet::new();
    let mut rings = Vec::new();
    for start in edges.iter().flat_map(|[a, b]| [[*a, *b], [*b, *a]]) {
        let (mut ring, mut edge) = (Vec::new(), start);
        while done.insert(edge) {
            ring.push(edge[0]);
            edge = next(edge);
        }
        if !ring.is_empty() {
            rings.push(ring);
        }
    }
    rings
}

/// Twice the area inside a ring, positive where it runs counter-clockwise.
fn enclosed(nodes: &[Node], ring: &[usize]) -> f64 {
    let place = |k: usize| nodes[ring[k % ring.len()]].place - nodes[ring[0]].place;
    (0..ring.len()).map(|k| place(k).perp_dot(place(k + 1))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn areas(segments: &[[f64; 4]]) -> Vec<f64> {
        let segments: Vec<[DVec3; 2]> =
            segments.iter().map(|[a, b, c, d]| [DVec3::new(*a, *b, 0.0), DVec3::new(*c, *d, 0.0)]).collect();
        let area = |ring: &Vec<DVec3>| radiosity_geom::polygon_area(ring);
        let segments = Segments::new(segments);
        let mut areas: Vec<f64> = faces(&segments, &|x| x.truncate(), 1e-9).iter().map(area).collect();
        areas.sort_by(f64::total_cmp);
        areas
    }

    const SQUARE: [[f64; 4]; 4] = [[0., 0., 4., 0.], [4., 0., 4., 4.], [4., 4., 0., 4.], [0., 4., 0., 0.]];

    #[test]
    fn loops_inside_and_at_the_border_are_faces() {
        let inner = [[1., 1., 2., 1.], [2., 2., 2., 1.], [2., 2., 1., 2.], [1., 1., 1., 2.]];
        assert_eq!(areas(&[&SQUARE[..], &inner].concat()), [1.0, 16.0]);
        let corner = [[3., 4., 3., 2.], [3., 2., 4., 2.]];
        assert_eq!(areas(&[&SQUARE[..], &corner].concat()), [2.0, 14.0]);
        // Beyond the border.
        let across = [[3., 1., 5., 1.], [5., 1., 5., 2.], [5., 2., 3., 2.], [3., 2., 3., 1.]];
        assert_eq!(areas(&[&SQUARE[..], &across].concat()), [1.0, 1.0, 15.0]);
    }

    #[test]
    fn lines_that_enclose_nothing_make_no_faces() {
        let walls = [[1., 1., 3., 1.], [2., 0., 2., 3.], [3., 3., 3.5, 3.5]];
        assert_eq!(areas(&[&SQUARE[..], &walls].concat()), [16.0]);
        assert_eq!(areas(&walls), [0.0; 0]);
    }

    #[test]
    fn a_board_of_lines_has_the_faces_between_them() {
        // 13 lines each way, beyond the border by 1/2: 12 × 12 cells of area 1.
        let line = |k: i32| {
            let k = f64::from(k);
            [[k, -0.5, k, 12.5], [-0.5, k, 12.5, k]]
        };
        let lines: Vec<[f64; 4]> = (0..=12).flat_map(line).collect();
        let areas = areas(&lines);
        assert_eq!(areas.len(), 144);
        assert!(areas.iter().all(|area| (area - 1.0).abs() < 1e-12));
    }

    #[test]
    fn touching_loops_are_faces_of_their_own() {
        let pair = [
            [1., 1., 2., 1.],
            [2., 1., 2., 2.],
            [2., 2., 1., 2.],
            [1., 2., 1., 1.],
            [2., 1., 3., 1.],
            [3., 1., 3., 3.],
            [3., 3., 2., 3.],
            [2., 3., 2., 1.],
        ];
        assert_eq!(areas(&pair), [1.0, 2.0]);
    }
}
