//! Known answers, and answers of small problems by trying everything: every engine must give
//! them.

#![allow(clippy::unwrap_used, clippy::panic)]

mod automorphisms;
mod best;
mod coverings;
mod engines;
mod explicit;
mod first;
mod holes;
mod oracle;
mod pins;
mod prunings;
mod table;
