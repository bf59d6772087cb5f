//! Settings: how the light was solved and read, what was done to the scene, and the command that does it
//! again.

use radiosity_scene::Scene;

use super::light_part::LightPart;
use crate::documents::document::Block;
use crate::table::{Column, Table};
use radiosity_reading::reader::ReadMode;
use radiosity_work::digits::short;

pub(super) fn blocks(scene: &Scene, light: Option<&LightPart>, command: &str) -> Vec<Block> {
    let mut blocks = vec![Block::Heading("Settings".to_owned())];
    let rows = of_scene(scene).into_iter().chain(light.into_iter().flat_map(of_light));
    let table = Table::new([Column::text("setting"), Column::text("value")], rows);
    blocks.push(Block::Table(table));
    let done: Vec<String> = scene
        .imported()
        .into_iter()
        .flat_map(|imported| imported.lines().collect::<Vec<_>>())
        .chain(scene.fitted.line())
        .collect();
    if !done.is_empty() {
        blocks.extend([
            Block::Subheading("What was done to the scene as it was read".to_owned()),
            Block::List(done),
        ]);
    }
    blocks
        .extend([Block::Subheading("The same report again".to_owned()), Block::Command(command.to_owned())]);
    blocks
}

fn of_scene(scene: &Scene) -> Vec<[String; 2]> {
    let pair = |name: &str, value: String| [name.to_owned(), value];
    let mut rows = vec![
        pair("program", format!("radiosity {}", env!("CARGO_PKG_VERSION"))),
        pair("scene", scene.origin.clone()),
    ];
    let variables: Vec<String> =
        scene.variables.iter().map(|(name, value)| format!("{name} = {}", short(*value))).collect();
    if !variables.is_empty() {
        rows.push(pair("variables", variables.join(", ")));
    }
    let groups: Vec<String> = scene
        .light_groups()
        .iter()
        .map(|group| format!("{} × {}", group.name, short(group.factor)))
        .collect();
    if !groups.is_empty() {
        rows.push(pair("light groups", groups.join(", ")));
    }
    rows
}

fn of_light(light: &LightPart) -> Vec<[String; 2]> {
    let LightPart { report, options, reading, .. } = light;
    let pair = |name: &str, value: String| [name.to_owned(), value];
    let order = match report.orders {
        [lowest, highest] if lowest == highest => lowest.to_string(),
        [lowest, highest] => format!("{lowest} to {highest}"),
    };
    let read = match reading.read {
        ReadMode::Basis => "the polynomials",
        ReadMode::Direct => "direct light at each point, the rest from the polynomials",
        ReadMode::Gather => "gathered at each point",
        ReadMode::GatherTwice => "gathered twice at each point",
    };
    let accuracy = match reading.read {
        ReadMode::Basis => String::new(),
        _ => format!(", to {}", short(reading.eps)),
    };
    let solver = match report.iterations {
        0 => report.solver.clone(),
        iterations => format!("{}, {iterations} iterations", report.solver),
    };
    vec![
        pair("order of the polynomials", order),
        pair("elements", report.elements.to_string()),
        pair("unknowns a band", report.unknowns.to_string()),
        pair("accuracy of transfers", short(options.eps)),
        pair("accuracy of shadows", short(options.accuracy().shadow_eps)),
        pair("transfers", format!("{}: {}", report.transport.kind, report.transport.why)),
        pair("direct light", report.direct.to_owned()),
        pair("solver", solver),
        pair("light of planes and surfaces", format!("{read}{accuracy}")),
    ]
}
