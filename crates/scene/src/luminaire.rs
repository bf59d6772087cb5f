//! Luminaires: lamps given by the intensity that they send in each direction, from a point or evenly from an
//! extent.
//!
//! At a point x with the unit normal n, at the distance r in the unit direction −ω from the luminaire,
//!
//! ```text
//! E = I(ω) cos θ / r² ,     cos θ = −n·ω        W m⁻² (lx where intensity is in cd)
//! ```
//!
//! (the law of inverse squares and cosines, J. H. Lambert, *Photometria*, 1760), for each piece of its extent
//! ([`crate::Extent`]).

use radiosity_geom::{DVec3, Motion, PARALLEL_DIRECTIONS};

use crate::{
    distribution::Distribution,
    extent::Extent,
    fault::Fault,
    light_group::LightGroup,
    material::{check_count, check_flux},
    names::check_name,
    place::Place,
    ranges::{check_number, check_range},
};

/// Angle (degrees) within which the intensity of an area may not fall from its peak to nothing. Chosen: a
/// point then sees the edge in some thousand cells of the area, of which 20000 are visited at most.
const STEEP: f64 = 0.5;

/// A lamp.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Luminaire {
    /// Name, unique among the luminaires of the scene.
    pub name: String,
    /// Position (scene length), in the coordinates that the scene is computed in.
    pub position: DVec3,
    /// The unit vector along which it aims: −z of its frame, γ = 0.
    pub aim: DVec3,
    /// The unit vector along x of its frame, in the plane C = 0.
    pub along: DVec3,
    /// Distribution of its intensity over directions.
    pub distribution: Distribution,
    /// Point, line or area that its light comes out of, with its middle in `position`. An area is a surface
    /// of the scene too, of the same name.
    pub extent: Extent,
    /// Factor on the relative intensities, per band (W/sr; a number for tables), not dimmed by its light
    /// group.
    pub strength: Vec<f64>,
    /// Factor of each band that a motion has put on its strength, which holds it; none where that is as it is
    /// at rest, or where it sends nothing at rest.
    pub emission_factors: Option<Vec<f64>>,
    /// Its light group, if it has one.
    pub group: Option<LightGroup>,
    /// Its place in the file; none if it was made in code.
    pub place: Option<Place>,
}

/// Amount of light that a luminaire sends, per band.
#[derive(Clone, Debug, PartialEq)]
pub enum Strength {
    /// Flux in all directions together (W, or lm).
    Flux(Vec<f64>),
    /// Intensity where it is largest (W/sr, or cd).
    Intensity(Vec<f64>),
    /// Intensities as its table states them (cd), in each of so many bands.
    AsMeasured(usize),
}

impl Luminaire {
    /// The luminaire `name` at `position` (scene length), which aims along −z, the plane C = 0 along x.
    ///
    /// # Errors
    /// A number that is not finite or out of range, a blank name; what is missing where no table says
    /// how much light it sends.
    pub fn new(
        name: impl Into<String>,
        position: DVec3,
        distribution: Distribution,
        strength: Strength,
    ) -> Result<Self, Fault> {
        let name = name.into();
        check_name(&name)?;
        position.to_array().into_iter().try_for_each(check_number)?;
        distribution.check()?;
        let strength = strength.factors(&distribution)?;
        let (aim, along) = (-DVec3::Z, DVec3::X);
        Ok(Self {
            name,
            position,
            aim,
            along,
            distribution,
            extent: Extent::Point,
            strength,
            emission_factors: None,
            group: None,
            place: None,
        })
    }

    /// The luminaire aimed along `aim` of any length; the plane C = 0 contains x, or y where it aims along x.
    ///
    /// # Errors
    /// A vector without a length.
    pub fn aimed(self, aim: DVec3) -> Result<Self, Fault> {
        aim.to_array().into_iter().try_for_each(check_number)?;
        let aim = aim.try_normalize().ok_or_else(no_aim)?;
        let along = [DVec3::X, DVec3::Y].into_iter().find_map(|axis| across(axis, aim));
        Ok(Self { aim, along: along.unwrap_or(self.along), ..self })
    }

    /// The luminaire turned about its aim until `along` lies in the half-plane C = 0.
    ///
    /// # Errors
    /// A vector along the aim, or without a length.
    pub fn turned(self, along: DVec3) -> Result<Self, Fault> {
        along.to_array().into_iter().try_for_each(check_number)?;
        let along = along
            .try_normalize()
            .and_then(|along| across(along, self.aim))
            .ok_or_else(|| Fault::no_direction("along", "give a direction across the aim, e.g. [1, 0, 0]"))?;
        Ok(Self { along, ..self })
    }

    /// The luminaire with light that comes out of `extent`.
    ///
    /// # Errors
    /// An area where intensity falls so steeply that its light could not be
    /// integrated.
    pub fn of_extent(self, extent: Extent) -> Result<Self, Fault> {
        let sides = self.distribution.hemispheres();
        if extent.is_area() && sides.iter().flatten().any(|side| side.scale < STEEP) {
            let cure = "give the spot an edge of 1 degree or more, or its table an angle at which it is dark; or leave the \
                        extent out for a point";
            return Err(Fault::bad_extent("its intensity falls to nothing within half a degree", cure));
        }
        Ok(Self { extent, ..self })
    }

