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
    Typed {
        bad: "heat cool.toml --transfers room.toml",
        cured: "heat cool.toml --transfers kept.transfers",
        told: &[
            "room.toml: these are no transfers between",
            "help: give the scene whose transfers are kept there",
        ],
    },
    Typed {
        bad: "heat cool.toml --transfers nowhere/kept",
        cured: "heat cool.toml --transfers kept.transfers",
        told: &["nowhere/kept", "help: choose a file that can be read and written"],
    },
    Typed {
        bad: "heat cool.toml --rays 10000 --order 2",
        cured: "heat cool.toml --order 2",
        told: &["--rays does not go with --order 2", "help: leave one of them out"],
    },
    Typed {
        bad: "heat cool.toml --sweep floor.temperature=300..310/2 --format text",
        cured: "heat cool.toml --sweep floor.temperature=300..310/2 --format csv",
        told: &["--format text has no place for a sweep", "help: take --format csv or json"],
    },
    Typed {
        bad: "heat cool.toml --sweep floor.temperature=300..310/2 -o f.txt",
        cured: "heat cool.toml --sweep floor.temperature=300..310/2 -o f.csv",
        told: &[
            "f.txt: the ending names no format",
            "help: end the name in .csv or .json, or add --format csv or json",
        ],
    },
    Typed {
        bad: "heat cool.toml --sweep floor=300..310/2",
        cured: "heat cool.toml --sweep floor.temperature=300..310/2",
        told: &[
            "\"floor\" has no key",
            "write floor.KEY with one of temperature, heat_flux, emissivity as KEY",
        ],
    },
    Typed {
        bad: "heat cool.toml --sweep floor.temperature=300...310/2",
        cured: "heat cool.toml --sweep floor.temperature=300..310/2",
        told: &["more than two points stand there", "write 300..310, or 300..0.310"],
    },
    Typed {
        bad: "heat cool.toml --set floor:back.temperature=310",
        cured: "heat cool.toml --set floor.temperature=310",
        told: &[
            "no surface and no material is called \"floor:back\"",
            "help: the back of a surface of one side is set in the file: back = \"front\" or back = … (K)",
        ],
    },
    Typed {
        bad: "heat oven --set wall.emissivity=0.5",
        cured: "heat oven --set wall-*.emissivity=0.5",
        told: &["no surface and no material is called \"wall\"", "help: write \"wall-*\""],
    },
    Typed {
        bad: "solve oven --set panel.emissivity=0.5",
        cured: "heat oven --set panel.emissivity=0.5",
        told: &["\"panel.emissivity\" is a quantity of heat", "help: only `radiosity heat` takes it"],
    },
    Typed {
        bad: "view-factors cool.toml --set floor.emissivity=0.5",
        cured: "heat cool.toml --set floor.emissivity=0.5",
        told: &["\"floor.emissivity\" is a quantity of heat", "help: only `radiosity heat` takes it"],
    },
    Typed {
        bad: "heat cool.toml --set flor.temperature=310",
        cured: "heat cool.toml --set floor.temperature=310",
        told: &["no surface and no material is called \"flor\"", "help: did you mean \"floor\"?"],
    },
    Typed {
        bad: "heat cool.toml --set floor.temprature=310",
        cured: "heat cool.toml --set floor.temperature=310",
        told: &["unknown key \"temprature\"", "help: did you mean \"temperature\"?"],
    },
    Typed {
        bad: "heat shared.toml --set a.emissivity=0.4",
        cured: "heat cool.toml --set a.emissivity=0.4",
        told: &[
            "is a surface, and a material of others, too",
            "help: give one of them another name in the scene",
        ],
    },
    Typed {
        bad: "heat cool.toml --rays 1000 --transport exact",
        cured: "heat cool.toml --rays 1000",
        told: &["--rays does not go with --transport exact", "help: leave"],
    },
    Typed { bad: "heat warm.toml --memory 1k", cured: "heat warm.toml", told: &["not enough memory"] },
];
