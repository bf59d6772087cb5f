//! Emission over time: factors on what things emit, band by band.

use crate::{
    fault::Fault,
    ranges::check_factor,
    time_function::{Curve, TimeFunction},
};

/// Factors on what surfaces and luminaires emit, one of each band, by time.
///
/// Before the first of its times and after the last the factors stay. Where a spline falls below 0 the factor
/// is 0: there is no negative light.
#[derive(Clone, Debug, PartialEq)]
pub struct EmissionTrack {
    /// The factor of each band, before negative ones become 0.
    bands: Vec<TimeFunction<f64>>,
}

impl EmissionTrack {
    /// The track of these `factors` ≥ 0 at the `times`, which ascend: at each time one factor of each band.
    /// At 1 things emit what is stated for the scene at rest, at 0 nothing.
    ///
    /// # Errors
    /// A factor out of range or not finite, times with other numbers of bands, none of them included; what
    /// [`TimeFunction::new`] refuses.
    pub fn new(factors: &[Vec<f64>], times: Vec<f64>, curve: Curve) -> Result<Self, Fault> {
        let bands = factors.first().map_or(0, Vec::len);
        if let Some(other) = factors.iter().find(|own| own.len() != bands || own.is_empty()) {
            let expected = format!("{}, one of each band", bands.max(1));
            return Err(Fault::wrong_count("the list of factors of a time", &expected, other.len()));
        }
        factors.iter().flatten().try_for_each(|factor| check_factor(*factor))?;
        let of_band = |band: usize| {
            let values = factors.iter().map(|own| own[band]).collect();
            TimeFunction::new("factors", values, times.clone(), curve)
        };
        // Without factors there is no band that could tell so.
        let bands = (0..bands.max(1)).map(of_band).collect::<Result<_, _>>()?;
        Ok(Self { bands })
    }

    /// Number of its bands.
    pub(crate) fn bands(&self) -> usize {
        self.bands.len()
    }

    /// The factor of each band at a time.
    pub(crate) fn factors(&self, time: f64) -> Vec<f64> {
        let lit = |factor: f64| if factor > 0.0 { factor } else { 0.0 };
        self.bands.iter().map(|band| lit(band.at(time))).collect()
    }

    /// The times between which the factors are smooth: those of given factors, and where a spline falls to
    /// 0 or rises from there.
    pub(crate) fn times(&self) -> Vec<f64> {
        let given = self.bands.first().map_or(&[][..], TimeFunction::times).iter().copied();
        given.chain(self.bands.iter().flat_map(TimeFunction::crossings)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fault::FaultKind;

    fn track(factors: &[&[f64]], curve: Curve) -> Result<EmissionTrack, Fault> {
        let factors: Vec<Vec<f64>> = factors.iter().map(|own| own.to_vec()).collect();
        let times = (0..factors.len()).map(|time| time as f64).collect();
        EmissionTrack::new(&factors, times, curve)
    }

    #[test]
    fn bands_have_factors_of_their_own_and_a_factor_that_stays_stays_to_the_bit() {
        for curve in [Curve::Line, Curve::Spline] {
            let track = track(&[&[1.0, 0.5, 0.3], &[1.0, 0.25, 0.3], &[1.0, 0.0, 0.3]], curve).unwrap();
            for k in -10..=40 {
                let time = 0.1 * f64::from(k);
                let factors = track.factors(time);
                assert_eq!(factors[0], 1.0, "{time}");
                assert!((factors[1] - (0.5 - 0.25 * time.clamp(0.0, 2.0))).abs() < 1e-15, "{time}");
                assert!((factors[2] - 0.3).abs() < 1e-16, "{time}");
            }
        }
    }

    #[test]
    fn a_spline_that_falls_below_nothing_is_dark_there() {
        let natural = |x: f64| {
            let t = (x - 1.5).abs();
            // M = 6/5 at both inner times, 0 at the outer ones.
            if t <= 0.5 { 0.6 * (t * t - 0.25) } else { (t - 0.5) + 0.2 * ((1.5 - t).powi(3) - (1.5 - t)) }
        };
        let track = track(&[&[1.0], &[0.0], &[0.0], &[1.0]], Curve::Spline).unwrap();
        let mut dark = 0;
        for k in 0..=300 {
            let time = 0.01 * f64::from(k);
            let factor = track.factors(time)[0];
            assert!((factor - natural(time).max(0.0)).abs() < 1e-14, "{time} {factor} {}", natural(time));
            dark += u32::from(factor == 0.0);
        }
        assert!(dark > 90, "{dark}");
        // Through 1, 1, 0, 1: it falls on below 0 behind the third value.
        let late = self::track(&[&[1.0], &[1.0], &[0.0], &[1.0]], Curve::Spline).unwrap();
        let times = late.times();
        assert_eq!(times[..4], [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(times.len(), 5);
        let lit = |time: f64| late.factors(time)[0] > 0.0;
        assert!(lit(1.99) && !lit(2.01) && !lit(times[4] - 1e-6) && lit(times[4] + 1e-6));
    }

    #[test]
    fn what_is_no_track_of_factors_is_told() {
        let fault = |factors: &[&[f64]]| track(factors, Curve::Line).unwrap_err();
        assert_eq!(fault(&[&[1.0], &[-0.1]]).kind, FaultKind::OutOfRange);
        assert_eq!(fault(&[&[1.0], &[f64::INFINITY]]).kind, FaultKind::NotFinite);
        assert_eq!(fault(&[&[1.0], &[1.0, 1.0]]).kind, FaultKind::WrongCount);
        assert_eq!(fault(&[&[], &[]]).kind, FaultKind::WrongCount);
        assert_eq!(fault(&[&[1.0]]), Fault::wrong_count("factors", "at least two", 1));
        assert_eq!(fault(&[]), Fault::wrong_count("factors", "at least two", 0));
    }
}
