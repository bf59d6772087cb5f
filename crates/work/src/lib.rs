//! Work: who shares it, what ends it, and how it is told of.
//!
//! In order: `wording` (sentences of messages, with the names of options as data), `interruption` (ends work at the next
//! possible place), `ranks` (processes or threads that share work, and the journal of what they have done).
//!
//! Imports nothing of the house.

pub mod wording;
pub mod interruption;
pub mod ranks;
