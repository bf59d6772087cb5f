//! Radiant heat against closed forms of grey enclosures (Modest, Radiative Heat Transfer, chapter 5), at
//! order 0 where the forms are those of networks; and what a balance of heat cannot be made of.

mod shared;
mod backs;
mod curved;
mod enclosures;
mod gaps;
mod kept;
mod levels;
mod random;
mod rays;
mod refusals;
