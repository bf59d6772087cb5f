//! The point-to-point kernel of diffuse transport (Zatz 1993, eq. 3, corrected):
//!
//! ```text
//! κ(x, y) = max(0, n_x·d) max(0, −n_y·d) / (π r⁴),   d = y − x,  r = |d| .
//! ```
//!
//! Irradiance is E(x) = ∫ κ(x, y) V(x, y) B(y) dA_y. κ is symmetric and has the unit 1/length².

use core::f64::consts::FRAC_1_PI;

use radiosity_elements::patch::Node;
use radiosity_geom::DVec3;

/// Whether the segment between two points is free.
pub type Sees<'a> = &'a dyn Fn(DVec3, DVec3) -> bool;

/// κ between two points; zero where either faces away or where they coincide.
#[inline]
pub fn kernel(x: &Node, y: &Node) -> f64 {
    let d = y.position - x.position;
    let leaving = -y.normal.dot(d);
    let arriving = x.normal.dot(d);
    if arriving <= 0.0 || leaving <= 0.0 {
        return 0.0;
    }
    let r2 = d.length_squared();
    arriving * leaving * FRAC_1_PI / (r2 * r2)
}

/// κV; the ray is cast only where κ > 0.
#[inline]
pub fn visible_kernel(x: &Node, y: &Node, sees: Option<Sees>, rays: &mut u64) -> f64 {
    let value = kernel(x, y);
    match sees {
        Some(sees) if value > 0.0 => {
            *rays += 1;
            if sees(x.position, y.position) { value } else { 0.0 }
        }
        _ => value,
    }
}

#[cfg(test)]
mod tests {
    use radiosity_geom::{DVec2, DVec3};

    use super::*;

    fn node(position: DVec3, normal: DVec3) -> Node {
        Node { position, normal, area: 1.0, parameters: DVec2::ZERO }
    }

    #[test]
    fn facing_points_at_distance_two() {
        let (x, y) = (node(DVec3::ZERO, DVec3::Z), node(2.0 * DVec3::Z, -DVec3::Z));
        assert!((kernel(&x, &y) - 0.25 * FRAC_1_PI).abs() < 1e-16);
        assert_eq!(kernel(&x, &y), kernel(&y, &x));
    }

    #[test]
    fn behind_is_dark() {
        assert_eq!(kernel(&node(DVec3::ZERO, DVec3::Z), &node(-DVec3::Z, DVec3::Z)), 0.0);
        assert_eq!(kernel(&node(DVec3::ZERO, DVec3::Z), &node(DVec3::Z, DVec3::Z)), 0.0);
    }
}
