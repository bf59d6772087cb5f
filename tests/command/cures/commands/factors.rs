//! Commands of view factors that are refused.

use super::super::Typed;

pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "view-factors room.toml --pairs room-bottom,room-top -o f.npy",
        cured: "view-factors room.toml --pairs room-bottom,room-top -o f.csv",
        told: &["--pairs are no matrix", "help: choose --format csv or json"],
    },
    Typed {
        bad: "view-factors room.toml --sparse csr -o f.csv",
        cured: "view-factors room.toml --sparse coo -o f.csv",
        told: &["--sparse csr: CSV has no place for it", "help: take --sparse coo"],
    },
    Typed {
        bad: "view-factors room.toml --sparse csr -o f.npy",
        cured: "view-factors room.toml --sparse csr -o f.npz",
        told: &["--sparse csr: NPY has no place for it", "or choose a file ending in .npz"],
    },
    Typed {
        bad: "view-factors room.toml --pairs room-bottom,room-tip",
        cured: "view-factors room.toml --pairs room-bottom,room-top",
        told: &[r#"unknown surface "room-tip""#, r#"help: did you mean "room-top"?"#],
    },
    Typed {
        bad: "view-factors room.toml --transport exact --rays 1000",
        cured: "view-factors room.toml --transport exact",
        told: &["--rays does not go with --transport exact", "help: leave one of them out"],
    },
    Typed {
        bad: "view-factors gap.obj --strict",
        cured: "view-factors gap.obj",
        told: &["help: mend the file, or let repairs be made by leaving out --strict"],
    },
];
