//! Readings with sixteen times the walks: where few walks leave means that are not normal, more do not. Cells and
//! curved lamps are left out, whose quadratures are not as exact.

use super::fairness::assert_fair;
use super::trial::{Trial, quotients};
use super::{furnaces, lamps, luminaires, means, skies, stacks};

const WALKS: f64 = 16384.0;

/// Trials of one kind.
type Make = fn() -> Vec<Trial>;

#[test]
#[ignore = "two minutes of CPU"]
fn all_readings_err_as_they_say() {
    let kinds: [(&str, Make); 13] = [
        ("rooms of concave shapes", furnaces::concave),
        ("sheets of all shapes", furnaces::sheets),
        ("patterns", furnaces::patterns),
        ("polygons", lamps::polygons),
        ("disks", lamps::disks),
        ("balls", lamps::balls),
        ("photometric tables", luminaires::tables),
        ("spots", luminaires::distributions),
        ("windows", skies::windows),
        ("mats", stacks::mats),
        ("covers", stacks::covers),
        ("rims", stacks::rims),
        ("pixels", means::pixels),
    ];
    let mut all = Vec::new();
    for (seed, (name, trials)) in (0..).zip(kinds) {
        println!("{name}");
        let own = quotients(&trials(), WALKS, 10_000 + 1000 * seed);
        assert_fair(&own);
        all.extend(own);
    }
    assert_fair(&all);
}
