//! The structure of the source: which part may use which, and the habits that can be checked.
//!
//! Comments are no dependencies: a link in the documentation may point anywhere.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// For every part of the crate the parts it may use.
const LAYERS: &[(&str, &[&str])] = &[
    ("tiles", &[]),
    ("torus", &["tiles"]),
    // Closed forms: no search.
    ("construct", &["tiles", "torus", "compact"]),
    ("count", &["construct"]),
    ("search", &[]),
    ("symmetry", &["tiles", "torus"]),
    ("packing", &["tiles", "torus", "symmetry", "search"]),
    ("compact", &["tiles", "torus"]),
    // Of the search only races, and what says when to stop.
    ("beam", &["tiles", "torus", "search"]),
    ("anneal", &["tiles", "torus", "search"]),
    ("portfolio", &["tiles", "torus", "search", "symmetry", "packing", "beam"]),
    // Of the search only what says when to stop.
    ("patch", &["tiles", "torus", "search"]),
    ("cover", &["tiles", "torus", "search", "packing", "beam", "anneal"]),
    // Of nothing it checks: neither search nor packing nor symmetry.
    ("verify", &["tiles", "torus"]),
    ("export", &["tiles", "torus", "symmetry", "packing"]),
    // Of the search only what says when to stop.
    ("aperiodic", &["tiles", "torus", "search"]),
    // Of the search only what says when to stop.
    ("dappled", &["tiles", "torus", "search"]),
    ("tiling", &["tiles", "torus", "construct"]),
    ("atlas", &["tiles", "torus", "construct", "tiling", "dappled"]),
    // Of the search only what says when to stop.
    ("texture", &["tiles", "torus", "search", "tiling", "atlas"]),
    ("store", &["tiles", "torus", "search", "symmetry", "packing"]),
    ("cluster", &["packing", "store"]),
    (
        "cli",
        &[
            "tiles",
            "torus",
            "construct",
            "count",
            "search",
            "symmetry",
            "packing",
            "beam",
            "anneal",
            "portfolio",
            "patch",
            "cover",
            "export",
            "aperiodic",
            "dappled",
            "tiling",
            "atlas",
            "texture",
            "verify",
            "store",
            "cluster",
        ],
    ),
];

/// Crates that only some files may name.
const CRATES: &[(&str, &[&str])] = &[
    ("anyhow", &["cli/", "main.rs"]),
    ("clap", &["cli/", "main.rs"]),
    ("ctrlc", &["cli/signal.rs"]),
    ("indicatif", &["cli/progress.rs"]),
    ("roxmltree", &["atlas/formats/"]),
    ("bincode", &["store/codec.rs"]),
    ("serde_json", &["store/", "cli/", "atlas/"]),
    (
        "rayon",
        &["packing/", "symmetry/", "atlas/", "aperiodic/classify/", "dappled/", "texture/", "cli/"],
    ),
    ("crossbeam", &["search/", "store/keeping.rs"]),
    (
        "rand",
        &[
            "search/estimate/",
            "anneal/",
            "aperiodic/coloring/",
            "beam/",
            "patch/",
            "compact/",
            "construct/",
            "dappled/",
            "texture/",
        ],
    ),
    (
        "rand_pcg",
        &[
            "search/estimate/",
            "anneal/",
            "aperiodic/coloring/",
            "beam/",
            "patch/",
            "compact/",
            "construct/",
            "dappled/",
            "texture/",
        ],
    ),
];

/// What no part of the crate may ask: the clock on the wall can be set back. Time is measured
/// from the start of the process.
const FORBIDDEN: &[&str] = &["unsafe", "SystemTime", "UNIX_EPOCH"];

/// Lines of a file at most.
const LONGEST: usize = 500;

struct Source {
    /// From `src` on, with slashes.
    path: String,
    text: String,
    /// Without comments and without what stands in quotation marks.
    code: String,
}

fn sources() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut sources = Vec::new();
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let relative = path.strip_prefix(&root).unwrap();
                let parts: Vec<_> = relative.iter().map(|part| part.to_str().unwrap()).collect();
                let text = fs::read_to_string(&path).unwrap();
                let code = stripped(&text);
                sources.push(Source { path: parts.join("/"), text, code });
            }
        }
    }
    sources.sort_by(|a, b| a.path.cmp(&b.path));
    sources
}

/// Rust without comments, strings and character literals.
fn stripped(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut code = String::new();
    let mut at = 0;
    let starts = |at: usize, with: &str| bytes[at..].starts_with(with.as_bytes());
    while at < bytes.len() {
        if starts(at, "//") {
            at += bytes[at..].iter().position(|&b| b == b'\n').unwrap_or(bytes.len() - at);
        } else if starts(at, "/*") {
            let mut depth = 0;
            loop {
                if at >= bytes.len() {
                    break;
                } else if starts(at, "/*") {
                    (at, depth) = (at + 2, depth + 1);
                } else if starts(at, "*/") {
                    (at, depth) = (at + 2, depth - 1);
                    if depth == 0 {
                        break;
                    }
                } else {
                    at += 1;
                }
            }
        } else if let Some(end) = raw_string(&bytes[at..]) {
            code.push_str("\"\"");
            at += end;
        } else if bytes[at] == b'"' {
            code.push_str("\"\"");
            at += 1;
            while at < bytes.len() && bytes[at] != b'"' {
                at += if bytes[at] == b'\\' { 2 } else { 1 };
            }
            at += 1;
        } else if starts(at, "'\\") {
            at += 2 + bytes[at + 3..].iter().position(|&b| b == b'\'').unwrap_or(0) + 2;
        } else if bytes[at] == b'\'' && bytes.get(at + 2) == Some(&b'\'') {
            at += 3;
        } else {
            code.push(char::from(bytes[at]));
            at += 1;
        }
    }
    code
}

