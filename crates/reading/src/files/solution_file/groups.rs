//! The light groups in the file: the coefficients of each in one piece, as text of the bytes that they are.

use std::ops::Range;
use std::sync::Arc;

use base64::{Engine, prelude::BASE64_STANDARD as STANDARD};
use radiosity_solve::solution::group_light::{GroupLight, Incident};
use radiosity_solve::solution::powers::Powers;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The light of each group, not dimmed; none where the scene has no groups.
#[derive(Debug, Default)]
pub(super) struct SavedGroups(Arc<[GroupLight]>);

impl SavedGroups {
    /// The file's groups of a solution.
    pub(super) fn of(groups: Arc<[GroupLight]>) -> Self {
        Self(groups)
    }

    /// The groups, without light through masks where they were read.
    pub(super) fn list(&self) -> &[GroupLight] {
        &self.0
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether each group has so many coefficients in each of so many bands.
    pub(super) fn are_full(&self, bands: usize, coefficients: usize) -> bool {
        let is_full =
            |own: &Incident| own.irradiance.len() == coefficients && own.direct.len() == coefficients;
        self.0.iter().all(|group| group.bands.len() == bands && group.bands.iter().all(is_full))
    }

    /// The largest coefficient in a range, by its absolute value.
    pub(super) fn largest(&self, range: &Range<usize>) -> f64 {
        let bands = self.0.iter().flat_map(|group| &group.bands);
        let all =
            bands.flat_map(|own| own.irradiance[range.clone()].iter().chain(&own.direct[range.clone()]));
        all.map(|own| own.abs()).fold(0.0, f64::max)
    }
}

impl Serialize for SavedGroups {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().map(SavedGroup::of))
    }
}

impl<'de> Deserialize<'de> for SavedGroups {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let groups = Vec::<ReadGroup>::deserialize(deserializer)?;
        Ok(Self(groups.into_iter().map(|ReadGroup(group)| group).collect()))
    }
}

/// A group that was read.
#[derive(Deserialize)]
#[serde(try_from = "SavedGroup")]
struct ReadGroup(GroupLight);

/// A light group, not dimmed.
#[derive(Serialize, Deserialize)]
struct SavedGroup {
    /// Null for the light of surfaces without a group.
    name: Option<String>,
    powers: Powers,
    bands: Vec<SavedBand>,
}

/// Light of a group in one band: coefficients in the orthonormal bases, element by element (W m⁻² times scene
/// length), as the Base64 (RFC 4648, section 4) of IEEE 754 numbers of 64 bits, low byte first.
#[derive(Serialize, Deserialize)]
struct SavedBand {
    /// Relative residual.
    residual: f64,
    irradiance: String,
    direct: String,
}

impl SavedGroup {
    fn of(light: &GroupLight) -> Self {
        let band = |own: &Incident| SavedBand {
            residual: own.residual,
            irradiance: encoded(&own.irradiance),
            direct: encoded(&own.direct),
        };
        let GroupLight { group, powers, bands, .. } = light;
        Self { name: group.clone(), powers: *powers, bands: bands.iter().map(band).collect() }
    }
}

impl TryFrom<SavedGroup> for ReadGroup {
    type Error = &'static str;

    fn try_from(SavedGroup { name, powers, bands }: SavedGroup) -> Result<Self, Self::Error> {
        let band = |own: &SavedBand| {
            let [irradiance, direct] = [&own.irradiance, &own.direct].map(|text| decoded(text));
            Some(Incident { irradiance: irradiance?, direct: direct?, residual: own.residual })
        };
        let bands: Option<Vec<Incident>> = bands.iter().map(band).collect();
        let bands = bands.ok_or("coefficients of a light group that are no numbers in Base64")?;
        Ok(Self(GroupLight { group: name, bands, powers, masked: None }))
    }
}

fn encoded(numbers: &[f64]) -> String {
    let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    STANDARD.encode(bytes)
}

/// The numbers of a text; None where it is none of finite ones.
fn decoded(text: &str) -> Option<Vec<f64>> {
    let bytes = STANDARD.decode(text).ok()?;
    let (numbers, rest) = bytes.as_chunks::<8>();
    let numbers: Vec<f64> = numbers.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
    (rest.is_empty() && numbers.iter().all(|number| number.is_finite())).then_some(numbers)
}
