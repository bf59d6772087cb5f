//! Reads EULUMDAT photometric files, `.ldt`.
//!
//! Source: A. Stockmar, "EULUMDAT – ein Leuchtendatenformat für den europäischen Beleuchtungsplaner", Licht
//! '90, 641–644 (1990). Each line has one item:
//!
//! * 1 company, 2 type, 3 symmetry `Isym`, 4 and 5 number `Mc` and distance of planes, 6 and 7 number `Ng`
//!   and distance of angles γ, 8 report, 9 luminaire, 10 its number, 11 file, 12 date;
//! * 13 to 15 length, width, height of the luminaire, 16 and 17 length and width of its luminous area (width
//!   0: round, length is the diameter), 18 to 21 its heights in the planes C0, C90, C180, C270, all in mm;
//! * 22 downward flux fraction in %, 23 light output ratio in %, 24 factor of the intensities, 25 tilt when
//!   measured;
//! * 26 number of lamp sets, then for each: number of lamps (below 0: absolute photometry, and the flux is
//!   the luminaire's), type, flux of all its lamps in lm, colour, colour rendering, watts;
//! * ten direct ratios, the `Mc` angles C, the `Ng` angles γ, and intensities in cd per 1000 lm, one plane
//!   after another.
//!
//! By `Isym` the planes are 0: all, 1: the first, 2: C0 to C180, 3: C270 over C0 to C90, 4: C0 to C90. Of
//! several lamp sets, which are choices, the first is taken, and that is noted. Distances, direct ratios and
//! the downward fraction follow from the rest and are not used. A decimal comma is read as a point; blank
//! sizes, ratios and watts are 0.

mod lamps;
mod planes;

use crate::error::Refusal;
use crate::note::Note;
use crate::note_text::NoteText;

use self::lamps::LampSet;
use self::planes::Stated;
use crate::Photometry;
use crate::numbers::Numbers;
use crate::opening::{Form, Opening};
use crate::text::{decode_western, told};
use crate::web::Web;

/// Most planes and most angles γ. Chosen: a table at every hundredth of a degree in γ, or every twentieth in
/// C.
const MOST_ANGLES: usize = 20_000;

/// Direct ratios in a file, one for each room index.
const DIRECT_RATIOS: usize = 10;

const METRES_PER_MILLIMETRE: f64 = 1e-3;

/// Flux of the lamps (lm) to which intensities in the file refer.
const PER_LUMENS: f64 = 1000.0;

/// Reads the luminaire in `bytes`, the contents of `file`.
///
/// # Errors
/// Numbers that are none, counts and symmetries that do not agree, intensities that cannot be, a text that
/// ends too early or goes on.
pub fn read(file: &str, bytes: &[u8]) -> Result<Photometry, Refusal> {
    let text = decode_western(bytes).map_err(|fault| fault.in_file(file))?;
    let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    photometry(Numbers::new(lines, 1)).map_err(|located| located.in_file(file))
}

/// Items of the lines 1 to 12: texts by keyword, the symmetry `Isym`, the numbers of planes and of angles γ.
struct Identity {
    description: Vec<(String, String)>,
    symmetry: usize,
    planes: usize,
    gammas: usize,
}

/// Items of the lines 22 to 25: light output ratio as a part of 1, factor of the intensities, tilt in
/// degrees.
struct Measurement {
    output_ratio: f64,
    factor: f64,
    tilt: f64,
}

fn photometry(mut numbers: Numbers) -> Result<Photometry, Refusal> {
    let mut notes = Vec::new();
    let identity = identity(&mut numbers)?;
    let opening = opening(&mut numbers, &mut notes)?;
    let measurement = measurement(&mut numbers, &mut notes)?;
    let lamps = lamps::first(&mut numbers, &mut notes)?;
    for _ in 0..DIRECT_RATIOS {
        numbers.next_or_zero("a direct ratio")?;
    }
    let web = web(&mut numbers, &identity, measurement.factor * lamps.flux / PER_LUMENS)?;
    numbers.end()?;
    let LampSet { flux, is_absolute } = lamps;
    let named = |(keyword, _): &&(String, String)| keyword == LUMINAIRE;
    Ok(Photometry {
        name: identity.description.iter().find(named).map(|(_, text)| text.clone()).unwrap_or_default(),
        description: identity.description,
        web,
        lamp_flux: (!is_absolute).then_some(flux),
        stated_flux: (measurement.output_ratio > 0.0).then_some(flux * measurement.output_ratio),
        opening,
        tilt: measurement.tilt,
        notes,
    }
    .checked())
}

