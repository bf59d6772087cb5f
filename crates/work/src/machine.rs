//! The speed of this machine, for what is told of times.
//!
//! A forecast is a sum of counts times prices, in seconds of [`FORECAST_THREADS`] threads of the machine on
//! which prices were measured. It is the same on any machine, and so are the ways that are chosen by it. On w
//! threads of this machine
//!
//! ```text
//! seconds by the clock = forecast × slowness × FORECAST_THREADS / w ,
//! ```
//!
//! where the slowness is the time of a fixed walk through a table of boxes over [`USUAL`], its time on that
//! machine. Rays, on which most of the time goes, walk in the same manner: each step waits for the outcome of
//! the one before.

use std::hint::black_box;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use crate::ranks::machine_share::available;

/// Threads that forecasts are of, whatever the number that works. Chosen.
pub const FORECAST_THREADS: f64 = 2.0;

/// Seconds of a walk on the machine of the prices. Measured: the walk on another machine, over the median of what 42
/// runs took there beside their forecasts (`studies/coverage/forecasts.py`).
const USUAL: f64 = 3.5e-4;

/// Steps of a walk, walks of which the quickest counts, and boxes of the table, which fill a cache of the second level.
/// Chosen.
const STEPS: usize = 1 << 15;
const WALKS: usize = 4;
const BOXES: usize = 1 << 12;

/// Threads of this machine, beside those of forecasts.
#[derive(Clone, Copy, Debug)]
pub struct Machine {
    pub(crate) threads: usize,
    pub(crate) slowness: f64,
}

impl Machine {
    /// So many threads of this machine, at least one; more than it has processors are as quick as these. Its speed
    /// is measured at the first call, which takes a millisecond.
    pub fn of(threads: usize) -> Self {
        static SLOWNESS: OnceLock<f64> = OnceLock::new();
        Self { threads: threads.clamp(1, available()), slowness: *SLOWNESS.get_or_init(slowness) }
    }

    /// Seconds by the clock in which these threads do what a forecast tells.
    pub fn seconds(&self, forecast: f64) -> f64 {
        forecast * self.slowness * FORECAST_THREADS / self.threads as f64
    }

    /// The forecast of what these threads do in so many seconds by the clock.
    pub fn forecast(&self, seconds: f64) -> f64 {
        seconds * self.threads as f64 / (self.slowness * FORECAST_THREADS)
    }
}

/// The time of a walk here over that on the machine of the prices.
fn slowness() -> f64 {
    let table = Table::new();
    let quickest = (0..WALKS).map(|_| table.time_of_walk()).min().unwrap_or_default();
    quickest.as_secs_f64() / USUAL
}

/// Boxes in random places.
struct Table {
    boxes: Vec<[[f64; 2]; 3]>,
}

impl Table {
    fn new() -> Self {
        // Numerical Recipes, "ranqd1".
        let mut state = 1_u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state) / f64::from(u32::MAX)
        };
        let mut side = || {
            let [low, width] = [random(), random()];
            [low, low + width]
        };
        Self { boxes: (0..BOXES).map(|_| [side(), side(), side()]).collect() }
    }

    fn time_of_walk(&self) -> Duration {
        let begun = Instant::now();
        black_box(self.walk(black_box([0.6, 0.8, 1.2])));
        begun.elapsed()
    }

    /// Length of a ray in the boxes on a walk that goes on by what it meets.
    fn walk(&self, slopes: [f64; 3]) -> f64 {
        let mut place = 0;
        let mut sum = 0.0;
        for step in 0..STEPS {
            let inside = self.boxes[place].iter().zip(slopes).fold(
                [0.0_f64, f64::MAX],
                |[near, far], (side, slope)| {
                    let [first, last] = side.map(|at| at * slope);
                    [near.max(first), far.min(last)]
                },
            );
            let is_met = inside[0] < inside[1];
            sum += if is_met { (inside[1] - inside[0]).sqrt() } else { 0.0 };
            place = (place * 5 + step + 1 + usize::from(is_met)) % BOXES;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_threads_take_less_and_a_slower_machine_more() {
        let machine = |threads, slowness| Machine { threads, slowness };
        assert_eq!(machine(2, 1.0).seconds(10.0), 10.0);
        assert_eq!(machine(1, 1.0).seconds(10.0), 20.0);
        assert_eq!(machine(8, 1.5).seconds(10.0), 3.75);
        let own = machine(3, 0.7);
        assert!((own.forecast(own.seconds(4.0)) - 4.0).abs() < 1e-12);
    }

    #[test]
    fn a_machine_has_a_speed_and_one_thread_at_least() {
        let [alone, none] = [1, 0].map(|threads| Machine::of(threads).seconds(1.0));
        assert!(alone > 0.0 && alone.is_finite());
        assert_eq!(alone, none);
    }
}
