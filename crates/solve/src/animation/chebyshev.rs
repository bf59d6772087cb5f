//! Interpolation through whole frames near nested Chebyshev points.
//!
//! ```text
//! x_k = cos(π k / n) ,   k = 0 … n ,
//! p(t) = Σ_k w_k f_k/(t − t_k) / Σ_k w_k/(t − t_k) ,   w_k = 1/Π_{j≠k} (t_k − t_j)
//! ```
//!
//! The points of n intervals are among those of 2 n, and so are the frames t_k nearest to them. An analytic
//! function is met to ρ^−n, ρ the sum of the half axes of the ellipse with the foci ±1 in which it is
//! analytic. The interpolant through rounded points is as stable: wherever there are frames enough, Σ_k
//! |ℓ_k(t)| < 4 at all frames for n ≤ 16, where the points themselves have 3. (J.-P. Berrut, L. N. Trefethen,
//! *Barycentric Lagrange interpolation*, SIAM Rev. 46 (2004), 501–517. doi:10.1137/S0036144502417715)

use std::f64::consts::PI;

/// Point number `k` of `intervals` + 1 in [−1, 1], ascending; exactly symmetric.
fn point(k: usize, intervals: usize) -> f64 {
    let (k, n) = (k as f64, intervals as f64);
    // −cos(π k/n), by the sine of the distance from the middle.
    (PI * (2.0 * k - n) / (2.0 * n)).sin()
}

/// The frames nearest to the points of `intervals` (a power of two) between these ends, ascending, each
/// another one; None where there are too few frames.
pub(super) fn frames([first, last]: [usize; 2], intervals: usize) -> Option<Vec<usize>> {
    let mut frames = vec![first, last];
    while frames.len() <= intervals {
        let finer = 2 * (frames.len() - 1);
        let between = frames.windows(2).enumerate().map(|(k, ends)| {
            let place = 0.5 * (1.0 + point(2 * k + 1, finer)) * (last - first) as f64;
            let nearest = first + place.round() as usize;
            (ends[1] - ends[0] > 1).then(|| nearest.clamp(ends[0] + 1, ends[1] - 1))
        });
        frames.extend(between.collect::<Option<Vec<usize>>>()?);
        frames.sort_unstable();
    }
    Some(frames)
}

/// The factors of the values at these frames, two or more, in the interpolant at a moment; their sum is 1.
pub(super) fn factors(frames: &[usize], moment: f64) -> Vec<f64> {
    let places: Vec<f64> = frames.iter().map(|frame| *frame as f64).collect();
    if let Some(met) = places.iter().position(|place| *place == moment) {
        return (0..places.len()).map(|k| if k == met { 1.0 } else { 0.0 }).collect();
    }
    // Four of these units are the length: products neither grow nor vanish.
    let unit = 0.25 * (places[places.len() - 1] - places[0]);
    let part = |place: &f64| {
        let others = places.iter().filter(|other| *other != place);
        1.0 / others.map(|other| (place - other) / unit).product::<f64>() / (moment - place)
    };
    let parts: Vec<f64> = places.iter().map(part).collect();
    let sum: f64 = parts.iter().sum();
    parts.into_iter().map(|part| part / sum).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LEVELS: [usize; 3] = [4, 8, 16];

    #[test]
    fn frames_are_nested_and_within_half_a_frame_of_the_points_where_these_are_apart() {
        assert_eq!(frames([0, 100], 4), Some(vec![0, 15, 50, 85, 100]));
        for last in 8..300 {
            let [four, eight, sixteen] = LEVELS.map(|intervals| frames([7, 7 + last], intervals));
            let is_part = |coarse: &Option<Vec<usize>>, fine: &Option<Vec<usize>>| {
                let (Some(coarse), Some(fine)) = (coarse, fine) else { return true };
                fine.iter().step_by(2).eq(coarse)
            };
            assert!(is_part(&four, &eight) && is_part(&eight, &sixteen), "{last}");
            let four = four.expect("there are nine frames");
            for (k, frame) in four.iter().enumerate() {
                let place = 7.0 + 0.5 * last as f64 * (1.0 - (PI * k as f64 / 4.0).cos());
                assert!((*frame as f64 - place).abs() < 0.5 + 1e-9, "{last} {k} {frame}");
            }
        }
        assert_eq!(frames([0, 7], 8), None);
    }

    #[test]
    fn interpolants_are_stable_whatever_the_number_of_frames() {
        for intervals in LEVELS {
            for last in 2 * intervals..400 {
                let Some(frames) = frames([0, last], intervals) else { continue };
                let at = |frame: usize| factors(&frames, frame as f64).iter().map(|x| x.abs()).sum();
                let most = (0..=last).map(at).fold(0.0, f64::max);
                assert!(most < 4.0, "{intervals} {last} {most}");
            }
        }
    }

    #[test]
    fn polynomials_are_met() {
        for (intervals, last) in [(1, 3), (2, 9), (4, 9), (4, 100), (8, 30), (16, 60), (16, 999)] {
            let frames = frames([5, 5 + last], intervals).expect("there are enough");
            let scaled = |moment: f64| 2.0 * (moment - 5.0) / last as f64 - 1.0;
            for place in [0.0, 0.13, 0.5, 0.55, 0.99, 1.0] {
                let moment = 5.0 + place * last as f64;
                for power in 0..=intervals as i32 {
                    let factors = factors(&frames, moment);
                    let sum: f64 = factors
                        .iter()
                        .zip(&frames)
                        .map(|(factor, frame)| factor * scaled(*frame as f64).powi(power))
                        .sum();
                    assert!((sum - scaled(moment).powi(power)).abs() < 1e-13, "{intervals} {moment} {power}");
                }
            }
        }
    }

    #[test]
    fn analytic_functions_are_met_as_fast_as_their_ellipse_says() {
        // 1/(1 + 4 x²) has its poles at ±i/2: ρ = (1 + √5)/2.
        let runge = |x: f64| 1.0 / (1.0 + 4.0 * x * x);
        let error = |intervals: usize| {
            let frames = frames([0, 200_000], intervals).expect("there are enough");
            let scaled = |moment: f64| moment / 100_000.0 - 1.0;
            let at = |moment: f64| {
                let values = factors(&frames, moment).into_iter().zip(&frames);
                values.map(|(factor, frame)| factor * runge(scaled(*frame as f64))).sum::<f64>()
                    - runge(scaled(moment))
            };
            (0..1000).map(|k| at(200.0 * f64::from(k)).abs()).fold(0.0, f64::max)
        };
        let rate = (error(16) / error(32)).powf(1.0 / 16.0);
        assert!((rate - 0.5 * (1.0 + 5f64.sqrt())).abs() < 0.02, "{rate}");
    }
}
