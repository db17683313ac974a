//! Certificates that are right.

use crate::{PUBLISHED, jeandel_rao, read};
use tilepack::aperiodic::coloring::certificate::{certificate, renumbered};
use tilepack::aperiodic::coloring::condition::Condition;
use tilepack::aperiodic::coloring::rounds::{Outcome, Search, run};
use tilepack::store::write_certificate;
use tilepack::verify::{ProvedSet, WayBack, check_certificate};

#[test]
fn the_published_certificate_is_right() {
    let certificate = read(PUBLISHED);
    let proved = ProvedSet {
        tiles: 24,
        colors: 4,
        pieces: 24,
        windows: 186,
        way_back: WayBack::Radius1,
        ambiguous: 2,
    };
    assert_eq!(check_certificate(&certificate), Ok(proved));
    let mut text = Vec::new();
    write_certificate(&mut text, &certificate).unwrap();
    assert_eq!(read(text), certificate);
}

/// The windows of the published certificate are those that the generator finds.
#[test]
fn the_windows_are_ours() {
    let published = read(PUBLISHED);
    let (windows, vertices) = jeandel_rao([4, 2]);
    let color = |pattern: &Vec<usize>| {
        let entry = published.rule.table.iter().find(|(labels, _)| labels == pattern);
        entry.unwrap().1 as u8
    };
    let colors: Vec<u8> = vertices.patterns.iter().map(color).collect();
    let ours = certificate(published.title.clone(), &vertices, &windows, &colors);
    let sorted = |certificate: &tilepack::torus::toral::ToralCertificate| {
        let all = certificate.windows.iter().map(|window| {
            // A polygon may begin at any vertex.
            let mut polygon = window.polygon.clone();
            polygon.sort_unstable();
            (window.labels.clone(), window.pieces.clone(), polygon)
        });
        let mut all: Vec<_> = all.collect();
        all.sort();
        all
    };
    assert_eq!(sorted(&ours), sorted(&published));
    assert_eq!((&ours.tiles, &ours.options), (&published.tiles, &published.options));
    assert_eq!((&ours.partition, &ours.image), (&published.partition, &published.image));
    assert!(check_certificate(&ours).is_ok());
}

/// A few rounds of a search.
pub(crate) fn search(condition: Condition, target: usize) -> Search {
    Search { condition, colors: 6, seed: 1, moves: 1 << 19, rounds: 12, target, threads: 2 }
}

#[test]
fn what_is_found_is_proved() {
    for (shape, condition, target, way_back) in [
        ([4, 2], Condition::Pair, 30, WayBack::Pair),
        ([4, 2], Condition::Radius(1), 28, WayBack::Radius1),
        ([4, 3], Condition::Pair, 36, WayBack::Pair),
        ([3, 3], Condition::Radius(2), 45, WayBack::Radius2),
    ] {
        let (windows, vertices) = jeandel_rao(shape);
        let Outcome { best, .. } = run(&vertices, &search(condition, target), &(), &|_| ());
        let (_, found) = best.unwrap();
        assert!(found.tiles <= target, "{shape:?} {condition:?}: {} tiles", found.tiles);
        let colors = renumbered(&found.colors);
        let certificate = certificate(String::new(), &vertices, &windows, &colors);
        let proved = check_certificate(&certificate).unwrap();
        assert_eq!(proved.tiles, found.tiles);
        assert!(proved.way_back <= way_back, "{proved:?}");
    }
}
