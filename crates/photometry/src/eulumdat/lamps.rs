//! Sets of lamps of EULUMDAT.

use crate::error::Refusal;
use crate::note::Note;
use crate::note_text::NoteText;

use crate::numbers::Numbers;

/// Most sets of lamps. Stockmar has 20.
const MOST_SETS: usize = 1000;

/// A set of lamps.
pub(super) struct LampSet {
    /// Flux of all its lamps, or of the luminaire in absolute photometry, lm, > 0.
    pub(super) flux: f64,
    pub(super) is_absolute: bool,
}

/// The first of the sets of lamps.
///
/// # Errors
/// No set, or one without flux.
pub(super) fn first(numbers: &mut Numbers, notes: &mut Vec<Note>) -> Result<LampSet, Refusal> {
    let count = numbers.whole("the number of lamp sets", 1, MOST_SETS)?;
    let first = set(numbers)?;
    for _ in 1..count {
        set(numbers)?;
    }
    if count > 1 {
        let text = format!("of {count} sets of lamps the first is taken, with {} lm", first.flux);
        Note::add(notes, NoteText::own(text), Some(numbers.place()));
    }
    Ok(first)
}

fn set(numbers: &mut Numbers) -> Result<LampSet, Refusal> {
    let is_absolute = numbers.next("the number of lamps")? < 0.0;
    numbers.word("the type of the lamps")?;
    let flux = numbers.factor("the flux of the lamps")?;
    for what in ["the colour of the lamps", "their colour rendering", "their watts"] {
        numbers.word(what)?;
    }
    Ok(LampSet { flux, is_absolute })
}
