//! Bodies that flat sheets belong to: sheets in other planes that share a side with them.

use radiosity_geom::{DVec3, distance_to_segment, sides};

/// A sheet beside another one.
#[derive(Clone, Copy, Debug)]
pub struct Beside<'a> {
    /// Its index.
    pub sheet: usize,
    /// Its outline.
    pub outline: &'a [DVec3],
    /// Whether one of both sheets has its front where its outline runs clockwise, and the other has not.
    pub is_flipped: bool,
}

/// Mean height (length) over a sheet of the body that it belongs to: of the sheets beside it with a side along
/// one of its `outline`, each `height` given. Faces of the same body run along that side in the other direction;
/// only if there are none do other sheets count. 0 if it belongs to none.
pub fn height<'a>(
    outline: &[DVec3],
    tolerance: f64,
    others: impl Iterator<Item = Beside<'a>>,
    height: impl Fn(usize) -> f64,
) -> f64 {
    let (mut of_body, mut of_all) = (0.0, 0.0);
    for other in others {
        let Some(is_along) = runs_along(outline, other.outline, tolerance) else { continue };
        let height = height(other.sheet);
        of_all += height;
        of_body += if is_along == other.is_flipped { height } else { 0.0 };
    }
    [of_body, of_all].into_iter().find(|height| height.abs() > tolerance).unwrap_or(0.0)
}

/// Whether the first side of another ring that lies on a side of this one runs in its direction. None without
/// such sides.
fn runs_along(own: &[DVec3], other: &[DVec3], tolerance: f64) -> Option<bool> {
    sides(other).find_map(|[a, b]| {
        let holds = |side: &[DVec3; 2]| [a, b].iter().all(|x| distance_to_segment(*x, *side) <= tolerance);
        let [p, q] = sides(own).find(holds)?;
        Some((q - p).dot(b - a) >= 0.0)
    })
}
