//! Small aperiodic sets of corner tiles, by coloring the vertices of Wang tilings.
pub mod language;
pub mod partition;
pub mod polygon;
pub mod zphi;