/// The length of a raw string that begins here.
fn raw_string(bytes: &[u8]) -> Option<usize> {
    let begin = bytes.strip_prefix(b"br").or(bytes.strip_prefix(b"r"))?;
    let hashes = begin.iter().take_while(|&&b| b == b'#').count();
    if begin.get(hashes) != Some(&b'"') {
        return None;
    }
    let end: Vec<u8> = [&b"\""[..], &b"#".repeat(hashes)].concat();
    let inside = &begin[hashes + 1..];
    let length = inside.windows(end.len()).position(|window| window == end)?;
    Some(bytes.len() - inside.len() + length + end.len())
}

/// The words of a text: identifiers, and single other characters.
fn words(code: &str) -> Vec<&str> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut words = Vec::new();
    let mut rest = code.trim_start();
    while let Some(first) = rest.chars().next() {
        let end = match is_word(first) {
            true => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        words.push(&rest[..end]);
        rest = rest[end..].trim_start();
    }
    words
}

/// The parts of the crate that a source names: `crate::part`, `tilepack::part`, in braces too.
fn parts_named(code: &str) -> BTreeSet<&str> {
    let words = words(code);
    let mut named = BTreeSet::new();
    // From a file of a part, two steps up and down into another one.
    for path in words.windows(7) {
        let upward = path[..6] == ["super", ":", ":", "super", ":", ":"];
        if upward && LAYERS.iter().any(|(part, _)| *part == path[6]) {
            named.insert(path[6]);
        }
    }
    for at in 0..words.len().saturating_sub(3) {
        let path = ["crate", "tilepack"].contains(&words[at]);
        if !path || words[at + 1..at + 3] != [":", ":"] {
            continue;
        }
        if words[at + 3] != "{" {
            named.insert(words[at + 3]);
            continue;
        }
        let mut depth = 0;
        for i in at + 3..words.len() {
            match words[i] {
                "{" => depth += 1,
                "}" => depth -= 1,
                word if depth == 1 && ["{", ","].contains(&words[i - 1]) => {
                    named.insert(word);
                }
                _ => {}
            }
            if depth == 0 {
                break;
            }
        }
    }
    named
}

fn part(path: &str) -> Option<&str> {
    path.split_once('/').map(|(part, _)| part)
}

#[test]
fn dependencies_point_one_way() {
    let mut wrong = Vec::new();
    for source in sources() {
        let Some(part) = part(&source.path) else { continue };
        let Some((_, allowed)) = LAYERS.iter().find(|(name, _)| *name == part) else {
            wrong.push(format!("src/{}: which layers may {part} use? See LAYERS", source.path));
            continue;
        };
        for named in parts_named(&source.code) {
            if named != part && !allowed.contains(&named) {
                wrong.push(format!("src/{} uses crate::{named}", source.path));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn crates_are_named_where_they_belong() {
    let mut wrong = Vec::new();
    for source in sources() {
        let words = words(&source.code);
        for (name, places) in CRATES {
            let allowed = places.iter().any(|place| source.path.starts_with(place));
            let names = words.windows(2).any(|pair| {
                pair[0] == *name && [":", ";", "as"].contains(&pair[1])
                    || pair[0] == "use" && pair[1] == *name
            });
            if names && !allowed {
                wrong.push(format!("src/{} names {name}, which is for {places:?}", source.path));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn habits() {
    let mut wrong = Vec::new();
    for Source { path, text, code } in sources() {
        let lines = text.lines().count();
        if lines > LONGEST {
            wrong.push(format!("src/{path} has {lines} lines, more than {LONGEST}"));
        }
        if !text.starts_with("//!") {
            wrong.push(format!("src/{path} does not open with //!"));
        }
        for word in FORBIDDEN {
            if words(&code).contains(word) {
                wrong.push(format!("src/{path} uses {word}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The reader of sources itself: what it must see, and what it must not.
#[test]
fn comments_and_strings_are_no_dependencies() {
    let code = stripped(
        r####"
        //! See [`crate::verify`].
        /* crate::search /* nested */ unsafe */
        use crate::{tiles::{Color, Kind}, torus}; use super::super::cli::x; use super::super::Words;
        const A: &str = "crate::packing \" // unsafe"; const B: char = '"'; const C: char = '\'';
        const D: &str = r#"crate::symmetry "quoted""#; fn f<'a>(x: &'a str) -> crate :: store::X {}
        "####,
    );
    assert_eq!(parts_named(&code), BTreeSet::from(["tiles", "torus", "store", "cli"]), "{code}");
    assert!(!words(&code).contains(&"unsafe"), "{code}");
    assert!(sources().len() > 40);
}
