//! Plans and results that were damaged or made up: refused by name, never another count.

use crate::{Place, result};
use std::path::Path;
use std::process::Command;
use tilepack::store::{PartResult, SearchPlan, StoreError, fingerprint, hexadecimal};

const WANG: &str = "--kind wang --colors 2";

/// A file of a format as its reader sees it.
trait Sealed: Sized {
    fn read(file: &Path) -> Result<Self, StoreError>;
}

impl Sealed for SearchPlan {
    fn read(file: &Path) -> Result<Self, StoreError> {
        SearchPlan::read(file)
    }
}

impl Sealed for PartResult {
    fn read(file: &Path) -> Result<Self, StoreError> {
        PartResult::read(file)
    }
}

/// Any bit flipped, any byte missing.
fn any_damage_is_found<T: Sealed>(place: &Place, name: &str) {
    let whole = place.bytes(name);
    let file = place.path("damaged");
    let refused = |bytes: &[u8], what: &str| {
        std::fs::write(&file, bytes).unwrap();
        let Err(error) = T::read(&file) else { panic!("{what}: read as if nothing were wrong") };
        let error = error.to_string();
        assert!(error.starts_with(&format!("{}", file.display())), "{what}: {error}");
    };
    for bit in 0..8 * whole.len() {
        let mut bytes = whole.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        refused(&bytes, &format!("bit {bit}"));
    }
    // All but the end of the last line.
    for length in 0..whole.len() - 1 {
        refused(&whole[..length], &format!("{length} bytes"));
    }
    refused(&[&whole[..], b"x"].concat(), "longer");
    refused(&[&whole[..], &whole[..]].concat(), "twice");
    std::fs::write(&file, &whole).unwrap();
    assert!(T::read(&file).is_ok());
}

#[test]
fn plans() {
    let place = Place::new();
    place.plan(WANG, 3, "some.plan");
    any_damage_is_found::<SearchPlan>(&place, "some.plan");
    place.run("merge damaged").exits(75);
    place.write("damaged", "no plan");
    for command in ["run damaged --part 0", "merge damaged"] {
        place.run(command).exits(2).says(&["damaged: "]);
    }
}

#[test]
fn results() {
    let place = Place::new();
    let plan = place.plan(WANG, 3, "some.plan");
    result(&plan, 1).write(&place.path("part")).unwrap();
    any_damage_is_found::<PartResult>(&place, "part");
    // A plan is no result, a result no plan.
    assert!(PartResult::read(&place.path("some.plan")).is_err());
    assert!(SearchPlan::read(&place.path("part")).is_err());
    place.run("run part --part 0").exits(2).says(&["part: ", "tilepack-plan/1"]);
}

/// A file with a checksum that is right, whatever it says.
fn seal(place: &Place, name: &str, format: &str, content: &str) {
    let checksum = hexadecimal(&fingerprint(content));
    let text = format!(
        "{{\"format\":\"{format}\",\"checksum\":\"{checksum}\",\n\"content\":{content}}}\n"
    );
    place.write(name, text);
}

/// The content of a file, as it stands there.
fn content(place: &Place, name: &str) -> String {
    let text = String::from_utf8(place.bytes(name)).unwrap();
    let line = text.lines().nth(1).unwrap();
    line.strip_prefix("\"content\":").unwrap().strip_suffix('}').unwrap().to_owned()
}

/// The bytes that the checksum is of, as the documentation tells to cut them out.
#[cfg(unix)]
#[test]
fn the_checksum_is_of_these_bytes() {
    let place = Place::new();
    let plan = place.plan(WANG, 3, "some.plan");
    let cut = r#"sed -n '2s/^"content":\(.*\)}$/\1/p' some.plan | tr -d '\n'"#;
    let page = include_str!("../../docs/long-runs.md");
    assert!(page.contains(&cut.replace("some.plan", "wang.plan")), "{cut}");
    let mut shell = Command::new("sh");
    let output = shell.args(["-c", cut]).current_dir(place.path(".")).output().unwrap();
    let hash = blake3::hash(&output.stdout);
    assert_eq!(hexadecimal(hash.as_bytes()), plan.name);
    assert_eq!(output.stdout, content(&place, "some.plan").as_bytes());
}

#[test]
fn plans_that_were_made_up() {
    let place = Place::new();
    place.plan(WANG, 3, "some.plan");
    let right = content(&place, "some.plan");
    seal(&place, "again.plan", "tilepack-plan/1", &right);
    assert_eq!(place.bytes("some.plan"), place.bytes("again.plan"));
    for (from, to) in [
        (r#""parts":3"#, r#""parts":0"#),
        (r#""parts":3"#, r#""parts":1000001"#),
        (r#""parts":3"#, r#""parts":-3"#),
        (r#""parts":3"#, r#""parts":3,"parts":3"#),
        (r#""parts":3"#, r#""parts":3,"more":1"#),
        (r#""depth":9"#, r#""depth":0"#),
        (r#""tree":1"#, r#""tree":2"#),
        (r#""question":"count""#, r#""question":"first""#),
        (
            r#""symmetry_removed":true"#,
            r#""symmetry_removed":true,"part":{"number":0,"of":2,"depth":1}"#,
        ),
        (r#""kind":"wang""#, r#""kind":"hexagon""#),
        (r#""size":"4x4""#, r#""size":"4x5""#),
        (r#""size":"4x4""#, r#""size":"04x4""#),
        (r#""colors":"2""#, r#""colors":"2,2""#),
        (r#""seed":null"#, r#""seed":-1"#),
    ] {
        assert!(right.contains(from), "{from}");
        seal(&place, "made-up.plan", "tilepack-plan/1", &right.replacen(from, to, 1));
        let error = SearchPlan::read(&place.path("made-up.plan")).unwrap_err().to_string();
        assert!(error.contains("made-up.plan: "), "{to}: {error}");
    }
    // A cut deeper than the tree is one at its last level, as when it is asked for.
    let deep = right.replacen(r#""depth":9"#, r#""depth":4000000000"#, 1);
    seal(&place, "deep.plan", "tilepack-plan/1", &deep);
    place.run("run deep.plan --part 0 --quiet").exits(0);
}

#[test]
fn results_that_were_made_up() {
    let place = Place::new();
    let plan = place.plan(WANG, 3, "some.plan");
    result(&plan, 1).write(&place.path("part")).unwrap();
    let right = content(&place, "part");
    for (from, to) in [
        (r#""parts":3"#, r#""parts":0"#),
        (r#""parts":3"#, r#""parts":1"#),
        (r#""part":1"#, r#""part":3"#),
        (r#""part":1"#, r#""part":18446744073709551615"#),
        (r#""packings":null"#, r#""packings":{"bytes":1,"hash":"12"}"#),
        (r#""packings":null"#, r#""packings":{"bytes":-1,"hash":""}"#),
        (r#""orbit_sizes":"0""#, r#""orbit_sizes":"-1""#),
        (r#""seconds":"#, r#""seconds":-"#),
        (r#""seconds":"#, r#""seconds":1e300,"was":"#),
    ] {
        assert!(right.contains(from), "{from}");
        seal(&place, "part", "tilepack-part/1", &right.replacen(from, to, 1));
        let error = PartResult::read(&place.path("part")).unwrap_err().to_string();
        assert!(error.contains("part: "), "{to}: {error}");
    }
}
