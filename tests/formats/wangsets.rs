//! Tile sets of Tiled as ours: there and back, and what is refused.

use crate::{Place, complete, packing, row, text};
use serde_json::{Value, json};
use tilepack::atlas::formats::Sheet;
use tilepack::atlas::formats::tiled::write_tsx;
use tilepack::atlas::formats::tsj::write_tsj;
use tilepack::atlas::formats::wangsets::{Choice, Wangset, read};
use tilepack::tiles::{Color, Kind, Members, TileId};

#[test]
fn there_and_back() {
    let pruned = Members::Pruned(vec![(Color(0), Color(2))]);
    let packings = [
        complete(Kind::Corner, "3"),
        complete(Kind::Wang, "2"),
        complete(Kind::Wang, "3,2"),
        packing(Kind::Corner, "3", Members::Compact),
        packing(Kind::Wang, "4", Members::Compact),
        row(Kind::Corner, "4", pruned),
        row(Kind::Wang, "3,1", Members::Complete),
    ];
    for packing in packings {
        let sheet = Sheet { packing: &packing, image: "a.png", tile: 8, margin: 1, spacing: 2 };
        let texts = [
            text(|out| write_tsx(out, &sheet, "a \"name\" & more")),
            text(|out| write_tsj(out, &sheet, "a \"name\" & more")),
        ];
        for text in texts {
            let back = read(&text, Choice::default()).unwrap();
            assert_eq!(back.set.kind(), packing.set.kind());
            assert_eq!(back.set.colors(), packing.set.colors());
            let tiles: Vec<TileId> = back.tiles.iter().map(|&(_, tile)| tile).collect();
            assert_eq!(tiles, packing.tiles);
            assert!(back.tiles.iter().map(|&(id, _)| id).eq(0..tiles.len() as u64));
            assert_eq!(back.name, "a \"name\" & more");
            assert!(!back.transformed && back.doubles.is_empty() && back.unset.is_empty());
        }
    }
}

/// A tile set with one wangset of a type, with so many colors, and these wangids.
fn tsx(kind: &str, colors: usize, wangids: &[&str]) -> String {
    let tiles = wangids.iter().enumerate();
    let tiles: Vec<String> = tiles
        .map(|(id, wangid)| format!("   <wangtile tileid=\"{id}\" wangid=\"{wangid}\"/>\n"))
        .collect();
    format!(
        "<tileset name=\"t\" tilecount=\"9\">\n <wangsets>\n  <wangset name=\"w\" type=\"{kind}\" \
         tile=\"-1\">\n{}{}  </wangset>\n </wangsets>\n</tileset>\n",
        "   <wangcolor name=\"\" color=\"#000000\" tile=\"-1\" probability=\"1\"/>\n"
            .repeat(colors),
        tiles.concat()
    )
}

fn taken(kind: &str, colors: usize, wangids: &[&str]) -> Wangset {
    read(&tsx(kind, colors, wangids), Choice::default()).unwrap()
}

#[test]
fn colors_are_numbered_by_their_use() {
    // Colors 2 and 5 horizontal, 3 vertical; 1 and 4 on no tile.
    let apart = taken("edge", 5, &["2,0,3,0,5,0,3,0", "5,0,3,0,2,0,3,0"]);
    assert_eq!(apart.set.colors().to_string(), "2,1");
    assert_eq!(apart.colors, [vec![2, 5], vec![3]]);
    let sides = |set: &Wangset, i: usize| set.set.kind().unpack(set.tiles[i].1, set.set.colors());
    assert_eq!([sides(&apart, 0), sides(&apart, 1)], [[0, 0, 1, 0], [1, 0, 0, 0]]);
    // Color 2 is on both: one numbering for all edges.
    let shared = taken("edge", 5, &["2,0,3,0,5,0,3,0", "5,0,2,0,2,0,3,0"]);
    assert_eq!(shared.set.colors().to_string(), "3");
    assert_eq!(shared.colors, [vec![2, 3, 5], vec![2, 3, 5]]);
    assert_eq!([sides(&shared, 0), sides(&shared, 1)], [[0, 1, 2, 1], [2, 0, 0, 1]]);
    // Top, TopRight, Right, ...: NE, SE, SW, NW.
    let corner = taken("corner", 4, &["0,1,0,2,0,3,0,4"]);
    assert_eq!(sides(&corner, 0), [0, 1, 2, 3]);
    // `mixed`, and no type as before Tiled 1.5: what the tiles have.
    assert_eq!(taken("mixed", 1, &["0,1,0,1,0,1,0,1"]).set.kind(), Kind::Corner);
    assert_eq!(taken("", 1, &["1,0,1,0,1,0,1,0"]).set.kind(), Kind::Wang);
    // A tile without any color is not in the wangset.
    assert_eq!(taken("corner", 1, &["0,0,0,0,0,0,0,0", "0,1,0,1,0,1,0,1"]).tiles[0].0, 1);
}

