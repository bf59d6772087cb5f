//! Commands on studies and verdicts that are refused.

use super::super::Typed;

pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "audit backs.toml --of view-factors --seconds 0.1",
        cured: "audit flat.toml --of view-factors --seconds 0.1",
        told: &["no view factor is large enough to be judged", "surfaces that see no other have no factors"],
    },
    Typed {
        bad: "audit flat.toml --of view-factors --order 2",
        cured: "audit flat.toml --of view-factors --seconds 0.1",
        told: &["--order does nothing with --of view-factors", "help: leave it out, or judge light"],
    },
    Typed {
        bad: "audit flat.toml --of view-factors --order 2",
        cured: "audit flat.toml --of light --order 2 --seconds 0.1 --readings 2",
        told: &["--order does nothing with --of view-factors", "or judge light with --of light"],
    },
    Typed {
        bad: "convergence room.toml --max-order 1 -o a.pdf",
        cured: "convergence room.toml --max-order 1 -o a.svg",
        told: &["the ending names no kind of drawing", "help: choose a file ending in .svg or .png"],
    },
    Typed {
        bad: "convergence room.toml --shots 3 --with constant",
        cured: "convergence room.toml --shots 3",
        told: &["--shots is a study of one order", "help: leave out --with and --bases, or --shots"],
    },
    Typed {
        bad: "convergence room.toml --basis constant --max-order 1",
        cured: "convergence room.toml --with constant --max-order 1",
        told: &["convergence runs at rising orders", "help: take --with constant"],
    },
    Typed {
        bad: "convergence room.toml --max-order 1 --reference part.json",
        cured: "convergence room.toml --max-order 1 --reference lit.json",
        told: &["its solver did not converge, which makes it no reference", "help: solve it with more"],
    },
    Typed {
        bad: "convergence dull.toml --max-order 1 --reference lit.json",
        cured: "convergence room.toml --max-order 1 --reference lit.json",
        told: &["it has other materials than the scene", "help: give a solution of the scene as it is"],
    },
    Typed {
        bad: "convergence bands.toml --max-order 1 --reference flat.json",
        cured: "convergence flat.toml --max-order 1 --reference flat.json",
        told: &["it has other bands than the scene", "wrote for this scene"],
    },
    Typed {
        bad: "report warm.toml -o warm.md --report figures.json",
        cured: "report warm.toml -o warm.md",
        told: &["--report has the figures of light", "help: leave it out; `radiosity heat -o FILE.json`"],
    },
    Typed {
        bad: "solve idle.toml --shadows mask",
        cured: "solve lampmask.toml --shadows mask",
        told: &["the emitter sends no light", "help: take the pair out of [[masks]]"],
    },
    Typed {
        bad: "solve room.toml --kernel paper-legendre --tensor",
        cured: "solve room.toml --kernel paper-legendre",
        told: &["--kernel with the rules of 1993 does not go with --tensor", "help: leave one of them out"],
    },
    Typed {
        bad: "solve room.toml --kernel paper-legendre --audit 1",
        cured: "solve room.toml --kernel paper-legendre",
        told: &["with the rules of 1993 finds other light than path tracing", "help: leave out --audit"],
    },
    Typed {
        bad: "check teapot --set widht=1",
        cured: "check teapot --set height=1",
        told: &["there is no parameter", "help: parameters of this scene: height, pot"],
    },
    Typed {
        bad: "render vars.toml -o p.png --size 8x8 --set widht=1",
        cured: "render vars.toml -o p.png --size 8x8 --set width=0.1",
        told: &[r#"did you mean "width"? variables of this scene: width; light groups: none"#],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --difference blank.exr",
        cured: "render room.toml -o p.png --size 8x8 --difference lit.exr",
        told: &["the picture to compare with is black", "help: choose another picture or another band"],
    },
];
