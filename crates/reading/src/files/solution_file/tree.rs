//! The tree of the file.

use std::collections::{BTreeMap, BTreeSet};

use base64::{Engine, prelude::BASE64_STANDARD as STANDARD};
use radiosity_elements::Discretization;
use radiosity_elements::mesh::Mesh;
use radiosity_published::zatz1993::masked_light::MaskedLight;
use radiosity_scene::{Scene, Source};
use radiosity_solve::Options;
use radiosity_solve::solution::Solution;
use radiosity_solve::solved::Solved;
use radiosity_work::checksum::Checksum;
use serde::{Deserialize, Serialize};

use super::element::{self, SavedElement};
use super::error::{SolutionFault, VERSION};
use super::figures::Figures;
use super::groups::SavedGroups;

/// Value of the key `format`, by which a solution file is recognised.
pub(super) const FORMAT: &str = "radiosity-solution";

/// Instructions for reading the numbers, for whoever opens the file.
const EVALUATION: &str = "On an element of order N, at coordinates (a, b) in [-1, 1]^2, irradiance = sum over k of \
     irradiance[band][k] p_i(a) p_j(b), with p_n(x) = sqrt(n + 1/2) P_n(x) (Legendre) and k running over total degree \
     d = 0..N ascending, within d over j = 0..d with i = d - j (basis total-degree-legendre), or k = i (N + 1) + j with \
     i, j = 0..N (basis tensor-legendre). On a plane frame a = (x - origin).first and \
     b = (x - origin).second for a point x, less scene.middle where that is given; on a parameter frame a = (u - center_u)/half_u, b = (v - center_v)/half_v. \
     An element that is covered is the part of its surface on which another lies; others end there. \
     radiosity = exitance[band] + reflectance[band] * irradiance, and transmittance times the irradiance on the other side where the scene's text gives the \
     material one; of materials that vary over a surface these are means over the element, and the text of the scene holds their patterns, \
     the files of which are in scene.pictures. Unit: that of the scene's exitance (W/m^2 unless the scene states a unit). \
     orthonormal holds the irradiance, and the part of it that comes straight from the emitters, in the basis that is \
     orthonormal on the element with respect to area: the program reads these back. Where there are light groups, the \
     irradiance is the sum of theirs, each times its factor in scene.factors, or 1: groups hold their coefficients in the \
     orthonormal bases, element by element, per band, as the Base64 of IEEE 754 numbers of 64 bits, low byte first; so is the exitance that of the scene's text times its factor.";

/// The file's tree.
#[derive(Debug, Serialize, Deserialize)]
pub struct SolutionFile {
    format: String,
    format_version: u32,
    /// CRC-32 of the file with 0 in this place, as JSON without blanks.
    checksum: u32,
    /// Version of the program that wrote it.
    program: String,
    pub(super) scene: SavedScene,
    pub(super) bands: Vec<String>,
    evaluation: String,
    pub(super) options: Options,
    pub(super) discretization: Discretization,
    /// Cells and orders of each surface where they were refined from these.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) mesh: Option<Mesh>,
    pub(super) figures: Figures,
    /// The light groups, not dimmed; none where the scene has none.
    #[serde(default, skip_serializing_if = "SavedGroups::is_empty")]
    pub(super) groups: SavedGroups,
    /// Light through shadow masks, of each group or of all light; empty where nothing is masked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) masked: Vec<MaskedLight>,
    pub(super) elements: Vec<SavedElement>,
}

/// The scene as it was read.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct SavedScene {
    pub(super) name: String,
    /// The name shown in messages.
    pub(super) origin: String,
    /// TOML or JSON; null for a scene of a `SceneBuilder`, which cannot be read back.
    pub(super) text: Option<String>,
    /// The texts that it includes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) included: Vec<SavedText>,
    /// The pictures of its materials.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) pictures: Vec<SavedPicture>,
    /// The files that were read outside its folder, of which messages show nothing.
    #[serde(default, skip_serializing_if = "BTreeSet::is_empty")]
    pub(super) outside: BTreeSet<String>,
    /// Distance within which corners were made to agree, if the user gave one (scene length).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) tolerance: Option<f64>,
    /// The moment, a real number of frames, of a scene in which something moves.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) moment: Option<f64>,
    /// Values of variables in the text that were set, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) settings: BTreeMap<String, f64>,
    /// Factors on the emission in the text, by light groups; those that are not dimmed are left out.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) factors: BTreeMap<String, f64>,
    /// Vector subtracted from the coordinates of a scene far from the origin: frames refer to this point.
    #[serde(default, skip_serializing_if = "is_origin")]
    middle: [f64; 3],
}

