//! Exact numbers of packings without meeting them one by one.
//!
//! * [`best`]: rings of dominoes, by the theorem of de Bruijn, van Aardenne-Ehrenfest, Smith and
//!   Tutte.

pub mod best;
