//! All corner cubes: stacks of layers, and a packing of another shape.

use tilepack::construct::{CubeStack, Seed, WangCubes, cube_binary};
use tilepack::torus::{CubeKind, CubeSet, Cubes, places};
use tilepack::verify::{CubesFault, check_cube_packing};

#[test]
fn stacks_have_every_cube_once() {
    for (colors, seed) in [(1, None), (2, None), (2, Some(5)), (3, None), (4, Some(1)), (5, None)] {
        let mut seed = seed.map(Seed::new);
        let stack = CubeStack::new(colors, seed.as_mut()).unwrap();
        let (n, layers) = (stack.side(), stack.layers());
        let sides = [layers, n, n];
        let set = CubeSet::new(CubeKind::Corner, [colors as u8; 3]).unwrap();
        let cubes = Cubes::of_points(set, sides, |[l, r, c]| stack.color(l, r, c));
        assert_eq!(check_cube_packing(&cubes), Ok(()), "{colors}");
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
    let color = |[l, r, c]: [usize; 3]| cube_binary::color(l, r, c);
    let set = CubeSet::new(CubeKind::Corner, [2; 3]).unwrap();
    let mut cubes = Cubes::of_points(set, cube_binary::SIDES, color);
    assert_eq!(check_cube_packing(&cubes), Ok(()));
    cubes.cubes[100] = 256;
    let fault = check_cube_packing(&cubes).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "layer 1, row 4, column 4: cube 256 is out of range: expected 0 to 255"
    );
}

#[test]
fn products_of_three_rings() {
    for colors in [[1, 1, 1], [2, 2, 2], [3, 3, 3], [1, 2, 3], [3, 1, 2], [4, 2, 3]] {
        for seed in [None, Some(3)] {
            let set = CubeSet::new(CubeKind::Wang, colors).unwrap();
            let product = WangCubes::new(set, seed.map(Seed::new));
            let packing = product.packing();
            assert_eq!(check_cube_packing(&packing), Ok(()), "{colors:?}");
            // The definition once more: every cube is met, and is where it is said to be.
            let mut met = std::collections::BTreeSet::new();
            let [layers, rows, columns] = product.sides();
            for [l, r, c] in places(product.sides()) {
                let cube = product.colors(l, r, c);
                let [n, e, s, w, b, t] = cube;
                assert!(met.insert(cube));
                assert_eq!(product.find([n, e, s, w, b, t]), (l, r, c));
                assert_eq!(product.colors(l, r, (c + 1) % columns)[3], e);
                assert_eq!(product.colors(l, (r + 1) % rows, c)[0], s);
                assert_eq!(product.colors((l + 1) % layers, r, c)[4], t);
            }
            let [h, v, z] = colors.map(usize::from);
            assert_eq!(met.len(), (h * v * z).pow(2));
        }
    }
}

#[test]
fn wrong_cubes() {
    let set = CubeSet::new(CubeKind::Wang, [2, 3, 2]).unwrap();
    let good = WangCubes::new(set, None).packing();
    let fault = |change: &dyn Fn(&mut Cubes)| {
        let mut cubes = good.clone();
        change(&mut cubes);
        check_cube_packing(&cubes).unwrap_err()
    };
    for (a, b) in [(0, 1), (7, 140), (50, 51)] {
        let swapped = fault(&|cubes| cubes.cubes.swap(a, b));
        assert!(matches!(swapped, CubesFault::Mismatch { .. }), "{swapped}");
    }
    // One color everywhere fits everywhere.
    let repeated = fault(&|cubes| cubes.cubes.fill(0)).to_string();
    assert_eq!(
        repeated,
        "layer 0, row 0, column 1: cube 0 again; it is at layer 0, row 0, column 0, too"
    );
    assert!(fault(&|cubes| cubes.sides = [4, 4, 8]).is_size());
    assert!(fault(&|cubes| cubes.cubes.truncate(8)).is_size());
    assert!(CubeSet::new(CubeKind::Corner, [2, 2, 3]).is_none());
    assert!(CubeSet::new(CubeKind::Wang, [2, 0, 3]).is_none());
    assert!(CubeSet::new(CubeKind::Wang, [255; 3]).is_none());
}
