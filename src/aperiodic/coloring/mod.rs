//! Small aperiodic sets of corner tiles, by coloring the vertices of Wang tilings.
//!
//! Take a set of Wang tiles that is known to be aperiodic, and give every vertex of its tilings a
//! color by the tiles around it. The corner tiles that come up fill the plane. If moreover every
//! tiling by them gives one by the Wang tiles, by a rule that looks only a few cells around, none
//! of them has a period. Colors are chosen so that there are few corner tiles.
//!
//! * [`language`] finds the windows of the Wang tilings, exactly with a [`partition`] of a torus
//!   into [`polygon`]s over `Z[phi]` ([`zphi`]), or from a
//!   [`super::patch`];
//! * [`vertices`] are the classes that get colors, [`condition`] says when the way back exists;
//! * [`anneal`] is one round of the search, [`rounds`] are many;
//! * [`certificate`] puts together what a checker needs.

pub mod anneal;
pub mod certificate;
pub mod condition;
pub mod language;
pub mod partition;
pub mod polygon;
pub mod rounds;
pub mod vertices;
pub mod zphi;
