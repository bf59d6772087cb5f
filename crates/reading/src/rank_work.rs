//! Work done and bytes sent by each rank of a run.

use std::fmt;

use radiosity_work::ranks::{Ranks, Traffic};
use serde::{Deserialize, Serialize};

/// Work done and bytes sent by one rank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RankWork {
    /// Number of threads.
    pub threads: usize,
    /// Terms of the kernel's quadrature rules.
    pub kernel_samples: u64,
    /// Rays that carried pairs of elements, and segments tested for visibility.
    pub rays: u64,
    /// Bytes sent to others: pieces of work, and numbers that products with distributed matrices complete.
    pub bytes_sent: u64,
    /// Bytes sent for products alone.
    pub bytes_of_products: u64,
    /// Number of products with distributed matrices.
    pub products: u64,
    /// Peak memory, where the system reports it.
    pub peak_bytes: Option<u64>,
}

/// Work done and bytes sent by all ranks of a run, in their order; two at the least.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RanksWork(Vec<RankWork>);

impl RankWork {
    /// The work of this rank so far, which has so many threads, 0 for all that it may use.
    fn so_far(ranks: &Ranks, threads: usize) -> Self {
        let Traffic { samples, rays, pieces, numbers, products } = ranks.traffic();
        Self {
            threads: ranks.threads(threads),
            kernel_samples: samples,
            rays,
            bytes_sent: pieces + numbers,
            bytes_of_products: numbers,
            products,
            peak_bytes: peak_bytes(),
        }
    }
}

impl RanksWork {
    /// The work of these ranks so far, of which this one has so many threads, 0 for all that it may use; None
    /// where it is alone. All ranks ask together.
    pub fn so_far(ranks: &Ranks, threads: usize) -> Option<Self> {
        (!ranks.are_alone()).then(|| Self(ranks.all(RankWork::so_far(ranks, threads))))
    }

    /// Greatest distance of a rank's count from the mean, relative to the mean; None where nothing was
    /// counted.
    fn imbalance(&self, count: impl Fn(&RankWork) -> u64) -> Option<f64> {
        let counts: Vec<f64> = self.0.iter().map(|rank| count(rank) as f64).collect();
        let mean = counts.iter().sum::<f64>() / counts.len() as f64;
        let off = counts.iter().map(|count| (count - mean).abs()).fold(0.0, f64::max);
        (mean > 0.0).then(|| off / mean)
    }
}

/// Peak resident memory of this process as Linux reports it; None elsewhere.
pub(crate) fn peak_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kibibytes)
}

/// A count of a rank.
type Count = fn(&RankWork) -> u64;

/// One line: number of ranks, evenness of their work, and bytes sent.
impl fmt::Display for RanksWork {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        let threads: usize = self.0.iter().map(|rank| rank.threads).sum();
        write!(to, "{} ranks with {threads} threads in all", self.0.len())?;
        let counts: [(&str, Count); 2] =
            [("kernel samples", |rank| rank.kernel_samples), ("rays", |rank| rank.rays)];
        for (what, count) in counts {
            if let Some(off) = self.imbalance(count) {
                write!(to, ", {what} within {:.1} % of the mean", 100.0 * off)?;
            }
        }
        let sent: u64 = self.0.iter().map(|rank| rank.bytes_sent).sum();
        write!(to, "; {:.3} MB sent", sent as f64 / 1e6)
    }
}

#[cfg(test)]
mod tests {
    use radiosity_work::ranks::threads::on_ranks;

    use super::*;

    #[test]
    fn a_rank_alone_tells_nothing_and_several_tell_how_even_they_are() {
        assert_eq!(RanksWork::so_far(Ranks::alone(), 2), None);
        let told = on_ranks(3, |ranks| {
            // 1, 2 and 3 thousand samples: the mean is 2, and a half of it is missed.
            ranks.count_work(1000 * (ranks.number() as u64 + 1), 0);
            RanksWork::so_far(ranks, 2).expect("there are three").to_string()
        });
        for line in told {
            let expected = "3 ranks with 6 threads in all, kernel samples within 50.0 % of the mean; ";
            assert!(line.starts_with(expected), "{line}");
        }
    }
}
