//! Shaded parts: parts of flat surfaces in narrow gaps under other flat surfaces, as of a ceiling behind a lamp or of a
//! wall behind a poster.
//!
//! About (h/d)² of the light outside comes into a gap of the height h under a surface of the diagonal d. Polynomials
//! over both tell for what others see of the surface too little, by the part that is hidden: lamps that hang 2 cm below
//! a tenth of a ceiling make it darker by a tenth. So each such part is an element of its own, with a constant: light
//! in a gap counts little outside of it.
//!
//! Surfaces that emit stay whole: their light does not differ by what hides them. So do those that let light through,
//! which depends on both of their sides, and those that state their cells.

use std::sync::Arc;

use radiosity_geom::{
    Aabb, Bvh, COINCIDENT, DVec3, PARALLEL_PLANES, PlanarRegion, Rect, Surface, polygon_area, polygon_width,
};
use radiosity_scene::Scene;
use radiosity_visibility::covered_parts::{CoveredParts, without};
use radiosity_visibility::tolerances::{NARROW_GAP, NARROW_GAP_IN_SCENE, NARROW_PIECE};

use super::near_outlines::NearOutlines;

/// Part of the area of a surface that gaps hide at least. Chosen: less makes what is seen darker by less than readings
/// tell.
const LEAST: f64 = 1e-3;

/// Part of the area of a surface that gaps hide at most. Chosen: what is nearly all hidden has no other light
/// beside it.
const MOST: f64 = 0.95;

/// A part of a flat surface that lies in a narrow gap.
#[derive(Debug)]
pub(super) struct ShadedPart {
    /// The part, as disjoint convex pieces, counter-clockwise seen from the surface's front.
    pub pieces: Vec<Vec<DVec3>>,
    /// Index of the surface over the gap.
    pub over: usize,
}

/// The shaded parts of all surfaces of a scene, in the order of what shades them.
#[derive(Debug, Default)]
pub(super) struct ShadedParts(Vec<Vec<ShadedPart>>);

impl ShadedParts {
    /// Finds those of surfaces with these `shapes`, footprints left out, outside of what is covered and under what they
    /// are not cut along the outline of.
    pub(super) fn of(
        scene: &Scene,
        shapes: &[Arc<dyn Surface>],
        covered_parts: &CoveredParts,
        near_outlines: &NearOutlines,
    ) -> Self {
        let gaps = Gaps::of(scene, near_outlines);
        let of_surface =
            |(surface, shape): (usize, &Arc<dyn Surface>)| gaps.parts(surface, &**shape, covered_parts);
        Self(shapes.iter().enumerate().map(of_surface).collect())
    }

    /// Parts of one surface.
    pub(super) fn of_surface(&self, surface: usize) -> &[ShadedPart] {
        self.0.get(surface).map_or(&[], Vec::as_slice)
    }
}

/// The flat surfaces of a scene, as ends of gaps.
struct Gaps<'a> {
    scene: &'a Scene,
    near_outlines: &'a NearOutlines,
    /// Greatest height of a gap (scene length).
    highest: f64,
    /// Index of each.
    flat: Vec<usize>,
    tree: Bvh,
}

impl<'a> Gaps<'a> {
    fn of(scene: &'a Scene, near_outlines: &'a NearOutlines) -> Self {
        let boxes: Vec<Aabb> =
            scene.surfaces.iter().map(|surface| surface.shape.bounds(&Rect::FULL)).collect();
        let all = boxes.iter().fold(Aabb::EMPTY, |all, own| all.union(*own));
        let is_flat = |index: &usize| scene.surfaces[*index].shape.region().is_some();
        let flat: Vec<usize> = (0..scene.surfaces.len()).filter(is_flat).collect();
        let tree = Bvh::build(&flat.iter().map(|index| boxes[*index]).collect::<Vec<_>>());
        Self { scene, near_outlines, highest: NARROW_GAP_IN_SCENE * all.diagonal(), flat, tree }
    }

    /// The shaded parts of a surface of this shape; none where it is hidden nearly all or nearly nowhere.
    fn parts(&self, surface: usize, shape: &dyn Surface, covered_parts: &CoveredParts) -> Vec<ShadedPart> {
        let own = &self.scene.surfaces[surface];
        let stays = own.material.emits() || own.material.transmits() || own.subdivide.is_some();
        let Some(region) = shape.region().filter(|_| !stays) else { return Vec::new() };
        let mut holes: Vec<Vec<DVec3>> =
            covered_parts.of_surface(surface).flat_map(|part| part.pieces.clone()).collect();
        let mut parts = Vec::new();
        for over in self.over(surface, region) {
            let Some(upper) = self.scene.surfaces[over].shape.region() else { continue };
            let pieces = without(region.common_parts(upper).collect(), &holes, region.normal());
            let is_broad = |piece: &Vec<DVec3>| polygon_width(piece) > NARROW_PIECE * region.extent();
            let pieces: Vec<Vec<DVec3>> = pieces.into_iter().filter(is_broad).collect();
            if !pieces.is_empty() {
                holes.extend(pieces.iter().cloned());
                parts.push(ShadedPart { pieces, over });
            }
        }
        parts.sort_by_key(|part| part.over);
        let hidden: f64 = parts.iter().flat_map(|part| &part.pieces).map(|piece| polygon_area(piece)).sum();
        if (LEAST..=MOST).contains(&(hidden / region.area())) { parts } else { Vec::new() }
    }

