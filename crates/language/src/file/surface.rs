//! Surfaces as typed.

use radiosity_geom::Motion;
use radiosity_scene::{
    MAX_ORDER, MAX_PARTS,
    place::{At, Span},
    ranges::{check_order, check_parts},
};

use crate::{
    fields::{counted, exactly},
    file::{
        per_band::{AMOUNTS, PerBand},
        sky::GlassFile,
        thermal::ConditionFile,
    },
    keys::{KeyTable, NameKey, ValueKind, keys},
    kinds::{FLAG, TEXT, TRANSFORM, TRUTH},
    shape::{ShapeFile, one_shape},
    terms,
};

keys! {
    /// `[[surfaces]]`.
    SurfaceFile("A surface, with exactly one shape", one_shape()) {
        name: At<String> = NameKey, "Its name, given once in the scene";
        material: Option<At<String>> = TEXT, "The name of its material";
        back_material: Option<At<String>> = TEXT, "The name of the material of its back, where it is two-sided";
        group: Option<At<String>> = TEXT, "Its light group";
        flux: Option<PerBand> = AMOUNTS, "Flux that it emits, W or lm, instead of its material's emission";
        opening: Option<At<bool>> = TRUTH, "It sends the light of the sky behind it";
        glass: Option<At<GlassFile>> = ValueKind::new(GlassFile::read, GlassFile::schema), "";
        order: Option<usize> = ValueKind::new(|node| counted(node, check_order), || terms::whole(0, MAX_ORDER, "")),
            "Degree of the polynomials";
        subdivide: Option<[usize; 2]> = ValueKind::new(
            |node| exactly(node, "subdivide", "numbers", |node| counted(node, check_parts)),
            || terms::with(terms::exactly(2, "number", ""), "items", terms::whole(1, MAX_PARTS, "Elements")),
        ), "Elements along u and v";
        two_sided: bool = FLAG, "The back emits and receives as well";
        flip: bool = FLAG, "Turns the front over";
        transform: Option<Motion> = TRANSFORM, "";
        ..condition: ConditionFile;
        ..shape: ShapeFile;
        ..span: Span;
    }
}

impl SurfaceFile {
    /// Place of `opening = true`, or of `glass`, which fills an opening; none where the surface is no opening.
    pub(crate) fn opening(&self) -> Option<&Span> {
        match (&self.opening, &self.glass) {
            (Some(opening), _) => opening.value.then_some(&opening.span),
            (None, glass) => glass.as_ref().map(|glass| &glass.span),
        }
    }
}
