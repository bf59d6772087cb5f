//! Files of luminaires, and the words that all readers of files share: places, faults, refusals, notes.
//!
//! In order: `file_place`, `note`, `error`, `files` (that a scene names), `text` and `numbers` (reading),
//! `symmetry`, `opening` and `web` (intensities by direction), `ies` and `eulumdat` (the formats) and
//! `luminaire` (either). Imports `work`.
//!
//! Photometry of luminaires: luminous intensity by direction, as tables of makers state it.
//!
//! Frame of a luminaire (CIE 121, coordinates C, γ; LM-63 calls them type C): the origin is the photometric
//! centre, z points up, γ is counted from straight down (the luminaire's axis, γ = 0) and C about the
//! vertical, counter-clockwise seen from above, from x (C = 0) over y (C = 90):
//!
//! ```text
//! direction(C, γ) = (sin γ cos C, sin γ sin C, −cos γ)
//! ```
//!
//! In LM-63 the length of the luminous opening is along x and its width along y. In EULUMDAT it is the other
//! way round: the plane C0 is across the lamps, so that the width is along x and the length along y.

pub mod file_place;
pub mod note_text;
pub mod note;
pub mod error;
pub mod files;
pub mod text;
mod numbers;
pub mod symmetry;
pub mod opening;
mod web;
pub mod ies;
pub mod eulumdat;
pub mod luminaire;

use glam::DVec3;

use crate::note::Note;
use crate::note_text::NoteText;
use crate::opening::Opening;
use crate::web::Web;

/// Difference of the flux of the table from the flux that the file states, over the latter, beyond which it
/// is noted. Chosen: files round ratios to whole percents.
const OFF_FLUX: f64 = 0.02;

/// A luminaire as its photometric file describes it. All intensities and fluxes are absolute: lumens of the
/// lamps, multipliers and factors of ballasts are applied.
#[derive(Clone, Debug, PartialEq)]
pub struct Photometry {
    /// Its name, for people; empty where the file has none.
    pub name: String,
    /// Texts of the file on the luminaire: keyword and text, in their order.
    pub description: Vec<(String, String)>,
    /// Luminous intensities in cd.
    pub web: Web,
    /// Flux of all lamps, lm; none where the photometry is absolute.
    pub lamp_flux: Option<f64>,
    /// Flux of the luminaire that the file states, lm.
    pub stated_flux: Option<f64>,
    /// Its luminous opening (m).
    pub opening: Opening,
    /// Tilt of the luminaire when it was measured, degrees; γ is counted from straight down all the same.
    pub tilt: f64,
    /// Notes on parts that were left out, and on values that look wrong.
    pub notes: Vec<Note>,
}

impl Photometry {
    /// Luminous intensity in a `direction` of the luminaire's frame, cd. The direction may have any length
    /// but 0.
    pub fn intensity(&self, direction: DVec3) -> f64 {
        let gamma = direction.truncate().length().atan2(-direction.z).to_degrees();
        let c = direction.y.atan2(direction.x).to_degrees();
        self.web.at(c, gamma)
    }

    /// Luminous flux, lm: the integral of [`Self::intensity`] over all directions.
    pub fn flux(&self) -> f64 {
        self.web.flux()
    }

    /// The part of the flux, lm, at angles γ from `least` to `most`, degrees.
    pub fn flux_between(&self, least: f64, most: f64) -> f64 {
        self.web.flux_between(least, most)
    }

    /// Greatest luminous intensity, cd.
    pub fn largest(&self) -> f64 {
        self.web.largest()
    }

    /// Adds remarks on the table, and on its flux where it differs from the stated one, to the notes.
    pub(crate) fn checked(mut self) -> Self {
        for text in self.web.remarks().into_iter().chain(self.off_flux()) {
            Note::add(&mut self.notes, NoteText::own(text), None);
        }
        self
    }

    fn off_flux(&self) -> Option<String> {
        let (found, stated) = (self.flux(), self.stated_flux?);
        ((found - stated).abs() > OFF_FLUX * stated)
            .then(|| format!("the intensities make {found:.0} lm, the file states {stated:.0} lm"))
    }
}
