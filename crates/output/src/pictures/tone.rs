//! Tones: from linear light, exposed, to the light that a screen shows, both 1 for white.
//!
//! Light up to K = 0.8 of white stays as it is, so that greys keep their ratios. Brighter light would be
//! burnt out above white; a shoulder lets it approach white instead,
//!
//! ```text
//! y = 1 − (1 − K) e^(−(x − K)/(1 − K)) ,     x > K ,
//! ```
//!
//! of slope 1 at K: within a step of eight bits of white from x = 2 on. It maps the greatest channel x of a
//! colour, the others keep their ratios to it, so that the hue stays. What is much brighter than white then
//! turns towards white, by the part
//!
//! ```text
//! g = 1 − 1/(1 + D (x − y)) ,     D = 0.15 .
//! ```
//!
//! References: H. Uchimura, *HDR theory and practice*, CEDEC 2017 (the shoulder); Khronos Group, *PBR Neutral
//! tone mapper*, 2024 (the greatest channel, K, g and D).

/// K, as a share of white.
const KNEE: f64 = 0.8;

/// D, the pace at which bright colours turn towards white.
const DESATURATION: f64 = 0.15;

/// A map from linear light to the light that a screen shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// In proportion, cut off at white channel by channel.
    Linear,
    /// In proportion up to a knee, then with a shoulder.
    Shoulder,
}

impl Tone {
    /// The colour on the screen, in [0, 1], of linear light that is not negative.
    pub(super) fn shown(self, light: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Linear => light.map(|x| x.min(1.0)),
            Self::Shoulder => shoulder(light),
        }
    }
}

fn shoulder(light: [f64; 3]) -> [f64; 3] {
    let greatest = light.into_iter().fold(0.0, f64::max);
    if greatest <= KNEE {
        return light;
    }
    let room = 1.0 - KNEE;
    let shown = 1.0 - room * (-(greatest - KNEE) / room).exp();
    let towards_white = 1.0 - 1.0 / (1.0 + DESATURATION * (greatest - shown));
    light.map(|x| {
        let kept = x * shown / greatest;
        kept + towards_white * (shown - kept)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shoulder_leaves_the_knee_smoothly_and_ends_at_white() {
        let shown = |x: f64| Tone::Shoulder.shown([x; 3])[0];
        for x in [0.0, 0.1, 0.5, KNEE] {
            assert_eq!(shown(x), x, "below the knee nothing changes");
        }
        let step = 1e-4;
        let slope = |x: f64| (shown(x + step) - shown(x)) / step;
        assert!((slope(KNEE) - 1.0).abs() < 1e-3);
        for x in (0..100).map(|k| f64::from(k) / 20.0) {
            assert!(slope(x) > 0.0 && slope(x) <= 1.0 + 1e-9 && shown(x) < 1.0, "{x}");
        }
        assert!(shown(2.0) > 254.0 / 255.0);
        assert_eq!(shown(1e9), 1.0);
    }

    #[test]
    fn bright_colours_keep_their_hue_and_turn_white() {
        let hue = |[r, g, b]: [f64; 3]| (g - b) / (r - b);
        for brightness in [0.5, 0.9, 2.0, 20.0] {
            let light = [1.0, 0.5, 0.25].map(|x| x * brightness);
            let shown = Tone::Shoulder.shown(light);
            assert!((hue(shown) - hue(light)).abs() < 1e-9, "{brightness}: {shown:?}");
            assert!(shown.iter().all(|x| (0.0..=1.0).contains(x)));
        }
        assert!(Tone::Shoulder.shown([1e4, 1.0, 0.0]).into_iter().all(|x| x > 0.99));
        assert_eq!(Tone::Linear.shown([0.9, 1.2, 0.0]), [0.9, 1.0, 0.0]);
    }
}
