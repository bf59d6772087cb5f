//! Commands with options of the method that are refused.

use super::super::Typed;

pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "convergence room.toml --max-order 1 --time-limit 9",
        cured: "convergence room.toml --max-order 1",
        told: &["--time-limit does nothing where many solutions follow each other", "leave it out"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --link-measure power",
        cured: "render room.toml -o p.png --size 8x8 --link-measure power --method hierarchical --eps 1e-1",
        told: &[
            "--link-measure does nothing without --method hierarchical",
            "help: add --method hierarchical",
        ],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --link-rays 8",
        cured: "render room.toml -o p.png --size 8x8 --link-rays 8 --method hierarchical --eps 1e-1",
        told: &["--link-rays does nothing without --method hierarchical", "help: add --method hierarchical"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --least-area 1e-3",
        cured: "render room.toml -o p.png --size 8x8 --least-area 1e-3 --method hierarchical --eps 1e-1",
        told: &["--least-area does nothing without --method hierarchical", "help: add --method hierarchical"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --ratio 0.3",
        cured: "render room.toml -o p.png --size 8x8 --ratio 0.3 --layers 1",
        told: &["--ratio does nothing without --layers", "help: add --layers"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --mask-cells 10",
        cured: "render room.toml -o p.png --size 8x8 --mask-cells 10 --shadows mask",
        told: &["--mask-cells does nothing without --shadows mask", "help: add --shadows mask"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --mask-average plain",
        cured: "render room.toml -o p.png --size 8x8 --mask-average plain --shadows mask",
        told: &["--mask-average does nothing without --shadows mask", "help: add --shadows mask"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --method hierarchical --order 2",
        cured: "render room.toml -o p.png --size 8x8 --method hierarchical --eps 1e-1",
        told: &["--method hierarchical knows no", "help: leave --order"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --method hierarchical --tensor",
        cured: "render room.toml -o p.png --size 8x8 --method hierarchical --eps 1e-1",
        told: &["--method hierarchical knows no", "help: leave --tensor"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --method hierarchical --subdivide 2",
        cured: "render room.toml -o p.png --size 8x8 --method hierarchical --eps 1e-1",
        told: &["--method hierarchical knows no", "help: leave --subdivide"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --method hierarchical --layers 1",
        cured: "render room.toml -o p.png --size 8x8 --method hierarchical --eps 1e-1",
        told: &["--method hierarchical knows no", "help: leave --layers"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --method hierarchical --transport exact",
        cured: "render room.toml -o p.png --size 8x8 --method hierarchical --eps 1e-1",
        told: &["--method hierarchical knows no", "help: leave --transport"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --method hierarchical --rays 1000",
        cured: "render room.toml -o p.png --size 8x8 --method hierarchical --eps 1e-1",
        told: &["--method hierarchical knows no", "help: leave --rays"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --method hierarchical --shadows rays",
        cured: "render room.toml -o p.png --size 8x8 --method hierarchical --eps 1e-1",
        told: &["--method hierarchical knows no", "help: leave --shadows"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --method hierarchical --shadow-eps 0.1",
        cured: "render room.toml -o p.png --size 8x8 --method hierarchical --eps 1e-1",
        told: &["--method hierarchical knows no", "help: leave --shadow-eps"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --method hierarchical --direct split",
        cured: "render room.toml -o p.png --size 8x8 --method hierarchical --eps 1e-1",
        told: &["--method hierarchical knows no", "help: leave --direct"],
    },
    Typed {
        bad: "solve room.toml --method collocation --rays 1000",
        cured: "solve room.toml --method collocation",
        told: &["does not go with", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --method collocation --rays 1000",
        cured: "solve room.toml --rays 1000",
        told: &["does not go with", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --method collocation --accuracy 1e-1",
        cured: "solve room.toml --method collocation",
        told: &["does not go with", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --method collocation --accuracy 1e-1",
        cured: "solve room.toml --accuracy 1e-1",
        told: &["does not go with", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --transport sampled --shadows off",
        cured: "solve room.toml --transport sampled",
        told: &["does not go with", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --transport sampled --shadows off",
        cured: "solve room.toml --shadows off",
        told: &["does not go with", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --rays 1000 --transport exact",
        cured: "solve room.toml --rays 1000",
        told: &["does not go with", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --rays 1000 --transport exact",
        cured: "solve room.toml --transport exact",
        told: &["does not go with", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --basis linear --rays 1000",
        cured: "solve room.toml --basis linear",
        told: &["does not go with", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --basis linear --rays 1000",
        cured: "solve room.toml --rays 1000",
        told: &["does not go with", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --preconditioner none --solver lu",
        cured: "solve room.toml --preconditioner none --solver cg",
        told: &["--preconditioner does nothing with --solver lu", "help: take --solver cg"],
    },
    Typed {
        bad: "solve room.toml --preconditioner none --solver lu",
        cured: "solve room.toml --preconditioner none --solver gmres",
        told: &["--preconditioner does nothing with --solver lu", "or gmres"],
    },
    Typed {
        bad: "solve room.toml --basis linear --order 2",
        cured: "solve room.toml --basis linear --subdivide 8",
        told: &[
            "--basis linear has no --order 2",
            "help: leave --order out, and take finer cells: --subdivide 8",
        ],
    },
    Typed {
        bad: "grid room.toml --bounces 1 --accuracy 1e-1",
        cured: "grid room.toml --bounces 1",
        told: &["--bounces does not go with --accuracy", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --bounces 1",
        cured: "grid room.toml --bounces 1",
        told: &[
            "a solution is kept for readers",
            "help: type --bounces to render, probe or grid, with the scene",
        ],
    },
    Typed {
        bad: "grid room.toml --ambient",
        cured: "grid room.toml",
        told: &["--ambient does nothing without --shots", "or leave --ambient out"],
    },
    Typed {
        bad: "grid room.toml --shots 10 --solver cg",
        cured: "grid room.toml --solver cg",
        told: &["--shots does nothing without --solver southwell", "or leave --shots out"],
    },
    Typed {
        bad: "solve room.toml --columns all",
        cured: "solve room.toml --columns all --solver southwell",
        told: &["--columns does nothing without --solver southwell", "help: add --solver southwell"],
    },
    Typed {
        bad: "solve room.toml --at-once block --solver cg",
        cured: "solve room.toml --at-once block --solver gauss-seidel",
        told: &["--at-once does nothing with --solver cg", "help: take --solver gauss-seidel"],
    },
    Typed {
        bad: "solve room.toml --sweep forward --solver cg",
        cured: "solve room.toml --sweep forward --solver gauss-seidel",
        told: &["--sweep does nothing with --solver cg", "help: take --solver gauss-seidel"],
    },
    Typed {
        bad: "solve room.toml --relaxation 1.1 --solver cg",
        cured: "solve room.toml --relaxation 1.1 --solver gauss-seidel",
        told: &["--relaxation does nothing with --solver cg", "help: take --solver gauss-seidel"],
    },
    Typed {
        bad: "solve room.toml --restart 9 --solver cg",
        cured: "solve room.toml --restart 9 --solver gmres",
        told: &["--restart does nothing with --solver cg", "help: take --solver gmres"],
    },
    Typed {
        bad: "probe room.toml",
        cured: "probe room.toml --points points.csv",
        told: &["nothing says where to read", "help: add --points FILE.csv"],
    },
    Typed {
        bad: "probe room.toml",
        cured: "probe room.toml --plane desk",
        told: &["nothing says where to read", "--plane NAME"],
    },
    Typed {
        bad: "probe room.toml",
        cured: "probe room.toml --plane 0,0,0.5;1,0,0;0,1,0;0.5",
        told: &["nothing says where to read", r#"or --plane "origin; edge; edge; spacing""#],
    },
    Typed {
        bad: "probe room.toml --planes --points points.csv",
        cured: "probe room.toml --planes",
        told: &["--points and --plane both say where to read", "help: leave one of them out"],
    },
    Typed {
        bad: "probe room.toml --plane dask",
        cured: "probe room.toml --plane desk",
        told: &[r#"unknown plane "dask""#, r#"did you mean "desk"?"#],
    },
    Typed {
        bad: "probe room.toml --plane 0,0,0.5;1,0,0;0,1,0",
        cured: "probe room.toml --plane 0,0,0.5;1,0,0;0,1,0;0.25",
        told: &[
            "there are 3 parts instead of 4",
            "help: write origin, edge, edge and spacing between semicolons",
        ],
    },
    Typed {
        bad: "probe room.toml --points none.csv",
        cured: "probe room.toml --points points.csv",
        told: &["none.csv: cannot be read", "help: give the path of a CSV file of points"],
    },
    Typed {
        bad: "probe room.toml --plane desk --log",
        cured: "probe room.toml --plane desk --log --picture p.png",
        told: &["--log speaks of a picture", "help: add --picture FILE.png"],
    },
    Typed {
        bad: "probe room.toml --plane desk --picture p.png --log --range 0,9",
        cured: "probe room.toml --plane desk --picture p.png --log --range 1,1000",
        told: &["there is no logarithm of 0", "such as --range 1,1000"],
    },
    Typed {
        bad: "probe room.toml --plane desk --picture p.jpg",
        cured: "probe room.toml --plane desk --picture p.png",
        told: &["the ending names no kind of plan", "help: choose a file ending in .png"],
    },
    Typed {
        bad: "probe room.toml --plane desk --read basis",
        cured: "probe room.toml --plane desk --read gather",
        told: &["the point lies on no surface", "choose --read gather"],
    },
    Typed {
        bad: "probe room.toml --plane desk -o out.txt",
        cured: "probe room.toml --plane desk -o out.csv",
        told: &["out.txt: the ending names no format", "help: end the name in .csv or .json"],
    },
    Typed {
        bad: "probe room.toml --plane desk -o out.csv --format json",
        cured: "probe room.toml --plane desk -o out.csv",
        told: &["--format json and the ending disagree", "help: leave out --format"],
    },
    Typed {
        bad: "render room.toml -o none/p.png",
        cured: "render room.toml -o p.png --size 8x8",
        told: &[
            "none/p.png: cannot be written",
            "help: choose a file in a folder that exists and can be written to",
        ],
    },
    Typed {
        bad: "render rooom.toml -o p.png",
        cured: "render room.toml -o p.png --size 8x8",
        told: &["rooom.toml: cannot be read", "help: check the path and its permissions"],
    },
    Typed {
        bad: "render room.toml -o p.exr --exposure 1",
        cured: "render room.toml -o p.png --size 8x8 --exposure 1",
        told: &["an .exr holds the values and nothing else", "choose a file ending in .png"],
    },
    Typed {
        bad: "animate room.toml -o f.gif",
        cured: "render room.toml -o p.png --size 8x8",
        told: &["nothing moves in this scene", "or take one picture: radiosity render room.toml"],
    },
    Typed {
        bad: "render room.toml --false-colour --band red -o p.png --size 8x8",
        cured: "render room.toml --false-colour --band grey -o p.png --size 8x8",
        told: &["red", "bands of this scene: grey"],
    },
    Typed {
        bad: "relight room.toml --set a=1 -o r.json",
        cured: "solve room.toml -o r.json",
        told: &["this is no solution", "help: solve it first with `radiosity solve`"],
    },
    Typed {
        bad: "convergence room.toml --accuracy 1e-2 --max-order 1",
        cured: "convergence room.toml --max-order 1",
        told: &["convergence runs every order and chooses none", "help: leave out --accuracy"],
    },
    Typed {
        bad: "view-factors room.toml --pairs room-bottom",
        cured: "view-factors room.toml --pairs room-bottom,room-top",
        told: &["two names are needed", "help: write the names of two surfaces, as in --pairs floor,ceiling"],
    },
    Typed {
        bad: "check scene.dxf",
        cured: "check scene.obj",
        told: &["scenes of this format are not read", "help: export its faces as .obj or .stl"],
    },
    Typed {
        bad: "convert room.toml room.vtu",
        cured: "solve room.toml -o room.json",
        told: &[
            "a scene has no light yet, and a grid holds light",
            "help: solve it: `radiosity solve room.toml",
        ],
    },
    Typed {
        bad: "heat room.toml",
        cured: "heat warm.toml",
        told: &[
            "neither a temperature nor a flux of heat is given",
            "help: give the surface or its material temperature = …, in kelvin",
        ],
    },
    Typed {
        bad: "audit warm.toml",
        cured: "audit warm.toml --of heat --seconds 0.1",
        told: &["nothing emits light, but temperatures or fluxes are given", "help: add --of heat"],
    },
    Typed {
        bad: "render room.toml -o p.glb --preview",
        cured: "render room.toml -o p.png --size 8x8 --preview",
        told: &["previews are pictures of one view", "or choose a file ending in .png"],
    },
];
