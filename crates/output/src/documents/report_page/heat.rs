//! Radiant heat: temperatures, fluxes and flows.

use radiosity_heat::{Heat, HeatError};

use crate::documents::document::Block;
use crate::documents::heat::table;
use radiosity_work::digits::significant;

/// Digits of computed figures. Chosen: errors of a thousandth are usual.
const DIGITS: usize = 4;

/// The loss of heat of the scene, in a sentence (W).
fn whole(heat: &Heat) -> String {
    let lost = significant(heat.lost, 2);
    match heat.is_closed() {
        true => format!("The scene is closed: the flows sum to {lost} W."),
        false => format!("{lost} W leave the scene, to surroundings at 0 K."),
    }
}

pub(super) fn blocks(heat: Result<&Heat, &HeatError>) -> Vec<Block> {
    let heading = Block::Heading("Radiant heat".to_owned());
    match heat {
        Ok(heat) => vec![
            heading,
            Block::Text(format!(
                "Temperature T, net flux q and net flow Q that leave each surface as radiation, with their estimated errors, or \
                 given{}. {} Conduction, convection and stored heat are left out. Lengths are metres.",
                heat.checked.as_ref().map(|checked| format!("; {checked}")).unwrap_or_default(),
                whole(heat)
            )),
            Block::Table(table(&heat.surfaces, DIGITS)),
        ],
        Err(error) => {
            let cure = error.cure().map(|cure| format!(": {cure}")).unwrap_or_default();
            vec![heading, Block::Warnings(vec![format!("There is no balance of heat: {error}{cure}")])]
        }
    }
}
