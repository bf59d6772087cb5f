//! Regions: the parts into which closed surfaces cut space.
//!
//! A shell has a side within and a side without. Two sides bound one region where the same shells lie around
//! both: around the side within a shell lie those around the shell, and itself. A region is closed if some
//! shell lies around it and all its sides are fronts: what leaves a front in it reaches fronts, all of it. Both sides
//! of a sheet that closes nothing bound the region around it.

use std::collections::{BTreeMap, BTreeSet};

use radiosity_geom::DVec3;
use radiosity_scene::Scene;

use crate::inspection::{
    enclosure::Enclosure,
    sheet::{Sheet, Sheets, backs},
    sheet_border, shell,
    shell::{Fronts, Group, Shell},
};

/// The regions that the surfaces of a scene bound with their fronts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Regions {
    /// The region of each surface.
    of: Vec<usize>,
    /// Whether each region is closed.
    closed: Vec<bool>,
}

/// The two sides of a shell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Within,
    Without,
}

/// A region that is being found.
struct Region {
    index: usize,
    has_backs: bool,
}

impl Regions {
    /// The regions of `scene`; None if some surface is neither a part of a closed surface whose fronts are all on one
    /// side, nor of an open sheet of two sides that touches no other. In a closed surface a surface of two sides has
    /// to be closed in itself.
    pub fn of(scene: &Scene) -> Option<Self> {
        let sheets = Sheets::of(scene);
        let groups = shell::groups(&sheets, &sheet_border::borders(&sheets));
        let (mut shells, mut open): (Vec<Shell>, Vec<&Group>) = (Vec::new(), Vec::new());
        for group in &groups {
            match shell::shell(&sheets, group) {
                Some(shell) => shells.push(shell),
                None if group.sheets.iter().all(|sheet| sheets.list[*sheet].two_sided) => open.push(group),
                None => return None,
            }
        }
        let is_mixed = |shell: &Shell| {
            let has_two_sided = shell.sheets.iter().any(|sheet| sheets.list[*sheet].two_sided);
            shell.fronts == Fronts::Mixed || (has_two_sided && shell.sheets.len() > 1)
        };
        if shells.iter().any(is_mixed) {
            return None;
        }
        let backs = backs(&scene.surfaces);
        let mut found: BTreeMap<BTreeSet<usize>, Region> = BTreeMap::new();
        let mut of = vec![0; scene.surfaces.len()];
        let enclosures: Vec<Enclosure<'_>> =
            shells.iter().map(|shell| Enclosure::new(&sheets, shell)).collect();
        let lying_around = |point: DVec3| -> BTreeSet<usize> {
            let all = enclosures.iter().enumerate().filter(|(_, enclosure)| enclosure.contains(point));
            all.map(|(shell, _)| shell).collect()
        };
        for group in open {
            let index = found.len();
            let key =
                same(group.sheets.iter().flat_map(|sheet| places(&sheets.list[*sheet])).map(&lying_around))?;
            let region = found.entry(key).or_insert(Region { index, has_backs: false });
            for front in group.sheets.iter().map(|sheet| sheets.list[*sheet].surface) {
                of[front] = region.index;
                of[backs[&front]] = region.index;
            }
        }
        for (own, shell) in shells.iter().enumerate() {
            let mut around = lying_around(sheets.list[shell.sheets[0]].samples()[0].point);
            around.remove(&own);
            let front = if shell.fronts == Fronts::Inside { Side::Within } else { Side::Without };
            for side in [Side::Within, Side::Without] {
                let mut key = around.clone();
                key.extend((side == Side::Within).then_some(own));
                let index = found.len();
                let region = found.entry(key).or_insert(Region { index, has_backs: false });
                let fronts = shell.surfaces.iter();
                let shown: Vec<usize> = match side == front {
                    true => fronts.copied().collect(),
                    false => fronts.filter_map(|front| backs.get(front).copied()).collect(),
                };
                region.has_backs |= shown.is_empty();
                shown.into_iter().for_each(|surface| of[surface] = region.index);
            }
        }
        let mut closed = vec![false; found.len()];
        for (around, region) in &found {
            closed[region.index] = !around.is_empty() && !region.has_backs;
        }
        Some(Self { of, closed })
    }

    /// Whether all that leaves the front of a surface reaches fronts.
    pub fn is_closed(&self, surface: usize) -> bool {
        self.closed[self.of[surface]]
    }

