//! Bicubic patches as quadtrees of tiles, to look for rays only where they pass.
//!
//! A ray descends from the whole patch to the quarters that it may meet, by their boxes ([`Sheared`]), until a box
//! shows that it meets the patch, or down to the smallest tiles. Seen along the ray, their control points form planar
//! nets, whose zeros are bracketed ([`zeros`]).

use super::net::{part, sample};
use super::sheared::{Passage, Sheared};
use crate::bernstein::Coefficient;
use crate::zeros::zeros;
use crate::{Hit, Ray, Rect};
use glam::{DVec2, DVec3, DVec4};

/// Quarterings of a patch. Chosen; not tuned.
const DEPTH: usize = 3;
/// Extent of the smallest tiles along either parameter.
const WIDTH: f64 = 2.0 / (1 << DEPTH) as f64;

/// A coefficient that stands for a control point.
pub(super) trait Control: Coefficient {
    /// The control point.
    fn point(self) -> DVec3;

    /// A multiple of its place across a ray from `origin`, by two unit vectors across the ray.
    fn seen(self, origin: DVec3, across: [DVec3; 2]) -> DVec2;
}

impl Control for DVec3 {
    fn point(self) -> DVec3 {
        self
    }

    fn seen(self, origin: DVec3, across: [DVec3; 2]) -> DVec2 {
        DVec2::from_array(across.map(|e| (self - origin).dot(e)))
    }
}

impl Control for DVec4 {
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
    /// Boxes of all levels of the quadtree, the whole patch first; each level by rows of equal u.
    boxes: Vec<Sheared>,
    /// Control nets of the smallest tiles, by rows of equal u.
    nets: Vec<[[T; 4]; 4]>,
}

/// A tile: its level in the quadtree and its place along u and v there.
#[derive(Clone, Copy)]
struct Place {
    level: usize,
    at: [usize; 2],
}

impl<T: Control> Tiles<T> {
    /// The tiles of the patch with the control net `net`, whose weights, if it has any, are positive.
    pub(super) fn new(net: &[[T; 4]; 4]) -> Self {
        let nets = |level: usize| Place::all(level).map(|place| part(net, &place.rect()));
        let around = |net: [[T; 4]; 4]| Sheared::around(&net.map(|row| row.map(T::point)));
        Self { boxes: (0..=DEPTH).flat_map(nets).map(around).collect(), nets: nets(DEPTH).collect() }
    }

    /// Whether a ray meets the patch.
    pub(super) fn any(&self, ray: &Ray) -> bool {
        self.any_in(Place::WHOLE, ray, across(ray))
    }

    /// The nearest hit.
    pub(super) fn nearest(&self, ray: &Ray) -> Option<Hit> {
        let mut best = None;
        self.nearest_in(Place::WHOLE, ray, across(ray), &mut best);
        best
    }

    fn any_in(&self, place: Place, ray: &Ray, across: [DVec3; 2]) -> bool {
        match self.boxes[place.index()].passage(ray) {
            Passage::Misses => false,
            Passage::Meets => true,
            Passage::Doubtful if place.level < DEPTH => {
                place.quarters().into_iter().any(|quarter| self.any_in(quarter, ray, across))
            }
            Passage::Doubtful => {
                let mut found = false;
                self.hits(place, ray, across, |_| {
                    found = true;
                    true
                });
                found
            }
        }
    }

    fn nearest_in(&self, place: Place, ray: &Ray, across: [DVec3; 2], best: &mut Option<Hit>) {
        let rest = best.map_or(*ray, |hit| ray.until(hit.t));
        if self.boxes[place.index()].passage(&rest) == Passage::Misses {
            return;
        }
        if place.level < DEPTH {
            return place.quarters().into_iter().for_each(|part| self.nearest_in(part, ray, across, best));
        }
        self.hits(place, ray, across, |hit| {
            *best = Hit::nearer(*best, hit);
            false
        });
    }

    /// Visits the hits with a smallest tile, until `visit` returns true.
    fn hits(&self, place: Place, ray: &Ray, across: [DVec3; 2], mut visit: impl FnMut(Hit) -> bool) {
        let net = &self.nets[place.row_major()];
        let mut seen = [[DVec2::ZERO; 4]; 4];
        for (seen, x) in seen.as_flattened_mut().iter_mut().zip(net.as_flattened()) {
            *seen = x.seen(ray.origin, across);
        }
        let [u, v] = place.corner();
        zeros(&seen, Hit::SEAM / WIDTH, |s, t| {
            let position = sample(net, s, t).value.point();
            let along = (position - ray.origin).dot(ray.direction) / ray.direction.length_squared();
            Hit::accept(ray, along, u + s * WIDTH, v + t * WIDTH).is_some_and(&mut visit)
        });
    }
}

/// Two unit vectors across a ray.
fn across(ray: &Ray) -> [DVec3; 2] {
    ray.direction.normalize().any_orthonormal_pair().into()
}

impl Place {
    const WHOLE: Place = Place { level: 0, at: [0; 2] };

    /// The tiles of a level, by rows of equal u.
    fn all(level: usize) -> impl Iterator<Item = Place> {
        let count = 1usize << level;
        (0..count * count).map(move |k| Place { level, at: [k / count, k % count] })
    }

    fn quarters(self) -> [Place; 4] {
        let [i, j] = self.at.map(|k| 2 * k);
        [[i, j], [i, j + 1], [i + 1, j], [i + 1, j + 1]].map(|at| Place { level: self.level + 1, at })
    }

    /// Among the tiles of its level.
    fn row_major(self) -> usize {
        (self.at[0] << self.level) + self.at[1]
    }

    /// Among the tiles of all levels: (4ˡ − 1)/3 come before those of level l.
    fn index(self) -> usize {
        ((1 << (2 * self.level)) - 1) / 3 + self.row_major()
    }

    /// Lowest u and v.
    fn corner(self) -> [f64; 2] {
        self.at.map(|k| k as f64 * self.width() - 1.0)
    }

    fn width(self) -> f64 {
        2.0 / (1 << self.level) as f64
    }

    fn rect(self) -> Rect {
        let [u, v] = self.corner().map(|low| [low, low + self.width()]);
        Rect { u, v }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The lowest t of all hits with all tiles, whatever their boxes say.
    fn brute<T: Control>(tiles: &Tiles<T>, ray: &Ray) -> Option<f64> {
        let mut best = None;
        for place in Place::all(DEPTH) {
            tiles.hits(place, ray, across(ray), |hit| {
                best = Hit::nearer(best, hit);
                false
            });
        }
        best.map(|hit| hit.t)
    }

    fn agree<T: Control>(tiles: &Tiles<T>, ray: &Ray) -> Result<(), TestCaseError> {
        let expected = brute(tiles, ray);
        prop_assert_eq!(tiles.any(ray), expected.is_some(), "{:?}", ray);
        prop_assert_eq!(tiles.nearest(ray).map(|hit| hit.t), expected, "{:?}", ray);
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// On sheets from nearly flat to tangled ones, plain and rational: segments between any points, and between
        /// points of the sheet, where boxes say least.
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
