//! Photometric files written from intensities in closed form.

use std::fmt::Write;

use glam::DVec3;

use super::direction;

/// Intensity by direction, cd.
pub(super) type Intensity = fn(DVec3) -> f64;

/// Angles from `start` to `end` in even steps.
pub(super) fn steps(start: f64, end: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|index| start + (end - start) * index as f64 / count as f64).collect()
}

fn joined(values: &[f64]) -> String {
    values.iter().map(|value| format!("{value:.9}")).collect::<Vec<_>>().join(" ")
}

/// An LM-63 file, angles in degrees and intensities in candelas.
pub(super) struct Ies {
    /// Lines up to `TILT=NONE`, inclusive.
    pub(super) header: &'static str,
    pub(super) lumens: f64,
    /// Multiplier of the candelas in the file.
    pub(super) multiplier: f64,
    /// Ballast factor and the number behind it.
    pub(super) ballast: [f64; 2],
    pub(super) gammas: Vec<f64>,
    pub(super) planes: Vec<f64>,
    pub(super) intensity: Intensity,
    /// Divisor of the intensities in the file.
    pub(super) divisor: f64,
}

impl Ies {
    pub(super) fn text(&self) -> String {
        let mut text = format!(
            "{}\n1 {} {} {} {} 1 2 -0.2 -0.2 0\n{} {} 30\n",
            self.header,
            self.lumens,
            self.multiplier,
            self.gammas.len(),
            self.planes.len(),
            self.ballast[0],
            self.ballast[1]
        );
        writeln!(text, "{}\n{}", joined(&self.gammas), joined(&self.planes)).expect("strings take all");
        for c in &self.planes {
            let row = self.gammas.iter().map(|gamma| (self.intensity)(direction(*c, *gamma)).max(0.0));
            writeln!(text, "{}", joined(&row.map(|value| value / self.divisor).collect::<Vec<_>>()))
                .expect("strings take all");
        }
        text
    }
}

/// An EULUMDAT file, angles in degrees and intensities in candelas.
pub(super) struct Eulumdat {
    pub(super) isym: usize,
    /// Angles of all planes C around the luminaire.
    pub(super) planes: Vec<f64>,
    /// Angles of the planes that have intensities in the file, in the file's order.
    pub(super) stated: Vec<f64>,
    pub(super) gammas: Vec<f64>,
    /// Flux of the lamps, lm, and light output ratio.
    pub(super) flux: f64,
    pub(super) output_ratio: f64,
    pub(super) intensity: Intensity,
}

impl Eulumdat {
    pub(super) fn text(&self) -> String {
        let mut lines: Vec<String> = vec!["Works".into(), "1".into(), self.isym.to_string()];
        lines.extend([self.planes.len().to_string(), "0".into(), self.gammas.len().to_string(), "0".into()]);
        lines.extend(["R 1", "Luminaire", "4711", "lamp.ldt", "1990"].map(str::to_owned));
        lines.extend(["1200", "300", "80", "1170", "270", "0", "0", "0", "0"].map(str::to_owned));
        lines.extend(["100".into(), (100.0 * self.output_ratio).to_string(), "1".into(), "0".into()]);
        lines.extend(["1".into(), "2".into(), "T16 28 W".into(), self.flux.to_string()]);
        lines.extend(["4000 K", "1B", "62"].map(str::to_owned));
        lines.extend((0..10).map(|index| format!("0.{index}")));
        lines.extend(self.planes.iter().chain(&self.gammas).map(f64::to_string));
        for c in &self.stated {
            lines.extend(self.gammas.iter().map(|gamma| {
                let intensity = (self.intensity)(direction(*c, *gamma)).max(0.0);
                format!("{:.6}", intensity * 1000.0 / self.flux)
            }));
        }
        lines.join("\r\n") + "\r\n"
    }
}
