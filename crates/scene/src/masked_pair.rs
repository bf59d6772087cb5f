//! Pairs of surfaces whose light is masked.

use std::num::NonZeroUsize;

use crate::{
    error::Located,
    fault::Fault,
    member_names::{MemberNames, NamedMember, found},
    place::Span,
    ranges::check_range,
};

/// Most cells along a side of a mask: a million values.
pub const MOST_MASK_CELLS: usize = 1000;

/// Pairs of surfaces that were chosen for shadow masks: of each emitter with each receiver.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MaskedPair {
    /// Name of the emitters, as it was typed.
    pub emitter: String,
    /// Name of the receivers, as it was typed.
    pub receiver: String,
    /// Indices of the surfaces whose light is masked, ascending.
    pub emitters: Vec<usize>,
    /// Indices of the surfaces on which it is masked, ascending.
    pub receivers: Vec<usize>,
    /// Cells along each side of an element's mask, where the pair states them.
    pub cells: Option<NonZeroUsize>,
}

impl MaskedPair {
    /// Whether the light of the surface `emitter` is masked on the surface `receiver`.
    pub fn is_of(&self, receiver: usize, emitter: usize) -> bool {
        let has = |list: &[usize], index: usize| list.binary_search(&index).is_ok();
        receiver != emitter && has(&self.receivers, receiver) && has(&self.emitters, emitter)
    }
}

/// A pair of surfaces, or several, by name; see [`SceneBuilder::masks`](crate::SceneBuilder::masks).
#[derive(Clone, Debug)]
pub struct MaskedPairDraft {
    /// The emitters.
    pub emitter: NamedMember,
    /// The receivers.
    pub receiver: NamedMember,
    /// Cells along each side of an element's mask, where they are stated.
    pub cells: Option<usize>,
    /// Place of the whole pair in a file; none if it was given in code.
    pub span: Option<Span>,
}

/// The pairs of surfaces that are chosen in a scene; number k of them is `mask k` in messages.
///
/// # Errors
/// The first that means no pair, as a name that nothing has.
pub fn masked_pairs(
    drafts: Vec<MaskedPairDraft>,
    surfaces: &[MemberNames],
) -> Result<Vec<MaskedPair>, Located> {
    let resolved = |(draft, number): (MaskedPairDraft, usize)| {
        draft.resolved(surfaces).map_err(|error| error.within(|| format!("mask {number}")))
    };
    drafts.into_iter().zip(1..).map(resolved).collect()
}

impl MaskedPairDraft {
    /// The light of the surfaces `emitter` on the surfaces `receiver`, each the name of a surface, an entry
    /// or an instance; a `*` at its end stands for any ending.
    pub fn new(emitter: impl Into<String>, receiver: impl Into<String>) -> Self {
        let named = |name: String| NamedMember { name, span: None };
        Self { emitter: named(emitter.into()), receiver: named(receiver.into()), cells: None, span: None }
    }

    /// The pairs of surfaces of these names.
    ///
    /// # Errors
    /// A name that nothing has, a number of cells out of range, and a surface with itself alone.
    fn resolved(self, surfaces: &[MemberNames]) -> Result<MaskedPair, Located> {
        let located = |span: Option<&Span>, fault: Fault| match span.or(self.span.as_ref()) {
            Some(span) => Located::at(span, fault),
            None => Located::nowhere(fault),
        };
        let meant = |named: &NamedMember| {
            let found =
                found(std::slice::from_ref(named), surfaces, MemberNames::all, Fault::unknown_surface);
            found.map_err(|(span, fault)| located(span.as_ref(), fault))
        };
        let (emitters, receivers) = (meant(&self.emitter)?, meant(&self.receiver)?);
        check_mask_cells(self.cells.unwrap_or(1)).map_err(|fault| located(None, fault))?;
        if emitters.iter().all(|emitter| receivers.iter().all(|receiver| receiver == emitter)) {
            let cause = format!("{:?} is the emitter and the receiver of a mask", self.emitter.name);
            let cure = "name two surfaces; what a surface hides of itself is in its transfers";
            return Err(located(self.receiver.span.as_ref(), Fault::conflict(cause, cure)));
        }
        let cells = self.cells.and_then(NonZeroUsize::new);
        let (emitter, receiver) = (self.emitter.name, self.receiver.name);
        Ok(MaskedPair { emitter, receiver, emitters, receivers, cells })
    }
}

/// Refuses a number of cells along a side of a mask that is out of range.
///
/// # Errors
/// [`FaultKind::OutOfRange`](crate::FaultKind::OutOfRange).
pub fn check_mask_cells(cells: usize) -> Result<(), Fault> {
    let inside = (1..=MOST_MASK_CELLS).contains(&cells);
    check_range(cells as f64, inside, "the number of cells", "1 ≤ cells ≤ 1000")
}
