//! Small aperiodic sets of corner tiles, by coloring the vertices of Wang tilings.
pub mod anneal;
pub mod certificate;
pub mod condition;
pub mod language;
pub mod partition;
pub mod polygon;
pub mod rounds;
pub mod vertices;
pub mod zphi;
