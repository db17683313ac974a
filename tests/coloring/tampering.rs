//! Certificates that were tampered with: each change is refused, or leaves a certificate that is
//! right as well.

use crate::{PUBLISHED, read};
use proptest::prelude::*;
use serde_json::{Value, json};
use tilepack::store::{Input, read_certificate};
use tilepack::torus::toral::ToralCertificate;
use tilepack::verify::{Step, check_certificate};

/// Why a certificate is refused; panics when it is not.
fn refused(change: impl FnOnce(&mut ToralCertificate)) -> (Step, String) {
    let mut certificate = read(PUBLISHED);
    change(&mut certificate);
    let fault = check_certificate(&certificate).unwrap_err();
    (fault.step, fault.to_string())
}

#[test]
fn each_step_has_its_reasons() {
    let all: Vec<(Step, &str, (Step, String))> = vec![
        (Step::WangTiles, "over 4 labels", refused(|c| c.wang[3][1] = 2)),
        (Step::WangTiles, "over 4 labels", refused(|c| c.wang.swap(0, 1))),
        (Step::WangTiles, "over 5 labels", refused(|c| c.wang_unmerged[0][0] = 3)),
        (Step::Partition, "does not suit", refused(|c| c.lattice[0] = [1, 1, 0, 0])),
        (Step::Partition, "does not suit", refused(|c| c.lattice[0][2] = 1)),
        (Step::Partition, "does not suit", refused(|c| c.domain = [0, 1, 4, 1])),
        (Step::Partition, "beyond", refused(|c| c.lattice[1][0] = i64::MIN)),
        (Step::Partition, "no tile", refused(|c| c.partition[4].label = 11)),
        (Step::Partition, "overlap", refused(|c| c.partition.push(c.partition[3].clone()))),
        (Step::Partition, "add up", refused(|c| drop(c.partition.pop()))),
        (Step::Partition, "not convex", refused(|c| c.partition[3].polygon.reverse())),
        (Step::Partition, "not convex", refused(|c| c.partition[3].polygon.swap(0, 1))),
        (Step::Partition, "2 vertices", refused(|c| c.partition[0].polygon.truncate(2))),
        (Step::Partition, "outside", refused(|c| c.partition[15].polygon[1] = [1, 1, 3, 1])),
        (Step::Partition, "overlap", refused(|c| c.partition[0].polygon[1] = [1, 0, 0, 0])),
        (Step::Windows, "add up", refused(|c| drop(c.windows.pop()))),
        (Step::Windows, "same pieces", refused(|c| c.windows.push(c.windows[7].clone()))),
        (Step::Windows, "is not in", refused(|c| c.windows[0].polygon[0] = [-2, 2, 2, 0])),
        (Step::Windows, "is not in", refused(|c| c.windows[0].pieces[0][1] += 1)),
        (Step::Windows, "but that of", refused(|c| c.windows[0].labels[0] = 6)),
        (Step::Windows, "no piece", refused(|c| c.windows[0].pieces[0][0] = 24)),
        (Step::Windows, "no piece", refused(|c| c.windows[0].pieces[0][0] = -1)),
        (Step::Windows, "too far", refused(|c| c.windows[0].pieces[0][2] = i64::MIN)),
        (Step::Windows, "is moved", refused(|c| c.windows[0].pieces[12][1] = 1)),
        (Step::Windows, "expected 20", refused(|c| c.window_shape = [4, 5])),
        (Step::Windows, "expected 15", refused(|c| c.windows[9].labels.truncate(14))),
        (Step::Windows, "1 to 400", refused(|c| c.window_shape = [0, 3])),
        (Step::Windows, "1 to 400", refused(|c| c.window_shape = [usize::MAX, 2])),
        (Step::Rule, "at least 1", refused(|c| c.rule.above = 0)),
        (Step::Rule, "see 6 rows", refused(|c| c.rule.below = 3)),
        (Step::Rule, "a color already", refused(|c| c.rule.table.push(c.rule.table[5].clone()))),
        (Step::Rule, "has no color", refused(|c| drop(c.rule.table.pop()))),
        (Step::Rule, "does not occur", refused(|c| c.rule.table.push((vec![0; 8], 1)))),
        (Step::Tiles, "not listed", refused(|c| c.rule.table[0].1 = 4)),
        (Step::Tiles, "not listed", refused(|c| c.tiles.truncate(23))),
        (Step::Tiles, "not listed", refused(|c| c.tiles[0][2] = 3)),
        (Step::Tiles, "does not occur", refused(|c| c.tiles.push([3, 3, 3, 3]))),
        (Step::Tiles, "are the same", refused(|c| c.tiles.push(c.tiles[3]))),
        (Step::Tiles, "images", refused(|c| drop(c.image.pop()))),
        (Step::Tiles, "has the image", refused(|c| c.image[0].push(5))),
        (Step::WayBack, "lists of options", refused(|c| drop(c.options.pop()))),
        (Step::WayBack, "has the options", refused(|c| c.options[3] = vec![2])),
    ];
    for (step, word, (found, message)) in all {
        // A shape of 4 x 5 has more cells than the lists.
        assert!(found == step && message.contains(word), "{step:?} {word}: {found:?} {message}");
    }
}

