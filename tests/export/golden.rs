//! Files as they have been written so far; a change in them is to be a decision.

use crate::{cnf_text, task, xcc_text};
use tilepack::tiles::{Kind, Members};

#[test]
fn files_stay_as_they_are() {
    let domino = task(Kind::Domino, "2", Members::Complete, "4x1", "");
    let compact = task(Kind::Wang, "2,1", Members::Compact, "2x2", "");
    for (name, text) in [
        ("domino-2.cnf", cnf_text(&domino)),
        ("domino-2.xcc", xcc_text(&domino).unwrap()),
        ("wang-compact.cnf", cnf_text(&compact)),
        ("wang-compact.xcc", xcc_text(&compact).unwrap()),
    ] {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/export/golden");
        let file = path.join(name);
        // To write them anew: TILEPACK_GOLDEN=write cargo test --test export
        if std::env::var_os("TILEPACK_GOLDEN").is_some() {
            std::fs::create_dir_all(&path).unwrap();
            std::fs::write(&file, &text).unwrap();
        }
        assert_eq!(std::fs::read_to_string(&file).unwrap(), text, "{name}");
    }
}
