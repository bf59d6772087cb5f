//! Chosen pairs of shadow masks as typed.

use radiosity_scene::{
    masked_pair::{MOST_MASK_CELLS, check_mask_cells},
    place::{At, Span},
};

use crate::{
    fields::{counted, text},
    keys::{ValueKind, keys},
    terms,
};

keys! {
    /// `[[masks]]`.
    MaskFile("A pair of surfaces whose light goes through a shadow mask with --shadows mask") {
        emitter: At<String> = NAME, "The surface that sends the light: a surface, an entry or an instance, a * stands for any ending";
        receiver: At<String> = NAME, "The surface that the light falls on, named alike";
        cells: Option<usize> =
            ValueKind::new(|node| counted(node, check_mask_cells), || terms::whole(1, MOST_MASK_CELLS, "")),
            "Cells along each side of the mask of an element; as --mask-cells says unless given";
        ..span: Span;
    }
}

/// The name of a surface.
const NAME: ValueKind<String> = ValueKind::new(|node| Ok(text(node)?.value), || terms::text(""))
    .example(", the name of a surface, such as \"lamp\"");
