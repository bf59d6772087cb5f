//! Warnings of runs, with the cures that they name.

use super::Typed;

/// Runs of `room.toml`, two walls of which shine, of `cube.toml`, all whose walls do, of `round.toml`, in which a ball
/// hangs there, of `hung.toml`, where a lamp hangs in a room, of `mirror.toml`, whose walls reflect nearly all light,
/// and of scenes made for their warnings.
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
        cured: "solve room.toml --solver lu --max-iterations 1 --keep-partial",
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
        bad: "solve room.toml --accuracy 1e-1 --solver jacobi --max-iterations 1 --keep-partial --audit 0.001",
        cured: "solve room.toml --accuracy 1e-1 --solver jacobi --max-iterations 99 --keep-partial --audit 0.001",
        told: &["the solver did not converge in a finer run: raise --max-iterations"],
    },
    Typed {
        bad: "solve room.toml --accuracy 1e-1 --solver jacobi --max-iterations 1 --keep-partial --audit 0.001",
        cured: "solve room.toml --accuracy 1e-1 --solver lu --max-iterations 1 --keep-partial --audit 0.001",
        told: &["the solver did not converge in a finer run", "or take another --solver"],
    },
    Typed {
        bad: "solve room.toml --transport sampled --rays 1 --audit 0.001",
        cured: "solve room.toml --transport sampled --rays 1 --accuracy 1e-1 --audit 0.001",
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
        told: &[
            "rays leave errors of up to",
            "or take --transport exact without --rays, which takes its time",
        ],
    },
    Typed {
        bad: "solve room.toml --transport sampled --rays 1 --audit 0.001",
        cured: "solve room.toml --transport sampled --rays 9999 --audit 0.001",
        told: &["rays leave an error of about", "send more with --rays"],
    },
    Typed {
        bad: "solve room.toml --solver jacobi --max-iterations 1",
        cured: "solve room.toml --solver jacobi --max-iterations 99",
        told: &["raise --tolerance or --max-iterations"],
    },
    Typed {
        bad: "solve room.toml --solver jacobi --max-iterations 1",
        cured: "solve room.toml --solver lu --max-iterations 1",
        told: &["or take another --solver; solve --keep-partial writes what there is"],
    },
    Typed {
        bad: "solve room.toml --solver southwell --columns shot --checkpoint columns",
        cured: "solve room.toml --solver southwell --columns shot",
        told: &["leave it out, or what needs all columns: rays (--transport exact has none), --checkpoint"],
    },
    Typed {
        bad: "solve mirror.toml --shadows off --eps 1e-1 --order 5",
        cured: "solve mirror.toml --shadows off --eps 1e-8 --order 5",
        told: &["the spectral radius is about", "quadrature is too coarse for so little loss; lower --eps"],
    },
    Typed {
        bad: "solve mirror.toml --shadows off --eps 1e-1 --order 5",
        cured: "solve mirror.toml --shadows off --eps 1e-8 --order 5",
        told: &["the error of the transfers counts once for every reflection: lower --eps"],
    },
    Typed {
        bad: "solve mirror.toml --eps 1e-1 --order 5 --audit 0.001",
        cured: "solve mirror.toml --eps 1e-8 --order 5 --audit 0.001",
        told: &["the error of the transfers counts once for every reflection: lower --eps"],
    },
    Typed {
        bad: "solve mirror.toml --shadows mask --order 2",
        cured: "solve mirror.toml --shadows mask --order 2 --eps 1e-8",
        told: &["what masks and transfers err by counts once for every reflection: lower --eps"],
    },
    Typed {
        bad: "solve unsettled.toml --shadows mask --subdivide 1 --order 0",
        cured: "solve finer.toml --shadows mask --subdivide 1 --order 0",
        told: &["take more --mask-cells, or more cells in [[masks]] that state them"],
    },
    Typed {
        bad: "solve mirror.toml --shadows off --eps 4e-6 --order 2 --method collocation",
        cured: "solve mirror.toml --shadows off --eps 4e-6 --order 2",
        told: &["leave --method collocation out, or take a higher --order"],
    },
    Typed {
        bad: "solve mirror.toml --shadows off --eps 1e-8 --order 1 --kernel paper-legendre",
        cured: "solve mirror.toml --shadows off --eps 1e-8 --order 1",
        told: &["the spectral radius is about", "choose the default kernel"],
    },
    Typed {
        bad: "solve mirror.toml --shadows off --eps 1e-8 --order 1 --kernel paper-legendre",
        cured: "solve mirror.toml --shadows off --eps 1e-8 --order 1",
        told: &["more than it has: its transfers miss the accuracy asked; choose the default kernel"],
    },
    Typed {
        bad: "solve round.toml --shadows off --order 1",
        cured: "solve round.toml --order 1 --audit 0.001",
        told: &[
            "an element sends",
            "more than it has",
            "where surfaces stand between others, leave --shadows off out, which lets light through them",
        ],
    },
    Typed {
        bad: "view-factors round.toml --shadows off",
        cured: "view-factors round.toml --audit 0.001",
        told: &[
            "sends 2.09 % more than it has: lower --eps; where surfaces stand between others, leave --shadows off out",
        ],
    },
    Typed {
        bad: "solve unsettled.toml --shadows mask --subdivide 1 --order 1",
        cured: "solve settled.toml --shadows mask --subdivide 1 --order 1",
        told: &["choose fewer pairs in [[masks]], of emitters that reflect little"],
    },
    Typed {
        bad: "heat gap.toml --subdivide 1 --order 3 --audit 0.1",
        cured: "heat gap.toml --subdivide 1 --order 6 --audit 0.1",
        told: &[
            "the balance by itself tells an error of",
            "path tracing finds more",
            "take a higher --order",
        ],
    },
    Typed {
        bad: "heat gap.toml --subdivide 1 --order 3 --audit 0.1",
        cured: "heat gap.toml --subdivide 4 --order 3 --audit 0.1",
        told: &["the balance by itself tells an error of", "or more elements by --subdivide"],
    },
    Typed {
        bad: "probe room.toml --points right.csv --read basis --subdivide 1 --order 0 --audit 0.001",
        cured: "probe room.toml --points right.csv --read basis --subdivide 1 --order 0 --audit 0.001 --accuracy 1e-1 --for solution",
        told: &["the method tells an error of", "ask for an --accuracy with --for solution"],
    },
    Typed {
        bad: "probe room.toml --points right.csv --read basis --subdivide 1 --order 0 --audit 0.001",
        cured: "probe room.toml --points right.csv --read gather --subdivide 1 --order 0 --audit 0.001",
        told: &["the method tells an error of", "or take --read gather"],
    },
    Typed {
        bad: "probe beam.toml --points right.csv --order 0 --audit 0.001",
        cured: "probe beam-cut.toml --points right.csv --order 0 --audit 0.001",
        told: &["narrow beams and patches of luminaires", "a finer subdivide = [n, n] of their own"],
    },
    Typed {
        bad: "probe torch.toml --points right.csv --direct split --order 1 --audit 0.001",
        cured: "probe torch.toml --points right.csv --direct projected --order 1 --audit 0.001",
        told: &["direct light, which is split off, falls on elements", "or take --direct projected"],
    },
    Typed {
        bad: "solve coarse.toml --accuracy 1e-3 --audit 0.001",
        cured: "solve room.toml --accuracy 1e-3 --audit 0.001",
        told: &["there is no finer run to try: leave out the order and the subdivide that surfaces state"],
    },
    Typed {
        bad: "probe distant.toml --points middle.csv --read-by walks --accuracy 1e-1 --audit 0.001",
        cured: "probe distant.toml --points middle.csv --read-by rays --accuracy 1e-1 --audit 0.001",
        told: &["walks end where each reading has had its most: take --read-by rays"],
    },
];
