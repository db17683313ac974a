//! x
pub mod board; pub mod machine; pub mod strip; pub mod dual; pub mod mend; pub mod solve;
