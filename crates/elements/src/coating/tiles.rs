//! Tiles: the rectangles of parameters over which a pattern is taken as constant.
//!
//! A tile is bounded by lines along which the pattern may jump, and holds one texel; where there would be
//! more than [`MOST`] along a direction, several, whose mean over the parameters it has. A polynomial has a
//! single tile, the whole.

use std::collections::BTreeMap;

use radiosity_core::dot;
use radiosity_geom::Rect;
use radiosity_scene::Pattern;

/// Most tiles along each direction of an element. What is lost of texels by taking means is their variation
/// within a tile times that of two polynomials: below (N/64)² of the contrast.
const MOST: usize = 64;

/// A band of a pattern over a rectangle of parameters, with its mean on every tile.
#[derive(Debug)]
pub(super) struct Tiles {
    /// Ranges of the tiles along u, and along v.
    ranges: [Vec<[f64; 2]>; 2],
    /// Means, v fastest; none of a polynomial.
    means: Vec<f64>,
}

/// A range of one parameter, with the columns or rows of texels in it.
#[derive(Debug)]
struct Strip {
    range: [f64; 2],
    lines: Vec<Line>,
}

/// A column or a row of texels: a parameter in it, and the length of all of its parts in a strip.
#[derive(Clone, Copy, Debug)]
struct Line {
    index: usize,
    parameter: f64,
    length: f64,
}

impl Tiles {
    /// Tiles of a band of `pattern` over `rect`.
    pub(super) fn of(pattern: &Pattern, band: usize, rect: &Rect) -> Self {
        let breaks = pattern.breaks();
        let whole = [rect.u, rect.v];
        let [along, across] = [0, 1].map(|axis| strips(pattern, axis, &breaks[axis], whole[axis]));
        let means =
            if pattern.degree().is_none() { means(pattern, band, &along, &across) } else { Vec::new() };
        let ranges = [along, across].map(|strips| strips.iter().map(|strip| strip.range).collect());
        Self { ranges, means }
    }

    /// The rectangle of parameters of each tile, and the mean over it where the pattern is not a polynomial.
    pub(super) fn list(&self) -> impl Iterator<Item = (Rect, Option<f64>)> {
        let [along, across] = &self.ranges;
        let rects = along.iter().flat_map(move |u| across.iter().map(move |v| Rect { u: *u, v: *v }));
        rects.enumerate().map(|(index, rect)| (rect, self.means.get(index).copied()))
    }

    /// The mean on the tile at these parameters; None for a polynomial.
    pub(super) fn at(&self, parameters: [f64; 2]) -> Option<f64> {
        let [i, j] = [0, 1].map(|axis| {
            let ranges = &self.ranges[axis];
            ranges.partition_point(|range| range[1] < parameters[axis]).min(ranges.len() - 1)
        });
        self.means.get(i * self.ranges[1].len() + j).copied()
    }

    /// The mean over the parameters `rect`, which are some of its own; None for a polynomial.
    pub(super) fn over(&self, rect: &Rect) -> Option<f64> {
        let shared = |range: &[f64; 2], own: [f64; 2]| (range[1].min(own[1]) - range[0].max(own[0])).max(0.0);
        let lengths = |axis: usize, own: [f64; 2]| -> Vec<f64> {
            self.ranges[axis].iter().map(|range| shared(range, own)).collect()
        };
        let (along, across) = (lengths(0, rect.u), lengths(1, rect.v));
        let area = along.iter().sum::<f64>() * across.iter().sum::<f64>();
        let sum: f64 =
            self.means.chunks_exact(across.len()).zip(&along).map(|(own, x)| x * dot(own, &across)).sum();
        (!self.means.is_empty() && area > 0.0).then(|| sum / area)
    }
}

