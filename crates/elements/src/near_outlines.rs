//! Near outlines: lines along which a flat surface is cut where another one lies parallel before a part of it, as a
//! wall behind a cabinet or a panel behind a sheet of insulation.
//!
//! At the outline of what lies before it over a gap, radiosity steps within about the width of the gap, from that of
//! the gap to that of the room. Polynomials over both miss it by as much. So the surface is cut along the lines of
//! constant u or v on which the sides of the outline lie. Outlines with other sides make shaded parts
//! (`shaded_parts`).

use radiosity_geom::{LOOSE, PARALLEL_PLANES, PlanarRegion, polygon_area};
use radiosity_scene::{Scene, SceneSurface};

use super::dividers::{Foot, Lines, foot};
use super::nearness::{MOST_ELEMENTS, length};

/// Width of a gap over the square roots of the areas at both sides up to which they are near. Chosen: over a wider one
/// radiosity steps within a length that polynomials follow.
const NEAR: f64 = 0.1;

/// Width over the gap of what lies between a line and a side of the surface, at least. Chosen: radiosity hardly steps
/// before a narrower strip, and layers at the side resolve it.
const STRIP: f64 = 2.0;

/// Part of the area of a surface that another one covers at least. Chosen, as for shaded parts.
const LEAST: f64 = 1e-3;

/// The near outlines of all surfaces of a scene.
#[derive(Debug, Default)]
pub(super) struct NearOutlines {
    /// Outlines on each surface.
    surfaces: Vec<Outlines>,
}

/// The near outlines on a surface.
#[derive(Clone, Debug, Default)]
struct Outlines {
    /// Surfaces whose outlines they are.
    faces: Vec<usize>,
    lines: Lines,
}

/// A face before a part of a surface.
#[derive(Debug)]
struct NearFace {
    surface: usize,
    face: usize,
    /// Width of the gap over the size of the smaller surface.
    slenderness: f64,
    lines: Lines,
}

impl NearOutlines {
    /// The outlines over the narrowest gaps, as long as no more than [`MOST_ELEMENTS`] follow in all.
    pub(super) fn of(scene: &Scene) -> Self {
        let count = scene.surfaces.len();
        if count >= MOST_ELEMENTS {
            return Self::default();
        }
        let pairs = (0..count).flat_map(|surface| (0..count).map(move |face| [surface, face]));
        let mut near: Vec<NearFace> = pairs.filter_map(|pair| near_face(scene, pair)).collect();
        near.sort_by(|a, b| a.slenderness.total_cmp(&b.slenderness));
        let mut surfaces = vec![Outlines::default(); count];
        let mut elements = count;
        for NearFace { surface, face, lines, .. } in near {
            let own = &surfaces[surface];
            let merged = [0, 1].map(|across| merged(&own.lines[across], &lines[across]));
            let more = cells(&merged) - cells(&own.lines);
            if elements + more <= MOST_ELEMENTS {
                elements += more;
                let own = &mut surfaces[surface];
                own.faces.push(face);
                own.lines = merged;
            }
        }
        Self { surfaces }
    }

    /// Where the surface of this index is cut.
    pub(super) fn lines(&self, surface: usize) -> Lines {
        self.surfaces.get(surface).map_or_else(Lines::default, |own| own.lines.clone())
    }

    /// Whether the surface of this index is cut along the outline of this face.
    pub(super) fn follow(&self, surface: usize, face: usize) -> bool {
        self.surfaces.get(surface).is_some_and(|own| own.faces.contains(&face))
    }
}

/// All lines, ascending, each once.
pub(super) fn merged(one: &[f64], other: &[f64]) -> Vec<f64> {
    let mut all: Vec<f64> = one.iter().chain(other).copied().collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|next, before| *next - *before <= LOOSE);
    all
}

/// Elements between these lines.
fn cells([u, v]: &Lines) -> usize {
    (u.len() + 1) * (v.len() + 1)
}

