//! All shapes of all corner tiles up to 12 colors: each is constructed, or listed as not covered.

use crate::{check, corner};
use tilepack::construct::NotConstructed;

/// Colors, width, height of the shapes with both sides at least 3 for which nothing is known.
const NOT_COVERED: &[(usize, usize, usize)] = &[
    (6, 162, 8),
    (6, 81, 16),
    (6, 16, 81),
    (6, 8, 162),
    (10, 1250, 8),
    (10, 625, 16),
    (10, 16, 625),
    (10, 8, 1250),
    (12, 256, 81),
    (12, 162, 128),
    (12, 128, 162),
    (12, 81, 256),
];

#[test]
fn every_shape_up_to_12_colors() {
    let mut not_covered = Vec::new();
    let mut covered = 0;
    for colors in 2..=12usize {
        let cells = colors.pow(4);
        for height in (3..=cells / 3).filter(|&height| cells.is_multiple_of(height)) {
            let width = cells / height;
            match corner(colors, width, height, None) {
                Ok(torus) => {
                    check(&torus);
                    covered += 1;
                }
                Err(NotConstructed::Unknown(_)) => not_covered.push((colors, width, height)),
                Err(error) => unreachable!("{error}"),
            }
        }
    }
    assert_eq!((covered, not_covered), (105, NOT_COVERED.to_vec()));
}

#[test]
fn narrow_shapes_are_impossible() {
    for (colors, width, height) in [(2, 2, 8), (4, 256, 1), (6, 648, 2)] {
        let Err(NotConstructed::Impossible(why)) = corner(colors, width, height, None) else {
            unreachable!()
        };
        assert!(why.contains("both sides must be at least 3"), "{why}");
    }
}

/// A few large ones: sides of every sort.
#[test]
fn larger_shapes() {
    for (colors, width, height) in [
        (15, 225, 225),
        (15, 15, 3375),
        (16, 64, 1024),
        (18, 108, 972),
        (20, 320, 500),
        (21, 147, 1323),
    ] {
        check(&corner(colors, width, height, None).unwrap());
    }
}

#[test]
fn the_name_says_how() {
    let name = |colors, w, h| corner(colors, w, h, None).unwrap().name().to_owned();
    assert_eq!(name(3, 27, 3), "raised and rotated triangular numbers");
    assert_eq!(name(4, 64, 4), "extension of 4x4 over 2 colors (numbered 4x4 blocks)");
    assert!(name(6, 108, 12).starts_with("product of 4x4 over 2 colors"), "{}", name(6, 108, 12));
}
