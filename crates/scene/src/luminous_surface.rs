//! Luminaires of an extent → the surfaces that send their light: black ones, one for each side that shines.

use radiosity_fit::sides::back_of;
use std::sync::Arc;

use radiosity_geom::shapes::{Disk, FULL_TURN, Parallelogram};
use radiosity_geom::{ShapeError, Surface};

use crate::{
    covering::Covering,
    error::{Located, title},
    extent::Extent,
    fault::Fault,
    luminaire::Luminaire,
    luminous_area::LuminousArea,
    material::Material,
    radiance::Radiance,
    surface_draft::{DraftPlaces, NamedShape, SurfaceDraft},
    thermal::{Condition, Thermal},
};

/// Name of the material of luminous areas, and their kind in messages.
const LUMINAIRE: &str = "luminaire";

/// The surfaces that send the light of the luminaire `own`, whose place in a file `typed` gives; none for a
/// point or a line.
pub fn luminous_surfaces(
    own: &Luminaire,
    typed: impl Fn() -> Option<DraftPlaces>,
) -> Result<Vec<SurfaceDraft>, Located> {
    let shape = shape(own).map_err(|error| {
        let fault = Fault::from(error);
        let located = match typed() {
            Some(typed) => Located::at(&typed.shape, fault),
            None => Located::nowhere(fault),
        };
        located.within(|| title("luminaire", &own.name))
    })?;
    let Some(shape) = shape else { return Ok(Vec::new()) };
    let [front, back] = LuminousArea::sides(own);
    let front = front.map(|area| LitSide { area, name: own.name.clone(), flip: false });
    let back = back.map(|area| LitSide { area, name: back_of(&own.name), flip: true });
    let lit = front.into_iter().chain(back);
    Ok(lit.map(|side| draft(own, side, Arc::clone(&shape), typed())).collect())
}

/// The luminous area of a luminaire, which faces along its aim; none for a point or a line.
fn shape(own: &Luminaire) -> Result<Option<Arc<dyn Surface>>, ShapeError> {
    let [x, y] = own.axes();
    Ok(match own.extent {
        Extent::Point | Extent::Line { .. } => None,
        Extent::Rectangle { sides } => {
            let (x, y) = (sides[0] * x, sides[1] * y);
            // y × x is along the aim.
            Some(Arc::new(Parallelogram::new(own.position - 0.5 * (x + y), y, x)?))
        }
        Extent::Disk { diameter } => {
            Some(Arc::new(Disk::new(own.position, own.aim, 0.5 * diameter, 0.0, FULL_TURN)?))
        }
    })
}

/// A side of a luminous area that shines.
struct LitSide {
    area: LuminousArea,
    /// Name of the surface that it becomes.
    name: String,
    /// Whether it is the back.
    flip: bool,
}

fn draft(
    own: &Luminaire,
    side: LitSide,
    shape: Arc<dyn Surface>,
    typed: Option<DraftPlaces>,
) -> SurfaceDraft {
    let LitSide { area, name, flip } = side;
    let size = shape.area();
    let emission = area.flux().into_iter().map(|flux| flux / size).collect();
    SurfaceDraft {
        kind: LUMINAIRE,
        shapes: vec![NamedShape { name: name.clone(), shape }],
        name,
        front: Covering::new(LUMINAIRE, Material { emission, ..Material::black(own.strength.len()) }),
        back: None,
        group: own.group.as_ref().map(|group| group.name.clone()),
        flux: None,
        opening: None,
        radiance: Some(Radiance::Luminaire(Arc::new(area))),
        // In `heat` the surface is adiabatic: it sends out as much as it absorbs.
        thermal: Thermal { emissivity: Some(1.0), condition: Some(Condition::HeatFlux(0.0)), back: None },
        order: None,
        subdivide: None,
        two_sided: false,
        flip,
        typed,
    }
}
