//! Warnings of runs, with the cures that they name.

use super::Typed;

/// Runs of `room.toml`, two walls of which shine, of `cube.toml`, all whose walls do, of `hung.toml`, where a
/// lamp hangs in a room, and of `mirror.toml`, whose walls reflect nearly all light.
pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "render hung.toml -o p.png --size 8x8",
        cured: "render hung.toml -o p.png --size 8x8 --shadow-eps 1e-2",
        told: &["of the largest of their row only", "--shadow-eps 1e-2 asks for no more than these reach"],
    },
    Typed {
        bad: "render cube.toml -o p.png --size 8x8 --method hierarchical --eps 1e-2",
        cured: "render cube.toml -o p.png --size 8x8",
        told: &["more than it has", "leave --method hierarchical out"],
    },
    Typed {
        bad: "solve room.toml --solver jacobi --max-iterations 1 --keep-partial",
        cured: "solve room.toml --solver jacobi --max-iterations 99 --keep-partial",
        told: &["the solver did not converge", "raise --max-iterations"],
    },
    Typed {
        bad: "solve room.toml --solver jacobi --max-iterations 1 --keep-partial",
        cured: "solve room.toml --solver lu --keep-partial",
        told: &["the solver did not converge", "or take another --solver"],
    },
    Typed {
        bad: "probe cube.toml --points far.csv",
        cured: "probe cube.toml --points points.csv",
        told: &["1 of the 2 points lie outside of the room or in solids: move them"],
    },
    Typed {
        bad: "solve lampmask.toml",
        cured: "solve lampmask.toml --shadows mask",
        told: &["the scene chooses pairs for shadow masks", "which have no effect without --shadows mask"],
    },
    Typed {
        bad: "solve cube.toml --accuracy 1e-1 --solver jacobi --max-iterations 1 --keep-partial",
        cured: "solve room.toml --accuracy 1e-1 --solver jacobi",
        told: &["the solver did not converge in a finer run: raise --max-iterations"],
    },
    Typed {
        bad: "solve cube.toml --accuracy 1e-1 --solver jacobi --max-iterations 1 --keep-partial",
        cured: "solve room.toml --accuracy 1e-1",
        told: &["the solver did not converge in a finer run", "or take another --solver"],
    },
    Typed {
        bad: "solve room.toml --transport sampled --rays 1 --accuracy 1e-1",
        cured: "solve room.toml --accuracy 1e-1",
        told: &["rays leave an error of about", "or ask for an --accuracy"],
    },
    Typed {
        bad: "view-factors room.toml --transport sampled --rays 2000",
        cured: "view-factors room.toml --transport sampled --rays 2000000",
        told: &["rays leave errors of up to", "rows miss: send more with --rays"],
    },
    Typed {
        bad: "view-factors room.toml --transport sampled --rays 2000",
        cured: "view-factors room.toml --transport exact",
        told: &["rays leave errors of up to", "or take --transport exact, which takes its time"],
    },
    Typed {
        bad: "solve room.toml --solver jacobi --max-iterations 1",
        cured: "solve room.toml --solver jacobi --max-iterations 99 --keep-partial",
        told: &["raise --tolerance or --max-iterations"],
    },
    Typed {
        bad: "solve room.toml --solver jacobi --max-iterations 1",
        cured: "solve room.toml --solver lu --keep-partial",
        told: &["or take another --solver; solve --keep-partial writes what there is"],
    },
    Typed {
        bad: "solve room.toml --solver southwell --columns shot --checkpoint columns",
        cured: "solve room.toml --solver southwell --columns shot",
        told: &["leave it out, or what needs all columns: rays (--transport exact has none), --checkpoint"],
    },
    Typed {
        bad: "solve mirror.toml --shadows off --eps 1e-1 --order 5",
        cured: "solve mirror.toml --shadows off --eps 1e-8 --order 2",
        told: &["the spectral radius is about", "quadrature is too coarse for so little loss; lower --eps"],
    },
    Typed {
        bad: "solve mirror.toml --shadows off --eps 1e-1 --order 5",
        cured: "solve mirror.toml --shadows off --eps 1e-8 --order 2",
        told: &["the error of the transfers counts once for every reflection: lower --eps"],
    },
    Typed {
        bad: "solve mirror.toml --shadows mask --order 2",
        cured: "solve mirror.toml --shadows off --eps 1e-8 --order 2",
        told: &["what masks err by counts once for every reflection", "or leave --shadows mask out"],
    },
    Typed {
        bad: "solve mirror.toml --shadows off --method collocation",
        cured: "solve mirror.toml --shadows off --eps 1e-8 --order 2",
        told: &["leave --method collocation out, or take a higher --order"],
    },
    Typed {
        bad: "solve mirror.toml --shadows off --kernel paper-legendre --order 1",
        cured: "solve mirror.toml --shadows off --eps 1e-8 --order 2",
        told: &["the spectral radius is about", "choose the default kernel"],
    },
    Typed {
        bad: "solve mirror.toml --shadows off --kernel paper-legendre --order 1",
        cured: "solve mirror.toml --shadows off --eps 1e-8 --order 2",
        told: &["more than it has: its transfers miss the accuracy asked; choose the default kernel"],
    },
];
