//! Warnings of runs, with the cures that they name.

use super::Typed;

/// Runs of `room.toml`, a cube whose walls shine, and of `hung.toml`, where a lamp hangs in a room.
pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "render hung.toml -o p.png --size 8x8",
        cured: "render hung.toml -o p.png --size 8x8 --shadow-eps 1e-2",
        told: &["of the largest of their row only", "--shadow-eps 1e-2 asks for no more than these reach"],
    },
    Typed {
        bad: "render room.toml -o p.png --size 8x8 --method hierarchical --eps 1e-2",
        cured: "render room.toml -o p.png --size 8x8",
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
        bad: "probe room.toml --points far.csv",
        cured: "probe room.toml --points points.csv",
        told: &["1 of the 2 points lie outside of the room or in solids: move them"],
    },
];