    /// Whether the fronts of two surfaces lie in one region, so that they may see each other.
    pub fn are_together(&self, surfaces: [usize; 2]) -> bool {
        self.of[surfaces[0]] == self.of[surfaces[1]]
    }
}

/// Places on a sheet, within and along its borders.
fn places(sheet: &Sheet) -> Vec<DVec3> {
    let within = sheet.samples().into_iter().map(|sample| sample.point);
    let borders = sheet.borders();
    let along = borders.iter().flat_map(|(border, _)| [-1.0, -0.5, 0.0, 0.5].map(|w| border.point(w)));
    within.chain(along).collect()
}

/// The value that all of these have, if they have one.
fn same<T: PartialEq>(mut all: impl Iterator<Item = T>) -> Option<T> {
    let first = all.next()?;
    all.all(|other| other == first).then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The regions of these surfaces, without materials.
    fn regions(surfaces: &[&str]) -> Option<Regions> {
        let list: Vec<String> = surfaces.iter().map(|own| format!("[[surfaces]]\n{own}\n")).collect();
        Regions::of(
            &radiosity_language::read(&radiosity_scene::Source::new("regions.toml", &list.concat()))
                .expect("a scene"),
        )
    }

    fn ball(center: [f64; 3], radius: f64) -> String {
        format!("sphere = {{ center = {center:?}, radius = {radius} }}\n")
    }

    const DISK: &str = "disk = { center = [2, 2, 2], normal = [0, 0, 1], radius = 1 }";
    const ROOM: &str = "box = { origin = [0, 0, 0], size = [4, 4, 4], inward = true }";

    #[test]
    fn a_room_is_closed_and_so_is_what_is_between_it_and_a_body_in_it() {
        let body = ball([2.0, 2.0, 2.0], 1.0);
        let found = regions(&[ROOM, &body]).expect("all is closed");
        assert!((0..7).all(|surface| found.is_closed(surface) && found.are_together([0, surface])));
    }

    #[test]
    fn outside_a_body_nothing_is_closed() {
        let found = regions(&[&ball([0.0; 3], 1.0)]).expect("all is closed");
        assert!(!found.is_closed(0));
    }

    #[test]
    fn a_shield_parts_what_is_within_from_what_is_without() {
        let shield = format!("two_sided = true\n{}", ball([2.0, 2.0, 2.0], 1.5));
        let found = regions(&[ROOM, &ball([2.0, 2.0, 2.0], 1.0), &shield]).expect("all is closed");
        assert!((0..9).all(|surface| found.is_closed(surface)));
        // The walls with the front of the shield, the body with its back.
        assert!(found.are_together([0, 7]) && found.are_together([6, 8]) && !found.are_together([7, 8]));
    }

    #[test]
    fn a_body_that_shows_its_back_closes_nothing() {
        let turned = format!("flip = true\n{}", ball([2.0, 2.0, 2.0], 1.0));
        let found = regions(&[ROOM, &turned]).expect("all is closed");
        assert!(!found.is_closed(0) && found.is_closed(6));
    }

    #[test]
    fn two_rooms_are_closed_each_by_itself() {
        let other = "box = { origin = [9, 0, 0], size = [4, 4, 4], inward = true }";
        let found = regions(&[ROOM, other]).expect("all is closed");
        assert!((0..12).all(|surface| found.is_closed(surface)) && !found.are_together([0, 6]));
    }

    #[test]
    fn open_boxes_and_lone_plates_have_no_regions() {
        let open = "box = { origin = [0, 0, 0], size = [4, 4, 4], inward = true, open = [\"top\"] }";
        assert!(regions(&[open]).is_none());
        assert!(regions(&[ROOM, DISK]).is_none());
    }

    #[test]
    fn both_sides_of_an_open_sheet_are_in_the_region_around_it() {
        let sheet = format!("two_sided = true\n{DISK}");
        let found = regions(&[ROOM, &sheet]).expect("all is closed but the sheet");
        assert!((0..8).all(|surface| found.is_closed(surface) && found.are_together([0, surface])));
        let outside = "two_sided = true\ndisk = { center = [9, 2, 2], normal = [0, 0, 1], radius = 1 }";
        let found = regions(&[ROOM, outside]).expect("all is closed but the sheet");
        assert!(found.is_closed(0) && !found.is_closed(6) && !found.is_closed(7));
        // One that pierces a wall joins what is within with what is without.
        let pierces = "two_sided = true\ndisk = { center = [3.8, 2, 2], normal = [0, 0, 1], radius = 1 }";
        assert!(regions(&[ROOM, pierces]).is_none());
    }
}
