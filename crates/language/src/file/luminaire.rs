//! Luminaires as typed.

use radiosity_geom::DVec3;
use radiosity_scene::{
    Distribution, Extent, Fault,
    error::{Located, luminaire_title},
    place::{At, Span},
    tree::{Node, Value, entry},
};

use crate::{
    fields::{Fields, exactly, list, number, point, real, table, text},
    file::per_band::{PerBand, per_band},
    include::PHOTOMETRY,
};

/// `[[luminaires]]`.
#[derive(Debug)]
pub(crate) struct LuminaireFile {
    pub name: At<String>,
    pub span: Span,
    pub position: DVec3,
    pub aim: Option<At<DVec3>>,
    pub along: Option<At<DVec3>>,
    pub distribution: DistributionFile,
    pub extent: Option<At<ExtentFile>>,
    /// Flux or intensity; none where a photometric file states it.
    pub strength: Option<StrengthFile>,
    pub group: Option<At<String>>,
    pub dimming: Option<At<f64>>,
}

/// Distribution of a luminaire's light over directions.
#[derive(Debug)]
pub(crate) enum DistributionFile {
    Formula(Distribution),
    /// The path of a photometric file.
    Table(At<String>),
}

/// Extent that the light of a luminaire comes out of.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ExtentFile {
    Typed(Extent),
    /// The luminous opening of its photometric file.
    OfTable,
}

/// Strength of a luminaire: flux, or intensity, per band.
#[derive(Debug)]
pub(crate) enum StrengthFile {
    Flux(PerBand),
    Intensity(PerBand),
}

impl StrengthFile {
    /// The numbers of the bands.
    pub(crate) fn numbers(&self) -> &PerBand {
        match self {
            Self::Flux(numbers) | Self::Intensity(numbers) => numbers,
        }
    }
}

/// The extent that is that of the photometric file.
const OF_TABLE: &str = "file";

const LUMINAIRE_KEYS: [&str; 12] = [
    "name",
    "position",
    "aim",
    "along",
    "extent",
    "flux",
    "intensity",
    "group",
    "dimming",
    "point",
    "spot",
    PHOTOMETRY,
];

/// The list of luminaires; `prefix` stands before the names of those that are given none.
pub(crate) fn read_luminaires(node: &Node, prefix: &str) -> Result<Vec<LuminaireFile>, Located> {
    let read = |(index, node)| {
        let name = format!("{prefix}luminaire-{}", index + 1);
        read_luminaire(node, &name)
            .map_err(|error| error.within(|| luminaire_title(&given(node).unwrap_or(name))))
    };
    list(node)?.iter().enumerate().map(read).collect()
}

/// The name in a table that may be wrong otherwise.
fn given(node: &Node) -> Option<String> {
    let name = text(entry(table(node).ok()?, "name")?).ok()?;
    Some(name.value)
}

/// A luminaire, called `unnamed` if it is given no name.
fn read_luminaire(node: &Node, unnamed: &str) -> Result<LuminaireFile, Located> {
    let fields = Fields::new(node, &LUMINAIRE_KEYS)?;
    let distribution = read_distribution(&fields)?;
    Ok(LuminaireFile {
        name: fields.optional("name", text)?.unwrap_or_else(|| At::new(unnamed.to_owned(), fields.span())),
        span: fields.span().clone(),
        position: fields.require("position", point)?,
        aim: fields.optional("aim", direction)?,
        along: fields.optional("along", direction)?,
        extent: fields.optional("extent", extent)?,
        strength: read_strength(&fields, matches!(distribution, DistributionFile::Table(_)))?,
        distribution,
        group: fields.optional("group", text)?,
        dimming: fields.optional("dimming", number)?,
    })
}

fn direction(node: &Node) -> Result<At<DVec3>, Located> {
    Ok(At::new(point(node)?, &node.span))
}

/// A diameter, two sides, or the word that stands for those of the photometric file.
fn extent(node: &Node) -> Result<At<ExtentFile>, Located> {
    let typed = match &node.value {
        Value::Text(_) => {
            let word = text(node)?.value;
            let fault = Fault::unknown_key(&word, &[OF_TABLE]);
            return match word == OF_TABLE {
                true => Ok(At::new(ExtentFile::OfTable, &node.span)),
                false => Err(Located::at(&node.span, fault)),
            };
        }
        Value::List(_) | Value::Points(_) => Extent::rectangle(exactly(node, "an extent", "sides", real)?),
        _ => Extent::disk(real(node)?),
    };
    let typed = typed.map_err(|fault| Located::at(&node.span, fault))?;
    Ok(At::new(ExtentFile::Typed(typed), &node.span))
}

/// Exactly one of the keys that say how its light is spread.
fn read_distribution(fields: &Fields<'_>) -> Result<DistributionFile, Located> {
    let given = ["point", "spot", PHOTOMETRY].into_iter().filter_map(|key| Some((key, fields.get(key)?)));
    let given: Vec<(&'static str, &Node)> = given.collect();
    let (key, node) = match given[..] {
        [] => return Err(Located::at(fields.span(), no_distribution())),
        [one] => one,
        [(first, _), (second, node), ..] => {
            return Err(Located::at(&node.span, Fault::exclusive(first, second)));
        }
    };
    let distribution = match key {
        "point" => Fields::new(node, &[]).map(|_| Distribution::Point)?,
        "spot" => read_spot(node)?,
        _ => return Ok(DistributionFile::Table(text(node)?)),
    };
    distribution.check().map_err(|fault| Located::at(&node.span, fault))?;
    Ok(DistributionFile::Formula(distribution))
}

fn no_distribution() -> Fault {
    Fault::absent(
        "nothing says how the light is spread over directions",
        "add point = {} for the same intensity all around, spot = { angle = 40, edge = 5 }, or photometry = \"lamp.ies\"",
    )
}

/// `{ angle = 40, edge = 5 }` or `{ exponent = 2 }`.
fn read_spot(node: &Node) -> Result<Distribution, Located> {
    let fields = Fields::new(node, &["angle", "edge", "exponent"])?;
    match fields.get("exponent") {
        None => {
            let edge = fields.optional("edge", real)?.unwrap_or(0.0);
            Ok(Distribution::Cone { angle: fields.require("angle", real)?, edge })
        }
        Some(exponent) => {
            for other in ["angle", "edge"] {
                if let Some(given) = fields.get(other) {
                    let fault = Fault::exclusive(other, "exponent");
                    return Err(Located::at(&given.span, fault));
                }
            }
            Ok(Distribution::Power { exponent: real(exponent)? })
        }
    }
}

/// The flux or the intensity, which may be left out where it `is_measured`.
fn read_strength(fields: &Fields<'_>, is_measured: bool) -> Result<Option<StrengthFile>, Located> {
    match (fields.get("flux"), fields.get("intensity")) {
        (Some(_), Some(second)) => {
            let fault = Fault::exclusive("flux", "intensity");
            Err(Located::at(&second.span, fault))
        }
        (None, Some(node)) => Ok(Some(StrengthFile::Intensity(per_band(node)?))),
        (Some(node), None) => Ok(Some(StrengthFile::Flux(per_band(node)?))),
        (None, None) if is_measured => Ok(None),
        (None, None) => Err(Located::at(fields.span(), Fault::no_flux())),
    }
}
