//! Sheets of others: what is off is found, and named.

use super::{compact, corner, noise, wang};
use tilepack::atlas::lint::{Findings, Question, heat_map, lint};
use tilepack::atlas::{Arrangement, Format, Image, Layout, Sheet, assemble};
use tilepack::tiles::Side;
use tilepack::tiles::{Kind, TileId};
use tilepack::torus::Packing;

const QUESTION: Question = Question { strip: 4, tolerance: 0.0 };

fn sheet(packing: &Packing, change: impl Fn(&mut Image)) -> Sheet {
    let images = noise(packing, 32, 4, Format::RGBA8);
    let layout = Layout::new(packing, Arrangement::Packed, 32, 0).unwrap();
    let mut whole = assemble(&images, &packing.tiles, layout.columns).unwrap();
    change(&mut whole);
    Sheet::new(whole, layout).unwrap()
}

fn look(packing: &Packing, change: impl Fn(&mut Image)) -> Findings {
    lint(&sheet(packing, change), QUESTION).unwrap()
}

#[test]
fn a_good_sheet_is_good() {
    for packing in [corner(3), wang(2, 3), compact(Kind::Corner, 3)] {
        let findings = look(&packing, |_| ());
        assert!(findings.deviations.is_empty() && findings.redraw.is_empty());
        assert!(findings.twice.is_empty() && findings.alike.is_empty());
        assert!(findings.lonely.is_empty() && findings.visible().next().is_none());
    }
}

/// The number of pairs that may lie side by side, by formula: complete corner sets have C^6 of
/// either direction, complete Wang sets CH^4 CV^3 side by side and CH^3 CV^4 above each other.
#[test]
fn all_pairs_are_looked_at() {
    assert_eq!(look(&corner(2), |_| ()).seams.len(), 2 * 64);
    assert_eq!(look(&corner(3), |_| ()).seams.len(), 2 * 729);
    assert_eq!(look(&wang(2, 3), |_| ()).seams.len(), 16 * 27 + 8 * 81);
}

#[test]
fn one_texel_is_found() {
    let packing = corner(3);
    // Row 2, column 4; the third row of texels in its south strip.
    let findings = look(&packing, |whole| {
        let (x, y) = (4 * 32 + 11, 2 * 32 + 30);
        let sample = whole.sample(x, y, 1);
        whole.set_sample(x, y, 1, sample ^ 64);
    });
    let cell = 2 * 9 + 4;
    assert_eq!(findings.deviations.len(), 1);
    let found = findings.deviations[0];
    assert_eq!((found.cell, found.side, found.corner), (cell, Side::South, false));
    assert_eq!((found.largest, found.at), (64.0, (11, 30)));
    assert_eq!(findings.redraw[0].0, cell);
    let tolerant = Question { tolerance: 64.0, ..QUESTION };
    let sheet = sheet(&packing, |_| ());
    assert!(lint(&sheet, tolerant).unwrap().deviations.is_empty());
}

#[test]
fn the_corner_problem_is_found() {
    let packing = wang(2, 2);
    let findings = look(&packing, |whole| whole.set_sample(32 + 1, 2, 0, 9));
    // The texel lies in both strips of the NW corner, and in the corner.
    assert_eq!(findings.deviations.len(), 3);
    assert!(findings.deviations.iter().any(|deviation| deviation.corner));
    assert!(findings.deviations.iter().all(|deviation| deviation.cell == 1));
}

#[test]
fn a_tile_of_another_drawing_makes_visible_seams() {
    let packing = corner(2);
    let layout = Layout::new(&packing, Arrangement::Packed, 16, 0).unwrap();
    let mut whole = Image::new(64, 64, Format::RGBA8);
    for y in 0..64 {
        for x in 0..64 {
            let light = if (x / 16, y / 16) == (1, 2) { 200 } else { 100 };
            (0..3).for_each(|channel| whole.set_sample(x, y, channel, light + (x % 3) as u16));
        }
    }
    let sheet = Sheet::new(whole, layout).unwrap();
    let findings = lint(&sheet, Question { strip: 0, tolerance: 0.0 }).unwrap();
    let cell = 2 * 4 + 1;
    assert!(findings.visible().next().is_some());
    assert!(findings.visible().all(|seam| seam.first == cell || seam.second == cell));
    assert_eq!(findings.redraw[0].0, cell);
}

#[test]
fn missing_partners_and_repeated_tiles() {
    let all = wang(2, 2);
    // Only tiles whose east is 1; twice the first of them.
    let mut tiles: Vec<TileId> =
        all.tiles.iter().copied().filter(|tile| tile.0 / 4 % 2 == 1).collect();
    tiles[7] = tiles[0];
    let lonely = tiles.iter().filter(|tile| tile.0 % 2 == 0).count();
    let layout = Layout::of_cells(Kind::Wang, all.set.colors(), tiles, 4, 8, 0).unwrap();
    let images = noise(&all, 8, 2, Format::RGBA8);
    let whole = assemble(&images, &layout.tiles, 4).unwrap();
    let findings =
        lint(&Sheet::new(whole, layout).unwrap(), Question { strip: 2, tolerance: 0.0 }).unwrap();
    assert_eq!(findings.twice.len(), 1);
    assert_eq!(findings.twice[0].1, [0, 7]);
    let west = findings.lonely.iter().filter(|(_, side)| *side == Side::West).count();
    assert_eq!(west, lonely);
}

#[test]
fn heat_is_where_it_is_off() {
    let packing = corner(2);
    let sheet = sheet(&packing, |whole| whole.set_sample(32 + 10, 32 + 1, 2, 77));
    let findings = lint(&sheet, QUESTION).unwrap();
    let map = heat_map(&sheet, &findings);
    assert_eq!((map.width(), map.height()), (128, 128));
    let red = |x: usize, y: usize| map.sample(x, y, 0) > map.sample(x, y, 1) + 20;
    let reds: Vec<usize> = (0..128 * 128).filter(|at| red(at % 128, at / 128)).collect();
    assert_eq!(reds, [33 * 128 + 42]);
}
