//! Borders of sheets: what the borders of sheets meet, at sample places along them.

use radiosity_geom::{Aabb, Border, DVec3, LOOSE};
use rayon::prelude::*;

use crate::inspection::sheet::{GAP, Sheet, Sheets};

/// Sample places w ∈ (−1, 1) along a border, off middles and ends, where others may begin. Arbitrary
/// otherwise: a meeting shorter than the steps between them, an eighth of the border, may be missed.
const PLACES: [f64; 10] = [-0.97, -0.83, -0.61, -0.37, -0.13, 0.09, 0.29, 0.53, 0.77, 0.94];

/// Meeting of a border with other sheets at a place.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Meeting {
    /// Borders.
    Borders(Vec<MetBorder>),
    /// The inside of a face.
    Face,
    /// A sheet that the border nearly reaches.
    Gap {
        /// Index among the sheets.
        sheet: usize,
        /// Distance of that sheet (scene length).
        distance: f64,
    },
    /// Nothing meets the border.
    Open,
}

/// A border that another one meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MetBorder {
    /// Index of its sheet among the sheets.
    pub(super) sheet: usize,
    /// Cosine between the directions of both, fronts on their left.
    pub(super) cosine: f64,
}

/// A sample place of a border.
#[derive(Debug)]
pub(super) struct BorderSample {
    pub(super) point: DVec3,
    pub(super) meeting: Meeting,
}

/// The places of one border of a sheet.
#[derive(Debug)]
pub(super) struct SheetBorder {
    /// Index among the sheets.
    pub(super) sheet: usize,
    pub(super) places: Vec<BorderSample>,
}

/// A border with the data to compare it.
struct Line<'a> {
    sheet: usize,
    border: Border<'a>,
    sign: f64,
    bounds: Aabb,
}

/// Every border of every sheet.
pub(super) fn borders(sheets: &Sheets) -> Vec<SheetBorder> {
    let lines: Vec<Vec<Line<'_>>> =
        sheets.list.iter().enumerate().map(|(k, sheet)| lines(k, sheet)).collect();
    let of_sheet = |own: usize| -> Vec<SheetBorder> {
        let near = sheets.near(own);
        let neighbours: Vec<&Line<'_>> = near.iter().chain([&own]).flat_map(|sheet| &lines[*sheet]).collect();
        let sheet_border = |line: &Line<'_>| {
            let place = |w: f64| BorderSample {
                point: line.border.point(w),
                meeting: meeting(sheets, line, w, &neighbours, &near),
            };
            SheetBorder { sheet: own, places: PLACES.map(place).into() }
        };
        lines[own].iter().map(sheet_border).collect()
    };
    let found: Vec<Vec<SheetBorder>> = (0..sheets.list.len()).into_par_iter().map(of_sheet).collect();
    found.into_iter().flatten().collect()
}

fn lines(sheet: usize, of: &Sheet) -> Vec<Line<'_>> {
    of.borders()
        .into_iter()
        .map(|(border, sign)| Line { sheet, bounds: around(&border), border, sign })
        .collect()
}

fn around(border: &Border<'_>) -> Aabb {
    let bounds = Aabb::around((0..=16).map(|k| border.point(f64::from(k) / 8.0 - 1.0)));
    // Between the points a bent border leaves their box by less than 1/16 of its diagonal.
    let bulge = if matches!(border, Border::Segment(..)) { 0.0 } else { bounds.diagonal() / 16.0 };
    bounds.inflate(bulge)
}

/// A place of a border that is compared with other sheets.
struct BorderPlace<'a> {
    sheets: &'a Sheets,
    sheet: usize,
    point: DVec3,
    normal: DVec3,
    direction: DVec3,
}

/// A border or face close to a place.
struct Reach {
    sheet: usize,
    distance: f64,
    /// Nearer than the tolerance of touching.
    touches: bool,
    /// Whether the border would have to move sideways to touch.
    is_gap: bool,
    /// Cosine between the directions of two borders.
    cosine: f64,
}

fn meeting(sheets: &Sheets, own: &Line<'_>, w: f64, lines: &[&Line<'_>], near: &[usize]) -> Meeting {
    let (sheet, normal) = (own.sheet, sheets.list[own.sheet].normal_at(&own.border, w));
    let place =
        BorderPlace { sheets, sheet, point: own.border.point(w), normal, direction: direction(own, w) };
    let others = lines.iter().filter(|line| !std::ptr::eq(**line, own));
    let borders: Vec<Reach> = others.filter_map(|line| place.reach_border(line)).collect();
    let met = |rim: &Reach| MetBorder { sheet: rim.sheet, cosine: rim.cosine };
    let touched: Vec<MetBorder> = borders.iter().filter(|reach| reach.touches).map(met).collect();
    if !touched.is_empty() {
        return Meeting::Borders(touched);
    }
    let faces: Vec<Reach> = near.iter().filter_map(|other| place.reach_face(*other)).collect();
    if faces.iter().any(|face| face.touches) {
        return Meeting::Face;
    }
    let gaps = borders.iter().chain(&faces).filter(|reach| reach.is_gap && reach.sheet != own.sheet);
    let nearest = gaps.min_by(|a, b| a.distance.total_cmp(&b.distance));
    nearest.map_or(Meeting::Open, |reach| Meeting::Gap { sheet: reach.sheet, distance: reach.distance })
}

impl BorderPlace<'_> {
    fn reach_border(&self, line: &Line<'_>) -> Option<Reach> {
        let room = GAP * self.size(line.sheet);
        if !line.bounds.inflate(room).contains(self.point) {
            return None;
        }
        let z = line.border.nearest(self.point);
        let offset = line.border.point(z) - self.point;
        let theirs = self.sheets.list[line.sheet].normal_at(&line.border, z);
        let reach = self.reach(line.sheet, offset, is_across(offset, theirs))?;
        Some(Reach { cosine: self.direction.dot(direction(line, z)), ..reach })
    }

    fn reach_face(&self, sheet: usize) -> Option<Reach> {
        let other = &self.sheets.list[sheet];
        if !other.bounds.inflate(GAP * self.size(sheet)).contains(self.point) {
            return None;
        }
        self.reach(sheet, other.drop(self.point)? - self.point, false)
    }

    /// The sheet at `offset`, if it is close; `grows`: that sheet would have to grow in this direction to
    /// touch.
    fn reach(&self, sheet: usize, offset: DVec3, grows: bool) -> Option<Reach> {
        let (distance, size) = (offset.length(), self.size(sheet));
        let is_sideways = offset.dot(self.direction).abs() <= 0.5 * distance;
        let is_gap = is_sideways && (grows || is_across(offset, self.normal));
        let reach = Reach { sheet, distance, touches: distance <= LOOSE * size, is_gap, cosine: 0.0 };
        (distance <= GAP * size).then_some(reach)
    }

    /// The smaller extent of the two sheets.
    fn size(&self, other: usize) -> f64 {
        self.sheets.list[self.sheet].extent.min(self.sheets.list[other].extent)
    }
}

/// Whether a sheet of this `normal` would grow along `offset`, at a cosine of at most 0.9, 26° off the
/// normal: close parallel sheets leave no gap.
fn is_across(offset: DVec3, normal: DVec3) -> bool {
    offset.dot(normal).abs() <= 0.9 * offset.length()
}

/// Unit tangent of a border, with the front on its left.
fn direction(line: &Line<'_>, w: f64) -> DVec3 {
    let [before, after] = [w - 1e-3, w + 1e-3].map(|w| line.border.point(w.clamp(-1.0, 1.0)));
    line.sign * (after - before).normalize_or_zero()
}
