//! Bicubic patches as quadtrees of tiles, to look for rays only where they pass.
//!
//! A ray descends from the whole patch to the quarters that it may meet, by their boxes ([`Sheared`]), until
//! a box shows that it meets the patch or a tile is straight enough to be met directly ([`Chart`]), or down
//! to the smallest tiles. Seen along the ray, their control points form planar nets, whose zeros are
//! bracketed ([`zeros`]).

use super::chart::{Chart, Meeting};
use super::net::{part, sample};
use super::quarters::Quarters;
use super::sheared::{Local, Passage, Sheared};
use crate::bernstein::Coefficient;
use crate::zeros::zeros;
use crate::{Hit, Ray, Rect};
use glam::{DVec2, DVec3, DVec4};

/// Quarterings of a patch: of rational ones, and at most. Chosen: one more is no faster on the teapot.
const OF_RATIONAL: usize = 3;
const DEEPEST: usize = 5;

/// A coefficient that stands for a control point.
pub(super) trait Control: Coefficient {
    /// Whether it has a weight.
    const IS_RATIONAL: bool;

    /// The control point.
    fn point(self) -> DVec3;

    /// A multiple of its place across a ray from `origin`, by two unit vectors across the ray.
    fn seen(self, origin: DVec3, across: [DVec3; 2]) -> DVec2;
}

impl Control for DVec3 {
    const IS_RATIONAL: bool = false;

    fn point(self) -> DVec3 {
        self
    }

    fn seen(self, origin: DVec3, across: [DVec3; 2]) -> DVec2 {
        DVec2::from_array(across.map(|e| (self - origin).dot(e)))
    }
}

impl Control for DVec4 {
    const IS_RATIONAL: bool = true;

    fn point(self) -> DVec3 {
        self.truncate() / self.w
    }

    fn seen(self, origin: DVec3, across: [DVec3; 2]) -> DVec2 {
        let from = self.truncate() - self.w * origin;
        DVec2::from_array(across.map(|e| from.dot(e)))
    }
}

/// A patch cut into tiles.
#[derive(Clone, Debug)]
pub(super) struct Tiles<T> {
    /// The tiles of all levels of the quadtree, the whole patch first, four quarters of a tile one after the
    /// other.
    tiles: Vec<Tile<T>>,
}

#[derive(Clone, Debug)]
struct Tile<T> {
    around: Sheared,
    /// None where no ray finds it straight enough.
    chart: Option<Box<Chart>>,
    content: Content<T>,
}

#[derive(Clone, Debug)]
enum Content<T> {
    /// Boxes of four quarters and the index of the first.
    Quarters(Box<Quarters>, usize),
    /// Control net of a smallest tile.
    Net(Box<[[T; 4]; 4]>),
}

/// A tile: its index, lowest u and v, and width along both.
#[derive(Clone, Copy)]
struct Place {
    tile: usize,
    corner: [f64; 2],
    width: f64,
}

impl<T: Control> Tiles<T> {
    /// The tiles of the patch with the control net `net`, whose weights, if it has any, are positive.
    pub(super) fn new(net: &[[T; 4]; 4]) -> Self {
        let mut tiles = vec![Tile::of(*net)];
        let mut open = vec![(Place::WHOLE, 0)];
        while let Some((place, level)) = open.pop() {
            let chart = &tiles[place.tile].chart;
            let enough = if T::IS_RATIONAL { OF_RATIONAL } else { DEEPEST };
            if level == enough || chart.as_ref().is_some_and(|chart| chart.is_straight()) {
                continue;
            }
            let first = tiles.len();
            let quarters = place.quarters(first);
            let nets = quarters.map(|quarter| part(net, &quarter.rect()));
            tiles.extend(nets.map(Tile::of));
            tiles[place.tile].divide(nets, first);
            open.extend(quarters.map(|quarter| (quarter, level + 1)));
        }
        Self { tiles }
    }

    /// Whether a ray meets the patch.
    pub(super) fn any(&self, ray: &Ray) -> bool {
        self.any_in(Place::WHOLE, ray)
    }

