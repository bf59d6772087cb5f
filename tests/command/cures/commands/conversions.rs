//! Commands of conversions that are refused.

use super::super::Typed;

pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "convert room.toml room.dxf",
        cured: "convert room.toml again.toml",
        told: &["the ending names no format that is written", "help: end the name in one of toml, json"],
    },
    Typed {
        bad: "convert lit.json grid.vtu --tessellate 3",
        cured: "convert lit.json grid.vtu",
        told: &["--tessellate cuts the surfaces of a scene", "help: leave it out"],
    },
    Typed {
        bad: "convert lit.json grid.vtu --frame 1",
        cured: "convert lit.json grid.vtu",
        told: &["how it was found cannot be changed", "help: leave the option out"],
    },
    Typed {
        bad: "convert round.toml round.obj",
        cured: "convert round.toml round.obj --tessellate 20",
        told: &["which OBJ does not have", "help: write the model as toml, json or mgf"],
    },
    Typed {
        bad: "convert round.toml round.vs3",
        cured: "convert round.toml round.mgf",
        told: &["View3D has flat surfaces only", "help: write it in another format"],
    },
    Typed {
        bad: "convert moves.toml still.toml --frame 1",
        cured: "convert moves.toml still.toml",
        told: &["a frame has no text of its own", "help: write the whole scene, without a frame"],
    },
    Typed {
        bad: "convert tensor.json grid-3.vtu",
        cured: "convert lit.json grid-3.vtu",
        told: &[
            "carries polynomials of total degree",
            "help: solve with an --order of 10 at the most, or without --tensor",
        ],
    },
    Typed {
        bad: "convert mask.json grid-4.vtu",
        cured: "convert lit.json grid-4.vtu",
        told: &["direct light goes through shadow masks", "help: solve with --shadows auto"],
    },
    Typed {
        bad: "convert bezier.toml bezier.mgf",
        cured: "convert bezier.toml bezier.mgf --tessellate 20",
        told: &["help: cut them into flat pieces (`convert --tessellate 20`)"],
    },
    Typed {
        bad: "convert bezier.toml bezier-2.mgf",
        cured: "convert bezier.toml bezier.json",
        told: &["write the scene as .toml or .json"],
    },
    Typed {
        bad: "convert bands.toml bands.obj",
        cured: "convert bands.toml bands-2.toml",
        told: &["has 2 bands; MTL has 1 or 3", "help: write the model as toml or json"],
    },
    Typed {
        bad: "convert bands.toml bands.mgf",
        cured: "convert bands.toml bands.json",
        told: &["MGF has no words for 2 bands", "help: write another format"],
    },
    Typed {
        bad: "convert alike.toml sub/again.toml",
        cured: "convert alike.toml again-2.toml",
        told: &[
            "the scene includes files or names pictures beside it",
            "help: write it into the folder of the scene",
        ],
    },
];
