//! Commands of readings at points that are refused.

use super::super::Typed;

pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "probe room.toml --planes --picture p.png --plane 0,0,0.5;1,0,0;0,1,0;0.5",
        cured: "probe room.toml --plane desk --picture p.png",
        told: &["--picture draws one plane, 2 are read", "help: choose one with --plane"],
    },
    Typed {
        bad: "probe planeless.toml --planes",
        cured: "probe room.toml --planes",
        told: &["there are no planes", "help: define one: [planes.desk] with origin, edges and spacing"],
    },
    Typed {
        bad: "probe planeless.toml --planes",
        cured: "probe planeless.toml --plane 0,0,0.5;1,0,0;0,1,0;0.5",
        told: &["there are no planes", "or type it with --plane"],
    },
    Typed {
        bad: "probe planeless.toml --plane desk",
        cured: "probe room.toml --plane desk",
        told: &[r#"unknown plane "desk""#, "help: define it: [planes.desk] with origin, edges and spacing"],
    },
    Typed {
        bad: "probe room.toml --plane 0,0;1,0,0;0,1,0;0.5",
        cured: "probe room.toml --plane 0,0,0.5;1,0,0;0,1,0;0.5",
        told: &["the origin '0,0' is not three numbers"],
    },
    Typed {
        bad: "probe room.toml --plane 0,0,0.5;1,0,0;0,1,0;a",
        cured: "probe room.toml --plane 0,0,0.5;1,0,0;0,1,0;0.5",
        told: &["the spacing 'a' is not one number or two"],
    },
    Typed {
        bad: "probe room.toml --points semi.csv",
        cured: "probe room.toml --points points.csv",
        told: &["there is no comma in it", "help: part the numbers by commas"],
    },
    Typed {
        bad: "probe room.toml --points few.csv",
        cured: "probe room.toml --points points.csv",
        told: &["help: write six numbers a line"],
    },
    Typed {
        bad: "probe room.toml --points nothing.csv",
        cured: "probe room.toml --points points.csv",
        told: &["there are no points in it"],
    },
    Typed {
        bad: "probe room.toml --points two.csv",
        cured: "probe room.toml --points points.csv",
        told: &["the header has two columns 'x'", "help: leave one out"],
    },
    Typed {
        bad: "probe room.toml --points head.csv",
        cured: "probe room.toml --points points.csv",
        told: &["the header has no column 'nz'"],
    },
    Typed {
        bad: "probe room.toml --points latin.csv",
        cured: "probe room.toml --points points.csv",
        told: &["this is no text", "help: save the file as UTF-8"],
    },
    Typed {
        bad: "probe - --points -",
        cured: "probe room.toml --points points.csv",
        told: &["scene and points cannot both come from standard input", "help: save one of them to a file"],
    },
    Typed {
        bad: "solve room.toml --accuracy 1e-1 --for points - --checkpoint points",
        cured: "solve room.toml --accuracy 1e-1 --for points points.csv --checkpoint points",
        told: &[
            "--checkpoint: points from standard input cannot be told from others",
            "help: save them to a file, and give its path",
        ],
    },
    Typed {
        bad: "probe room.toml --plane desk --read basis --read-eps 1e-3",
        cured: "probe room.toml --plane desk --read-eps 1e-3",
        told: &["is the accuracy of recomputed light", "help: leave one of them out"],
    },
    Typed {
        bad: "probe room.toml --plane desk --read direct --read-by rays",
        cured: "probe room.toml --plane desk --read gather --read-by rays",
        told: &["says by what light is gathered", "or take --read gather"],
    },
    Typed {
        bad: "probe room.toml --plane desk --read-by walks --bounces 1",
        cured: "probe room.toml --plane desk --read-by rays --bounces 1",
        told: &[
            "finds all light, and the solution has that of some reflections alone",
            "help: take --read-by rays",
        ],
    },
    Typed {
        bad: "probe room.toml --plane desk --read-by rays --shadows off",
        cured: "probe room.toml --plane desk --read-by cells --shadows off",
        told: &["always sees exact shadows, and the solution has others", "help: take --read-by cells"],
    },
    Typed {
        bad: "grid room.toml --accuracy 1e-1 --read basis",
        cured: "grid room.toml --accuracy 1e-1 --read basis --for solution",
        told: &["is that of gathered light", "help: add --for solution"],
    },
    Typed {
        bad: "grid room.toml --accuracy 1e-1 --read basis",
        cured: "grid room.toml --accuracy 1e-1 --read gather",
        told: &["is that of gathered light", "or take --read gather"],
    },
    Typed {
        bad: "grid moves.toml --shots 1 --solver southwell --read gather",
        cured: "grid moves.toml --shots 99 --solver southwell --read basis",
        told: &[
            "limits the light of the polynomials, and other readings add light that was not shot",
            "help: take --read basis",
        ],
    },
    Typed {
        bad: "probe cube.toml --points norm.csv --read basis",
        cured: "probe cube.toml --points right.csv --read basis",
        told: &["the normal is not that of the surface under the point"],
    },
];
