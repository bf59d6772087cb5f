//! Memory that is free, and refusals of results for which there is no room.

use std::fs::read_to_string;
use std::path::Path;

use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{Wording, option};

use super::ranges::Bytes;
use super::refusal::Refusal;

/// Part of the free memory that is used unless the user says otherwise. Chosen.
const SHARE: f64 = 0.8;

/// 80 % of the free memory of the machine, or of the control group of this process, whichever is less; None
/// if unknown. These ranks share it where they are on one machine, and all take what the one with the least
/// has.
fn usable(ranks: &Ranks) -> Option<u64> {
    let free = [machine(), confined()].into_iter().flatten().min();
    let own = free.map(|free| free / ranks.machine_share().ranks as u64);
    let free = ranks.all(own).into_iter().flatten().min()?;
    Some((SHARE * free as f64) as u64)
}

/// The bytes that were asked for, or those that are usable.
pub fn allowed(asked: Option<Bytes>, ranks: &Ranks) -> Option<u64> {
    asked.map(|Bytes(bytes)| bytes).or_else(|| usable(ranks))
}

/// Refuses to begin on results of so many bytes where there is no room for them in what is `allowed`, or
/// usable; `what` they are, and how to need less.
///
/// # Errors
/// Where there is no room.
pub fn require(
    needed: u64,
    allowed: Option<Bytes>,
    what: &str,
    less: impl Into<Wording>,
    ranks: &Ranks,
) -> Result<(), Refusal> {
    match self::allowed(allowed, ranks) {
        Some(allowed) if allowed < needed => Err(Refusal::new(
            format!(
                "not enough memory: {what} need about {:.0} MB, {:.0} MB allowed",
                needed as f64 / 1e6,
                allowed as f64 / 1e6
            ),
            less.into() + ", or allow more with " + option("memory"),
        )),
        _ => Ok(()),
    }
}

/// Free memory of the machine, as Linux reports it ("MemAvailable").
fn machine() -> Option<u64> {
    let info = read_to_string("/proc/meminfo").ok()?;
    let line = info.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kibibytes)
}

/// The least that a control group (version 2) of this process, or one around it, leaves.
fn confined() -> Option<u64> {
    let groups = read_to_string("/proc/self/cgroup").ok()?;
    let own = groups.lines().find_map(|line| line.strip_prefix("0::/"))?;
    let root = Path::new("/sys/fs/cgroup");
    let folder = root.join(own);
    folder.ancestors().take_while(|folder| folder.starts_with(root)).filter_map(left_in).min()
}

fn left_in(group: &Path) -> Option<u64> {
    let number = |file| read_to_string(group.join(file)).ok()?.trim().parse::<u64>().ok();
    // A group without a limit says "max".
    let (limit, used) = (number("memory.max")?, number("memory.current")?);
    let statistics = read_to_string(group.join("memory.stat")).unwrap_or_default();
    let cached = statistics.lines().find_map(|line| line.strip_prefix("inactive_file "));
    // The system gives back unused pages of files when needed.
    let cached = cached.and_then(|bytes| bytes.parse().ok()).unwrap_or(0);
    Some(limit.saturating_sub(used.saturating_sub(cached)))
}
