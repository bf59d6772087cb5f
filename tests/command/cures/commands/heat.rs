//! Commands of balances of heat that are refused.

use super::super::Typed;

pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "heat warm.toml --picture h.png --band grey",
        cured: "heat warm.toml --picture h.png --size 8x8",
        told: &["--band: heat is of all wavelengths together", "help: leave it out"],
    },
    Typed {
        bad: "heat glow.toml",
        cured: "heat warm.toml",
        told: &[
            "heat would pass through",
            "help: leave the transmittance of the material out: the surfaces of radiant heat are opaque",
        ],
    },
    Typed {
        bad: "heat level.toml",
        cured: "heat oven.toml",
        told: &["no temperature sets the level of", "help: give one of them a temperature"],
    },
    Typed {
        bad: "heat cold.toml",
        cured: "heat cool.toml",
        told: &["more heat is drawn than arrives", "help: draw less heat, a heat_flux nearer to 0"],
    },
    Typed {
        bad: "heat cold.toml",
        cured: "heat oven.toml",
        told: &["more heat is drawn than arrives", "or give a temperature instead"],
    },
    Typed {
        bad: "heat black.toml",
        cured: "heat grey.toml",
        told: &["no emissivity is given for", "help: give the material emissivity = …, 0 < ε ≤ 1"],
    },
    Typed { bad: "heat warm.toml --memory 1k", cured: "heat warm.toml", told: &["not enough memory"] },
];
