//! Scenes far from the origin, in coordinates about their own middle.
//!
//! Map coordinates spend most digits on the place of the scene: at 10⁷ times its size 9 of 16 are left. So
//! the middle is subtracted from all coordinates before anything is computed, along each axis where it is
//! far. It is a multiple of a power of two about the size of the scene, so that no difference is rounded.

use std::sync::Arc;

use radiosity_geom::{Aabb, DVec3, Motion, Placed, Rect, Surface};

/// Distance from the origin, in sizes of the scene, beyond which the middle is subtracted: two of 16 digits
/// are spent on the place there. Scenes that are nearer keep the coordinates that were typed, to the last
/// bit.
const FAR: f64 = 100.0;

/// The middle of the `shapes` (length), rounded; zero if they are near the origin.
pub fn of<'a>(shapes: impl Iterator<Item = &'a Arc<dyn Surface>>) -> DVec3 {
    let bounds = shapes.fold(Aabb::EMPTY, |bounds, shape| bounds.union(shape.bounds(&Rect::FULL)));
    let (center, size) = (bounds.center(), bounds.diagonal());
    if bounds.is_empty() {
        return DVec3::ZERO;
    }
    let unit = size.log2().ceil().exp2();
    let off = |x: f64| if x.abs() > FAR * size { (x / unit).round() * unit } else { 0.0 };
    DVec3::from_array(center.to_array().map(off))
}

/// The shape with `middle` subtracted from its coordinates.
pub fn taken_off(shape: &Arc<dyn Surface>, middle: DVec3) -> Arc<dyn Surface> {
    if let Some(Ok(moved)) = shape.with_corners(&|x| x - middle) {
        return Arc::from(moved);
    }
    let motion = Motion::new(-middle, DVec3::Z, 0.0, 1.0).expect("a finite translation is a motion");
    Arc::new(Placed::new(Box::new(Arc::clone(shape)), motion))
}

#[cfg(test)]
mod tests {
    use radiosity_geom::shapes::{FULL_TURN, Polygon, Sphere};

    use super::*;

    #[test]
    fn differences_are_exact_and_near_scenes_stay() {
        let corners = [[0.1, 0.2, 0.3], [1.7, 0.2, 0.3], [1.7, 3.1, 0.3]].map(DVec3::from_array);
        let far = DVec3::new(431_234.5, -5_412_345.25, 99.75);
        let at = |offset: DVec3| -> Arc<dyn Surface> {
            Arc::new(Polygon::new(corners.map(|x| x + offset).to_vec(), Vec::new()).expect("a triangle"))
        };
        assert_eq!(of([at(DVec3::ZERO)].iter()), DVec3::ZERO);
        let shape = at(far);
        let middle = of([Arc::clone(&shape)].iter());
        let moved = taken_off(&shape, middle);
        assert!(moved.corners().iter().all(|x| x.truncate().length() < 10.0), "its height is not far");
        // Put back, every corner is where it was to the last bit.
        assert!(moved.corners().iter().zip(shape.corners()).all(|(x, typed)| *x + middle == typed));
    }

    #[test]
    fn shapes_without_corners_move_as_a_whole() {
        let far = DVec3::new(1e6, 0.0, 0.0);
        let ball = Sphere::new(far, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).expect("a ball");
        let moved = taken_off(&(Arc::new(ball) as Arc<dyn Surface>), far);
        assert_eq!(moved.ball(), Some((DVec3::ZERO, 1.0)));
    }
}