    /// The nearest hit.
    pub(super) fn nearest(&self, ray: &Ray) -> Option<Hit> {
        let mut best = None;
        self.nearest_in(Place::WHOLE, ray, &mut best);
        best
    }

    fn any_in(&self, place: Place, ray: &Ray) -> bool {
        let tile = &self.tiles[place.tile];
        let local = tile.around.seen(ray);
        match tile.around.passage(&local, ray.range) {
            Passage::Misses => return false,
            Passage::Meets => return true,
            Passage::Doubtful => {}
        }
        match (tile.meeting(&local, place.width), &tile.content) {
            (Meeting::None, _) => false,
            (Meeting::At { s, t, along }, _) => place.accept(ray, along, [s, t]).is_some(),
            (Meeting::Doubtful, Content::Quarters(boxes, first)) => {
                let entered = boxes.entered(&local, ray.range).into_iter();
                let mut quarters = place.quarters(*first).into_iter().zip(entered);
                quarters.any(|(quarter, is_entered)| is_entered && self.any_in(quarter, ray))
            }
            (Meeting::Doubtful, Content::Net(net)) => {
                let mut found = false;
                place.hits(net, ray, |_| {
                    found = true;
                    true
                });
                found
            }
        }
    }

    fn nearest_in(&self, place: Place, ray: &Ray, best: &mut Option<Hit>) {
        let tile = &self.tiles[place.tile];
        let local = tile.around.seen(ray);
        let range = best.map_or(*ray, |hit| ray.until(hit.t)).range;
        if tile.around.passage(&local, range) == Passage::Misses {
            return;
        }
        let mut take = |hit: Hit| *best = Hit::nearer(*best, hit);
        match (tile.meeting(&local, place.width), &tile.content) {
            (Meeting::None, _) => {}
            (Meeting::At { s, t, along }, _) => {
                place.accept(ray, along, [s, t]).into_iter().for_each(take);
            }
            (Meeting::Doubtful, Content::Quarters(boxes, first)) => {
                let entered = boxes.entered(&local, range).into_iter();
                let quarters = place.quarters(*first).into_iter().zip(entered);
                let entered = quarters.filter(|(_, is_entered)| *is_entered);
                entered.for_each(|(quarter, _)| self.nearest_in(quarter, ray, best));
            }
            (Meeting::Doubtful, Content::Net(net)) => place.hits(net, ray, |hit| {
                take(hit);
                false
            }),
        }
    }
}

impl<T: Control> Tile<T> {
    fn of(net: [[T; 4]; 4]) -> Self {
        let points = net.map(|row| row.map(T::point));
        let around = Sheared::around(&points);
        let chart = if T::IS_RATIONAL { None } else { Chart::new(around.local(&points)).map(Box::new) };
        Self { around, chart, content: Content::Net(Box::new(net)) }
    }

    /// Replaces the control net by those of four quarters; `first` is the index of the first.
    fn divide(&mut self, nets: [[[T; 4]; 4]; 4], first: usize) {
        let Content::Net(net) = &self.content else { return };
        let points = |net: [[T; 4]; 4]| net.map(|row| row.map(T::point));
        let boxes = self.around.parts(&points(**net), nets.map(points));
        self.content = Content::Quarters(Box::new(Quarters::new(boxes)), first);
    }

    /// Meeting of a ray with the tile, as far as its chart tells; `width` is that of the tile along u and v.
    fn meeting(&self, ray: &Local, width: f64) -> Meeting {
        self.chart.as_ref().map_or(Meeting::Doubtful, |chart| chart.meet(ray, Hit::SEAM / width))
    }
}

/// Two unit vectors across a ray.
fn across(ray: &Ray) -> [DVec3; 2] {
    ray.direction.normalize().any_orthonormal_pair().into()
}

impl Place {
    const WHOLE: Place = Place { tile: 0, corner: [-1.0; 2], width: 2.0 };

    /// The quarters, of which the first has the index `first`.
    fn quarters(self, first: usize) -> [Place; 4] {
        let width = 0.5 * self.width;
        let [u, v] = self.corner;
        let corners = [[u, v], [u, v + width], [u + width, v], [u + width, v + width]];
        std::array::from_fn(|k| Place { tile: first + k, corner: corners[k], width })
    }

