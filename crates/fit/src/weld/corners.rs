//! Corners nearer to each other than the tolerance of their sheets become one node.

use std::collections::HashMap;

use radiosity_geom::{Aabb, Bvh, DVec3};

use super::apart::Apart;
use super::forest::Forest;
use super::sheet::Sheets;

/// The corners of all sheets, merged into nodes.
#[derive(Debug)]
pub(super) struct Corners {
    /// Initial position of each node: the corner, or the mean of those that it joins.
    pub(super) nodes: Vec<DVec3>,
    /// The sheets of each node, ascending.
    pub(super) sheets: Vec<Vec<usize>>,
    /// The largest tolerance of the sheets of each node (scene length).
    pub(super) tolerances: Vec<f64>,
    /// The node at each position, by the position's bits.
    of_position: HashMap<[u64; 3], usize>,
}

fn bits(x: DVec3) -> [u64; 3] {
    // Adding zero makes −0 and 0 one.
    x.to_array().map(|x| (x + 0.0).to_bits())
}

impl Corners {
    /// The corners of `sheets`, merged except for those of sheets that are `apart`.
    pub(super) fn merged(sheets: &Sheets, apart: &Apart) -> Self {
        let places = Places::of(sheets);
        let forest = places.joined(sheets, apart);
        let count = places.list.len();
        let mut members: HashMap<usize, Vec<usize>> = HashMap::new();
        (0..count).for_each(|place| members.entry(forest.root(place)).or_default().push(place));
        // Chains may join corners that must not be one: then each of them is a node of its own.
        let broken = members.extract_if(|_, group| places.conflict(group, apart)).collect::<Vec<_>>();
        members.extend(broken.into_iter().flat_map(|(_, group)| group).map(|place| (place, vec![place])));
        let (mut nodes, mut owners, mut starts) = (Vec::new(), Vec::new(), Vec::new());
        for place in 0..count {
            let Some(group) = members.get(&place) else { continue };
            starts.extend(group.iter().map(|member| (places.list[*member], nodes.len())));
            nodes.push(mean(group.iter().map(|member| places.list[*member]).collect()));
            let mut own: Vec<usize> =
                group.iter().flat_map(|member| places.sheets[*member].clone()).collect();
            own.sort_unstable();
            own.dedup();
            owners.push(own);
        }
        let of_position = starts.iter().map(|(position, node)| (bits(*position), *node)).collect();
        let largest = |owners: &Vec<usize>| {
            owners.iter().map(|sheet| sheets.list[*sheet].tolerance.largest()).fold(0.0, f64::max)
        };
        let tolerances = owners.iter().map(largest).collect();
        Self { nodes, sheets: owners, tolerances, of_position }
    }

    /// The node of the corner at exactly this position.
    pub(super) fn node(&self, position: DVec3) -> Option<usize> {
        self.of_position.get(&bits(position)).copied()
    }
}

/// The mean of points, independent of their order.
fn mean(mut points: Vec<DVec3>) -> DVec3 {
    points.sort_by_key(|x| bits(*x));
    points.iter().sum::<DVec3>() / points.len() as f64
}

/// The distinct positions of corners, with the sheets that have a corner there.
struct Places {
    list: Vec<DVec3>,
    sheets: Vec<Vec<usize>>,
}

impl Places {
    fn of(sheets: &Sheets) -> Self {
        let mut places = Self { list: Vec::new(), sheets: Vec::new() };
        let mut known: HashMap<[u64; 3], usize> = HashMap::new();
        for (index, sheet) in sheets.list.iter().enumerate() {
            for corner in &sheet.corners {
                let place = *known.entry(bits(*corner)).or_insert_with(|| {
                    places.list.push(*corner);
                    places.sheets.push(Vec::new());
                    places.list.len() - 1
                });
                places.sheets[place].push(index);
            }
        }
        places
    }

    /// A forest whose trees are the places that become one.
    fn joined(&self, sheets: &Sheets, apart: &Apart) -> Forest {
        let most = |place: usize| {
            self.sheets[place].iter().map(|sheet| sheets.list[*sheet].tolerance.most()).fold(0.0, f64::max)
        };
        let boxes: Vec<Aabb> =
            (0..self.list.len()).map(|place| Aabb::around([self.list[place]]).inflate(most(place))).collect();
        let tree = Bvh::build(&boxes);
        let mut forest = Forest::new(self.list.len());
        for (own, bounds) in boxes.iter().enumerate() {
            tree.overlapping(bounds, |other| {
                if other < own && self.are_one(own, other, sheets, apart) {
                    forest.join(own, other);
                }
            });
        }
        forest
    }

    /// Whether two of a group of places belong to one sheet, or to sheets that are apart.
    fn conflict(&self, group: &[usize], apart: &Apart) -> bool {
        let pairs = group.iter().enumerate().flat_map(|(k, a)| group[..k].iter().map(move |b| (*a, *b)));
        pairs.into_iter().any(|(a, b)| {
            self.sheets[a]
                .iter()
                .any(|own| self.sheets[b].iter().any(|other| own == other || apart.contains(&(*own, *other))))
        })
    }

    /// Whether two places are nearer than the tolerance of a pair of their sheets, but not equal to rounding
    /// already.
    fn are_one(&self, own: usize, other: usize, sheets: &Sheets, apart: &Apart) -> bool {
        let distance = self.list[own].distance(self.list[other]);
        let pairs = || self.sheets[own].iter().flat_map(|a| self.sheets[other].iter().map(move |b| (*a, *b)));
        let tolerance = |(a, b): (usize, usize)| sheets.list[a].tolerance.with(&sheets.list[b].tolerance);
        distance > sheets.reach()
            && pairs().map(tolerance).any(|tolerance| distance <= tolerance)
            && !pairs().any(|(a, b)| a == b || apart.contains(&(a, b)))
    }
}