/// A text that the scene includes.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct SavedText {
    /// The name shown in messages, by which it is included.
    pub(super) origin: String,
    pub(super) text: String,
}

/// A picture that the scene names.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct SavedPicture {
    /// The path by which it is named.
    pub(super) origin: String,
    /// The bytes of its file in Base64 (RFC 4648, section 4).
    pub(super) base64: String,
}

/// The pictures that a scene names.
fn pictures(scene: &Scene) -> Vec<SavedPicture> {
    let saved = |(origin, bytes): (&str, &[u8])| SavedPicture {
        origin: origin.to_owned(),
        base64: STANDARD.encode(bytes),
    };
    scene.source.iter().flat_map(Source::pictures).map(saved).collect()
}

/// The texts that a scene includes.
fn included(scene: &Scene) -> Vec<SavedText> {
    let saved = |(origin, text): (&str, &str)| SavedText { origin: origin.to_owned(), text: text.to_owned() };
    scene.source.iter().flat_map(Source::included).map(saved).collect()
}

fn is_origin(middle: &[f64; 3]) -> bool {
    *middle == [0.0; 3]
}

/// The light through masks of each group of a solution, or of all its light.
fn masked(solution: &Solution) -> Vec<MaskedLight> {
    match solution.groups() {
        [] => solution.masked().into_iter().cloned().collect(),
        groups => groups.iter().filter_map(|group| group.masked.as_deref().cloned()).collect(),
    }
}

/// The factors of the groups of `scene` that are dimmed.
fn factors(scene: &Scene) -> BTreeMap<String, f64> {
    let dimmed = scene.light_groups().into_iter().filter(|group| group.factor != 1.0);
    dimmed.map(|group| (group.name.clone(), group.factor)).collect()
}

impl SolutionFile {
    /// The file of a solved scene.
    pub fn new(solved: &Solved) -> Self {
        let Solved { scene, options, outcome, .. } = solved;
        Self {
            format: FORMAT.to_owned(),
            format_version: VERSION,
            checksum: 0,
            program: env!("CARGO_PKG_VERSION").to_owned(),
            scene: SavedScene {
                name: scene.name.clone(),
                origin: scene.origin.clone(),
                text: scene.source.as_ref().map(|source| source.text().into_owned()),
                included: included(scene),
                pictures: pictures(scene),
                outside: scene.source.as_ref().map(|source| source.outside().clone()).unwrap_or_default(),
                tolerance: scene.source.as_ref().and_then(|source| source.tolerance),
                moment: scene.source.as_ref().and_then(|source| source.moment),
                settings: scene.source.as_ref().map(|source| (*source.settings).clone()).unwrap_or_default(),
                factors: factors(scene),
                middle: scene.middle.to_array(),
            },
            bands: scene.bands.clone(),
            evaluation: EVALUATION.to_owned(),
            options: *options,
            discretization: *outcome.solution.elements().discretization(),
            mesh: outcome.solution.elements().refined_mesh().cloned(),
            figures: Figures::of(solved),
            groups: SavedGroups::of(outcome.solution.shared_groups()),
            masked: masked(&outcome.solution),
            elements: element::all(scene, &outcome.solution),
        }
        .sealed()
    }

    /// The file with the checksum of its content.
    #[must_use]
    pub fn sealed(mut self) -> Self {
        self.checksum = self.sum();
        self
    }

    /// The file, if its checksum is that of its content.
    pub(super) fn whole(mut self) -> Result<Self, SolutionFault> {
        let stated = self.checksum;
        if self.sum() == stated { Ok(self) } else { Err(SolutionFault::Damaged) }
    }

    /// The sum of the file with 0 in the place of its checksum, where it then is.
    fn sum(&mut self) -> u32 {
        self.checksum = 0;
        let mut sum = Checksum::default();
        serde_json::to_writer(&mut sum, self).expect("a sum takes all bytes");
        sum.sum()
    }

    /// Power that the scene emits, its light groups not dimmed.
    pub(super) fn emitted(&self) -> f64 {
        let groups: f64 = self.groups.list().iter().map(|group| group.powers.emitted).sum();
        groups.max(self.figures.powers().emitted)
    }
}
