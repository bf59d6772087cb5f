//! Commands of solutions, audits and reports that are refused.

use super::super::Typed;

pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "convergence room.toml --max-order 1 --reference points.csv",
        cured: "convergence room.toml --max-order 1 --reference lit.json",
        told: &["points.csv", "help: give a file that `radiosity solve` wrote for this scene"],
    },
    Typed {
        bad: "solve lit.json -o again.json",
        cured: "solve room.toml -o again.json",
        told: &[
            "this is a solution already",
            "help: give it to render, probe or grid; for anything else, give the scene it was made from",
        ],
    },
    Typed {
        bad: "solve room.toml -o -",
        cured: "solve room.toml -o room.json",
        told: &["-: an output needs a name"],
    },
    Typed {
        bad: "audit room.toml --audit 9",
        cured: "audit moves.toml --seconds 0.1 --readings 2",
        told: &["--audit says how long another verb is checked", "help: take --seconds instead"],
    },
    Typed {
        bad: "audit endless.toml --seconds 0.02 --readings 2",
        cured: "audit cube.toml --seconds 0.02 --readings 2",
        told: &[
            "walks of path tracing end at 0 places, too few for a verdict: light goes on",
            "help: give the materials there a lower reflectance",
        ],
    },
    Typed {
        bad: "solve lists.csv",
        cured: "solve room.toml",
        told: &[
            "a list of polygons carries no materials",
            "for light write a TOML scene, where each surface has a shape and a material",
        ],
    },
    Typed {
        bad: "solve lists.csv",
        cured: "view-factors lists.csv",
        told: &[
            "a list of polygons carries no materials",
            "`radiosity view-factors` and `radiosity check` need none",
        ],
    },
    Typed {
        bad: "solve moves.toml --frame 0 -o b.json --layers 8 --ratio 0.05",
        cured: "solve moves.toml --frame 0 -o b.json --layers 2 --ratio 0.05",
        told: &["help: take fewer --layers or a larger --ratio"],
    },
    Typed {
        bad: "solve vary.toml -o b.json --basis linear",
        cured: "solve vary.toml -o b.json --basis constant",
        told: &["its reflectance varies"],
    },
    Typed {
        bad: "solve blind.toml --for picture --accuracy 1e-1",
        cured: "solve blind.toml --for gathered --accuracy 1e-1",
        told: &[
            "there is no camera, so nothing says what the picture shows",
            "help: add [camera] with eye and target, or take --for gathered",
        ],
    },
    Typed {
        bad: "solve turned.toml --for picture --accuracy 1e-1",
        cured: "solve room.toml --for picture --accuracy 1e-1",
        told: &["the camera sees no front of any surface", "help: turn the camera"],
    },
    Typed {
        bad: "solve room.toml --memory 1k",
        cured: "solve room.toml",
        told: &["not enough memory", "allow more with --memory, or leave it out"],
    },
    Typed {
        bad: "solve sourced.toml --shadows mask",
        cured: "solve sourced.toml",
        told: &["shadow masks are made for the light of surfaces only", "choose another kind of --shadows"],
    },
    Typed {
        bad: "solve apart.toml --shadows mask",
        cured: "solve lampmask.toml --shadows mask",
        told: &[
            "their fronts do not see each other",
            "help: take the pair out of [[masks]], or name surfaces whose fronts see each other",
        ],
    },
    Typed {
        bad: "report lit.json -o r.pdf",
        cured: "report lit.json -o r.md",
        told: &[
            "the ending names no kind of report",
            "help: choose a file ending in .html (one file with all)",
        ],
    },
];
