//! All corner tiles over an even number `C = 2k` of colors on a square torus of `C^2` a side.
//!
//! The torus is tiled by 4 x 4 blocks; block `(u, v)`, `0 <= u, v < k^2`. A color is
//! `2 d + b`: the low bit `b` is that of the torus [`BASE`] in the block, and the digit `d`
//! counts blocks in base `k`: cells in an even row and even column show the low digit of `u`, in
//! an odd row and even column its high digit, and in odd columns likewise the digits of `v`.
//!
//! *Why every window occurs once:* its low bits say where in a block it begins. It has one cell
//! of each parity class, so shows all four digits, and these say which block; only where it
//! begins in the last row of a block does it show the low digit of `u + 1` for that of `u`.
//! (The high digit is then still that of `u`, and digits of `v` stand in odd columns, which the
//! last column of a block shows before the next block begins.)
//!
//! Other members: the digits permuted in each of the 16 cells of the block by itself, the base
//! shifted and transposed, the colors permuted. Existence: Hurlbert, Mitchell, Paterson 1996.

use super::Seed;
use super::corner::Window;

/// The packing of the 16 corner tiles over two colors: the first in row order.
pub const BASE: [[u8; 4]; 4] = [[0, 0, 0, 1], [0, 0, 1, 0], [1, 0, 1, 1], [0, 1, 1, 1]];

/// The color at a row and column, for even `colors`.
pub fn color(colors: usize, row: usize, column: usize) -> u8 {
    let k = colors / 2;
    let block = if column.is_multiple_of(2) { row / 4 } else { column / 4 };
    let digit = if row.is_multiple_of(2) { block % k } else { block / k };
    2 * digit as u8 + BASE[row % 4][column % 4]
}

/// Where in [`BASE`] the window with each four low bits `NW NE SW SE` begins: `4 row + column`.
pub const WINDOWS: [u8; 16] = {
    let mut windows = [0; 16];
    let mut cell = 0;
    while cell < 16 {
        let (row, column) = (cell / 4, cell % 4);
        let (below, east) = ((row + 1) % 4, (column + 1) % 4);
        let (above, beneath) = (&BASE[row], &BASE[below]);
        let low = 8 * above[column] + 4 * above[east] + 2 * beneath[column] + beneath[east];
        windows[low as usize] = cell as u8;
        cell += 1;
    }
    windows
};

/// The row and column of a window, for even `colors`: no table of the torus is needed.
pub fn find(colors: usize, window: Window) -> (usize, usize) {
    let k = colors / 2;
    let begin = usize::from(WINDOWS[bits(window.map(|pair| pair.map(|color| color % 2)))]);
    let (row, column) = (begin / 4, begin % 4);
    // The digit in the even rows (or odd ones) and the even columns (or odd ones) of the torus.
    let digit = |odd_row: usize, odd_column: usize| {
        usize::from(window[(row + odd_row) % 2][(column + odd_column) % 2] / 2)
    };
    // A window that begins in the last row of a block has its even row in the next one.
    let low = (digit(0, 0) + if row == 3 { k - 1 } else { 0 }) % k;
    (4 * (digit(1, 0) * k + low) + row, 4 * (digit(1, 1) * k + digit(0, 1)) + column)
}

/// A member of the family. [`EvenTorus::new`] without a seed is the closed form [`color`].
#[derive(Debug, Clone)]
pub struct EvenTorus {
    /// Half the number of colors.
    k: usize,
    /// For each of the 16 cells of a block, the color for each digit.
    colors: Vec<[u8; 128]>,
    /// The low bit of every color.
    bits: Box<[u8; 256]>,
    /// For the low bits `NW NE SW SE` of a window, what the rest of them says.
    places: [Place; 16],
}

/// What the colors of the windows with given low bits say: row and column are the sums of four
/// digits times their weights. A sum of both at once has the row in its upper half.
#[derive(Debug, Clone)]
struct Place {
    /// Where in a block the window begins.
    begin: u64,
    /// The weights of the digits at NW, NE, SW, SE.
    weights: [u64; 4],
    /// The digits by color, there.
    digits: Box<[[u8; 256]; 4]>,
}

/// A row and a column as one number.
const fn both(row: usize, column: usize) -> u64 {
    (row as u64) << 32 | column as u64
}