#[test]
fn choices() {
    let doubles = tsx("corner", 2, &["0,1,0,1,0,1,0,2", "0,1,0,1,0,1,0,1", "0,1,0,1,0,1,0,2"]);
    let error = read(&doubles, Choice::default()).unwrap_err().to_string();
    assert!(error.starts_with("8:4: tile 2 has the same colors as tile 0 (NE 0, SE 0"), "{error}");
    let kept = read(&doubles, Choice { keep_first: true, ..Choice::default() }).unwrap();
    assert_eq!((kept.tiles.len(), kept.doubles), (2, vec![(2, 0)]));

    let unset = tsx("corner", 2, &["0,1,0,0,0,1,0,2", "0,1,0,1,0,1,0,1"]);
    let error = read(&unset, Choice::default()).unwrap_err().to_string();
    assert!(error.starts_with("6:4: tile 0 has unset colors"), "{error}");
    let skipped = read(&unset, Choice { skip_unset: true, ..Choice::default() }).unwrap();
    assert_eq!((skipped.tiles.len(), skipped.unset), (1, vec![0]));

    let one = tsx("corner", 1, &["0,1,0,1,0,1,0,1"]);
    let second = one.replace("name=\"w\" type=\"corner\"", "name=\"v\" type=\"mixed\"");
    let inner = |text: &str| {
        let (begin, end) = (text.find("  <wangset ").unwrap(), text.find(" </wangsets>").unwrap());
        text[begin..end].to_owned()
    };
    let both = one.replace(" </wangsets>", &format!("{} </wangsets>", inner(&second)));
    let error = read(&both, Choice::default()).unwrap_err().to_string();
    assert_eq!(error, "7:3: 2 wangsets: choose one of 'w', 'v'");
    let chosen = |name| read(&both, Choice { wangset: Some(name), ..Choice::default() });
    assert_eq!(chosen("v").unwrap().name, "v");
    assert_eq!(chosen("x").unwrap_err().to_string(), "1:1: no wangset 'x': expected 'w' or 'v'");

    // In a map; and with tiles that Tiled may turn.
    let map = format!("<map>\n{one}</map>");
    assert_eq!(read(&map, Choice::default()).unwrap().tiles.len(), 1);
    let turned =
        one.replace(" <wangsets>", "<transformations hflip=\"0\" rotate=\"1\"/><wangsets>");
    assert!(read(&turned, Choice::default()).unwrap().transformed);
    let json: Value = json!({"type": "map", "tilesets": [{"firstgid": 1, "wangsets": [{
        "name": "j", "type": "corner", "colors": [{}],
        "wangtiles": [{"tileid": 3, "wangid": [0, 1, 0, 1, 0, 1, 0, 1]}]
    }]}]});
    let in_json = read(&json.to_string(), Choice::default()).unwrap();
    assert_eq!((in_json.name.as_str(), in_json.tiles), ("j", vec![(3, TileId(0))]));
}

