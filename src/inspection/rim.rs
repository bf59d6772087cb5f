//! Rims: what the borders of sheets meet, tried at places along them.

use radiosity_geom::{Aabb, Border, DVec3};

use crate::inspection::sheet::{GAP, Sheet, Sheets, TOUCH};

/// Where along a border it is tried, w ∈ (−1, 1); off the middles and ends at which others may begin.
const PLACES: [f64; 10] = [-0.97, -0.83, -0.61, -0.37, -0.13, 0.09, 0.29, 0.53, 0.77, 0.94];

/// What stands at a place of a border.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Meeting {
    /// Borders, each with its sheet and the cosine between the two directions, fronts to their left.
    Rims(Vec<(usize, f64)>),
    /// The inside of a face.
    Face,
    /// A sheet that the border nearly reaches.
    Gap {
        /// Index among the sheets.
        sheet: usize,
        /// How far it is.
        distance: f64,
    },
    /// Nothing.
    Open,
}

/// The places of one border of a sheet.
#[derive(Debug)]
pub(super) struct Rim {
    /// Index among the sheets.
    pub(super) sheet: usize,
    /// Points and what stands there.
    pub(super) places: Vec<(DVec3, Meeting)>,
}

/// A border with what is needed to compare it.
struct Line<'a> {
    sheet: usize,
    border: Border<'a>,
    sign: f64,
    bounds: Aabb,
}

/// Every border of every sheet.
pub(super) fn rims(sheets: &Sheets) -> Vec<Rim> {
    let lines: Vec<Vec<Line<'_>>> =
        sheets.list.iter().enumerate().map(|(k, sheet)| lines(k, sheet)).collect();
    let of_sheet = |own: usize| {
        let near = sheets.near(own);
        let neighbours: Vec<&Line<'_>> = near.iter().chain([&own]).flat_map(|sheet| &lines[*sheet]).collect();
        let rim = |line: &Line<'_>| {
            let place = |w: f64| (line.border.point(w), meeting(sheets, line, w, &neighbours, &near));
            Rim { sheet: own, places: PLACES.map(place).to_vec() }
        };
        lines[own].iter().map(rim).collect::<Vec<_>>()
    };
    (0..sheets.list.len()).flat_map(of_sheet).collect()
}

fn lines(sheet: usize, of: &Sheet) -> Vec<Line<'_>> {
    of.rims()
        .into_iter()
        .map(|(border, sign)| Line { sheet, bounds: around(&border), border, sign })
        .collect()
}

fn around(border: &Border<'_>) -> Aabb {
    let bounds = Aabb::around((0..=16).map(|k| border.point(f64::from(k) / 8.0 - 1.0)));
    // Between the points a bent border leaves their box by less than its size over 16.
    let bulge = if matches!(border, Border::Segment(..)) { 0.0 } else { bounds.diagonal() / 16.0 };
    bounds.inflate(bulge)
}

fn meeting(sheets: &Sheets, own: &Line<'_>, w: f64, lines: &[&Line<'_>], near: &[usize]) -> Meeting {
    let (x, sheet) = (own.border.point(w), &sheets.list[own.sheet]);
    let normal = sheet.normal_at(&own.border, w);
    let mut touched = Vec::new();
    let mut gap: Option<(usize, f64)> = None;
    let mut note_gap = |other: usize, distance: f64| {
        if gap.is_none_or(|(_, least)| distance < least) {
            gap = Some((other, distance));
        }
    };
    for line in lines.iter().filter(|line| !std::ptr::eq(**line, own)) {
        let other = &sheets.list[line.sheet];
        let size = sheet.extent.min(other.extent);
        if !line.bounds.inflate(GAP * size).contains(x) {
            continue;
        }
        let z = line.border.nearest(x);
        let offset = line.border.point(z) - x;
        if offset.length() <= TOUCH * size {
            touched.push((line.sheet, direction(own, w).dot(direction(line, z))));
        } else if offset.length() <= GAP * size
            && line.sheet != own.sheet
            && (is_sideways(offset, normal) || is_sideways(offset, other.normal_at(&line.border, z)))
        {
            note_gap(line.sheet, offset.length());
        }
    }
    if !touched.is_empty() {
        return Meeting::Rims(touched);
    }
    for (index, other) in near.iter().map(|index| (*index, &sheets.list[*index])) {
        let size = sheet.extent.min(other.extent);
        if !other.bounds.inflate(GAP * size).contains(x) {
            continue;
        }
        match other.drop(x) {
            Some((_, distance)) if distance <= TOUCH * size => return Meeting::Face,
            Some((foot, distance)) if distance <= GAP * size && is_sideways(foot - x, normal) => {
                note_gap(index, distance);
            }
            _ => {}
        }
    }
    gap.map_or(Meeting::Open, |(sheet, distance)| Meeting::Gap { sheet, distance })
}

/// Whether a sheet of this `normal` would grow along `offset`: parallel sheets close to each other leave no gap.
fn is_sideways(offset: DVec3, normal: DVec3) -> bool {
    offset.dot(normal).abs() <= 0.9 * offset.length()
}

/// Unit tangent of a border, the front to its left.
fn direction(line: &Line<'_>, w: f64) -> DVec3 {
    let [before, after] = [w - 1e-3, w + 1e-3].map(|w| line.border.point(w.clamp(-1.0, 1.0)));
    line.sign * (after - before).normalize_or_zero()
}
