//! Points inside a closed surface.
//!
//! A ray from a point inside leaves the closed surface once more often than it enters it: the number of
//! crossings is odd. Rays along edges may miscount, so most of three decide.

use radiosity_geom::{Aabb, Bvh, COINCIDENT, DVec3, Ray};

use crate::inspection::{
    sheet::{Sheet, Sheets},
    shell::Shell,
};

/// Directions of rays, along no axis, diagonal or plane of both, where edges of buildings run. Arbitrary
/// otherwise.
const DIRECTIONS: [DVec3; 3] =
    [DVec3::new(0.31, 0.57, 0.76), DVec3::new(-0.69, 0.41, -0.6), DVec3::new(0.17, -0.83, 0.53)];

/// The space that a shell encloses.
pub(super) struct Enclosure<'a> {
    members: Vec<&'a Sheet>,
    pub(super) bounds: Aabb,
    tree: Bvh,
}

impl<'a> Enclosure<'a> {
    pub(super) fn new(sheets: &'a Sheets, shell: &Shell) -> Self {
        let members: Vec<&Sheet> = shell.sheets.iter().map(|k| &sheets.list[*k]).collect();
        let boxes: Vec<Aabb> = members.iter().map(|sheet| sheet.bounds).collect();
        let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
        Enclosure { members, bounds, tree: Bvh::build(&boxes) }
    }

    /// Whether `point` lies inside.
    pub(super) fn contains(&self, point: DVec3) -> bool {
        let is_odd = |direction: &&DVec3| self.crossings(&Ray::new(point, **direction)) % 2 == 1;
        self.bounds.contains(point) && DIRECTIONS.iter().filter(is_odd).count() > 1
    }

    /// Number of crossings of a ray with the shell.
    fn crossings(&self, ray: &Ray) -> usize {
        let mut count = 0;
        self.tree.any(ray, |member| {
            count += crossings(self.members[member], *ray);
            false
        });
        count
    }
}

/// Number of crossings of a ray with a sheet; hits within rounding of each other are one.
fn crossings(sheet: &Sheet, mut ray: Ray) -> usize {
    let hair = COINCIDENT * sheet.extent / ray.direction.length();
    let mut count = 0;
    while let Some(hit) = sheet.shape.intersect(&ray) {
        count += 1;
        ray.range[0] = hit.t + hair.max(1e-12 * hit.t.abs());
    }
    count
}