    /// The flat surfaces over a narrow gap before the front of one, the nearest first.
    fn over(&self, surface: usize, region: &PlanarRegion) -> Vec<usize> {
        let bounds = Aabb::around(region.outer().iter().copied()).inflate(self.highest);
        let near = self.tree.near(&bounds).into_iter().map(|place| self.flat[place]);
        let others = near.filter(|other| *other != surface && !self.near_outlines.follow(surface, *other));
        let height = |other: usize| self.height(region, self.scene.surfaces[other].shape.region()?);
        let mut over: Vec<(f64, usize)> = others.filter_map(|other| Some((height(other)?, other))).collect();
        over.sort_by(|a, b| a.0.total_cmp(&b.0));
        over.into_iter().map(|(_, other)| other).collect()
    }

    /// Height of the narrow gap between the front of a flat surface and another one; None where there is none.
    fn height(&self, region: &PlanarRegion, other: &PlanarRegion) -> Option<f64> {
        let is_parallel = region.normal().cross(other.normal()).length() < PARALLEL_PLANES;
        let height = region.height(other.outer()[0]);
        let narrow = (NARROW_GAP * region.extent().min(other.extent())).min(self.highest);
        (is_parallel && (COINCIDENT * region.extent()..=narrow).contains(&height)).then_some(height)
    }
}

#[cfg(test)]
mod tests {
    use radiosity_scene::Source;

    use super::*;

    /// Areas of the shaded parts of a wall of 4 × 2, with this emission, behind other surfaces.
    fn areas(emission: f64, others: &str) -> Vec<f64> {
        areas_of(&text(emission, others))
    }

    fn text(emission: f64, others: &str) -> String {
        format!(
            r#"
            bands = ["grey"]
            materials = {{ wall = {{ reflectance = 0.5, emission = {emission} }}, grey = {{ reflectance = 0.5 }} }}
            surfaces = [
                {{ name = "wall", material = "wall",
                   parallelogram = {{ origin = [0, 0, 0], edge1 = [4, 0, 0], edge2 = [0, 2, 0] }} }},
                {others}
            ]
            "#
        )
    }

    fn areas_of(text: &str) -> Vec<f64> {
        let scene = radiosity_language::read(&Source::new("wall.toml", text)).expect("it is a scene");
        let shapes: Vec<Arc<dyn Surface>> =
            scene.surfaces.iter().map(|surface| Arc::clone(&surface.shape)).collect();
        let parts = ShadedParts::of(&scene, &shapes, &CoveredParts::new(&scene), &NearOutlines::default());
        let area = |part: &ShadedPart| part.pieces.iter().map(|piece| polygon_area(piece)).sum();
        parts.of_surface(0).iter().map(area).collect()
    }

    /// A poster of 1 × 1 from x on, so high over the wall.
    fn poster(x: f64, height: f64) -> String {
        format!(
            r#" {{ name = "poster{x}-{height}", material = "grey", parallelogram = {{
                 origin = [{x}, 0.5, {height}], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }} }},"#
        )
    }

    #[test]
    fn a_wall_is_parted_behind_what_is_close() {
        for (others, expected) in [
            (poster(1.0, 0.02), vec![1.0]),
            // One that reaches over the border, two, and one behind another.
            (poster(3.5, 0.02), vec![0.5]),
            (poster(0.5, 0.02) + &poster(2.0, 0.01), vec![1.0, 1.0]),
            (poster(1.0, 0.01) + &poster(1.5, 0.02), vec![1.0, 0.5]),
        ] {
            let found = areas(0.0, &others);
            assert_eq!(found.len(), expected.len(), "{others}");
            found
                .iter()
                .zip(expected)
                .for_each(|(area, own)| assert!((area - own).abs() < 1e-9, "{found:?}"));
        }
    }

    /// A rug of 1 × 1, whose foot is no part of the floor, hides nothing but that.
    #[test]
    fn footprints_are_no_parts() {
        let rug = r#" { name = "rug", material = "grey",
            box = { origin = [1, 0.5, 0], size = [1, 1, 0.01], open = ["bottom"] } },"#;
        let holed = |text: &str| {
            text.replace("edge2 = [0, 2, 0] }", &format!("edge2 = [0, 2, 0], holes = {HOLE} }}"))
        };
        const HOLE: &str = "[[[1, 0.5, 0], [2, 0.5, 0], [2, 1.5, 0], [1, 1.5, 0]]]";
        assert!(areas_of(&holed(&text(0.0, rug))).is_empty());
    }

    #[test]
    fn walls_that_emit_and_what_is_far_behind_or_on_them_part_nothing() {
        assert!(areas(1.0, &poster(1.0, 0.02)).is_empty());
        for height in [0.2, -0.02, 0.0] {
            assert!(areas(0.0, &poster(1.0, height)).is_empty(), "{height}");
        }
    }
}
