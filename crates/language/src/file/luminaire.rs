//! Luminaires as typed.

use radiosity_geom::DVec3;
use radiosity_scene::{
    Distribution, Extent, Fault,
    error::Located,
    place::{At, Span},
    tree::{Node, Value},
};
use serde_json::json;

use crate::{
    fields::{exactly, real, text},
    file::per_band::{AMOUNTS, PerBand},
    keys::{DefaultValue, GivenFields, KeyTable, NameKey, ValueKind, keys},
    kinds::{POINT, TEXT, VECTOR},
    terms,
};

keys! {
    /// `[[luminaires]]`.
    LuminaireFile("A lamp by its intensity in each direction", terms::required("oneOf", &DISTRIBUTIONS); check) {
        name: At<String> = NameKey, "Its name, given once in its list";
        position: DVec3 = POINT, "Where it is";
        aim: Option<At<DVec3>> = VECTOR.or(DefaultValue::Numbers(&[0.0, 0.0, -1.0])), "Where it aims";
        along: Option<At<DVec3>> = VECTOR, "The direction of the plane C = 0 of its photometric file";
        extent: Option<At<ExtentFile>> = ValueKind::new(extent, extent_schema),
            "What its light comes out of, across the aim: a disk, a rectangle, a line, or the opening of its photometric file";
        flux: Option<PerBand> = AMOUNTS, "All its light, W or lm";
        intensity: Option<PerBand> = AMOUNTS, "The peak of its intensity, W/sr or cd, instead of the flux";
        group: Option<At<String>> = TEXT, "Its light group";
        dimming: Option<At<f64>> =
            ValueKind::number(real, terms::at_least_zero).or(DefaultValue::Number(1.0)),
            "Factor on its light";
        point: Option<PointFile> = ValueKind::new(PointFile::read, PointFile::schema), "";
        spot: Option<Distribution> = ValueKind::new(spot, SpotFile::schema), "";
        photometry: Option<At<String>> = TEXT, "Path of a photometric file, .ies or .ldt, from the folder of this one";
        ..span: Span;
    }
}

keys! {
    /// `point = {}`.
    PointFile("The same intensity all around") {}
}

keys! {
    /// `{ angle = 40, edge = 5 }` or `{ exponent = 2 }`.
    SpotFile("A cone of light, or a power of the cosine"; check_spot) {
        angle: Option<f64> =
            ValueKind::number(real, || json!({ "exclusiveMinimum": 0, "exclusiveMaximum": 360 })),
            "Angle across the cone, to half the peak, degrees";
        edge: f64 =
            ValueKind::number(real, || json!({ "minimum": 0, "maximum": 179 })).or(DefaultValue::Number(0.0)),
            "Angle over which the peak falls to nothing, degrees";
        exponent: Option<f64> =
            ValueKind::number(real, || json!({ "minimum": 0, "maximum": 10000 })),
            "Exponent n of the cosine, instead of angle and edge";
        ..span: Span;
    }
}

/// Extent that the light of a luminaire comes out of.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ExtentFile {
    Typed(Extent),
    /// The luminous opening of its photometric file.
    OfTable,
}

/// The keys that say how light is spread, of which one is given.
const DISTRIBUTIONS: [&str; 3] = ["point", "spot", "photometry"];

/// The extent that is that of the photometric file.
const OF_TABLE: &str = "file";

/// Light is spread in one way, and a table alone tells how much there is.
fn check(own: &LuminaireFile, fields: &GivenFields<'_>) -> Result<(), Located> {
    if own.point.is_none() && own.spot.is_none() && own.photometry.is_none() {
        let fault = Fault::absent(
            "nothing says how the light is spread over directions",
            "add point = {} for the same intensity all around, spot = { angle = 40, edge = 5 }, or photometry = \"lamp.ies\"",
        );
        return Err(Located::at(&own.span, fault));
    }
    fields.at_most_one(&DISTRIBUTIONS)?;
    fields.at_most_one(&["flux", "intensity"])?;
    match own.strength().is_some() || own.photometry.is_some() {
        true => Ok(()),
        false => Err(Located::at(&own.span, Fault::no_flux())),
    }
}

impl LuminaireFile {
    /// The numbers of its flux or of its intensity; none where a photometric file states them.
    pub(crate) fn strength(&self) -> Option<&PerBand> {
        self.flux.as_ref().or(self.intensity.as_ref())
    }
}

/// A diameter, two sides, or the word that stands for those of the photometric file.
fn extent(node: &Node) -> Result<ExtentFile, Located> {
    let typed = match &node.value {
        Value::Text(_) => {
            let word = text(node)?.value;
            return match word == OF_TABLE {
                true => Ok(ExtentFile::OfTable),
                false => Err(Located::at(&node.span, Fault::unknown_key(&word, &[OF_TABLE]))),
            };
        }
        Value::List(_) | Value::Points(_) => Extent::rectangle(exactly(node, "an extent", "sides", real)?),
        _ => Extent::disk(real(node)?),
    };
    typed.map(ExtentFile::Typed).map_err(|fault| Located::at(&node.span, fault))
}

fn extent_schema() -> serde_json::Value {
    let diameter = terms::positive("");
    let side =
        terms::ranged(terms::at_least_zero(), "Side along C = 0, then along C = 90; one of 0 makes a line");
    let sides = terms::with(terms::exactly(2, "number", "Sides"), "items", side);
    json!({ "anyOf": [diameter["anyOf"][0], diameter["anyOf"][1], sides, { "const": OF_TABLE }] })
}

fn check_spot(own: &SpotFile, fields: &GivenFields<'_>) -> Result<(), Located> {
    let other = ["angle", "edge"].into_iter().find_map(|key| Some((key, fields.get(key)?)));
    match (own.exponent, other) {
        (Some(_), Some((first, node))) => Err(Located::at(&node.span, Fault::exclusive(first, "exponent"))),
        _ => Ok(()),
    }
}

fn spot(node: &Node) -> Result<Distribution, Located> {
    let SpotFile { angle, edge, exponent, span } = SpotFile::read(node)?;
    let spot = match (exponent, angle) {
        (Some(exponent), _) => Distribution::Power { exponent },
        (None, Some(angle)) => Distribution::Cone { angle, edge },
        (None, None) => return Err(Located::at(&span, Fault::missing_key("angle", ""))),
    };
    spot.check().map_err(|fault| Located::at(&node.span, fault))?;
    Ok(spot)
}
