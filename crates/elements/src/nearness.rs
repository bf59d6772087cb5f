//! Near faces: surfaces that others face from near by, and the layers of elements that resolve their sides.
//!
//! Between two faces at a distance g what comes in at their sides falls off within a few g. Polynomials over a length
//! s ≫ g of a face miss that. With the cells of sides a part q as wide as those beside them,
//!
//! ```text
//! L = ⌈ln(s/(W g)) / ln(1/q)⌉ ,     W = 2 ,
//! ```
//!
//! layers make the outermost ones about g wide. Each direction of a surface has its own length; where it closes,
//! or ends in a point, there is no side. g is the median over places of the surface, so that what stands on a part
//! of it does not count: that part is a divider's, one between near outlines or a shaded one (`dividers`,
//! `near_outlines`, `shaded_parts`).

use radiosity_geom::{Aabb, Bvh, COINCIDENT, DVec3, Rect, Surface};
use radiosity_scene::Scene;

use super::cells::Layers;

/// W: length of a direction over the distance of what is near up to which it needs no layers.
const WIDE: f64 = 2.0;

/// Most elements of all surfaces that layers make; layers are fewer everywhere where there would be more. Chosen: pairs
/// of so many take some tenths of a second, and beyond a gap of a thousandth sides count little.
pub(super) const MOST_ELEMENTS: usize = 200;

/// Parameters of the places at which distances are taken, along u and v. Chosen: a median of nine.
const PLACES: [f64; 3] = [-0.6, 0.0, 0.6];

/// Chords that measure the length of a direction. Chosen: those of a full circle are a tenth too short.
const CHORDS: usize = 4;

/// Numbers of layers of a surface along u and v, each at the lower and the upper side.
type Counts = [[usize; 2]; 2];

/// Layers of all surfaces of a scene for the sake of near faces.
#[derive(Debug)]
pub(super) struct Nearness {
    counts: Vec<Counts>,
    /// Most at a side.
    most: usize,
}

impl Nearness {
    pub(super) fn of(scene: &Scene) -> Self {
        if scene.surfaces.len() >= MOST_ELEMENTS {
            return Self { counts: vec![Counts::default(); scene.surfaces.len()], most: 0 };
        }
        let faces = Faces::of(scene);
        let counts: Vec<Counts> = (0..scene.surfaces.len()).map(|surface| faces.counts(surface)).collect();
        let elements = |most: usize| -> usize { counts.iter().map(|own| elements(own, most)).sum() };
        let longest = counts.iter().flatten().flatten().copied().max().unwrap_or(0);
        let most = (1..=longest).rev().find(|most| elements(*most) <= MOST_ELEMENTS).unwrap_or(0);
        Self { counts, most }
    }

    /// Layers of the surface of this index along u and v, at the lower and the upper side.
    pub(super) fn layers(&self, surface: usize) -> [[Layers; 2]; 2] {
        let of = |count: usize| Layers { count: count.min(self.most), ..Layers::NONE };
        self.counts[surface].map(|sides| sides.map(of))
    }
}

/// Elements of a surface with these layers, so many `most` at a side.
fn elements(counts: &Counts, most: usize) -> usize {
    counts.iter().map(|[low, high]| 1 + (*low).min(most) + (*high).min(most)).product()
}

/// The surfaces of a scene, as faces of each other.
struct Faces<'a> {
    scene: &'a Scene,
    tree: Bvh,
}

impl<'a> Faces<'a> {
    fn of(scene: &'a Scene) -> Self {
        let boxes: Vec<Aabb> =
            scene.surfaces.iter().map(|surface| surface.shape.bounds(&Rect::FULL)).collect();
        Self { scene, tree: Bvh::build(&boxes) }
    }

    /// Numbers of layers of the surface of this index.
    fn counts(&self, surface: usize) -> Counts {
        let shape = &*self.scene.surfaces[surface].shape;
        let lengths = [0, 1].map(|along| length(shape, along, 0.0));
        let longest = lengths.into_iter().fold(0.0, f64::max);
        let Some(distance) = self.distance(surface, longest / WIDE) else { return Counts::default() };
        [0, 1].map(|along| {
            let wanted = layer_count(lengths[along] / distance);
            let closes = closes(shape, along);
            let is_side = |end: f64| !closes && length(shape, 1 - along, end) > COINCIDENT * longest;
            [-1.0, 1.0].map(|end| if is_side(end) { wanted } else { 0 })
        })
    }

    /// Median distance of the nearest faces before the front of a surface; None where most are farther than `most`.
    fn distance(&self, surface: usize, most: f64) -> Option<f64> {
        let shape = &*self.scene.surfaces[surface].shape;
        let near: Vec<usize> = self.tree.near(&shape.bounds(&Rect::FULL).inflate(most)).into_iter().collect();
        let others: Vec<&dyn Surface> = near
            .into_iter()
            .filter(|other| *other != surface)
            .map(|other| &*self.scene.surfaces[other].shape)
            .collect();
        let places = PLACES.iter().flat_map(|u| PLACES.iter().map(move |v| [*u, *v]));
        let nearest = |[u, v]: [f64; 2]| {
            let own = shape.jet(u, v);
            let of = |other: &&dyn Surface| faced(own.position, own.normal, *other);
            others.iter().filter_map(of).fold(f64::INFINITY, f64::min)
        };
        let mut distances: Vec<f64> = places.map(nearest).collect();
        distances.sort_by(f64::total_cmp);
        let median = distances[distances.len() / 2];
        (median <= most && median > COINCIDENT * most).then_some(median)
    }
}