const LUMINAIRE: &str = "LUMINAIRE";

fn identity(numbers: &mut Numbers) -> Result<Identity, Refusal> {
    let mut description = vec![("COMPANY".to_owned(), numbers.word("the company")?.to_owned())];
    numbers.whole("the type of the luminaire", 0, 3)?;
    let symmetry = numbers.whole("the symmetry Isym", 0, 4)?;
    let planes = numbers.whole("the number of planes Mc", 1, MOST_ANGLES)?;
    numbers.next_or_zero("the distance of planes Dc")?;
    let gammas = numbers.whole("the number of angles Ng", 2, MOST_ANGLES)?;
    numbers.next_or_zero("the distance of angles Dg")?;
    for (keyword, what) in [
        ("TEST", "the measurement report"),
        (LUMINAIRE, "the name of the luminaire"),
        ("LUMCAT", "the number of the luminaire"),
        ("FILE", "the name of the file"),
        ("DATE", "the date"),
    ] {
        description.push((keyword.to_owned(), numbers.word(what)?.to_owned()));
    }
    description.retain(|(_, text)| !text.is_empty());
    Ok(Identity { description, symmetry, planes, gammas })
}

fn opening(numbers: &mut Numbers, notes: &mut Vec<Note>) -> Result<Opening, Refusal> {
    let mut millimetres = |what: &str| numbers.amount_or_zero(what).map(|size| size * METRES_PER_MILLIMETRE);
    for what in ["the length of the luminaire", "its width", "its height"] {
        millimetres(what)?;
    }
    let length = millimetres("the length of the luminous area")?;
    let width = millimetres("the width of the luminous area")?;
    let mut heights = [0.0; 4];
    for (height, plane) in heights.iter_mut().zip(["C0", "C90", "C180", "C270"]) {
        *height = millimetres(&format!("the height of the luminous area in plane {plane}"))?;
    }
    let height = heights.into_iter().fold(0.0, f64::max);
    if heights.iter().any(|each| *each != height) {
        Note::add(
            notes,
            "the luminous area is not as high all around; the greatest height is taken",
            Some(numbers.place()),
        );
    }
    let (form, extent) = match (length > 0.0, width > 0.0) {
        (true, false) => (Form::Upright, [length, length, height]),
        (false, false) if height == 0.0 => (Form::Point, [0.0; 3]),
        _ => (Form::Box, [width, length, height]),
    };
    Ok(Opening { form, extent })
}

fn measurement(numbers: &mut Numbers, notes: &mut Vec<Note>) -> Result<Measurement, Refusal> {
    numbers.next_or_zero("the downward flux fraction")?;
    let output_ratio = numbers.amount_or_zero("the light output ratio")? / 100.0;
    let factor = numbers.factor("the conversion factor of the intensities")?;
    let tilt = numbers.next_or_zero("the tilt of the luminaire when measured")?;
    if tilt != 0.0 {
        let text = format!(
            "the luminaire was tilted by {}° when measured; γ is counted from straight down",
            told(tilt)
        );
        Note::add(notes, NoteText::own(text), Some(numbers.place()));
    }
    Ok(Measurement { output_ratio, factor, tilt })
}

fn web(numbers: &mut Numbers, identity: &Identity, factor: f64) -> Result<Web, Refusal> {
    let all = numbers.increasing(identity.planes, "an angle C")?;
    let place = numbers.place();
    let Stated { symmetry, planes } =
        planes::stated(identity.symmetry, &all).map_err(|fault| fault.at(place))?;
    let gammas = numbers.increasing(identity.gammas, "an angle γ")?;
    let place = numbers.place();
    let mut table = numbers.amounts(planes.len() * gammas.len(), "a luminous intensity")?;
    table.iter_mut().for_each(|candela| *candela *= factor);
    Web::new(symmetry, &planes, gammas, table).map_err(|fault| fault.at(place))
}
