//! Packings that need no search: mathematics says which color stands where.
//!
//! * [`euler`]: rings of dominoes, by Hierholzer's algorithm, for any list of dominoes;
//!   [`ring`]: rings of all dominoes in closed form, both ways.
//! * [`wang_product`]: all Wang tiles, as a ring of columns times a ring of rows.
//! * [`corner_odd`], [`corner_even`]: all corner tiles over any number of colors on the square
//!   torus; [`corner_tall`], [`extend`], [`product`]: tori of other shapes; [`corner`]: which of
//!   these gives a torus of a shape.
//! * [`cube_stack`]: all corner cubes, in space; [`cube_binary`]: those over two colors in another
//!   shape; [`wang_cube`]: all Wang cubes, as a product of three rings.
//! * [`registry`]: what covers which set and shape.
//!
//! Every construction works both ways: from a cell to its colors, and from a tile to its cell.

pub mod corner;
pub mod corner_even;
pub mod corner_odd;
pub mod corner_tall;
pub mod cube_binary;
pub mod cube_stack;
pub mod euler;
pub mod extend;
pub mod product;
pub mod registry;
pub mod ring;
pub mod seed;
pub mod wang_cube;
pub mod wang_product;

pub use corner::{CornerTorus, Window};
pub use cube_stack::CubeStack;
pub use euler::{Digraph, NoCircuit};
pub use registry::{Constructed, NotConstructed, construct, construct_wei};
pub use ring::Ring;
pub use seed::Seed;
pub use wang_cube::WangCubes;
