//! Exactness of filtering: against the oracle, and what the theory says.

use super::oracle::{Picture, Way, largest, tiling};
use super::{FINE, compact, corner, noise, wang};
use tilepack::atlas::fill::Noise;
use tilepack::atlas::filter::{Direction, Exactness, Filter, Footprint};
use tilepack::atlas::{Arrangement, Format, Gutter, Image, Layout, Scene, TileImages};
use tilepack::tiles::Kind;
use tilepack::torus::Packing;

fn levels(
    packing: &Packing,
    layout: &Layout,
    gutter: Gutter,
    images: &dyn TileImages,
) -> Vec<Image> {
    Scene { layout, packing, gutter, images }.levels(layout.levels()).unwrap()
}

fn exactness(
    packing: &Packing,
    arrangement: Arrangement,
    gutter: (usize, Gutter),
    images: &Noise,
) -> Exactness {
    let layout = Layout::new(packing, arrangement, images.canvas.side, gutter.0).unwrap();
    let levels = levels(packing, &layout, gutter.1, images);
    Filter::new(&layout, &levels).unwrap().exactness()
}

const PACKED: (Arrangement, (usize, Gutter)) = (Arrangement::Packed, (0, Gutter::Neighbor));

/// What is looked at: a name, pictures, where tiles lie, and their gutters.
type Case<'a> = (&'a str, &'a Packing, Noise, Arrangement, (usize, Gutter));

/// The same largest difference as filtering a large tiling gives; zero where it gives zero.
#[test]
fn as_the_oracle_says() {
    let two = corner(2);
    let square = compact(Kind::Wang, 2);
    let strict = |packing: &Packing, strip| noise(packing, 8, strip, FINE);
    let loose = Noise { loose_corners: true, ..strict(&square, 2) };
    let by_number = Arrangement::ByNumber;
    let (packed, none) = PACKED;
    let cases: [Case<'_>; 6] = [
        ("corner, packed", &two, strict(&two, 2), packed, none),
        ("corner, by number", &two, strict(&two, 2), by_number, none),
        ("corner, gutter", &two, strict(&two, 2), by_number, (2, Gutter::Neighbor)),
        ("corner, clamped", &two, strict(&two, 2), by_number, (4, Gutter::Clamp)),
        ("wang, packed", &square, strict(&square, 2), packed, none),
        ("wang, loose corners", &square, loose, packed, none),
    ];
    for (name, packing, images, arrangement, (gutter, fill)) in cases {
        let layout = Layout::new(packing, arrangement, 8, gutter).unwrap();
        let shipped = levels(packing, &layout, fill, &images);
        let filter = Filter::new(&layout, &shipped).unwrap();
        let atlas = Picture::of(&shipped[0]).levels(shipped.len());
        let tiles = tiling(packing, 40);
        let mut ways = vec![
            (Way::Bilinear(0), Footprint::Bilinear { level: 0 }),
            (Way::Bilinear(1), Footprint::Bilinear { level: 1 }),
            (Way::Trilinear(0), Footprint::Trilinear { level: 0 }),
        ];
        if shipped.len() > 2 {
            ways.push((Way::Bilinear(2), Footprint::Bilinear { level: 2 }));
        }
        for (direction, dx, dy) in [
            (Direction::East, 1.0, 0.0),
            (Direction::South, 0.0, 1.0),
            (Direction::SouthEast, 1.0, 1.0),
            (Direction::NorthEast, 1.0, -1.0),
        ] {
            let ratio = 4;
            let footprint = Footprint::Anisotropic { level: 0, ratio, direction };
            ways.push((Way::Anisotropic(ratio, dx, dy), footprint));
        }
        for (way, footprint) in ways {
            let expected = largest(&layout, &atlas, &images, &tiles, way);
            let found = filter.error(footprint);
            assert_eq!(found == 0.0, expected == 0.0, "{name}, {footprint:?}: {found} {expected}");
            // The levels are rounded to 16 bits; the oracle's are not.
            assert!((found - expected).abs() < 0.02, "{name}, {footprint:?}: {found} {expected}");
        }
    }
}

/// The table of what is exact: tiles of 32 texels, a strip of 4, sRGB.
#[test]
fn exact_through_the_logarithm_of_the_strip() {
    let tiles = [corner(2), corner(3), compact(Kind::Corner, 3), wang(2, 2), wang(2, 3)];
    for packing in &tiles {
        for (strip, lod) in [(1, 0), (2, 1), (4, 2), (7, 2), (8, 3)] {
            let images = noise(packing, 32, strip, Format::RGBA8);
            let figures = exactness(packing, PACKED.0, PACKED.1, &images);
            assert_eq!(figures.exact_to_lod(), Some(lod), "{:?} {strip}", packing.set);
            for (ratio, error) in figures.anisotropic {
                assert_eq!(error == 0.0, ratio <= 2 * strip, "{ratio}:1, {strip}");
            }
        }
    }
}

#[test]
fn not_exact_without_packing_or_with_clamped_gutters_or_loose_corners() {
    let three = corner(3);
    let images = noise(&three, 32, 4, Format::RGBA8);
    for gutter in [(0, Gutter::Neighbor), (16, Gutter::Clamp)] {
        let figures = exactness(&three, Arrangement::ByNumber, gutter, &images);
        assert_eq!(figures.exact_to_lod(), None);
        assert!(figures.bilinear[0] > 60.0 && figures.anisotropic[1].1 > 60.0, "{figures:?}");
    }
    let square = wang(2, 2);
    let images = Noise { loose_corners: true, ..noise(&square, 32, 4, Format::RGBA8) };
    let figures = exactness(&square, PACKED.0, PACKED.1, &images);
    assert_eq!(figures.exact_to_lod(), None);
    assert!(figures.bilinear[0] > 60.0, "{figures:?}");
}

/// A gutter of legal neighbors is as good as a packing, as far as it goes.
#[test]
fn gutters_of_neighbors_are_exact() {
    let three = corner(3);
    let images = noise(&three, 32, 4, Format::RGBA8);
    for arrangement in [Arrangement::Packed, Arrangement::ByNumber] {
        for (gutter, lod) in [(1, 0), (2, 1), (4, 2), (8, 2)] {
            let figures = exactness(&three, arrangement, (gutter, Gutter::Neighbor), &images);
            assert_eq!(figures.exact_to_lod(), Some(lod), "{gutter}");
        }
    }
}

/// Tiles that are all alike can be filtered at any level.
#[test]
fn one_color_is_exact_everywhere() {
    let one = corner(1);
    let images = noise(&one, 16, 8, Format::RGBA8);
    let figures = exactness(&one, PACKED.0, PACKED.1, &images);
    assert_eq!(figures.exact_to_lod(), Some(4));
}
