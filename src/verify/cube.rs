//! Checking a packing of all corner cubes from the definition.
//!
//! Colors stand on the points of a torus in space; eight neighboring points are the corners of a
//! cube. Over `C` colors there are `C^8` cubes, and in a packing each occurs exactly once: as
//! many points as cubes, and no cube twice.

/// What is wrong with a packing of cubes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum CubeFault {
    /// The number of points is not that of the cubes, or that of the sides.
    #[error("{points} points, but there are {cubes} cubes")]
    Size {
        /// The points given.
        points: usize,
        /// The cubes over the colors.
        cubes: u64,
    },
    /// A color is out of range, or a cube occurs again.
    #[error("layer {layer}, row {row}, column {column}: a color out of range, or a cube again")]
    Cube {
        /// From the bottom.
        layer: usize,
        /// From the north.
        row: usize,
        /// From the west.
        column: usize,
    },
}

/// Checks that every cube over the colors occurs once; `points` are the colors by layers, in
/// each by rows, and `sides` the numbers of layers, rows and columns. Takes a byte a cube.
///
/// # Errors
/// The first fault.
pub fn check_cubes(colors: u8, sides: [usize; 3], points: &[u8]) -> Result<(), CubeFault> {
    let [layers, rows, columns] = sides;
    let cubes = u64::from(colors).pow(8);
    let all = layers.checked_mul(rows).and_then(|plane| plane.checked_mul(columns));
    if all != Some(points.len()) || cubes != points.len() as u64 {
        return Err(CubeFault::Size { points: points.len(), cubes });
    }
    let mut seen = vec![false; points.len()];
    for layer in 0..layers {
        for row in 0..rows {
            for column in 0..columns {
                let fault = CubeFault::Cube { layer, row, column };
                let mut number = 0;
                for corner in 0..8 {
                    let l = (layer + corner / 4) % layers;
                    let r = (row + corner / 2 % 2) % rows;
                    let c = (column + corner % 2) % columns;
                    let color = points[(l * rows + r) * columns + c];
                    if color >= colors {
                        return Err(fault);
                    }
                    number = number * usize::from(colors) + usize::from(color);
                }
                if std::mem::replace(&mut seen[number], true) {
                    return Err(fault);
                }
            }
        }
    }
    Ok(())
}