impl EvenTorus {
    /// The closed form, or a member chosen by a seed; `colors` must be even.
    pub fn new(colors: usize, mut seed: Option<&mut Seed>) -> Self {
        let k = colors / 2;
        let mut base = BASE;
        let mut names: Vec<u8> = (0..colors).map(|color| color as u8).collect();
        if let Some(seed) = seed.as_deref_mut() {
            let (down, right, transposed) = (seed.below(4), seed.below(4), seed.below(2) == 1);
            for (row, cells) in base.iter_mut().enumerate() {
                for (column, cell) in cells.iter_mut().enumerate() {
                    let (row, column) = ((row + down) % 4, (column + right) % 4);
                    *cell = if transposed { BASE[column][row] } else { BASE[row][column] };
                }
            }
            seed.shuffle(&mut names);
        }
        let mut torus = Self {
            k,
            colors: vec![[0; 128]; 16],
            bits: Box::new([0; 256]),
            places: std::array::from_fn(|_| Place {
                begin: 0,
                weights: [0; 4],
                digits: Box::new([[0; 256]; 4]),
            }),
        };
        for (color, &name) in names.iter().enumerate() {
            torus.bits[usize::from(name)] = color as u8 % 2;
        }
        for cell in 0..16 {
            let (row, column) = (cell / 4, cell % 4);
            let mut order: Vec<u8> = (0..k).map(|digit| digit as u8).collect();
            if let Some(seed) = seed.as_deref_mut() {
                seed.shuffle(&mut order);
            }
            for (digit, &shown) in order.iter().enumerate() {
                let color = names[usize::from(2 * shown + base[row][column])];
                torus.colors[cell][digit] = color;
            }
        }
        for cell in 0..16 {
            let (row, column) = (cell / 4, cell % 4);
            let at = |r: usize, c: usize| base[(row + r) % 4][(column + c) % 4];
            let low = bits([[at(0, 0), at(0, 1)], [at(1, 0), at(1, 1)]]);
            torus.places[low] = torus.place(row, column);
        }
        torus
    }

    /// What a window says that begins at this row and column of a block.
    fn place(&self, row: usize, column: usize) -> Place {
        let k = self.k;
        let mut place =
            Place { begin: both(row, column), weights: [0; 4], digits: Box::new([[0; 256]; 4]) };
        for corner in 0..4 {
            let (r, c) = (row + corner / 2, column + corner % 2);
            place.weights[corner] = match (r % 2, c % 2) {
                (0, 0) => both(4, 0),
                (1, 0) => both(4 * k, 0),
                (0, _) => both(0, 4),
                (_, _) => both(0, 4 * k),
            };
            // Below the last row of a block the low digit is that of the next block.
            let ahead = if r == 4 && c % 2 == 0 { k - 1 } else { 0 };
            for (digit, &color) in self.colors[r % 4 * 4 + c % 4][..k].iter().enumerate() {
                place.digits[corner][usize::from(color)] = ((digit + ahead) % k) as u8;
            }
        }
        place
    }

    /// Columns, and rows.
    pub fn side(&self) -> usize {
        4 * self.k * self.k
    }

    /// Writes the colors of a row.
    pub fn row(&self, row: usize, colors: &mut [u8]) {
        let (k, block) = (self.k, row / 4);
        let even = row.is_multiple_of(2);
        let tables: [&[u8]; 4] = std::array::from_fn(|c| &self.colors[row % 4 * 4 + c][..k]);
        let digit = if even { block % k } else { block / k };
        let (first, third) = (tables[0][digit], tables[2][digit]);
        // The blocks of a row in k runs of k: the high digit of v counts the runs, its low
        // digit the blocks of one.
        for (high, run) in colors.chunks_exact_mut(4 * k).enumerate() {
            let (second, fourth) = (tables[1][high], tables[3][high]);
            if even {
                let digits = tables[1].iter().zip(tables[3]);
                for (cells, (&second, &fourth)) in run.chunks_exact_mut(4).zip(digits) {
                    cells.copy_from_slice(&[first, second, third, fourth]);
                }
            } else {
                for cells in run.chunks_exact_mut(4) {
                    cells.copy_from_slice(&[first, second, third, fourth]);
                }
            }
        }
    }

    /// The row and column of a window.
    pub fn find(&self, window: Window) -> (usize, usize) {
        let low = window.map(|pair| pair.map(|color| self.bits[usize::from(color)]));
        let place = &self.places[bits(low) & 15];
        let sum = (0..4).fold(place.begin, |sum, corner| {
            let color = window[corner / 2][corner % 2];
            sum + u64::from(place.digits[corner][usize::from(color)]) * place.weights[corner]
        });
        ((sum >> 32) as usize, sum as u32 as usize)
    }
}

/// The low bits of a window as one number.
fn bits([[nw, ne], [sw, se]]: Window) -> usize {
    usize::from(8 * nw + 4 * ne + 2 * sw + se)
}
