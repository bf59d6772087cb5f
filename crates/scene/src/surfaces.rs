//! Drafts → the surfaces of one scene: shapes fitted together, names unique, no surface in another.

use std::collections::BTreeSet;

use radiosity_fit::sides::front_of;
use radiosity_fit::{coincident::Occupied, middle};
use radiosity_geom::{Aabb, Bvh, DVec3};
use radiosity_work::interruption::check_interrupt;

use crate::{
    error::{Located, title},
    fault::{Fault, FaultKind},
    fitted::{self, Fitted},
    luminaire::Luminaire,
    names::UniqueNames,
    outlook::KnownOutlooks,
    place::Span,
    surface::SceneSurface,
    surface_draft::SurfaceDraft,
};

/// The surfaces of a scene, with the changes to their shapes.
pub struct Surfaces {
    /// The surfaces, in order.
    pub list: Vec<SceneSurface>,
    /// Maker of each surface.
    pub makers: Vec<Maker>,
    /// The vector subtracted from all coordinates (scene length).
    pub middle: DVec3,
    /// Changes to their shapes, made to fit them together.
    pub fitted: Fitted,
}

/// The draft that a surface was made from, and its front.
pub struct Maker {
    /// Index of the draft.
    pub draft: usize,
    /// The name of its front.
    pub front: String,
}

/// The surfaces of all drafts, in order, with unique names and none in another. Their shapes are fitted
/// together within `tolerance` (scene length), or within the tolerance of the input.
pub fn fitted_surfaces(
    drafts: impl IntoIterator<Item = Result<SurfaceDraft, Located>>,
    tolerance: Option<f64>,
) -> Result<Surfaces, Located> {
    let drafts = drafts.into_iter().collect::<Result<Vec<_>, _>>()?;
    drafts.iter().try_for_each(SurfaceDraft::check_extents)?;
    let mut drafts = drafts.into_iter().map(SurfaceDraft::lit).collect::<Result<Vec<_>, _>>()?;
    tolerance.map_or(Ok(()), check_tolerance)?;
    let middle = middle::of(drafts.iter().flat_map(|draft| &draft.shapes).map(|own| &own.shape));
    let fitted = fitted::fit(&mut drafts, middle, tolerance);
    let (list, makers) = named(&drafts)?;
    if list.is_empty() {
        Err(Located::nowhere(Fault::absent(
            "the scene has no surface",
            "add a [[surfaces]] entry with a name, a material and a shape",
        )))
    } else {
        Ok(Surfaces { list, makers, middle, fitted })
    }
}

/// The materials of these that no surface has.
pub fn unused_materials<'a>(
    names: impl IntoIterator<Item = &'a str>,
    surfaces: &[SceneSurface],
) -> Vec<String> {
    let used: BTreeSet<&str> = surfaces.iter().filter_map(|own| own.material_name.as_deref()).collect();
    names.into_iter().filter(|name| !used.contains(name)).map(str::to_owned).collect()
}

/// Whether each surface, then each luminaire, emits.
pub fn emitting(surfaces: &[SceneSurface], luminaires: &[Luminaire]) -> Vec<bool> {
    let surfaces = surfaces.iter().map(SceneSurface::is_source);
    surfaces.chain(luminaires.iter().map(Luminaire::is_source)).collect()
}

/// The surfaces of all drafts, with unique names and none in another, and their makers.
fn named(drafts: &[SurfaceDraft]) -> Result<(Vec<SceneSurface>, Vec<Maker>), Located> {
    let mut names = UniqueNames::default();
    let mut occupied = Vec::new();
    let mut surfaces = Vec::new();
    let mut outlooks = KnownOutlooks::default();
    let mut makers = Vec::new();
    for (index, draft) in drafts.iter().enumerate() {
        check_interrupt();
        let typed = draft.typed.as_ref();
        let shapes = draft.shapes.iter().map(|shape| draft.sides(shape, &mut outlooks));
        let shapes: Vec<Vec<SceneSurface>> = shapes.collect();
        for side in shapes.iter().flatten() {
            let name = names.add(&side.name, typed.and_then(|typed| typed.name_line.clone()));
            name.map_err(|fault| draft.located(typed.map(|typed| &typed.name), fault))?;
        }
        for sides in shapes {
            occupied.push(OccupiedSpace {
                name: sides[0].name.clone(),
                occupied: Occupied::new(&sides[0].shape),
                span: typed.map(|typed| typed.shape.clone()),
            });
            let maker = || Maker { draft: index, front: sides[0].name.clone() };
            makers.extend(sides.iter().map(|_| maker()));
            let (first, count) = (surfaces.len(), sides.len());
            surfaces.extend(sides.into_iter().enumerate().map(|(side, own)| SceneSurface {
                other_side: (count == 2).then_some(first + 1 - side),
                ..own
            }));
        }
    }
    check_apart(&occupied)?;
    Ok((surfaces, makers))
}

/// Refuses a tolerance that is no finite length ≥ 0.
fn check_tolerance(value: f64) -> Result<(), Located> {
    match value.is_finite() && value >= 0.0 {
        true => Ok(()),
        false => {
            let fault = Fault::out_of_range("the tolerance length", value, "0 ≤ length");
            Err(Located::nowhere(fault))
        }
    }
}

/// The space that a surface occupies, with its name and the place of its shape in a file.
struct OccupiedSpace {
    name: String,
    occupied: Occupied,
    span: Option<Span>,
}

impl OccupiedSpace {
    /// Whether this is the back of `front`: named so, and facing away.
    fn is_back_of(&self, front: &OccupiedSpace) -> bool {
        front_of(&self.name) == Some(front.name.as_str()) && self.occupied.opposes(&front.occupied)
    }
}

fn coincident(other: &str) -> Fault {
    let cause = format!("coincides with surface {other:?}");
    let cure = format!(
        "remove one of the two, move them apart by a millionth of their size or more, or cut a hole into {other:?} where \
         this one lies; for both sides of one surface use two_sided = true"
    );
    Fault::new(FaultKind::Coincident, cause, cure)
}

/// Refuses the first surface that lies in an earlier one, except backs.
fn check_apart(occupied: &[OccupiedSpace]) -> Result<(), Located> {
    let boxes: Vec<Aabb> = occupied.iter().map(|space| *space.occupied.bounds()).collect();
    let tree = Bvh::build(&boxes);
    for (index, own) in occupied.iter().enumerate() {
        let near = tree.near(own.occupied.bounds()).into_iter().filter(|other| *other < index);
        let clashes = |other: &&OccupiedSpace| {
            other.occupied.coincides(&own.occupied) && !own.is_back_of(other) && !other.is_back_of(own)
        };
        if let Some(other) = near.map(|other| &occupied[other]).find(clashes) {
            let fault = coincident(&other.name);
            let located = match &own.span {
                Some(span) => Located::at(span, fault),
                None => Located::nowhere(fault),
            };
            return Err(located.within(|| title("surface", &own.name)));
        }
    }
    Ok(())
}
