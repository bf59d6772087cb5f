//! Photometric tables in closed form: their files, and what lies between their angles by the published rule.

use std::fmt::Write;

/// Which planes a file states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Symmetry {
    None,
    Axial,
    AboutC0,
    AboutC90,
    Quadrant,
}

/// A table of intensities at even steps of C and γ, degrees.
#[derive(Clone, Copy, Debug)]
pub(super) struct Web {
    pub(super) symmetry: Symmetry,
    /// Step of C, a divisor of 90.
    pub(super) turn: f64,
    /// First and last γ, and the number of steps between them.
    pub(super) gammas: [f64; 2],
    pub(super) steps: usize,
}

/// Luminous flux of the lamps of EULUMDAT files.
const LUMENS: f64 = 1800.0;

impl Web {
    /// Intensity at a node (cd).
    fn node(&self, c: f64, gamma: f64) -> f64 {
        let (c, gamma) = (c.to_radians(), gamma.to_radians());
        let around = match self.symmetry {
            Symmetry::None => 0.3 * (c - 0.7).cos() + 0.2 * (2.0 * c).sin(),
            Symmetry::Axial => 0.0,
            Symmetry::AboutC0 => 0.4 * c.cos(),
            Symmetry::AboutC90 => 0.4 * c.sin(),
            Symmetry::Quadrant => 0.5 * (2.0 * c).cos(),
        };
        // At γ = 0 and 180° all planes agree, as sin γ = 0.
        300.0 * (0.3 + gamma.cos().powi(2) + 0.2 * gamma.cos()) * (1.0 + around * gamma.sin())
    }

    /// Angle γ of a step.
    fn gamma(&self, step: usize) -> f64 {
        let [first, last] = self.gammas;
        first + (last - first) * step as f64 / self.steps as f64
    }

    /// Intensity in a direction given in the frame of the luminaire by its parts along C = 0, C = 90 and the
    /// aim: bilinear in C and γ (cd).
    pub(super) fn intensity(&self, [x, y, aim]: [f64; 3]) -> f64 {
        let gamma = x.hypot(y).atan2(aim).to_degrees();
        let [first, last] = self.gammas;
        if gamma < first || gamma > last {
            return 0.0;
        }
        let along = (gamma - first) / (last - first) * self.steps as f64;
        let step = (along.floor() as usize).min(self.steps - 1);
        let around = y.atan2(x).to_degrees().rem_euclid(360.0) / self.turn;
        let plane = around.floor();
        let row = |plane: f64| {
            let [low, high] = [step, step + 1].map(|k| self.node(plane * self.turn, self.gamma(k)));
            low + (along - step as f64) * (high - low)
        };
        let [low, high] = [row(plane), row(plane + 1.0)];
        low + (around - plane) * (high - low)
    }

    fn planes(&self, first: f64, last: f64) -> Vec<f64> {
        let count = ((last - first) / self.turn).round() as usize;
        (0..=count).map(|k| first + k as f64 * self.turn).collect()
    }

    fn all_gammas(&self) -> Vec<f64> {
        (0..=self.steps).map(|k| self.gamma(k)).collect()
    }

    /// An LM-63 file.
    pub(super) fn ies(&self) -> String {
        let planes = match self.symmetry {
            Symmetry::None => self.planes(0.0, 360.0),
            Symmetry::Axial => vec![0.0],
            Symmetry::AboutC0 => self.planes(0.0, 180.0),
            Symmetry::AboutC90 => self.planes(90.0, 270.0),
            Symmetry::Quadrant => self.planes(0.0, 90.0),
        };
        let gammas = self.all_gammas();
        let mut text = format!(
            "IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] none\nTILT=NONE\n1 -1 1 {} {} 1 2 0 0 0\n1 1 10\n{}\n{}\n",
            gammas.len(),
            planes.len(),
            joined(&gammas),
            joined(&planes)
        );
        for c in planes {
            let row: Vec<f64> = gammas.iter().map(|gamma| self.node(c, *gamma)).collect();
            writeln!(text, "{}", joined(&row)).expect("strings take all");
        }
        text
    }

    /// An EULUMDAT file.
    pub(super) fn eulumdat(&self) -> String {
        let around = self.planes(0.0, 360.0 - self.turn);
        let (isym, stated) = match self.symmetry {
            Symmetry::None => (0, around.clone()),
            Symmetry::Axial => (1, vec![0.0]),
            Symmetry::AboutC0 => (2, self.planes(0.0, 180.0)),
            Symmetry::AboutC90 => (3, self.planes(270.0, 450.0)),
            Symmetry::Quadrant => (4, self.planes(0.0, 90.0)),
        };
        let gammas = self.all_gammas();
        let mut lines: Vec<String> = vec!["Works".into(), "1".into(), isym.to_string()];
        lines.extend([around.len().to_string(), "0".into(), gammas.len().to_string(), "0".into()]);
        lines.extend(["R 1", "Luminaire", "4711", "lamp.ldt", "1990"].map(str::to_owned));
        lines.extend(["1200", "300", "80", "1170", "270", "0", "0", "0", "0"].map(str::to_owned));
        lines.extend(["100", "80", "1", "0", "1", "2", "T16 28 W"].map(str::to_owned));
        lines.push(LUMENS.to_string());
        lines.extend(["4000 K", "1B", "62"].map(str::to_owned));
        lines.extend((0..10).map(|index| format!("0.{index}")));
        lines.extend(around.iter().chain(&gammas).map(f64::to_string));
        for c in stated {
            let row = gammas.iter().map(|gamma| format!("{:.9}", self.node(c, *gamma) * 1000.0 / LUMENS));
            lines.extend(row);
        }
        lines.join("\r\n") + "\r\n"
    }
}

fn joined(values: &[f64]) -> String {
    values.iter().map(|value| format!("{value:.9}")).collect::<Vec<_>>().join("\n")
}
