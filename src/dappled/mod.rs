//! Dappled tilings: rectangles of tiles in which nothing repeats for too long.
//!
//! A tiling by `K` tiles is *dappled* when no tile stands more than `p` times in a row or `q`
//! times in a column; limits differ by tile, by direction, even by cell, and a set of tiles may
//! have a limit of its own. All of them are [`Condition`]s of one form: *of these tiles, no more
//! than so many side by side*. A [`Rule`] holds them for a rectangle whose edges are free or meet.
//!
//! * [`Field`] is a tiling, or part of one; [`Rule`] what it must keep, and the obvious check;
//! * [`brick`] are walls, tiles of which are laid by such tilings;
//! * [`count`] tells how many there are, and draws them at random;
//! * [`exact`] completes partial tilings, or proves that they have no completion;
//! * [`faults`] finds all that a field breaks, fast;
//! * [`make()`](make::make) changes any field into a tiling, in time that grows with its cells alone;
//! * [`mod@flow`] has streams wind through tilings of two tiles;
//! * [`closest`] finds the nearest dappled tiling of a field, with proof;
//! * [`notation`] reads limits, fields and maps of limits from text.
//!
//! **Where things are**: columns count from the west, rows from the north, both from 0.
//!
//! **Lines that meet their own end**: without end they repeat for ever, so a line of one tile
//! alone breaks every limit, however short the line is (the strict reading).
//!
//! Source: Kaji, Derouet-Jourdan, Ochiai, *Dappled tiling*, 2016.

pub mod brick;
pub mod closest;
pub mod count;
pub mod exact;
pub mod faults;
mod field;
pub mod flow;
pub mod make;
pub mod notation;
mod rule;

pub use field::{FREE, Field, FieldError, MOST_CELLS};
pub use rule::{Condition, Direction, Edges, Fault, Limit, MOST_TILES, Rule, RuleError, Window};
