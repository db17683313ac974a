//! All corner tiles on the square torus: every number of colors.

use crate::{check, complete, corner, has_every_window_once, labels};
use tilepack::construct::{corner_even, corner_odd};
use tilepack::tiles::{Kind, TileId};

#[test]
fn every_number_of_colors_up_to_16() {
    for colors in 1..=16 {
        check(&corner(colors, colors * colors, colors * colors, None).unwrap());
    }
}

#[test]
fn every_number_of_colors_up_to_33() {
    for colors in 17..=33 {
        let torus = corner(colors, colors * colors, colors * colors, None).unwrap();
        assert!(has_every_window_once(colors, colors * colors, &labels(&torus)), "{colors}");
    }
}

/// The tables of a torus against the formulas, cell by cell and back.
#[test]
fn closed_forms() {
    for colors in 2..=9usize {
        let side = colors * colors;
        let torus = corner(colors, side, side, None).unwrap();
        let odd = !colors.is_multiple_of(2);
        for (cell, &color) in labels(&torus).iter().enumerate() {
            let (row, column) = (cell / side, cell % side);
            let formula = if odd { corner_odd::color } else { corner_even::color };
            assert_eq!(formula(colors, row, column), color, "{colors}: {row}, {column}");
            if odd {
                let at = |r, c| corner_odd::color(colors, (row + r) % side, (column + c) % side);
                let window = [[at(0, 0), at(0, 1)], [at(1, 0), at(1, 1)]];
                assert_eq!(corner_odd::find(colors, window), (row, column));
            }
        }
    }
}

/// Far too many tiles to look at all of them: the tile in every so manieth cell is found there.
#[test]
fn many_colors() {
    for colors in [47usize, 48, 63, 64, 127, 128, 254, 255] {
        let side = colors * colors;
        let torus = corner(colors, side, side, None).unwrap();
        let mut here = vec![0; side];
        let mut below = vec![0; side];
        for row in [0, 1, 2, 3, side / 2, side / 2 + 1, side - 4, side - 3, side - 2, side - 1] {
            torus.row(row, &mut here);
            torus.row((row + 1) % side, &mut below);
            for column in (0..side).step_by(7).chain([side - 1]) {
                let east = (column + 1) % side;
                let sides = [here[east], below[east], below[column], here[column]];
                let set = complete(Kind::Corner, &colors.to_string());
                let tile: TileId = Kind::Corner.pack(&sides, set.colors()).unwrap();
                assert_eq!(torus.locate(tile), Some((row, column)), "{colors}");
            }
        }
    }
}

#[test]
fn two_colors_give_the_base() {
    let torus = corner(2, 4, 4, None).unwrap();
    assert_eq!(labels(&torus), corner_even::BASE.concat());
    assert_eq!(torus.name(), "numbered 4x4 blocks");
}
