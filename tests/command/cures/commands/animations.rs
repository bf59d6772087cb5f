//! Commands of animations that are refused.

use super::super::Typed;

pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "animate moves.toml -o f.gif --fps 99",
        cured: "animate moves.toml -o f.gif --fps 50 --size 8x8",
        told: &["a .gif shows 50 pictures a second at the most", "help: add --fps 50"],
    },
    Typed {
        bad: "animate moves.toml -o f.apng --fps 5000",
        cured: "animate moves.toml -o f.apng --fps 50 --size 8x8",
        told: &["an .apng shows", "help: add --fps 50, which screens show"],
    },
    Typed {
        bad: "animate moves.toml -o f-####.png --fps 9",
        cured: "animate moves.toml -o f-####.png --size 8x8",
        told: &["files have no speed", "help: leave out --fps"],
    },
    Typed {
        bad: "animate moves.toml -o f.png",
        cured: "animate moves.toml -o f-####.png --size 8x8",
        told: &[
            "one name for all frames",
            "help: write #### where the number of the frame goes, as in frame-####.png",
        ],
    },
    Typed {
        bad: "animate moves.toml -o f-####.bmp",
        cured: "animate moves.toml -o f-####.png --size 8x8",
        told: &["the ending names no kind of pictures", "help: choose names such as frame-####.png"],
    },
    Typed {
        bad: "animate moves.toml -o f-####.png --accuracy 1e-1",
        cured: "animate moves.toml -o f-####.png --size 8x8 --quality quick",
        told: &[
            "elements that one frame needs are not those of another",
            "help: leave it out and choose --quality",
        ],
    },
    Typed {
        bad: "animate moves.toml -o f-####.png --method hierarchical",
        cured: "animate moves.toml -o f-####.png --size 8x8",
        told: &["links of one frame are not those of another", "help: leave it out"],
    },
    Typed {
        bad: "animate moves.toml -o f-####.exr --exposure 1",
        cured: "animate moves.toml -o f-####.png --exposure 1 --size 8x8",
        told: &["--exposure: an .exr holds the values and nothing else", "or choose files ending in .png"],
    },
    Typed {
        bad: "animate moves.toml -o f-####.png --shadows mask --animation path",
        cured: "animate moves.toml -o f-####.png --shadows mask --animation selective --size 8x8",
        told: &[
            "light that goes through shadow masks cannot be interpolated along a path",
            "help: add --animation selective",
        ],
    },
    Typed {
        bad: "animate moves.toml -o f.apng --fps 0.001",
        cured: "animate moves.toml -o f.apng --fps 1 --size 8x8",
        told: &["a picture of such a film stays for", "help: raise --fps"],
    },
    Typed {
        bad: "animate moves.toml -o f-####.png --bounces 1",
        cured: "render moves.toml -o p.png --frame 1 --bounces 1 --size 8x8",
        told: &["help: take single frames: render --frame K --bounces"],
    },
    Typed {
        bad: "animate moves.toml -o f-####.png --transport sampled --animation series",
        cured: "animate moves.toml -o f-####.png --transport exact --animation series --size 8x8",
        told: &["rays carry the pairs of this scene", "help: add --transport exact"],
    },
];