/// The strips of a range between breaks, ascending.
fn strips(pattern: &Pattern, axis: usize, breaks: &[f64], range: [f64; 2]) -> Vec<Strip> {
    let inner = breaks.iter().copied().filter(|x| range[0] < *x && *x < range[1]);
    let ends: Vec<f64> = [range[0]].into_iter().chain(inner).chain([range[1]]).collect();
    let parts: Vec<[f64; 2]> = ends.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let strip = |parts: &[[f64; 2]]| Strip {
        range: [parts[0][0], parts[parts.len() - 1][1]],
        lines: lines(pattern, axis, parts),
    };
    parts.chunks(parts.len().div_ceil(MOST)).map(strip).collect()
}

/// The columns or rows of texels over some ranges, each once however often it is repeated.
fn lines(pattern: &Pattern, axis: usize, parts: &[[f64; 2]]) -> Vec<Line> {
    let mut lines: BTreeMap<usize, Line> = BTreeMap::new();
    for [from, to] in parts {
        let parameter = 0.5 * (from + to);
        let index = pattern.line(axis, parameter);
        let line = lines.entry(index).or_insert(Line { index, parameter, length: 0.0 });
        line.length += to - from;
    }
    lines.into_values().collect()
}

/// The means over all tiles, v fastest: sums over columns for each row first, so that repeated texels are
/// read once a strip.
fn means(pattern: &Pattern, band: usize, along: &[Strip], across: &[Strip]) -> Vec<f64> {
    let rows: BTreeMap<usize, f64> =
        across.iter().flat_map(|strip| strip.lines.iter().map(|line| (line.index, line.parameter))).collect();
    let mut means = Vec::with_capacity(along.len() * across.len());
    for strip in along {
        let sum = |v: f64| -> f64 {
            strip.lines.iter().map(|u| u.length * pattern.at(band, [u.parameter, v])).sum()
        };
        let sums: BTreeMap<usize, f64> = rows.iter().map(|(index, v)| (*index, sum(*v))).collect();
        let width = strip.range[1] - strip.range[0];
        means.extend(across.iter().map(|other| {
            let area = width * (other.range[1] - other.range[0]);
            other.lines.iter().map(|v| v.length * sums[&v.index]).sum::<f64>() / area
        }));
    }
    means
}

#[cfg(test)]
mod tests {
    use radiosity_scene::Placement;

    use super::*;

    /// Texels of 1 to 4, repeated 50 times along each direction: more than there are tiles.
    #[test]
    fn tiles_of_many_texels_have_their_mean() {
        let placement = Placement { scale: [50.0; 2], ..Placement::default() };
        let pattern = Pattern::texels(2, vec![vec![1.0, 2.0, 3.0, 4.0]], placement).expect("a grid");
        let tiles = Tiles::of(&pattern, 0, &Rect::FULL);
        assert_eq!(tiles.list().count(), 2500);
        for (rect, mean) in tiles.list() {
            assert!((mean.expect("texels") - 2.5).abs() < 1e-12, "{rect:?}");
        }
        let part = Rect { u: [-1.0, -0.5], v: [0.2, 0.4] };
        assert!((tiles.over(&part).expect("texels") - 2.5).abs() < 1e-12);
    }

    #[test]
    fn few_texels_are_tiles() {
        let values = vec![vec![0.1, 0.2, 0.3, 0.4]];
        let pattern = Pattern::texels(2, values, Placement::default()).expect("a grid");
        let tiles = Tiles::of(&pattern, 0, &Rect { u: [-1.0, 0.5], v: [-1.0, 1.0] });
        let means: Vec<Option<f64>> = tiles.list().map(|(_, mean)| mean).collect();
        assert_eq!(means, [0.1, 0.3, 0.2, 0.4].map(Some));
        assert_eq!(tiles.at([0.3, -0.9]), Some(0.2));
        // Two thirds of the width are the first column.
        let lower = tiles.over(&Rect { u: [-1.0, 0.5], v: [-1.0, 0.0] }).expect("texels");
        assert!((lower - (0.1 * 2.0 + 0.2) / 3.0).abs() < 1e-15);
    }
}