    /// The luminaire at `factor` ≥ 0 of its strength.
    ///
    /// # Errors
    /// A factor that is not finite or out of range.
    pub fn at_factor(mut self, factor: f64) -> Result<Self, Fault> {
        check_range(factor, factor >= 0.0, "the dimming", "dimming ≥ 0; 1 is full")?;
        self.strength.iter_mut().for_each(|strength| *strength *= factor);
        Ok(self)
    }

    /// The luminaire as a member of the light group `name`.
    ///
    /// # Errors
    /// A blank name.
    pub fn in_group(self, name: impl Into<String>) -> Result<Self, Fault> {
        let name = name.into();
        check_name(&name)?;
        Ok(Self { group: Some(LightGroup::new(name)), ..self })
    }

    /// The luminaire moved by `motion`, its extent scaled along with it.
    pub fn moved(self, motion: &Motion) -> Self {
        let [aim, along] = [self.aim, self.along].map(|axis| motion.direction(axis));
        let (position, extent) = (motion.point(self.position), self.extent.scaled(motion.scale()));
        Self { position, aim, along, extent, ..self }
    }

    /// The luminaire after `middle` was subtracted from all coordinates.
    pub fn about(self, middle: DVec3) -> Self {
        Self { position: self.position - middle, ..self }
    }

    /// Checks that there is a strength for each of `bands` bands.
    pub(super) fn check(&self, bands: usize) -> Result<(), Fault> {
        check_count("the flux or intensity", &self.strength, bands)
    }

    /// The unit vectors along x and y of its frame, C = 0 and C = 90.
    pub(crate) fn axes(&self) -> [DVec3; 2] {
        [self.along, self.along.cross(self.aim)]
    }

    /// Vector from the middle of its line to an end (scene length); zero for a point and for areas.
    pub fn half_line(&self) -> DVec3 {
        self.extent.half_line(self.axes())
    }

    /// Relative intensity in a unit direction from it; times a band's strength it is the intensity.
    pub fn relative(&self, direction: DVec3) -> f64 {
        let [x, y] = self.axes().map(|axis| axis.dot(direction));
        self.distribution.relative(DVec3::new(x, y, -self.aim.dot(direction)))
    }

    /// The angle γ of a unit direction, degrees.
    pub(super) fn gamma(&self, direction: DVec3) -> f64 {
        self.aim.cross(direction).length().atan2(self.aim.dot(direction)).to_degrees()
    }

    /// Whether both spread their light alike over directions.
    pub fn is_aimed_as(&self, other: &Self) -> bool {
        self.aim == other.aim && self.along == other.along && self.distribution == other.distribution
    }

    /// Flux of a band (W), not dimmed by its light group.
    pub fn flux(&self, band: usize) -> f64 {
        self.strength[band] * self.distribution.flux_factor()
    }

    /// Multiplies its strength in each band by a factor, if it sends anything.
    pub(crate) fn dim(&mut self, factors: &[f64]) {
        if self.emits() {
            self.strength.iter_mut().zip(factors).for_each(|(strength, factor)| *strength *= factor);
            self.emission_factors = Some(factors.to_vec());
        }
    }

    /// Whether it sends light, or would if no motion had dimmed it to nothing.
    pub fn is_source(&self) -> bool {
        self.emits() || self.emission_factors.is_some()
    }

    /// Whether it sends light in any band.
    pub fn emits(&self) -> bool {
        self.strength.iter().any(|strength| *strength > 0.0)
    }

    /// The factor of its light group; 1 without a group.
    pub fn factor(&self) -> f64 {
        self.group.as_ref().map_or(1.0, |group| group.factor)
    }

    /// Whether it is a member of the light group `name`; of no group for None.
    pub fn is_in(&self, group: Option<&str>) -> bool {
        self.group.as_ref().map(|own| own.name.as_str()) == group
    }
}

/// The unit vector in the plane of two, at right angles to the second; None if both lie along one line.
pub fn across(along: DVec3, aim: DVec3) -> Option<DVec3> {
    let across = along.reject_from_normalized(aim);
    if across.length() > PARALLEL_DIRECTIONS { across.try_normalize() } else { None }
}

fn no_aim() -> Fault {
    Fault::no_direction("aim", "give a direction, e.g. [0, 0, -1], which is down")
}

impl Strength {
    /// Factors on the relative intensities of a distribution.
    fn factors(self, distribution: &Distribution) -> Result<Vec<f64>, Fault> {
        let (numbers, over) = match self {
            Self::Flux(flux) => {
                flux.iter().try_for_each(|flux| check_flux(*flux))?;
                (flux, distribution.flux_factor())
            }
            Self::Intensity(intensity) => {
                intensity.iter().try_for_each(|intensity| check_intensity(*intensity))?;
                (intensity, distribution.peak())
            }
            Self::AsMeasured(bands) if matches!(distribution, Distribution::Table(_)) => {
                (vec![1.0; bands], 1.0)
            }
            Self::AsMeasured(_) => return Err(Fault::no_flux()),
        };
        let factors: Vec<f64> = numbers.into_iter().map(|number| number / over).collect();
        // A table that is dark everywhere cannot be scaled.
        factors.iter().try_for_each(|factor| check_number(*factor))?;
        Ok(factors)
    }
}

/// Checks that an intensity is finite and ≥ 0.
pub fn check_intensity(value: f64) -> Result<(), Fault> {
    check_range(value, value >= 0.0, "the intensity", "intensity ≥ 0")
}