/// Two colors made one: the list is corrected everywhere, and still the tiles prove nothing.
#[test]
fn a_coloring_without_a_way_back_is_refused() {
    let (windows, vertices) = crate::jeandel_rao([4, 2]);
    let published = read(PUBLISHED);
    let color = |pattern: &Vec<usize>| {
        let entry = published.rule.table.iter().find(|(labels, _)| labels == pattern);
        (entry.unwrap().1 as u8).min(2)
    };
    let colors: Vec<u8> = vertices.patterns.iter().map(color).collect();
    let merged = tilepack::aperiodic::coloring::certificate::certificate(
        String::new(),
        &vertices,
        &windows,
        &colors,
    );
    let fault = check_certificate(&merged).unwrap_err();
    assert_eq!(fault.step, Step::WayBack, "{fault}");
    assert!(fault.reason.contains("corner tile"), "{fault}");
}

/// The places of all numbers of a certificate.
fn numbers(value: &Value, path: String, all: &mut Vec<String>) {
    match value {
        Value::Number(_) => all.push(path),
        Value::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                numbers(item, format!("{path}/{i}"), all);
            }
        }
        Value::Object(fields) => {
            for (name, item) in fields {
                numbers(item, format!("{path}/{name}"), all);
            }
        }
        _ => {}
    }
}

/// Whether a file with these values is refused, by the reader or by the verifier.
fn is_refused(value: &Value) -> bool {
    let input = Input::from_bytes("c.json", serde_json::to_vec(value).unwrap()).unwrap();
    read_certificate(&input).map_or(true, |certificate| check_certificate(&certificate).is_err())
}

/// No other color of a single pattern is as good here.
#[test]
fn every_color_matters() {
    let certificate = read(PUBLISHED);
    for entry in (0..certificate.rule.table.len()).step_by(3) {
        for color in 0..4 {
            let mut changed = certificate.clone();
            changed.rule.table[entry].1 = color;
            let same = color == certificate.rule.table[entry].1;
            assert_eq!(check_certificate(&changed).is_ok(), same, "entry {entry}, color {color}");
        }
    }
}

#[test]
fn titles_and_unknown_fields_do_not_matter() {
    let mut value: Value = serde_json::from_str(PUBLISHED).unwrap();
    value["title"] = json!("another title");
    value["surprise"] = json!([1, 2, 3]);
    value.as_object_mut().unwrap().remove("jr_tiles_5");
    assert!(!is_refused(&value));
    value["jr_convention"] = json!("[E,N,W,S]");
    assert!(is_refused(&value));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(80))]

    #[test]
    fn a_number_changed_is_refused(at in any::<prop::sample::Index>(), by in prop_oneof![
        Just(1i64), Just(-1), -40i64..40, any::<i64>(),
    ]) {
        prop_assume!(by != 0);
        let mut value: Value = serde_json::from_str(PUBLISHED).unwrap();
        let mut all = Vec::new();
        numbers(&value, String::new(), &mut all);
        let path = at.get(&all);
        let number = value.pointer_mut(path).unwrap();
        *number = json!(number.as_i64().unwrap().wrapping_add(by));
        prop_assert!(is_refused(&value), "{path} changed by {by}");
    }

    /// Lists with an entry dropped, doubled, or two of them swapped.
    #[test]
    fn lists_changed_are_refused_or_harmless(
        which in 0usize..7, kind in 0usize..3,
        at in any::<prop::sample::Index>(), other in any::<prop::sample::Index>(),
    ) {
        let mut value: Value = serde_json::from_str(PUBLISHED).unwrap();
        let names = ["/partition", "/vertex_rule/table", "/corner_tiles", "/image", "/windows",
            "/options", "/jr_tiles_4"];
        let name = names[which];
        let list = value.pointer_mut(name).unwrap().as_array_mut().unwrap();
        let (i, j) = (at.index(list.len()), other.index(list.len()));
        let same = list[i] == list[j];
        match kind {
            0 => drop(list.remove(i)),
            1 => list.insert(j, list[i].clone()),
            _ => list.swap(i, j),
        }
        // The order of windows and of the rule says nothing, nor does that of two corner tiles
        // which stand for the same Wang tiles.
        let alike = |name: &str| value[name][i] == value[name][j];
        let harmless = kind == 2
            && (same
                || ["/windows", "/vertex_rule/table"].contains(&name)
                || name == "/corner_tiles" && alike("image") && alike("options"));
        prop_assert_eq!(is_refused(&value), !harmless, "{} {} {} {}", name, kind, i, j);
    }
}
