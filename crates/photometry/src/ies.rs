//! Reads IES LM-63 photometric files, `.ies`, of 1986, 1991, 1995, 2002 and 2019.
//!
//! Sources: ANSI/IESNA LM-63-02 and ANSI/IES LM-63-19, "Standard File Format for the Electronic Transfer of
//! Photometric Data"; I. Ashdown, "Parsing the IESNA LM-63 Photometric Data File" (1998), for the editions
//! before.
//!
//! * The first line tells the edition; without one it is that of 1986, whose lines before `TILT=` are plain
//!   labels. Later ones have keywords, `[LUMINAIRE] text`, continued by `[MORE]`.
//! * `TILT=NONE`, or `TILT=INCLUDE` with factors of the lamp's output by its tilt: read, and left out, for
//!   they are 1 as measured. `TILT=FILE` is refused.
//! * Then numbers, parted by blanks, commas or ends of lines: lamps, lumens of each (−1: absolute
//!   photometry), multiplier, counts of vertical and horizontal angles, type (1 = C), unit (1 = feet,
//!   2 = metres), width, length, height; ballast factor, a second factor (1986 and 1991; later it is no
//!   factor), watts; vertical angles, horizontal angles, candelas of one plane after another.
//! * Candelas are multiplied by the multiplier and the ballast factors, as the standards say.
//! * Horizontal angles end at 0 (the same all around), 90 (symmetric about both axes), 180 (about C0–C180),
//!   run from 90 to 270 (about C90–C270), or go all around.

mod edition;
mod header;
mod opening;
mod planes;

use crate::error::Refusal;
use crate::note::Note;
use crate::note_text::NoteText;

use crate::Photometry;
use crate::ies::edition::Edition;
use crate::ies::header::Header;
use crate::numbers::Numbers;
use crate::text::{decode_western, told};
use crate::web::Web;

/// Most angles of either kind. Chosen: a table at every hundredth of a degree in γ, or every twentieth in C.
const MOST_ANGLES: usize = 20_000;

/// Most factors by tilt in a file. Chosen.
const MOST_TILTS: usize = 10_000;

/// Reads the luminaire in `bytes`, the contents of `file`.
///
/// # Errors
/// A file without `TILT=`; photometry of types A and B; counts, angles or intensities that cannot be; a text
/// that ends too early, or goes on.
pub fn read(file: &str, bytes: &[u8]) -> Result<Photometry, Refusal> {
    let text = decode_western(bytes).map_err(|fault| fault.in_file(file))?;
    Header::of(&text).and_then(|header| photometry(&header)).map_err(|located| located.in_file(file))
}

/// Values before the opening: flux of the lamps (lm), multiplier, counts of vertical and of horizontal
/// angles.
struct Lamps {
    flux: Option<f64>,
    multiplier: f64,
    counts: [usize; 2],
}

fn photometry(header: &Header) -> Result<Photometry, Refusal> {
    let mut notes = Vec::new();
    let words = header.data.lines().enumerate().flat_map(|(index, line)| {
        line.split([' ', '\t', ',', '\r', '\u{1a}'])
            .filter(|word| !word.is_empty())
            .map(move |word| (header.line + 1 + index, word))
    });
    let mut numbers = Numbers::new(words, header.line);
    if header.has_tilt_factors {
        tilt_factors(&mut numbers)?;
        Note::add(
            &mut notes,
            "the lamp's output by tilt is left out: it burns as measured",
            Some(numbers.place()),
        );
    }
    let lamps = lamps(&mut numbers)?;
    let opening = opening::read(&mut numbers, header.edition)?;
    let factor = lamps.multiplier * ballast(&mut numbers, header.edition, &mut notes)?;
    let web = web(&mut numbers, lamps.counts, factor)?;
    numbers.end()?;
    Ok(Photometry {
        name: header.name(),
        description: header.keywords.clone(),
        web,
        lamp_flux: lamps.flux,
        stated_flux: None,
        opening,
        tilt: 0.0,
        notes,
    }
    .checked())
}

fn tilt_factors(numbers: &mut Numbers) -> Result<(), Refusal> {
    numbers.whole("the position of the lamp (1 upright, 2 along, 3 across)", 1, 3)?;
    let count = numbers.whole("the number of tilt factors", 1, MOST_TILTS)?;
    numbers.increasing(count, "a tilt angle")?;
    numbers.amounts(count, "a tilt factor")?;
    Ok(())
}

fn lamps(numbers: &mut Numbers) -> Result<Lamps, Refusal> {
    let count = numbers.factor("the number of lamps")?;
    let lumens = numbers.next("the lumens of each lamp")?;
    if lumens < 0.0 && lumens != -1.0 {
        return Err(numbers.fault(
            format!("the lumens of each lamp are {}", told(lumens)),
            "write them, or -1 where the candelas are absolute",
        ));
    }
    let multiplier = numbers.factor("the candela multiplier")?;
    let vertical = numbers.whole("the number of vertical angles", 2, MOST_ANGLES)?;
    let horizontal = numbers.whole("the number of horizontal angles", 1, MOST_ANGLES)?;
    let kind = numbers.whole("the photometric type (1 is C)", 1, 3)?;
    if kind != 1 {
        return Err(numbers.fault(
            format!("the photometry is of type {}", if kind == 2 { "B" } else { "A" }),
            "convert the file to type C with a photometric program: its angles cannot be turned into C and γ exactly",
        ));
    }
    let flux = (lumens > 0.0).then_some(count * lumens);
    Ok(Lamps { flux, multiplier, counts: [vertical, horizontal] })
}

/// Factor of the intensities by the ballast, the second factor of 1986 and 1991 included.
fn ballast(numbers: &mut Numbers, edition: Edition, notes: &mut Vec<Note>) -> Result<f64, Refusal> {
    let factor = numbers.factor("the ballast factor")?;
    let second = match edition {
        Edition::Of1986 | Edition::Of1991 => numbers.factor("the ballast-lamp photometric factor")?,
        Edition::Of1995 | Edition::Of2002 => {
            let reserved = numbers.next("the number for future use")?;
            if reserved != 1.0 {
                let text = format!("the number for future use is {}, not 1; it is left out", told(reserved));
                Note::add(notes, NoteText::own(text), Some(numbers.place()));
            }
            1.0
        }
        Edition::Of2019 => {
            numbers.next("the file generation type")?;
            1.0
        }
    };
    numbers.next("the input watts")?;
    Ok(factor * second)
}

fn web(numbers: &mut Numbers, [vertical, horizontal]: [usize; 2], factor: f64) -> Result<Web, Refusal> {
    let gammas = numbers.increasing(vertical, "a vertical angle")?;
    let planes = numbers.increasing(horizontal, "a horizontal angle")?;
    let place = numbers.place();
    let symmetry = planes::symmetry(&planes).map_err(|fault| fault.at(place))?;
    let mut table = numbers.amounts(vertical * horizontal, "a luminous intensity")?;
    table.iter_mut().for_each(|candela| *candela *= factor);
    Web::new(symmetry, &planes, gammas, table).map_err(|fault| fault.at(place))
}
