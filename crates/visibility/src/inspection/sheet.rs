//! The sheets of a scene: its surfaces, those with two sides only once.

use radiosity_fit::sides::front_of;
use std::{collections::BTreeMap, sync::Arc};

use radiosity_geom::{Aabb, Border, Bvh, DVec3, LOOSE, Patch, Plane, Surface};
use radiosity_scene::{Scene, SceneSurface};

/// Borders nearer than this part of the smaller extent, but not touching, leave a gap. An arbitrary choice:
/// with a larger value warnings are given of gaps that were meant, with a smaller one leaks that were not are
/// passed over.
pub(super) const GAP: f64 = 1e-2;

/// A surface as a sheet in space.
#[derive(Debug)]
pub(super) struct Sheet {
    /// Index of the surface in the scene; of the front if there are two sides.
    pub(super) surface: usize,
    pub name: String,
    pub shape: Arc<dyn Surface>,
    pub two_sided: bool,
    pub(super) emits: bool,
    /// Whether its temperature or its flux of heat is known.
    pub(super) has_heat: bool,
    pub(super) bounds: Aabb,
    pub(super) extent: f64,
}

/// All sheets of a scene.
#[derive(Debug)]
pub(super) struct Sheets {
    pub(super) list: Vec<Sheet>,
    tree: Bvh,
}

impl Sheets {
    pub(super) fn of(scene: &Scene) -> Self {
        let backs = backs(&scene.surfaces);
        let mut is_back = vec![false; scene.surfaces.len()];
        backs.values().for_each(|back| is_back[*back] = true);
        let sheet =
            |k: usize| Sheet::new(k, &scene.surfaces[k], backs.get(&k).map(|back| &scene.surfaces[*back]));
        let list: Vec<Sheet> = (0..scene.surfaces.len()).filter(|k| !is_back[*k]).map(sheet).collect();
        let boxes: Vec<Aabb> = list.iter().map(|sheet| sheet.bounds.inflate(GAP * sheet.extent)).collect();
        Sheets { tree: Bvh::build(&boxes), list }
    }

    /// The other sheets that may touch sheet `index` or leave a gap to it, ascending.
    pub(super) fn near(&self, index: usize) -> Vec<usize> {
        let mut near: Vec<usize> = self.around(&self.list[index].bounds).collect();
        near.retain(|other| *other != index);
        near.sort_unstable();
        near
    }

    /// The sheets that may reach into `bounds`, in no particular order.
    pub(super) fn around(&self, bounds: &Aabb) -> impl Iterator<Item = usize> {
        self.tree.search(|other| other.overlaps(bounds))
    }
}

/// The backs of surfaces that have one, by the fronts' indices.
pub(super) fn backs(surfaces: &[SceneSurface]) -> BTreeMap<usize, usize> {
    let named: BTreeMap<&str, usize> =
        surfaces.iter().enumerate().map(|(k, s)| (s.name.as_str(), k)).collect();
    let front_of = |back: &SceneSurface| {
        let front = *named.get(front_of(&back.name)?)?;
        covers(&surfaces[front], back).then_some(front)
    };
    surfaces.iter().enumerate().filter_map(|(back, surface)| Some((front_of(surface)?, back))).collect()
}

/// Whether one surface covers the other; the fronts of two such surfaces are opposite, since a scene has no
/// others.
fn covers(front: &SceneSurface, back: &SceneSurface) -> bool {
    let [front, back] = [front, back].map(|surface| Sheet::new(0, surface, None));
    let room = LOOSE * front.extent;
    let lies_on = |point: DVec3| front.drop(point).is_some_and(|foot| foot.distance(point) <= room);
    let [own, other] = [&front, &back].map(|sheet| sheet.shape.area());
    (own - other).abs() <= LOOSE * own && back.samples().iter().all(|sample| lies_on(sample.point))
}

impl Sheet {
    fn new(index: usize, surface: &SceneSurface, back: Option<&SceneSurface>) -> Self {
        let shape = Arc::clone(&surface.shape);
        let bounds = Patch::whole(&*shape).bounds();
        let emits = surface.material.emits() || back.is_some_and(|back| back.material.emits());
        Sheet {
            surface: index,
            name: surface.name.clone(),
            shape,
            two_sided: back.is_some(),
            emits,
            has_heat: surface.thermal.condition.is_some(),
            bounds,
            extent: bounds.diagonal(),
        }
    }

    /// This sheet in another frame of its scene.
    pub(super) fn as_in(&self, still: &Scene) -> Self {
        let front = &still.surfaces[self.surface];
        let own = Self::new(self.surface, front, None);
        Self { two_sided: self.two_sided, emits: self.emits, ..own }
    }

    pub(super) fn patch(&self) -> Patch<'_> {
        Patch::whole(&*self.shape)
    }

    /// The borders that are longer than a point; the front is on their left where the sign is 1.
    pub(super) fn borders(&self) -> Vec<(Border<'_>, f64)> {
        // Turning a surface over keeps its tangents, but reverses the vertices of a region.
        let middle = self.shape.jet(0.0, 0.0);
        let against = self.shape.region().is_none() && middle.du.cross(middle.dv).dot(middle.normal) < 0.0;
        let long = |border: &Border<'_>| {
            let points = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|w| border.point(w));
            points.iter().any(|point| point.distance(points[0]) > LOOSE * self.extent)
        };
        let sign = if against { -1.0 } else { 1.0 };
        self.patch().borders().into_iter().filter(long).map(|border| (border, sign)).collect()
    }

    /// The front's normal at a place of one of its borders.
    pub(super) fn normal_at(&self, border: &Border<'_>, w: f64) -> DVec3 {
        match border {
            Border::Segment(..) => self.shape.jet(0.0, 0.0).normal,
            Border::Side(..) => {
                let [u, v] = border.parameters(w);
                self.shape.jet(u, v).normal
            }
        }
    }

    /// The foot of `point` on the sheet; None if it lies outside a planar one.
    pub(super) fn drop(&self, point: DVec3) -> Option<DVec3> {
        match self.shape.region() {
            Some(region) => {
                let foot = point - (point - region.origin()).dot(region.normal()) * region.normal();
                region.contains(foot).then_some(foot)
            }
            None => {
                let foot = self.shape.project(point);
                Some(self.shape.jet(foot.u, foot.v).position)
            }
        }
    }

    /// Tangent planes of the front at points all over the sheet, some close to its corners, none in its middle,
    /// where others may begin. Arbitrary otherwise.
    pub(super) fn samples(&self) -> Vec<Plane> {
        const STEPS: [f64; 5] = [-0.97, -0.5, 0.03, 0.5, 0.97];
        match self.shape.region() {
            Some(region) => {
                let inward = |piece: &Vec<DVec3>| {
                    let middle = piece.iter().sum::<DVec3>() / piece.len() as f64;
                    let corners = piece.iter().map(move |corner| middle.lerp(*corner, 0.97));
                    std::iter::once(middle).chain(corners).collect::<Vec<_>>()
                };
                let points = region.convex_pieces().iter().flat_map(inward).collect::<Vec<_>>();
                points.into_iter().map(|point| Plane { point, normal: region.normal() }).collect()
            }
            None => {
                let places = STEPS.into_iter().flat_map(|u| STEPS.map(|v| [u, v]));
                let jets = places.map(|[u, v]| self.shape.jet(u, v));
                jets.map(|jet| Plane { point: jet.position, normal: jet.normal }).collect()
            }
        }
    }
}