/// The face before a part of a surface, where it is near and its outline follows the parameters.
fn near_face(scene: &Scene, [surface, face]: [usize; 2]) -> Option<NearFace> {
    let SceneSurface { shape, material, subdivide, .. } = &scene.surfaces[surface];
    let is_free = surface != face && subdivide.is_none() && material.emission_pattern.is_none();
    let region = shape.region().filter(|_| is_free)?;
    let other = scene.surfaces[face].shape.region()?;
    let gap = gap(region, other)?;
    let common: f64 = region.common_parts(other).map(|piece| polygon_area(&piece)).sum();
    if common < LEAST * region.area() {
        return None;
    }
    let ring = other.outer();
    let sides = ring.iter().zip(ring.iter().cycle().skip(1));
    let feet = sides.map(|(a, b)| foot(&**shape, [*a, *b])).collect::<Option<Vec<Foot>>>()?;
    let lines = [0, 1].map(|across| {
        let width = length(&**shape, across, 0.0);
        let own = feet.iter().filter(|foot| foot.across == across && foot.span[1] - foot.span[0] > LOOSE);
        let is_apart = |at: &f64| 0.5 * (1.0 - at.abs()) * width >= STRIP * gap;
        merged(&own.map(|foot| foot.at).filter(is_apart).collect::<Vec<f64>>(), &[])
    });
    let slenderness = gap / size(region).min(size(other));
    (cells(&lines) > 1).then_some(NearFace { surface, face, slenderness, lines })
}

/// Width of the gap between the front of a flat surface and a parallel one; None where that is not near.
fn gap(region: &PlanarRegion, other: &PlanarRegion) -> Option<f64> {
    let is_parallel = region.normal().cross(other.normal()).length() < PARALLEL_PLANES;
    let height = region.height(other.outer()[0]);
    let most = NEAR * size(region).min(size(other));
    (is_parallel && (LOOSE * region.extent()..=most).contains(&height)).then_some(height)
}

/// The square root of the area of a flat surface (length).
fn size(region: &PlanarRegion) -> f64 {
    region.area().sqrt()
}

#[cfg(test)]
mod tests {
    use radiosity_scene::Source;

    use super::*;

    /// The outlines on a wall of 4 × 2 of these surfaces.
    fn outlines(others: &str) -> NearOutlines {
        let wall = r#"
            { name = "wall", material = "grey",
              parallelogram = { origin = [0, 0, 0], edge1 = [4, 0, 0], edge2 = [0, 2, 0] } },"#;
        let text = format!(
            "bands = [\"grey\"]\nmaterials = {{ grey = {{ reflectance = 0.5 }} }}\nsurfaces = [{wall}{others}]\n"
        );
        NearOutlines::of(&radiosity_language::read(&Source::new("wall.toml", &text)).expect("it is a scene"))
    }

    /// A sheet of 1 × 1 from x on, this high over the wall, its edges turned by an angle.
    fn sheet(x: f64, height: f64, angle: f64) -> String {
        let (sin, cos) = angle.sin_cos();
        format!(
            r#" {{ name = "sheet{x}-{height}", material = "grey", parallelogram = {{
                 origin = [{x}, 0.5, {height}], edge1 = [{cos}, {sin}, 0], edge2 = [{}, {cos}, 0] }} }},"#,
            -sin
        )
    }

    #[test]
    fn a_wall_is_cut_along_the_outline_of_what_is_near() {
        let found = outlines(&sheet(1.0, 0.02, 0.0));
        let [u, v] = found.lines(0);
        let is = |found: &[f64], expected: &[f64]| {
            found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12)
        };
        assert!(is(&u, &[-0.5, 0.0]) && is(&v, &[-0.5, 0.5]), "{u:?} {v:?}");
        assert!(found.follow(0, 1) && !found.follow(1, 0));
        // One that reaches over a side.
        let [u, v] = outlines(&sheet(3.5, 0.02, 0.0)).lines(0);
        assert!(is(&u, &[0.75]) && is(&v, &[-0.5, 0.5]), "{u:?} {v:?}");
    }

    #[test]
    fn what_is_far_or_behind_or_turned_cuts_nothing() {
        for (x, height, angle) in
            [(1.0, 0.2, 0.0), (1.0, -0.02, 0.0), (1.0, 0.0, 0.0), (1.5, 0.02, 0.3), (5.0, 0.02, 0.0)]
        {
            let found = outlines(&sheet(x, height, angle));
            assert!(found.lines(0) == Lines::default() && !found.follow(0, 1), "{x} {height} {angle}");
        }
    }

    #[test]
    fn many_faces_make_no_more_elements_than_are_wanted() {
        let sheets: String =
            (0..20).map(|k| sheet(0.15 * f64::from(k), 0.01 + 1e-4 * f64::from(k), 0.0)).collect();
        let found = outlines(&sheets);
        let count = 21 - 1 + cells(&found.lines(0));
        assert!((50..=MOST_ELEMENTS).contains(&count), "{count}");
        assert!(found.follow(0, 1) && !found.follow(0, 20));
    }
}
