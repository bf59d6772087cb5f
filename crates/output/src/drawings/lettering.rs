//! Text on a picture, in a fixed-width bitmap font.

use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};

use super::picture::{Colour, Picture};

/// A line of text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lettering<'a> {
    /// The text. ASCII, Latin-1, and superscript digits and minus; what the font has not shows as a question
    /// mark.
    pub text: &'a str,
    /// Wanted height of a line in pixels; the font has 16, 20, 24 and 32, the next lower is taken.
    pub size: u32,
    /// Colour of the letters.
    pub colour: Colour,
    /// Whether the text runs upwards.
    pub upright: bool,
}

impl<'a> Lettering<'a> {
    /// Black text from left to right.
    pub(crate) fn level(text: &'a str, size: u32) -> Self {
        Self { text, size, colour: [0; 3], upright: false }
    }

    /// Width and height of the line before it is turned (pixels).
    pub(crate) fn extent(&self) -> [i32; 2] {
        let width: usize = self.text.chars().map(|c| advance(c, raster(self.size))).sum();
        [width as i32, raster(self.size).val() as i32]
    }

    /// Draws the line with its left upper corner, or the left lower one of an upright line, at (x, y).
    pub(crate) fn draw(&self, picture: &mut Picture, [x, y]: [i32; 2]) {
        self.ink(|place, part| {
            let [dx, dy] = if self.upright { [place[1], -place[0]] } else { place };
            picture.blend(x + dx, y + dy, self.colour, part);
        });
    }

    /// Calls `ink` for every pixel of the line before it is turned, from its left upper corner, with the part
    /// of it that letters cover.
    pub(crate) fn ink(&self, mut ink: impl FnMut([i32; 2], f64)) {
        let size = raster(self.size);
        let mut right = 0;
        for letter in self.text.chars() {
            let (plain, raised) = plain(letter, size);
            let height = if raised { smaller(size) } else { size };
            let drop = if raised { -(size.val() as i32) / 12 } else { 0 };
            let glyph = get_raster(plain, FontWeight::Regular, height)
                .or_else(|| get_raster('?', FontWeight::Regular, height));
            for (row, pixels) in glyph.iter().flat_map(|glyph| glyph.rows().enumerate()) {
                for (column, level) in pixels.iter().enumerate() {
                    ink([right + column as i32, row as i32 + drop], f64::from(*level) / 255.0);
                }
            }
            right += advance(letter, size) as i32;
        }
    }
}

fn raster(size: u32) -> RasterHeight {
    match size {
        32.. => RasterHeight::Size32,
        24.. => RasterHeight::Size24,
        20.. => RasterHeight::Size20,
        _ => RasterHeight::Size16,
    }
}

fn smaller(size: RasterHeight) -> RasterHeight {
    if size == RasterHeight::Size32 { RasterHeight::Size20 } else { RasterHeight::Size16 }
}

fn advance(letter: char, size: RasterHeight) -> usize {
    get_raster_width(FontWeight::Regular, if plain(letter, size).1 { smaller(size) } else { size })
}

/// A superscript as the plain character to be raised; anything else as it is.
fn plain(letter: char, size: RasterHeight) -> (char, bool) {
    const RAISED: [(char, char); 11] = [
        ('⁰', '0'),
        ('¹', '1'),
        ('²', '2'),
        ('³', '3'),
        ('⁴', '4'),
        ('⁵', '5'),
        ('⁶', '6'),
        ('⁷', '7'),
        ('⁸', '8'),
        ('⁹', '9'),
        ('⁻', '-'),
    ];
    // The smallest letters have no smaller ones, but ¹, ² and ³ of their own.
    if size == RasterHeight::Size16 && get_raster(letter, FontWeight::Regular, size).is_some() {
        return (letter, false);
    }
    let found = RAISED.iter().find(|(raised, _)| *raised == letter);
    found.map_or((letter, false), |(_, plain)| (*plain, true))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inked(text: &str, upright: bool) -> Vec<[i32; 2]> {
        let mut picture = Picture::filled(200, 200, [255; 3]);
        Lettering { text, size: 24, colour: [0; 3], upright }.draw(&mut picture, [50, 100]);
        let all = (0..200).flat_map(|y| (0..200).map(move |x| [x, y]));
        all.filter(|[x, y]| picture.at(*x, *y) != Some([255; 3])).collect()
    }

    #[test]
    fn letters_lie_in_their_extent() {
        let line = Lettering::level("10⁻³ W/m²", 24);
        let [width, height] = line.extent();
        let ink = inked(line.text, false);
        assert!(!ink.is_empty());
        assert!(ink.iter().all(|[x, y]| (50..50 + width).contains(x) && (98..100 + height).contains(y)));
    }

    #[test]
    fn upright_text_is_the_same_turned() {
        let mut turned: Vec<[i32; 2]> =
            inked("Fj", true).iter().map(|[x, y]| [50 - (y - 100), 100 + (x - 50)]).collect();
        turned.sort_unstable_by_key(|[x, y]| (*y, *x));
        assert_eq!(turned, inked("Fj", false));
    }

    #[test]
    fn unknown_characters_are_questions() {
        assert_eq!(inked("漢", false), inked("?", false));
    }
}
