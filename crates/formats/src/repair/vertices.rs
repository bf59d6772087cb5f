//! Vertices that repeat their neighbours, and spikes: outlines that run to a point and straight back.

use std::collections::VecDeque;

use glam::DVec3;
use radiosity_fit::outline::tolerance;
use radiosity_geom::distance_to_segment;
use radiosity_photometry::note_text::NoteText;

use crate::model::{Model, Shape};
use crate::repair::record::{RepairKind, Repairs, counted};

/// Takes out vertices that repeat their neighbours, and spikes. Other vertices stay, also those of no effect.
pub(super) fn mend(model: &mut Model, asked: Option<f64>, repairs: &mut Repairs) {
    for surface in &mut model.surfaces {
        let Shape::Polygon { outline, holes } = &mut surface.shape else { continue };
        let tolerance = tolerance(outline, asked);
        let mut found = Found::default();
        for ring in std::iter::once(outline).chain(holes.iter_mut()) {
            found.mend(ring, tolerance);
        }
        holes.retain(|hole| hole.len() > 2);
        if found.is_some() {
            let text =
                NoteText::default().naming(&surface.name).then(format!(" has {}, taken out", found.text()));
            repairs.say(RepairKind::Vertices, vec![surface.name.clone()], Some(surface), text);
        }
    }
}

/// Numbers of vertices that were taken out, by their fault.
#[derive(Default)]
struct Found {
    repeated: usize,
    spikes: usize,
}

impl Found {
    fn is_some(&self) -> bool {
        self.repeated + self.spikes > 0
    }

    fn text(&self) -> String {
        let parts = [(self.repeated, "repeated point"), (self.spikes, "spike")];
        let told: Vec<String> =
            parts.iter().filter(|(count, _)| *count > 0).map(|(count, noun)| counted(*count, noun)).collect();
        told.join(" and ")
    }

    /// Takes points out of a ring until none repeats its neighbour or is the tip of a spike.
    fn mend(&mut self, ring: &mut Vec<DVec3>, tolerance: f64) {
        let faulty = (0..ring.len()).any(|k| {
            let [a, b, c] = [0, 1, 2].map(|step| ring[(k + step) % ring.len()]);
            Fault::at(a, b, c, tolerance).is_some()
        });
        if !faulty {
            return;
        }
        let mut kept: VecDeque<DVec3> = VecDeque::with_capacity(ring.len());
        for x in ring.iter() {
            kept.push_back(*x);
            while self.settle_end(&mut kept, tolerance) {}
        }
        while self.settle_seam(&mut kept, tolerance) {}
        *ring = kept.into();
    }

    fn count(&mut self, fault: Fault) {
        match fault {
            Fault::Repeated => self.repeated += 1,
            Fault::Spike => self.spikes += 1,
        }
    }

    /// Takes out the last but one point, or the last, if the last three are at fault.
    fn settle_end(&mut self, kept: &mut VecDeque<DVec3>, tolerance: f64) -> bool {
        let Some(last) = kept.len().checked_sub(1) else { return false };
        if last > 0 && kept[last].distance(kept[last - 1]) <= tolerance {
            self.count(Fault::Repeated);
            kept.pop_back();
            return false;
        }
        if last < 2 || Fault::at(kept[last - 2], kept[last - 1], kept[last], tolerance).is_none() {
            return false;
        }
        self.count(Fault::Spike);
        kept.remove(last - 1);
        true
    }

    /// Takes out one point where the ring closes, if there is a fault.
    fn settle_seam(&mut self, kept: &mut VecDeque<DVec3>, tolerance: f64) -> bool {
        let count = kept.len();
        if count < 3 {
            return false;
        }
        // The tip of the fault, and its neighbours; the first points of the ring are kept rather than the
        // last.
        for tip in [count - 1, 0, count - 2, 1] {
            let [a, b, c] = [count - 1, 0, 1].map(|step| kept[(tip + step) % count]);
            if let Some(fault) = Fault::at(a, b, c, tolerance) {
                let is_first = matches!(fault, Fault::Repeated) && b.distance(c) > tolerance;
                let taken = if is_first && tip == 0 { count - 1 } else { tip };
                self.count(fault);
                kept.remove(taken);
                return true;
            }
        }
        false
    }
}

/// Fault of a point between its neighbours.
enum Fault {
    Repeated,
    Spike,
}

impl Fault {
    fn at(a: DVec3, b: DVec3, c: DVec3, tolerance: f64) -> Option<Fault> {
        if a.distance(b) <= tolerance || b.distance(c) <= tolerance {
            return Some(Fault::Repeated);
        }
        let is_back = (b - a).dot(c - b) < 0.0;
        let is_spike =
            distance_to_segment(c, [a, b]) <= tolerance || distance_to_segment(a, [b, c]) <= tolerance;
        (is_back && is_spike).then_some(Fault::Spike)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mended(points: &[[f64; 2]]) -> (Vec<[f64; 2]>, [usize; 2]) {
        let mut ring: Vec<DVec3> = points.iter().map(|[x, y]| DVec3::new(*x, *y, 0.0)).collect();
        let mut found = Found::default();
        found.mend(&mut ring, 1e-9);
        (ring.iter().map(|x| [x.x, x.y]).collect(), [found.repeated, found.spikes])
    }

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

    #[test]
    fn repeated_points_are_kept_once() {
        let [a, b, c, d] = SQUARE;
        assert_eq!(mended(&[a, a, b, c, c, c, d, a]), (SQUARE.to_vec(), [4, 0]));
        assert_eq!(mended(&SQUARE), (SQUARE.to_vec(), [0, 0]));
        assert_eq!(mended(&[a, b, [1.0, 1e-10], c, d]), (SQUARE.to_vec(), [1, 0]));
    }

    #[test]
    fn spikes_go_wherever_the_ring_begins() {
        let [a, b, c, d] = SQUARE;
        let ring = [a, b, c, [2.0, 1.0], [3.0, 1.0], [2.0, 1.0], c, d];
        for turn in 0..ring.len() {
            let mut ring = ring;
            ring.rotate_left(turn);
            let (found, [repeated, spikes]) = mended(&ring);
            assert_eq!(found.len(), 4, "{turn}: {found:?}");
            assert!(SQUARE.iter().all(|x| found.contains(x)) && repeated + spikes == 4);
        }
    }

    #[test]
    fn a_point_of_no_effect_stays_and_a_fold_goes() {
        let [a, b, c, d] = SQUARE;
        assert_eq!(mended(&[a, [0.5, 0.0], b, c, d]).1, [0, 0]);
        assert_eq!(mended(&[a, [1.5, 0.0], b, c, d]), (SQUARE.to_vec(), [0, 1]));
    }
}
