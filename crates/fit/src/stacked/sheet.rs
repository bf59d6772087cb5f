//! A flat sheet that may lie on others, and which of two does.

use std::cmp::Ordering;
use std::sync::Arc;

use radiosity_geom::{DVec3, PlanarRegion, Surface, layer_order};

/// A flat sheet that may lie on others.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The surface as it stands in the scene.
    pub shape: Arc<dyn Surface>,
    /// The surface as it was read.
    pub typed: Arc<dyn Surface>,
    /// Whether its back emits and receives too.
    pub two_sided: bool,
    /// Whether its front is that of the shape turned over.
    pub flip: bool,
    /// Whether it stays where it is: then the other sheet of a pair moves.
    pub stays: bool,
    /// Its name: a sheet and one called `name:back` are two sides of one surface.
    pub name: String,
}

impl Sheet {
    /// The normal of its front.
    pub(super) fn normal(&self) -> DVec3 {
        let normal = self.region().map_or(DVec3::ZERO, PlanarRegion::normal);
        if self.flip { -normal } else { normal }
    }

    pub(super) fn region(&self) -> Option<&PlanarRegion> {
        self.shape.region()
    }

    pub(super) fn area(&self) -> f64 {
        self.region().map_or(0.0, PlanarRegion::area)
    }

    /// Largest distance of two of its corners (scene length); 0 if it is curved.
    pub fn extent(&self) -> f64 {
        self.region().map_or(0.0, PlanarRegion::extent)
    }

    /// Typed middle and normal: of equal sheets that coincide the one with the later lies on the other.
    fn rank(&self) -> [f64; 6] {
        let corners = self.typed.corners();
        let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
        let [a, b] = [middle, self.normal()].map(|x| x.to_array());
        [a[0], a[1], a[2], b[0], b[1], b[2]]
    }

    /// The order of two sheets that coincide, lower ones first.
    pub(super) fn order(&self, other: &Sheet) -> Ordering {
        let pairs = self.rank().into_iter().zip(other.rank());
        pairs.fold(layer_order(self.area(), other.area()), |order, (a, b)| order.then(a.total_cmp(&b)))
    }

    /// Mean height of its typed corners over another sheet (scene length).
    pub(super) fn typed_height(&self, other: &Sheet) -> f64 {
        let corners = self.typed.corners();
        let Some(region) = other.typed.region() else { return 0.0 };
        let sign = if other.flip { -1.0 } else { 1.0 };
        sign * corners.iter().map(|x| region.height(*x)).sum::<f64>() / corners.len() as f64
    }
}
