//! Made-up pictures keep the strip they promise.

use super::{FINE, corner, noise, wang};
use tilepack::atlas::fill::{Canvas, Marks, Noise, Truchet};
use tilepack::atlas::{Format, StripCheck, TileImages};
use tilepack::torus::Packing;

fn keeps(packing: &Packing, images: &dyn TileImages, strip: usize) -> Result<(), String> {
    let mut check = StripCheck::new(packing.set.kind(), packing.set.colors(), strip);
    packing.tiles.iter().try_for_each(|&tile| {
        let image = images.draw(tile).unwrap();
        check.add(tile, &image).map_err(|error| error.to_string())
    })
}

#[test]
fn of_every_kind_size_and_width() {
    for packing in [corner(2), corner(3), wang(2, 2), wang(3, 2)] {
        for (side, strips) in
            [(1, vec![0]), (8, vec![0, 1, 2, 3, 4]), (33, vec![1, 5, 16]), (64, vec![4, 32])]
        {
            for strip in strips {
                for format in [Format::RGBA8, FINE] {
                    let (kind, colors) = (packing.set.kind(), packing.set.colors());
                    let canvas = Canvas { kind, colors, side, strip, format };
                    let all: [&dyn TileImages; 3] = [
                        &Marks { canvas },
                        &Noise { canvas, seed: 3, loose_corners: false },
                        &Truchet { canvas, seed: 3 },
                    ];
                    for (which, images) in all.into_iter().enumerate() {
                        let kept = keeps(&packing, images, strip);
                        assert_eq!(kept, Ok(()), "{which} {kind} {side} {strip}");
                    }
                }
            }
        }
    }
}

#[test]
fn and_no_wider_one() {
    for packing in [corner(3), wang(2, 2)] {
        let images = noise(&packing, 32, 4, Format::RGBA8);
        assert!(keeps(&packing, &images, 5).is_err());
    }
    let square = wang(2, 2);
    let loose = Noise { loose_corners: true, ..noise(&square, 32, 4, Format::RGBA8) };
    let error = keeps(&square, &loose, 4).unwrap_err();
    assert!(error.contains("differ at column"), "{error}");
}

/// Curves go on from tile to tile: no step across a seam is much larger than those inside.
#[test]
fn curves_are_seamless() {
    use tilepack::atlas::lint::{Question, lint};
    use tilepack::atlas::{Arrangement, Layout, Sheet, assemble};
    for packing in [corner(3), wang(2, 2)] {
        let (kind, colors) = (packing.set.kind(), packing.set.colors());
        let canvas = Canvas { kind, colors, side: 64, strip: 4, format: Format::RGBA8 };
        let images = Truchet { canvas, seed: 1 };
        let layout = Layout::new(&packing, Arrangement::Packed, 64, 0).unwrap();
        let whole = assemble(&images, &packing.tiles, layout.columns).unwrap();
        let sheet = Sheet::new(whole, layout).unwrap();
        let findings = lint(&sheet, Question { strip: 4, tolerance: 0.0 }).unwrap();
        assert!(findings.deviations.is_empty());
        assert_eq!(findings.visible().count(), 0, "{kind}");
    }
}
