//! Ranges along arcs of circles.

use std::f64::consts::TAU;

/// Least and most of a cos φ + b sin φ over a range of φ.
pub(crate) fn arc_range(a: f64, b: f64, [start, end]: [f64; 2]) -> [f64; 2] {
    let at = |angle: f64| a * angle.cos() + b * angle.sin();
    let (p, q) = (at(start), at(end));
    let amplitude = a.hypot(b);
    let crest = b.atan2(a);
    let passes = |angle: f64| angle + TAU * ((start - angle) / TAU).ceil() <= end;
    let most = if passes(crest) { amplitude } else { p.max(q) };
    let least = if passes(crest + 0.5 * TAU) { -amplitude } else { p.min(q) };
    [least, most]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn arcs_are_bounded_tightly(a in -1.0..1.0, b in -1.0..1.0, start in -7.0..7.0, sweep in 0.01..TAU) {
            let [least, most] = arc_range(a, b, [start, start + sweep]);
            let samples = (0..=1000).map(|k| start + sweep * f64::from(k) / 1000.0).map(|x: f64| a * x.cos() + b * x.sin());
            let (low, high) = samples.fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
            prop_assert!(least <= low + 1e-14 && high <= most + 1e-14);
            prop_assert!(low - least < 1e-4 && most - high < 1e-4);
        }
    }
}
