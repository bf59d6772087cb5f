//! A node of eight children: their boxes side by side, tested at once.
//!
//! A ray passes a box where its latest entry into a slab comes before its earliest exit from one (Kay and
//! Kajiya, *Ray tracing complex scenes*, 1986). The signs of its direction tell beforehand which face of a
//! slab it enters by.

use super::frame::{Box32, ROOM, Ray32};
use glam::Vec4;

/// Boxes side by side.
pub(super) const WIDTH: usize = 8;

/// Boxes to a vector, and vectors to a fork.
const LANES: usize = 4;
const VECTORS: usize = WIDTH / LANES;

/// Eight boxes and what is in them; missing ones are empty.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(super) struct Fork {
    /// Lowest and highest x, lowest and highest y, lowest and highest z.
    faces: [[Vec4; VECTORS]; 6],
    children: [u32; WIDTH],
}

/// A child that a ray enters, with the place where it does so: comparable by that place.
pub(super) type Entry = i64;

/// The content of the child.
pub(super) fn child(entry: Entry) -> u32 {
    entry as u32
}

/// Where the ray enters.
pub(super) fn place(entry: Entry) -> f32 {
    f32::from_bits((entry >> 32) as u32)
}

/// The entry of `child` at 0.
pub(super) fn at_start(child: u32) -> Entry {
    i64::from(child)
}

impl Fork {
    pub(super) fn new(boxes: &[Box32], contents: &[u32]) -> Fork {
        let at = |k: usize| boxes.get(k).unwrap_or(&Box32::EMPTY);
        let coordinate = |f: usize, k: usize| [at(k).min, at(k).max][f % 2][f / 2];
        let vector =
            |f: usize, v: usize| Vec4::from_array(std::array::from_fn(|k| coordinate(f, LANES * v + k)));
        let face = |f: usize| std::array::from_fn(|v| vector(f, v));
        let children = std::array::from_fn(|k| contents.get(k).copied().unwrap_or(0));
        Fork { faces: std::array::from_fn(face), children }
    }

    /// All children.
    #[cfg(test)]
    pub(super) fn contents(&self) -> impl Iterator<Item = u32> {
        let [low, high] = [0, 1].map(|f| self.faces[f].iter().flat_map(Vec4::to_array).collect::<Vec<f32>>());
        (0..WIDTH).filter(move |k| low[*k] <= high[*k]).map(|k| self.children[k])
    }

    /// The nearest of the children that the ray enters before `end`; pushes the others, the farthest first,
    /// above the first `depth` entries of a stack.
    #[inline]
    pub(super) fn entered(
        &self,
        ray: &Ray32,
        end: f32,
        stack: &mut [Entry],
        depth: &mut usize,
    ) -> Option<Entry> {
        let (mut entry, mut exit) = ([Vec4::ZERO; VECTORS], [Vec4::splat(end); VECTORS]);
        for axis in 0..3 {
            let (near, far) =
                (&self.faces[2 * axis + ray.signs[axis]], &self.faces[2 * axis + 1 - ray.signs[axis]]);
            let (origin, inverse) = (ray.origin[axis], ray.inverse[axis]);
            for v in 0..VECTORS {
                // Of two of which the first is no number, the second is taken.
                entry[v] = ((near[v] - origin) * inverse).max(entry[v]);
                exit[v] = ((far[v] - origin) * inverse).min(exit[v]);
            }
        }
        let mut left = 0;
        for v in 0..VECTORS {
            left |= entry[v].cmple(exit[v] * ROOM).bitmask() << (LANES * v);
        }
        let entry: [[f32; LANES]; VECTORS] = entry.map(|entry| entry.to_array());
        let entry = entry.as_flattened();
        let start = *depth;
        let mut nearest = None;
        while left != 0 {
            let k = left.trailing_zeros() as usize % WIDTH;
            left &= left - 1;
            let key = i64::from(entry[k].to_bits()) << 32 | i64::from(self.children[k]);
            nearest = Some(nearest.map_or(key, |nearest: Entry| {
                let other = key.max(nearest);
                let mut at = *depth;
                while at > start && stack[at - 1] < other {
                    stack[at] = stack[at - 1];
                    at -= 1;
                }
                stack[at] = other;
                *depth += 1;
                key.min(nearest)
            }));
        }
        nearest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ray_tree::frame::Frame;
    use crate::slabs::Slabs;
    use crate::{Aabb, Ray};
    use glam::DVec3;
    use proptest::prelude::*;

    proptest! {
        /// No box that the ray meets is left out, and they come in the order of the ray, the last first.
        #[test]
        fn boxes_are_entered_far_ones_first(
            corners in prop::collection::vec(prop::array::uniform6(-1.0..1.0_f64), 0..=WIDTH),
            origin in prop::array::uniform3(-1.0..1.0_f64), target in prop::array::uniform3(-1.0..1.0_f64),
            level in prop::bool::ANY,
        ) {
            let point = |x: &[f64]| DVec3::from_slice(x);
            let boxes: Vec<Aabb> = corners.iter().map(|x| Aabb::around([point(&x[..3]), point(&x[3..])])).collect();
            let frame = Frame::around(&Aabb { min: DVec3::splat(-1.0), max: DVec3::ONE });
            let mut direction = point(&target) - point(&origin);
            direction.y *= if level { 0.0 } else { 1.0 };
            let ray = Ray { origin: point(&origin), direction, range: [0.0, 1.0] };
            let ray32 = frame.ray(&ray).expect("it starts within the frame");
            let single: Vec<Box32> = boxes.iter().map(|bounds| frame.enclose(bounds)).collect();
            let contents: Vec<u32> = (7..).take(boxes.len()).collect();
            // What lies on the stack before stays there.
            let (mut stack, mut depth) = ([0; WIDTH + 1], 2);
            let nearest = Fork::new(&single, &contents).entered(&ray32, ray32.end(1.0), &mut stack, &mut depth);
            prop_assert_eq!(&stack[..2], &[0, 0]);
            let entries: Vec<Entry> = stack[2..depth].iter().copied().chain(nearest).collect();
            let found: Vec<u32> = entries.iter().map(|entry| child(*entry)).collect();
            for (k, bounds) in boxes.iter().enumerate() {
                let is_met = Slabs::new(&ray).entry(bounds, 0.0, 1.0).is_some();
                prop_assert!(!is_met || found.contains(&(7 + k as u32)), "{k} not in {found:?}");
                let is_far = Slabs::new(&ray).entry(&bounds.inflate(1e-5), 0.0, 1.0).is_none();
                prop_assert!(!is_far || !found.contains(&(7 + k as u32)), "{k} in {found:?}");
            }
            prop_assert!(entries.is_sorted_by(|a, b| place(*a) >= place(*b)));
        }
    }
}