/// Distance of the nearest point of another surface whose front faces a place.
fn faced(place: DVec3, normal: DVec3, other: &dyn Surface) -> Option<f64> {
    let foot = other.project(place);
    let there = other.jet(foot.u, foot.v);
    let way = there.position - place;
    (way.dot(normal) > 0.0 && way.dot(there.normal) < 0.0).then_some(foot.distance)
}

/// The place of a surface at `at` along u or v, with the other parameter.
fn place(shape: &dyn Surface, along: usize, at: f64, other: f64) -> DVec3 {
    if along == 0 { shape.jet(at, other).position } else { shape.jet(other, at).position }
}

/// Length of a surface along u or v where the other parameter is `other`, by chords.
pub(super) fn length(shape: &dyn Surface, along: usize, other: f64) -> f64 {
    let at = |step: usize| place(shape, along, -1.0 + 2.0 * step as f64 / CHORDS as f64, other);
    (0..CHORDS).map(|step| at(step).distance(at(step + 1))).sum()
}

/// Whether a surface ends along u or v where it begins.
fn closes(shape: &dyn Surface, along: usize) -> bool {
    let ends = [-1.0, 1.0].map(|end| place(shape, along, end, 0.0));
    ends[0].distance(ends[1]) <= COINCIDENT * length(shape, along, 0.0)
}

/// Layers at each side of a length, given over the distance of what is near.
fn layer_count(slenderness: f64) -> usize {
    let Layers { ratio, .. } = Layers::NONE;
    let wanted = ((slenderness / WIDE).ln() / -ratio.ln()).ceil();
    (wanted.max(0.0) as usize).min(Layers::most(ratio))
}

#[cfg(test)]
mod tests {
    use radiosity_scene::Source;

    use super::*;

    /// Numbers of layers of the surfaces of a scene.
    fn counts(surfaces: &str) -> Vec<Counts> {
        let text = format!("materials = {{ grey = {{ reflectance = 0.5 }} }}\nsurfaces = [{surfaces}]\n");
        let scene = radiosity_language::read(&Source::new("faces.toml", &text)).expect("it is a scene");
        let all = Nearness::of(&scene);
        let counted = |surface: usize| all.layers(surface).map(|sides| sides.map(|own| own.count));
        (0..scene.surfaces.len()).map(counted).collect()
    }

    /// A plate of 1 × 4 at the height z that faces up, or down.
    fn plate(name: &str, z: f64, up: bool) -> String {
        let [a, b] = if up { ["[1, 0, 0]", "[0, 4, 0]"] } else { ["[0, 4, 0]", "[1, 0, 0]"] };
        format!(
            "{{ name = \"{name}\", material = \"grey\", parallelogram = {{ origin = [0, 0, {z}], edge1 = {a}, \
             edge2 = {b} }} }},"
        )
    }

    #[test]
    fn outermost_cells_of_plates_are_about_as_wide_as_their_gap() {
        for gap in [0.2, 0.05, 0.01] {
            let all = counts(&(plate("low", 0.0, true) + &plate("high", gap, false)));
            let [[short, low], [long, high]] = all[0];
            assert_eq!([low, high], [short, long], "both sides");
            assert_eq!(all[1], [all[0][1], all[0][0]], "the other plate has its edges in the other order");
            for (length, count) in [(1.0, short), (4.0, long)] {
                let width = 0.5 * length * 0.25_f64.powi(count as i32);
                assert!((0.2..=1.01).contains(&(width / gap)), "{width} over a gap of {gap}");
            }
        }
    }

    #[test]
    fn faces_that_are_far_or_look_elsewhere_want_none() {
        let none = [Counts::default(); 2];
        assert_eq!(counts(&(plate("low", 0.0, true) + &plate("high", 3.0, false))), none);
        assert_eq!(counts(&(plate("low", 0.0, false) + &plate("high", 0.05, true))), none, "back to back");
        assert_eq!(counts(&(plate("low", 0.0, true) + &plate("high", 0.05, true))), none, "one looks away");
    }

    #[test]
    fn tubes_have_layers_at_their_ends_and_balls_none() {
        let tube = |name: &str, radius: f64, flip: bool| {
            format!(
                "{{ name = \"{name}\", material = \"grey\", flip = {flip}, cylinder = {{ base = [0, 0, 0], \
                 axis = [0, 0, 2], radius = {radius} }} }},"
            )
        };
        for sides in counts(&(tube("inner", 0.9, false) + &tube("outer", 1.0, true))) {
            let layered: Vec<[usize; 2]> = sides.into_iter().filter(|side| *side != [0, 0]).collect();
            assert_eq!(layered, [[2, 2]], "only along the axis");
        }
        let ball = |name: &str, radius: f64, flip: bool| {
            format!(
                "{{ name = \"{name}\", material = \"grey\", flip = {flip}, \
                 sphere = {{ center = [0, 0, 0], radius = {radius} }} }},"
            )
        };
        assert_eq!(counts(&(ball("inner", 0.95, false) + &ball("outer", 1.0, true))), [Counts::default(); 2]);
    }

    #[test]
    fn many_near_faces_get_few_layers() {
        let pair = |k: usize| {
            plate(&format!("low{k}"), k as f64, true) + &plate(&format!("high{k}"), k as f64 + 0.01, false)
        };
        let cells = |pairs: usize| -> usize {
            let plates: String = (0..pairs).map(pair).collect();
            counts(&plates).iter().map(|own| elements(own, usize::MAX)).sum()
        };
        let of_one = cells(1);
        let of_ten = cells(10);
        assert!(20 < of_ten && of_ten <= MOST_ELEMENTS && of_ten < 10 * of_one, "{of_ten} {of_one}");
    }
}