    fn rect(self) -> Rect {
        let [u, v] = self.corner.map(|low| [low, low + self.width]);
        Rect { u, v }
    }

    /// Visits the hits with a tile that has the control net `net`, until `visit` returns true.
    fn hits<T: Control>(self, net: &[[T; 4]; 4], ray: &Ray, mut visit: impl FnMut(Hit) -> bool) {
        let across = across(ray);
        let mut seen = [[DVec2::ZERO; 4]; 4];
        for (seen, x) in seen.as_flattened_mut().iter_mut().zip(net.as_flattened()) {
            *seen = x.seen(ray.origin, across);
        }
        zeros(&seen, Hit::SEAM / self.width, |s, t| {
            let position = sample(net, s, t).value.point();
            let along = (position - ray.origin).dot(ray.direction) / ray.direction.length_squared();
            self.accept(ray, along, [s, t]).is_some_and(&mut visit)
        });
    }

    /// The hit at (s, t) ∈ [0, 1]² of the tile, if the ray has it.
    fn accept(self, ray: &Ray, along: f64, [s, t]: [f64; 2]) -> Option<Hit> {
        let [u, v] = self.corner;
        Hit::accept(ray, along, u + s * self.width, v + t * self.width)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The lowest t of all hits with all smallest tiles, whatever their boxes and charts say.
    fn brute<T: Control>(tiles: &Tiles<T>, ray: &Ray) -> Option<f64> {
        let (mut best, mut open) = (None, vec![Place::WHOLE]);
        while let Some(place) = open.pop() {
            match &tiles.tiles[place.tile].content {
                Content::Quarters(_, first) => open.extend(place.quarters(*first)),
                Content::Net(net) => place.hits(net, ray, |hit| {
                    best = Hit::nearer(best, hit);
                    false
                }),
            }
        }
        best.map(|hit| hit.t)
    }

    fn agree<T: Control>(tiles: &Tiles<T>, ray: &Ray) -> Result<(), TestCaseError> {
        let expected = brute(tiles, ray);
        prop_assert_eq!(tiles.any(ray), expected.is_some(), "{:?}", ray);
        let nearest = tiles.nearest(ray).map(|hit| hit.t);
        let apart = nearest.zip(expected).map(|(found, expected)| (found - expected).abs());
        prop_assert!(
            nearest.is_some() == expected.is_some() && apart.is_none_or(|apart| apart < 1e-11),
            "{:?}",
            ray
        );
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// On sheets from nearly flat to tangled ones, plain and rational: segments between any points, and
        /// between points of the sheet, where boxes say least.
        #[test]
        fn rays_meet_what_all_tiles_together_meet(
            offsets in prop::collection::vec(prop::array::uniform3(-1.0..1.0), 16),
            weights in prop::array::uniform16(0.3..3.0f64),
            roughness in prop_oneof![Just(0.01), Just(0.2), Just(1.0)],
            ends in prop::collection::vec(prop::array::uniform6(-1.0..1.0), 20),
        ) {
            let net: [[DVec3; 4]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| {
                let place = DVec3::new(i as f64 / 1.5 - 1.0, j as f64 / 1.5 - 1.0, 0.0);
                place + roughness * DVec3::from_array(offsets[4 * i + j])
            }));
            let weighted: [[DVec4; 4]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| {
                let w: f64 = weights[4 * i + j];
                (w * net[i][j]).extend(w)
            }));
            let (plain, rational) = (Tiles::new(&net), Tiles::new(&weighted));
            for [a, b, c, d, e, f] in ends {
                let free = Ray::segment(DVec3::new(a, b, c), DVec3::new(d, e, f));
                agree(&plain, &free)?;
                agree(&rational, &free)?;
                let on = |s: f64, t: f64| sample(&net, 0.5 * (1.0 + s), 0.5 * (1.0 + t)).value;
                let own = Ray { range: [1e-6, 1.0 - 1e-6], ..Ray::segment(on(a, b), on(d, e)) };
                agree(&plain, &own)?;
            }
        }
    }
}
