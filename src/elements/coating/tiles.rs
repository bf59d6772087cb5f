//! Tiles: the rectangles of parameters over which a pattern is taken as constant.
//!
//! A tile is bounded by lines along which the pattern may jump, and holds one texel; where there would be more than
//! [`MOST`] along a direction, several, whose mean it has. A polynomial has a single tile, the whole.

use radiosity_geom::Rect;

use crate::scene::Pattern;

/// Most tiles along each direction of an element. What is lost of texels by taking means is their variation within a
/// tile times that of two polynomials: below (N/64)² of the contrast. Chosen; not tuned.
const MOST: usize = 64;

/// The tiles of a pattern over a rectangle of parameters.
#[derive(Debug)]
pub(super) struct Tiles {
    along: Vec<Strip>,
    across: Vec<Strip>,
}

/// A range of one parameter, with the middles and lengths of the texels in it.
#[derive(Debug)]
struct Strip {
    range: [f64; 2],
    texels: Vec<Texel>,
}

/// The part of a texel in a strip.
#[derive(Clone, Copy, Debug)]
struct Texel {
    middle: f64,
    length: f64,
}

/// One tile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tile<'a> {
    along: &'a Strip,
    across: &'a Strip,
}

impl Tiles {
    /// Those of `pattern` over `rect`.
    pub(super) fn of(pattern: &Pattern, rect: &Rect) -> Self {
        let [u, v] = pattern.breaks();
        Self { along: strips(&u, rect.u), across: strips(&v, rect.v) }
    }

    /// All of them.
    pub(super) fn list(&self) -> impl Iterator<Item = Tile<'_>> {
        self.along.iter().flat_map(|along| self.across.iter().map(move |across| Tile { along, across }))
    }
}

/// A band of a pattern of texels, with its mean on every tile.
#[derive(Debug)]
pub(super) struct Means {
    /// Ends of the tiles along u, and along v.
    ends: [Vec<f64>; 2],
    /// Means, v fastest.
    values: Vec<f64>,
}

impl Means {
    /// Those of a band of `pattern` over `rect`.
    pub(super) fn of(pattern: &Pattern, band: usize, rect: &Rect) -> Self {
        let tiles = Tiles::of(pattern, rect);
        let ends = [&tiles.along, &tiles.across];
        Self {
            ends: ends.map(|strips| strips.iter().map(|strip| strip.range[1]).collect()),
            values: tiles.list().map(|tile| tile.mean(pattern, band)).collect(),
        }
    }

    /// The mean on the tile at these parameters.
    pub(super) fn at(&self, parameters: [f64; 2]) -> f64 {
        let [i, j] = [0, 1].map(|axis| {
            let ends = &self.ends[axis];
            ends.partition_point(|end| *end < parameters[axis]).min(ends.len() - 1)
        });
        self.values[i * self.ends[1].len() + j]
    }
}

impl Tile<'_> {
    /// The parameters that it covers.
    pub(super) fn rect(&self) -> Rect {
        Rect { u: self.along.range, v: self.across.range }
    }

    /// Mean of a band of `pattern`, which is constant on texels.
    pub(super) fn mean(&self, pattern: &Pattern, band: usize) -> f64 {
        let mut sum = 0.0;
        for u in &self.along.texels {
            for v in &self.across.texels {
                sum += u.length * v.length * pattern.at(band, [u.middle, v.middle]);
            }
        }
        let length = |strip: &Strip| strip.texels.iter().map(|texel| texel.length).sum::<f64>();
        sum / (length(self.along) * length(self.across))
    }
}

/// The strips of a range between breaks, ascending.
fn strips(breaks: &[f64], range: [f64; 2]) -> Vec<Strip> {
    let inner = breaks.iter().copied().filter(|x| range[0] < *x && *x < range[1]);
    let ends: Vec<f64> = [range[0]].into_iter().chain(inner).chain([range[1]]).collect();
    let texels: Vec<[f64; 2]> = ends.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let strip = |texels: &[[f64; 2]]| Strip {
        range: [texels[0][0], texels[texels.len() - 1][1]],
        texels: texels
            .iter()
            .map(|[from, to]| Texel { middle: 0.5 * (from + to), length: to - from })
            .collect(),
    };
    texels.chunks(texels.len().div_ceil(MOST)).map(strip).collect()
}
