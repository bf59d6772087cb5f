//! Error against work, a panel a scene: all runs as dots, the front of each family as a line.

use std::error::Error;
use std::fs;
use std::path::Path;

use radiosity::output::drawings::diagram::{COLOURS, Curve, Diagram, Dot, Panel, Spacing};

use crate::family::Family;
use crate::front::Front;
use crate::record::Record;
use crate::study::Study;
use crate::work::Work;

const COLUMNS: usize = 3;

/// Larger errors are not drawn.
const LARGEST: f64 = 1.0;

/// Draws the panels of the studies that have runs.
pub(crate) fn write(
    path: &Path,
    work: Work,
    studies: &[Study],
    records: &[Record],
) -> Result<(), Box<dyn Error>> {
    let panel = |study: &Study| {
        let is_own = |record: &&Record| record.scene == study.name && record.error <= LARGEST;
        let own: Vec<&Record> = records.iter().filter(is_own).collect();
        (!own.is_empty()).then(|| panel(study.title, work, &own))
    };
    let diagram = Diagram {
        title: format!("Error against {}", work.label()),
        caption: "dots: all runs; lines: the runs that none cheaper surpasses".to_owned(),
        columns: COLUMNS,
        panels: studies.iter().filter_map(panel).collect(),
    };
    Ok(fs::write(path, diagram.drawing().svg())?)
}

fn colour(family: Family) -> [u8; 3] {
    let [blue, red, green, purple, sky, orange] = COLOURS;
    match family {
        Family::Constant => [0; 3],
        Family::Legendre => [150; 3],
        Family::Hybrid => purple,
        Family::Orders(1, _) => orange,
        Family::Orders(2, _) => sky,
        Family::Orders(4, _) => green,
        Family::Orders(..) => blue,
        Family::Gathered => red,
    }
}

fn panel(title: &str, work: Work, own: &[&Record]) -> Panel {
    let place = |record: &Record| [work.of(record), record.error];
    let curve = |family: Family| {
        let members = || own.iter().copied().filter(move |record| family.holds(record));
        let front = Front::of(members(), work);
        let dot = |record: &&Record| Dot { place: place(record), text: String::new() };
        Curve {
            label: family.label(),
            colour: colour(family),
            dots: front.runs().iter().map(dot).collect(),
            others: members().map(place).collect(),
        }
    };
    let axes = [work.label(), "relative error"].map(str::to_owned);
    Panel {
        title: title.to_owned(),
        axes,
        along: Spacing::Logarithmic,
        curves: Family::ALL.map(curve).into(),
    }
}
