//! Surfaces that are the two sides of one sheet: the same points at the same parameters, normals reversed.

use crate::{Aabb, Surface};

/// Where twins are compared: corners and places in general position.
const PLACES: [[f64; 2]; 6] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [0.1, 0.3], [-0.7, -0.4]];

/// The other side of each surface, by its place in the list; the surface itself where there is none.
pub(super) fn twins<S: Surface>(surfaces: &[S], boxes: &[Aabb]) -> Vec<u32> {
    let mut twins: Vec<u32> = (0..surfaces.len() as u32).collect();
    let key = |k: &u32| {
        let Aabb { min, max } = boxes[*k as usize];
        [min.x, min.y, min.z, max.x, max.y, max.z].map(f64::to_bits)
    };
    let mut order = twins.clone();
    order.sort_unstable_by_key(|k| (key(k), *k));
    for same in order.chunk_by(|a, b| key(a) == key(b)) {
        for (k, a) in same.iter().enumerate() {
            let is_other_side = |b: &&u32| are_sides(&surfaces[*a as usize], &surfaces[**b as usize]);
            if let Some(b) = same[k + 1..].iter().find(is_other_side) {
                (twins[*a as usize], twins[*b as usize]) = (*b, *a);
            }
        }
    }
    twins
}

fn are_sides<S: Surface>(a: &S, b: &S) -> bool {
    PLACES.iter().all(|[u, v]| {
        let (a, b) = (a.jet(*u, *v), b.jet(*u, *v));
        a.position == b.position && a.normal == -b.normal
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{Cylinder, FULL_TURN, Parallelogram};
    use crate::{Flipped, Rect};
    use glam::DVec3;
    use std::sync::Arc;

    #[test]
    fn sides_of_one_sheet_find_each_other() {
        let square = |z: f64| -> Arc<dyn Surface> {
            Arc::new(Parallelogram::new(z * DVec3::Z, DVec3::X, DVec3::Y).expect("a square"))
        };
        let tube: Arc<dyn Surface> =
            Arc::new(Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, FULL_TURN).expect("a tube"));
        let back = |front: &Arc<dyn Surface>| -> Arc<dyn Surface> {
            Arc::new(Flipped::new(Box::new(front.clone())))
        };
        let surfaces = [square(0.0), back(&tube), square(1.0), back(&square(0.0)), tube.clone(), square(1.0)];
        let boxes = surfaces.each_ref().map(|surface| surface.bounds(&Rect::FULL));
        assert_eq!(twins(&surfaces, &boxes), [3, 4, 2, 0, 1, 5]);
    }
}