#[test]
fn what_is_not_clear_is_refused_with_its_place() {
    let good = "0,1,0,1,0,1,0,1";
    let cases = [
        (tsx("corner", 1, &[good, "0,2,0,1,0,1,0,1"]), "6:4: tile 1: color 2: the wangset has 1"),
        (tsx("corner", 1, &["0,1,0,1"]), "5:4: tile 0: wangid '0,1,0,1': expected eight numbers"),
        (tsx("corner", 1, &["0x1010101"]), "5:4: tile 0: wangid '0x1010101': expected eight numbers with commas between them; it was saved by Tiled before 1.5"),
        (tsx("corner", 1, &["1,1,0,1,0,1,0,1"]), "5:4: tile 0 has colors on edges and on corners"),
        (tsx("edge", 1, &[good]), "5:4: tile 0 has its colors on corners, but the wangset has them on edges"),
        (tsx("mixed", 1, &[good, "1,0,1,0,1,0,1,0"]), "6:4: tile 1 has its colors on edges, but others have them on corners"),
        (tsx("round", 1, &[good]), "3:3: wangset of type 'round'"),
        (tsx("corner", 1, &[]), "3:3: wangset 'w' has no tile with colors"),
        (tsx("corner", 1, &[good, good]).replace("tileid=\"1\"", "tileid=\"0\""), "6:4: tile 0 has a second wangid"),
        (tsx("corner", 1, &[good]).replace("tileid=\"0\"", "tileid=\"-1\""), "5:4: tileid '-1': expected a number"),
        (tsx("corner", 1, &[good]).replace(" tileid=\"0\"", ""), "5:4: <wangtile> without tileid"),
        ("<tileset>\n <wangsets>".to_owned(), "1:1: the root node was opened but never closed"),
        ("<svg/>".to_owned(), "1:1: <svg>: expected <tileset> or <map>"),
        ("<tileset/>".to_owned(), "1:1: no wangset"),
        ("<map><tileset source=\"x.tsx\"/></map>".to_owned(), "1:1: the map does not hold its tile set; import x.tsx"),
        ("kind=wang".to_owned(), "1:1: expected a tile set or map of Tiled"),
        (String::new(), "1:1: expected a tile set or map of Tiled"),
        ("{\"wangsets\": [\n {\"wangtiles\": 3}]}".to_owned(), "2:1"),
        ("{\"wangsets\": [{\"type\":\"corner\",\"colors\":[{}],\"wangtiles\":[\n {\"tileid\":0,\"wangid\":[0,1,0,0,0,1,0,1]}]}]}".to_owned(), "2:23: tile 0 has unset colors"),
        ("{\"wangsets\": [{\"type\":\"corner\",\"colors\":[{}],\"wangtiles\":[\n {\"tileid\":0,\"wangid\":\"0\"}]}]}".to_owned(), "2:23: tile 0: wangid '\"0\"': expected eight"),
        ("{\"tilesets\": [{\"source\":\"y.tsj\"}]}".to_owned(), "1:1: the map does not hold its tile set; import y.tsj"),
    ];
    for (text, expected) in cases {
        let error = read(&text, Choice::default()).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{text}\n{error}\n{expected}");
    }
}

/// A set drawn in Tiled is packed.
#[test]
fn the_command() {
    let place = Place::new();
    let packing = complete(Kind::Wang, "2");
    let sheet = Sheet { packing: &packing, image: "a.png", tile: 8, margin: 0, spacing: 0 };
    place.write("hand.tsx", text(|out| write_tsx(out, &sheet, "hand")));
    let run = place.run("import hand.tsx -o set.json --json");
    assert_eq!(run.code, 0, "{run:?}");
    let told: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!((&told["result"], &told["wangset"]), (&json!("imported"), &json!("hand")));
    assert_eq!(
        (&told["tiles"], &told["colors"], &told["kind"]),
        (&json!(16), &json!(2), &json!("wang"))
    );
    assert_eq!(told["table"][4], json!({"id": 4, "tile": packing.tiles[4].0}));
    assert_eq!(told["vertical_colors"], json!([3, 4]));
    assert_eq!(place.run("find --set set.json --size 4x4 --quiet -o p.json").code, 0);
    assert_eq!(place.run("export p.json --to tiled-tsj -o p.tsj --quiet").code, 0);
    assert_eq!(place.run("import p.tsj -o again.json --quiet").code, 0);
    let tiles =
        |file: &str| serde_json::from_str::<Value>(&place.read(file)).unwrap()["tiles"].clone();
    assert_eq!(tiles("again.json"), tiles("set.json"));

    place.write("bad.tsx", tsx("corner", 1, &["0,1"]));
    let run = place.run("import bad.tsx -o bad.json");
    assert_eq!(run.code, 2);
    assert!(run.stderr.starts_with("tilepack: bad.tsx:5:4: tile 0"), "{run:?}");
    assert!(!place.path("bad.json").exists());
    let run = place.run("import hand.tsx --json");
    assert!(run.code == 2 && run.stderr.contains("--json needs -o"), "{run:?}");
}

/// Whatever a file holds, it is read or refused.
#[test]
fn damaged_files_give_an_error_or_a_set() {
    let packing = complete(Kind::Wang, "2");
    let sheet = Sheet { packing: &packing, image: "a.png", tile: 8, margin: 0, spacing: 0 };
    let texts =
        [text(|out| write_tsx(out, &sheet, "set")), text(|out| write_tsj(out, &sheet, "set"))];
    for text in texts {
        let choice = Choice { keep_first: true, skip_unset: true, ..Choice::default() };
        let mut refused = 0;
        for at in 0..text.len() {
            // Cut off here, and a byte of another kind here.
            let begin = read(&text[..at], choice);
            assert!(begin.is_err() || text[at..].trim().is_empty(), "{at}");
            for other in ["9", "\"", "<", "-", "\n"] {
                let changed = format!("{}{other}{}", &text[..at], &text[at + 1..]);
                if at % 7 == 0 && read(&changed, choice).is_err() {
                    refused += 1;
                }
            }
        }
        assert!(refused > 100, "{refused}");
    }
}
