//! A face: a whole surface, or a cell of its parameters, as a node of the tree holds it.

use std::sync::Arc;

use radiosity_elements::flat_patches;
use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_elements::sampling::area_preserving_map::AreaPreservingMap;
use radiosity_geom::{Aabb, DVec3, Rect, Surface};
use radiosity_light::tolerances::LONG_CELL;

use super::harmonics::{HARMONICS, add, clamped_cosine};

/// Points per direction of the rule for the moments of curved faces, which are smooth, and for their area, to
/// a few digits.
const MOMENT_POINTS: usize = 6;

/// A piece of one surface.
#[derive(Debug)]
pub(crate) struct Face {
    /// Index of the surface in the scene.
    pub surface: usize,
    /// The parameters it covers, as far as the surface exists there.
    pub rect: Rect,
    /// Disjoint patches that cover it.
    pub patches: Vec<Patch>,
    /// Unit normal of its plane, where it is flat.
    pub normal: Option<DVec3>,
    /// Points whose convex hull contains it.
    pub hull: Vec<DVec3>,
    /// ∫ A_l Y_lm(n) dA (scene length²).
    pub moments: [f64; HARMONICS],
    /// Points on it at random.
    pub area_map: AreaPreservingMap,
}

impl Face {
    /// The whole of surface number `surface`; None if it has no area.
    pub(crate) fn whole(surface: usize, shape: &Arc<dyn Surface>) -> Option<Self> {
        let pieces = shape.region().map_or_else(Vec::new, |region| region.convex_pieces().to_vec());
        Self::over(surface, shape, &pieces, Rect::FULL, shape.area())
    }

    /// The part over `rect`, where its convex `pieces` reach if it is flat; `area` (scene length²) is that of
    /// the surface.
    fn over(
        surface: usize,
        shape: &Arc<dyn Surface>,
        pieces: &[Vec<DVec3>],
        rect: Rect,
        area: f64,
    ) -> Option<Self> {
        let (patches, normal) = match shape.region() {
            Some(_) => {
                let (patches, plane) = flat_patches(shape, pieces, area, &rect);
                (patches, Some(plane.normal))
            }
            None => (vec![Patch::curved(Arc::clone(shape), &rect)], None),
        };
        if patches.is_empty() {
            return None;
        }
        let hull = patches.iter().flat_map(Patch::hull).collect();
        let area_map = AreaPreservingMap::of(&patches);
        Some(Self { surface, rect, patches, normal, hull, moments: [0.0; HARMONICS], area_map })
    }

    /// The cells that it is cut into, those without area left out.
    pub(crate) fn cells(&self, shape: &Arc<dyn Surface>) -> Vec<Self> {
        let pieces: Vec<Vec<DVec3>> = match self.normal {
            Some(_) => self.patches.iter().map(Patch::polygon).collect(),
            None => Vec::new(),
        };
        let rects = self.parts(shape.as_ref());
        let area = shape.area();
        rects.into_iter().filter_map(|rect| Self::over(self.surface, shape, &pieces, rect, area)).collect()
    }

    /// Quarters of the parameters, or halves of a long cell.
    fn parts(&self, shape: &dyn Surface) -> Vec<Rect> {
        let [u, v] = self.rect.center();
        let jet = shape.jet(u, v);
        let [along, across] = self.rect.half_extent();
        let (along, across) = (along * jet.du.length(), across * jet.dv.length());
        if along > LONG_CELL * across {
            self.rect.split_u().to_vec()
        } else if across > LONG_CELL * along {
            self.rect.split_v().to_vec()
        } else {
            self.rect.quarters().to_vec()
        }
    }

    /// Sets the moments, for its `area` (scene length²); those of the constant function are then right to
    /// rounding.
    pub(crate) fn measure(&mut self, area: f64) {
        let mut moments = [0.0; HARMONICS];
        if let Some(normal) = self.normal {
            add(&mut moments, area, &clamped_cosine(normal));
        } else {
            let nodes = self.nodes(MOMENT_POINTS);
            let total: f64 = nodes.iter().map(|node| node.area).sum();
            let mut weigh =
                |node: &Node| add(&mut moments, area * node.area / total, &clamped_cosine(node.normal));
            nodes.iter().for_each(&mut weigh);
        }
        self.moments = moments;
    }

    /// The Gauss points of its patches, `count` along each direction, each with the area that it stands for.
    pub(crate) fn nodes(&self, count: usize) -> Vec<Node> {
        let rule = UnitRule::of(count);
        let mut nodes = Vec::with_capacity(self.patches.len() * count * count);
        for patch in &self.patches {
            for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
                let node = patch.node(s, t);
                nodes.push(Node { area: ws * wt * node.area, ..node });
            }
        }
        nodes
    }

    /// Area of its patches (scene length²), to a few digits where it is curved.
    pub(crate) fn patch_area(&self) -> f64 {
        self.nodes(MOMENT_POINTS).iter().map(|node| node.area).sum()
    }

    /// Centre and radius of a ball around it.
    pub(crate) fn ball(&self) -> (DVec3, f64) {
        let center = Aabb::around(self.hull.iter().copied()).center();
        let farthest = self.hull.iter().map(|x| x.distance_squared(center)).fold(0.0, f64::max);
        (center, farthest.sqrt())
    }
}
