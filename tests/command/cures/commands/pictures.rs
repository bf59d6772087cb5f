//! Commands of pictures that are refused.

use super::super::Typed;

pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "render room.toml -o p.png --frame 1",
        cured: "render room.toml -o p.png --size 8x8",
        told: &["a frame is asked for, yet nothing moves in the scene", "help: leave the frame out"],
    },
    Typed {
        bad: "render moves.toml -o p.png --frame 9",
        cured: "render moves.toml -o p.png --frame 1 --size 8x8",
        told: &["there is no frame 9", "help: choose one from 0 to 1"],
    },
    Typed {
        bad: "render away.toml -o p.png --frame 1",
        cured: "render moves.toml -o p.png --frame 1 --size 8x8",
        told: &[
            "too far for its size",
            "help: keep the path near the scene: beyond four million times its size a shape has too few digits",
        ],
    },
    Typed {
        bad: "render onto.toml -o p.png --frame 1",
        cured: "render moves.toml -o p.png --frame 1 --size 8x8",
        told: &["it coincides with surface", "help: lead the path a millionth of its size or more past"],
    },
    Typed {
        bad: "render lit.json -o p.png --size 8x8 --order 2",
        cured: "render lit.json -o p.png --size 8x8",
        told: &["is a solution, how it was found cannot be changed", "help: leave the option out"],
    },
    Typed {
        bad: "render lit.json -o p.png --size 8x8 --order 2",
        cured: "render room.toml -o p.png --size 8x8 --order 2",
        told: &[
            "is a solution, how it was found cannot be changed",
            "or give the scene instead of its solution",
        ],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --difference warm.toml",
        cured: "render room.toml -o p.png --size 8x8 --difference lit.json",
        told: &["help: give a file that `radiosity solve` wrote for this scene"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --difference points.exr",
        cured: "render room.toml -o p.png --size 8x8 --difference lit.exr",
        told: &["help: give a picture of this scene that `radiosity render -o FILE.exr` wrote"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 9x9 --difference lit.exr",
        cured: "render room.toml -o p.png --size 8x8 --difference lit.exr",
        told: &["it has 8x8 pixels, the picture 9x9", "help: add --size 8x8"],
    },
    Typed {
        bad: "render room.toml -o p.glb --importance",
        cured: "render room.toml -o p.png --importance --size 8x8",
        told: &["textures hold light, not its importance", "or choose a file ending in .png"],
    },
    Typed {
        bad: "render room.toml -o p.glb --samples 2",
        cured: "render room.toml -o p.png --samples 2 --size 8x8",
        told: &["--samples counts rays", "or choose a file ending in .png"],
    },
    Typed {
        bad: "render room.toml -o p.glb --false-colour",
        cured: "render room.toml -o p.png --false-colour --size 8x8",
        told: &[
            "a .glb holds textures of light, for which there is no --false-colour",
            "help: leave out --false-colour, or choose a file ending in .png",
        ],
    },
    Typed {
        bad: "render room.toml -o p.html --isolines",
        cured: "render room.toml -o p.png --isolines --false-colour --size 8x8",
        told: &["a page to walk through has no --isolines"],
    },
    Typed {
        bad: "render room.toml -o p.html --importance",
        cured: "render room.toml -o p.png --importance --size 8x8",
        told: &["--importance: a page to walk through shows light"],
    },
    Typed {
        bad: "render room.toml -o p.bmp",
        cured: "render room.toml -o p.png --size 8x8",
        told: &["the ending names no kind of picture", "help: choose a file ending in .png (colours)"],
    },
    Typed {
        bad: "render room.toml -o p.png --log",
        cured: "render room.toml -o p.png --log --false-colour --size 8x8 --range 1,9",
        told: &[
            "speak of false colours and differences",
            "help: add --false-colour or --difference FILE.exr, or leave them out",
        ],
    },
    Typed {
        bad: "render room.toml -o p.png --isolines --difference lit.exr --size 8x8",
        cured: "render room.toml -o p.png --isolines --false-colour --size 8x8",
        told: &["speak of false colours", "help: choose --false-colour instead of --difference"],
    },
    Typed {
        bad: "render scene.ply -o p.png",
        cured: "render scene.ply -o p.png --size 8x8 --materials m.toml",
        told: &[
            "the file gives its surfaces no materials",
            r#"--materials materials.toml, such as [materials."*"] with reflectance = 0.5"#,
        ],
    },
    Typed {
        bad: "render bare.toml -o p.png",
        cured: "render room.toml -o p.png --size 8x8",
        told: &[
            r#"the key "material" is missing"#,
            "help: add `material = …`, the name of one of [materials.…]",
        ],
    },
    Typed {
        bad: "render dark.toml -o p.png",
        cured: "render room.toml -o p.png --size 8x8",
        told: &[
            "nothing emits light",
            "help: give a material an emission above 0, e.g. emission = 10, and use it on a surface",
        ],
    },
    Typed {
        bad: "render dark.toml -o p.png",
        cured: "heat warm.toml",
        told: &["nothing emits light", "`radiosity heat` takes temperatures instead"],
    },
    Typed {
        bad: "render rooom -o p.png",
        cured: "render room.toml -o p.png --size 8x8",
        told: &[r#"unknown scene "rooom""#, "a scene file is given by its path, ending in .toml or .json"],
    },
    Typed {
        bad: "render groups.toml -o p.png --set sn=1",
        cured: "render groups.toml -o p.png --size 8x8 --set sun=1",
        told: &[r#"help: did you mean "sun"?"#],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --checkpoint room.toml",
        cured: "render room.toml -o p.png --size 8x8 --checkpoint kept",
        told: &["--checkpoint", "help: choose a folder that exists or can be made"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --order 2 --checkpoint used",
        cured: "render room.toml -o p.png --size 8x8 --order 2 --checkpoint fresh",
        told: &["a run was recorded here", "or choose another folder"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --order 1 --checkpoint used --resume",
        cured: "render room.toml -o p.png --size 8x8 --order 2 --checkpoint used --resume",
        told: &[
            "this records a run of another scene, or with other options, or of another program",
            "help: give the scene and the options of that run",
        ],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --order 2 --checkpoint used",
        cured: "render room.toml -o p.png --size 8x8 --order 2 --checkpoint used --resume",
        told: &["a run was recorded here", "help: add --resume to go on from there"],
    },
    Typed {
        bad: "render groups.json -o p.png --size 8x8 --set sn=1",
        cured: "render groups.json -o p.png --size 8x8 --set sun=1",
        told: &[r#"no light comes from a group "sn""#, r#"help: did you mean "sun"?"#],
    },
    Typed {
        bad: "render vars.json -o p.png --size 8x8 --set width=0.1",
        cured: "render vars.toml -o p.png --size 8x8 --set width=0.1",
        told: &["is a variable, which is set when the scene is read", "not a solution of it"],
    },
    Typed {
        bad: "render lit.json -o p.png --size 8x8 --set a=1",
        cured: "render groups.json -o p.png --size 8x8 --set sun=1",
        told: &["this scene has no light groups", "and solve it again"],
    },
    Typed {
        bad: "render lit.json -o p.png --size 8x8 --set width=1",
        cured: "render vars.toml -o p.png --size 8x8 --set width=0.1",
        told: &["help:"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --difference flat.json",
        cured: "render room.toml -o p.png --size 8x8 --difference lit.json",
        told: &[
            "it has other surfaces than the scene",
            "help: give a file that `radiosity solve` wrote for this scene",
        ],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --difference nopic.exr",
        cured: "render room.toml -o p.png --size 8x8 --difference lit.exr",
        told: &[
            "it is no OpenEXR picture",
            "help: give a picture of this scene that `radiosity render -o FILE.exr` wrote",
        ],
    },
];
