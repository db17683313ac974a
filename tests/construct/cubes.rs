//! All corner cubes: stacks of layers, and a packing of another shape.

use tilepack::construct::{CubeStack, Seed, corner_even::BASE};
use tilepack::verify::{CubeFault, check_cubes};

fn points(stack: &CubeStack) -> Vec<u8> {
    let (n, layers) = (stack.side(), stack.layers());
    let at = |cell: usize| stack.color(cell / (n * n), cell / n % n, cell % n);
    (0..layers * n * n).map(at).collect()
}

#[test]
fn stacks_have_every_cube_once() {
    for (colors, seed) in [(1, None), (2, None), (2, Some(5)), (3, None), (4, Some(1)), (5, None)] {
        let mut seed = seed.map(Seed::new);
        let stack = CubeStack::new(colors, seed.as_mut()).unwrap();
        let (n, layers) = (stack.side(), stack.layers());
        let sides = [layers, n, n];
        assert_eq!(check_cubes(colors as u8, sides, &points(&stack)), Ok(()), "{colors}");
        for cell in 0..layers * n * n {
            let (l, i, j) = (cell / (n * n), cell / n % n, cell % n);
            let at = |l, i, j| stack.color(l % layers, i % n, j % n);
            let face = |l| [[at(l, i, j), at(l, i, j + 1)], [at(l, i + 1, j), at(l, i + 1, j + 1)]];
            assert_eq!(stack.find(face(l), face(l + 1)), (l, i, j), "{colors}");
        }
    }
}

/// Four layers of 8x8 over two colors: another shape, not by a stack.
#[test]
fn eight_by_eight_by_four() {
    let first = [0b0101_1000, 0b0110_0001, 0b1111_1011, 0b0101_1100];
    let second = [0b0111_0101, 0b1000_0011, 0b0111_0011, 0b1010_1111u8];
    let rows = [first, second].concat();
    let color = |l: usize, i: usize, j: usize| {
        let base = if l % 2 == 1 { BASE[i % 4][j % 4] } else { 0 };
        ((rows[i] >> (7 - j) & 1) + base + (l / 2) as u8) % 2
    };
    let mut points: Vec<u8> = (0..256).map(|p| color(p / 64, p / 8 % 8, p % 8)).collect();
    assert_eq!(check_cubes(2, [4, 8, 8], &points), Ok(()));
    points[77] ^= 1;
    assert!(matches!(check_cubes(2, [4, 8, 8], &points), Err(CubeFault::Cube { .. })));
    points[77] = 2;
    assert!(matches!(check_cubes(2, [4, 8, 8], &points), Err(CubeFault::Cube { .. })));
    let size = CubeFault::Size { points: 256, cubes: 256 };
    assert_eq!(check_cubes(2, [4, 8, 7], &points), Err(size));
}
