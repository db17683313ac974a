//! Solutions in both forms: messages, several in one file, and claims of the caller.

use crate::input;
use serde_json::json;
use tilepack::store::{Claim, read_solution, solutions};
use tilepack::tiles::{Color, Colors, Kind, Members};

/// What is wrong, the text, and the message.
type Refused = (&'static str, &'static str, &'static str);

/// A solution with one part replaced.
fn spoilt(part: &str, by: &str) -> String {
    let right = r#"{"format":"tilepack/1","kind":"wang","colors":[2,1],"set":"complete","cover":false,
"width":1,"height":4,"topology":"torus",
"tiles":[[0],[1],[3],[2]],"provenance":null}"#;
    assert!(right.contains(part), "{part}");
    right.replacen(part, by, 1)
}

const SPOILT: &[Refused] = &[
    ("tilepack/1", "tilepack/2", "in:1:11: format \"tilepack/2\": expected \"tilepack/1\""),
    ("\"tilepack/1\"", "1", "in:1:11: invalid type: integer `1`, expected a string"),
    (r#""format":"tilepack/1","#, "", "in:1:1: expected a field \"format\""),
    (
        "torus",
        "plane",
        "in:2:33: topology \"plane\": expected \"torus\" or \"cylinder\" or \"rectangle\"",
    ),
    ("wang", "hexagon", "in:1:31: kind 'hexagon': expected corner, wang or domino"),
    ("[2,1]", "0", "in:1:47: 0 colors: expected 1 to 255"),
    ("[2,1]", "[2,256]", "in:1:53: 256 colors: expected 1 to 255"),
    (
        "[2,1]",
        "[2]",
        "in:1:49: invalid length 1, expected a number of colors, or [CH, CV] for Wang tiles and \
         dominoes",
    ),
    (
        "[2,1]",
        "2.5",
        "in:1:47: invalid type: floating point `2.5`, expected a number of colors, or [CH, CV] for Wang tiles and dominoes",
    ),
    (
        "\"complete\"",
        "\"all\"",
        "in:1:59: invalid value: string \"all\", expected \"complete\", \"compact\", {\"pruned\": [[A,B],...]} or {\"tiles\": [N,...]}",
    ),
    (
        "\"complete\"",
        "{\"pruned\":[[0,2]]}",
        "in:1:73: invalid value: integer `2`, expected a color from 0 to 1",
    ),
    (
        "\"complete\"",
        "{\"pruned\":[[1,1]]}",
        "in:1:59: excluded pair 1-1: expected two different colors",
    ),
    (
        "\"complete\"",
        "{\"pruned\":[[1]]}",
        "in:1:74: invalid length 1, expected a pair of two colors",
    ),
    (
        "\"complete\"",
        "{\"tiles\":[4]}",
        "in:1:69: invalid value: integer `4`, expected a tile number from 0 to 3",
    ),
    (
        "\"complete\"",
        "{\"tiles\":[1,1]}",
        "in:1:59: tile 1 (N 0, E 0, S 1, W 0) is listed twice in the set",
    ),
    ("\"complete\"", "{\"tiles\":[]}", "in:1:59: the set holds no tile"),
    (
        "\"complete\"",
        "{\"tiles\":[1],\"pruned\":[]}",
        "in:1:72: a set is either pruned or a list of tiles",
    ),
    (
        "\"complete\"",
        "{\"odd\":[1]}",
        "in:1:60: invalid value: map, expected \"complete\", \"compact\", {\"pruned\": [[A,B],...]} or {\"tiles\": [N,...]}",
    ),
    (
        "\"complete\"",
        "7",
        "in:1:59: invalid type: integer `7`, expected \"complete\", \"compact\", {\"pruned\": [[A,B],...]} or {\"tiles\": [N,...]}",
    ),
    (
        "\"cover\":false",
        "\"cover\":\"yes\"",
        "in:1:78: invalid type: string \"yes\", expected a boolean",
    ),
    ("\"width\":1", "\"width\":0", "in:2:9: size 0x4: both sides must be at least 1"),
    (
        "\"width\":1",
        "\"width\":-1",
        "in:2:9: invalid type: integer `-1`, expected a number of cells from 0 to 4294967295",
    ),
    (
        "\"width\":1",
        "\"width\":4294967295",
        "in:2:9: size 4294967295x4: more than 4294967295 cells",
    ),
    ("\"width\":1", "\"width\":1e400", "in:2:13: number out of range"),
    ("\"width\":1", "\"width\":2", "in:3:12: row 0 has 1 of 2 tiles, the width"),
    ("\"height\":4", "\"height\":3", "in:3:25: more rows of tiles than 3, the height"),
    ("\"height\":4", "\"height\":5", "in:3:25: 4 of 5 rows of tiles, the height"),
    ("\"height\":4", "\"height\":4,\"height\":4", "in:2:22: duplicate field `height`"),
    ("[3]", "[3,1]", "in:3:22: row 2 has more tiles than 1, the width"),
    ("[3]", "[4]", "in:3:19: invalid value: integer `4`, expected a tile number from 0 to 3"),
    ("[3]", "[-3]", "in:3:19: invalid type: integer `-3`, expected a tile number from 0 to 3"),
    ("[3]", "[\"3\"]", "in:3:19: invalid type: string \"3\", expected a tile number from 0 to 3"),
    ("[3]", "[null]", "in:3:19: invalid type: null, expected a tile number from 0 to 3"),
    ("[3]", "3", "in:3:18: invalid type: integer `3`, expected row 2, a list of tiles"),
    ("[3]", "[3", "in:3:38: expected `,` or `]`"),
    (
        "[[0],[1],[3],[2]]",
        "\"none\"",
        "in:3:9: invalid type: string \"none\", expected a list of rows of tiles",
    ),
    ("null}", "null", "in:3:43: EOF while parsing an object"),
    ("null}", "null}}", "in:3:45: expected '{', the beginning of a solution"),
    ("null}", "null} x", "in:3:46: expected '{', the beginning of a solution"),
    ("null}", "1 2}", "in:3:42: expected `,` or `}`"),
    ("{", "{x", "in:1:2: key must be a string"),
    (
        "{",
        "",
        "in:1:1: '\"format\":\"tilepack/1\",\"kind\":\"wang\",\"colors\":[2,1],\"set\":\"complete\",\"cover\":false,': expected '{', as JSON begins, or a number of a grid",
    ),
];

#[test]
fn spoilt_solutions_are_refused_with_a_place() {
    assert!(read_solution(&input(&spoilt("{", "{")), &Claim::default()).is_ok());
    for &(part, by, message) in SPOILT {
        let error = read_solution(&input(&spoilt(part, by)), &Claim::default()).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
}

/// Grids that are refused, and why.
const GRIDS: &[(&str, &str)] = &[
    ("kind=corner colors=4\n0 1 2\n3 2 x", "in:3:5: color 'x': expected a number from 0 to 3"),
    ("kind=corner colors=4\n0 1 2\n3 2 4", "in:3:5: color '4': expected a number from 0 to 3"),
    ("kind=corner colors=4\n0 1 2\n3 2 .", "in:3:5: color '.': expected a number from 0 to 3"),
    ("kind=corner colors=4\n0 1 2\n\t-1 2 3", "in:3:2: color '-1': expected a number from 0 to 3"),
    ("kind=wang colors=2\n0 16", "in:2:3: tile '16': expected a number from 0 to 15"),
    ("kind=domino colors=2,3\n0 9", "in:2:3: tile '9': expected a number from 0 to 8"),
    ("kind=domino colors=2,3\n0\n9", "in:3:1: tile '9': expected a number from 0 to 3"),
    ("kind=corner colors=4 # é\n0 1 2\n\n# x\n3 2", "in:5:4: row 1 has 2 cells, but row 0 has 3"),
    ("kind=corner colors=4\n0 1 2\n3 2 1 0", "in:3:7: row 1 has 4 cells, but row 0 has 3"),
    (
        "kind=corner colors=4\n0 1 2 99999999999999999999\n",
        "in:2:7: color '99999999999999999999': expected a number from 0 to 3",
    ),
    ("kind=round colors=4\n0", "in:1:1: kind 'round': expected corner, wang or domino"),
    ("kind=wang colors=0\n0", "in:1:11: 0 colors: expected 1 to 255"),
    (
        "kind=corner colors=1,2\n0",
        "in:1:1: corner tiles have one number of colors, but 1,2 was given",
    ),
    (
        "kind=wang colors=2 set=most\n0",
        "in:1:20: set 'most': expected complete, compact, pruned:A-B,C-D,... or tiles:N,N,...",
    ),
    (
        "kind=wang colors=2 set=pruned:0\n0",
        "in:1:20: set 'pruned:0': expected complete, compact, pruned:A-B,C-D,... or tiles:N,N,...",
    ),
    ("kind=wang colors=2 set=pruned:0-2\n0", "in:1:1: color 2 is out of range: expected 0 to 1"),
    ("kind=wang colors=2 set=tiles:\n0", "in:1:20: set 'tiles:': expected tiles:N,N,..."),
    (
        "kind=wang colors=2 set=tiles:3,3\n0",
        "in:1:1: tile 3 (N 0, E 0, S 1, W 1) is listed twice in the set",
    ),
    ("kind=wang colors=2 set=tiles:16\n0", "in:1:1: tile 16 is out of range: expected 0 to 15"),
    (
        "kind=domino colors=2 set=compact\n0",
        "in:1:1: compact sets are defined for corner and Wang tiles, not for dominoes",
    ),
    ("kind=wang kind=wang colors=2\n0", "in:1:11: 'kind=wang': said before on this line"),
    (
        "kind=wang colors=2 size=3\n0",
        "in:1:20: 'size=3': expected kind=, colors=, set=, cover, topology=, border= or rotations",
    ),
    (
        "kind=wang colors=2 covers\n0",
        "in:1:20: 'covers': expected kind=, colors=, set=, cover, topology=, border= or rotations",
    ),
    ("kind=wang colors=2", "in: expected a solution, as JSON or as rows of numbers"),
    ("# nothing\n", "in: expected a solution, as JSON or as rows of numbers"),
    ("", "in: expected a solution, as JSON or as rows of numbers"),
    (
        "kind=wang\n0",
        "in:1:1: the colors of the grid are not known: expected a first line like 'kind=corner colors=4', or the options --kind and --colors",
    ),
    (
        "# a comment\n0 1\n1 0",
        "in:2:1: the kind of the grid is not known: expected a first line like 'kind=corner colors=4', or the options --kind and --colors",
    ),
    ("[[0, 1]]", "in:1:1: '[[0,': expected '{', as JSON begins, or a number of a grid"),
];

#[test]
fn wrong_grids_are_refused_with_a_place() {
    for &(text, message) in GRIDS {
        let error = read_solution(&input(text), &Claim::default()).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
}

#[test]
fn a_claim_fills_gaps_and_contradicts() {
    let grid = "0 0 0 1\n0 0 1 0\n1 0 1 1\n0 1 1 1";
    let json = spoilt("{", "{");
    let claim = |kind, colors, members: Option<Members>, cover| {
        let colors = Some(Colors::one(colors).unwrap());
        Claim { kind: Some(kind), colors, members, cover }
    };
    let with = |text: &str, claim: &Claim| {
        read_solution(&input(text), claim).map_err(|error| error.to_string())
    };
    let pruned = Members::Pruned(vec![(Color(1), Color(0))]);
    let solution = with(grid, &claim(Kind::Corner, 3, Some(pruned.clone()), Some(true))).unwrap();
    assert!(solution.packing.cover);
    assert_eq!(solution.packing.set.members(), &Members::Pruned(vec![(Color(0), Color(1))]));

    let headed = format!("kind=corner colors=2 set=complete\n{grid}");
    for (text, claim, message) in [
        (
            &headed,
            claim(Kind::Wang, 2, None, None),
            "in:1:1: kind corner in the file, but wang was asked for",
        ),
        (
            &headed,
            claim(Kind::Corner, 3, None, None),
            "in:1:1: colors 2 in the file, but 3 was asked for",
        ),
        (
            &headed,
            claim(Kind::Corner, 2, Some(pruned.clone()), None),
            "in:1:1: set complete in the file, but pruned:0-1 was asked for",
        ),
        (
            &json,
            claim(Kind::Wang, 2, None, None),
            "in:1:1: colors 2,1 in the file, but 2 was asked for",
        ),
        (
            &json,
            Claim { cover: Some(true), ..Claim::default() },
            "in:1:1: a packing in the file, but a covering was asked for",
        ),
        (
            &json,
            Claim { members: Some(pruned), ..Claim::default() },
            "in:1:1: set complete in the file, but pruned:0-1 was asked for",
        ),
    ] {
        let error = with(text, &claim).unwrap_err();
        assert_eq!(error, message);
    }
    let agreed = claim(Kind::Corner, 2, Some(Members::Complete), Some(true));
    assert!(with(&headed, &agreed).unwrap().packing.cover);
}

#[test]
fn several_solutions_in_one_file() {
    let one = spoilt("{", "{");
    let many = format!("\u{feff}\n{one}\r\n\n{one} {one}");
    let lines: Vec<_> = solutions(&input(&many), &Claim::default())
        .map(|solution| solution.unwrap().line)
        .collect();
    assert_eq!(lines, [2, 6, 8]);
    let error = read_solution(&input(&many), &Claim::default()).unwrap_err();
    assert_eq!(error.to_string(), "in: a second solution on line 6, expected one");
    // Reading ends after the first error.
    let broken = format!("{one}\n{}\n{one}", spoilt("[3]", "[9]"));
    let input = input(&broken);
    let all: Vec<_> = solutions(&input, &Claim::default()).collect();
    assert_eq!(all.len(), 2);
    assert_eq!(
        all[1].as_ref().unwrap_err().to_string(),
        "in:6:19: invalid value: integer `9`, expected a tile number from 0 to 3"
    );
}

#[test]
fn unknown_fields_are_ignored_and_provenance_is_kept() {
    let text = spoilt("null}", r#"{"seed":7,"tiles":[[9]]},"later":{"format":[1e9]}}"#);
    let solution = read_solution(&input(&text), &Claim::default()).unwrap();
    assert_eq!(solution.provenance, json!({"seed": 7, "tiles": [[9]]}));
}
