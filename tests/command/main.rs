//! The command as its users meet it: what it prints, refuses and leaves behind, and closed forms run through it.

mod analytic_cases;
mod animate;
mod bad_input;
mod behaviour;
mod builtin;
mod exact_factors;
mod fitted;
mod formats;
mod frames;
mod glb;
mod heat;
mod hostile_names;
mod imports;
mod inspection;
mod language;
mod luminaires;
mod matrices;
mod pictures;
mod planes;
mod probe;
mod program;
mod relight;
mod report;
mod solution_file;
mod textures;
mod vtu;
