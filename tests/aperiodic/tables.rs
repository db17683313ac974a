//! Tables 8.1 to 8.7 of A. Lagae, *Tile-Based Methods in Computer Graphics*, 2007, and the sizes
//! that the set of Jeandel and Rao gives.

use super::published;
use tilepack::aperiodic::convert::{Method, convert};

/// Tiles/colors of the steps corner, Wang, corner, ...; `a>b` when a pairs give b tiles, which is
/// where the table says that it failed.
const TABLES: &[(&str, Method, &str)] = &[
    (
        "culik13",
        Method::Diagonal,
        "125/13 125/50 1240/125 1240/418 14810/1240 14810/4523 160168/14810",
    ),
    (
        "kari14",
        Method::Diagonal,
        "214/14 214/86 3052/214 3052/1208 58910/3052 58910/19274 1213029/58910",
    ),
    ("ammann16", Method::Diagonal, "87/16 87/44 286/87 286/160 777/286 777/464 1642/777"),
    ("culik13", Method::Horizontal, "36>30"),
    ("kari14", Method::Horizontal, "34>21"),
    ("ammann16", Method::Horizontal, "44/6 44/24 138/24 138/82 438/82 438/271 1406/271"),
    ("culik13", Method::Vertical, "53>47"),
    ("kari14", Method::Vertical, "86/6 86/36 504/36 504/216 2968/216 2968/1272 17464/1272"),
    ("ammann16", Method::Vertical, "44/6 44/24 138/24 138/82 438/82 438/271 1406/271"),
    ("culik13", Method::Rotation, "60/9 60/21 126/42 126/84 336/149 336/228 702/456"),
    ("kari14", Method::Rotation, "94/9 94/23 210/46 210/136 596/204 596/372 1306/744"),
    ("ammann16", Method::Rotation, "49/12 49/32 113/52 113/80 257/160 257/226 545/416"),
    ("culik13", Method::Subdivision, "52/19 52/36 208/89 208/176 832/385 832/768 3328/1601"),
    ("kari14", Method::Subdivision, "56/21 56/40 224/97 224/192 896/417 896/832 3584/1729"),
    ("ammann16", Method::Subdivision, "64/23 64/44 256/109 256/216 1024/473 1024/944 4096/1969"),
    ("jeandel_rao11_4colors", Method::Diagonal, "89/11"),
    ("jeandel_rao11_4colors", Method::Rotation, "40/8"),
    ("jeandel_rao11_4colors", Method::Subdivision, "44/16"),
    ("jeandel_rao11_5labels", Method::Diagonal, "85/11"),
    ("jeandel_rao11_5labels", Method::Rotation, "36/9"),
    ("jeandel_rao11_5labels", Method::Subdivision, "44/17"),
];

#[test]
fn every_number_to_the_last_row() {
    for &(name, method, steps) in TABLES {
        let mut set = published(name);
        for (at, expected) in steps.split(' ').enumerate() {
            let step = if at % 2 == 0 { method } else { Method::ToWang };
            let converted = convert(&set, step).unwrap();
            let (tiles, colors) = (converted.set.tiles().len(), converted.colors);
            let found = match converted.pairs {
                Some(pairs) if !converted.is_injective() => format!("{pairs}>{tiles}"),
                _ => format!("{tiles}/{colors}"),
            };
            assert_eq!(found, expected, "{name}, {method}, step {at}");
            set = converted.set;
        }
    }
}

/// White and black tiles of table 8.1.
#[test]
fn rotation_has_two_sorts_of_tiles() {
    for (name, white, black) in [("culik13", 13, 47), ("kari14", 14, 80), ("ammann16", 16, 33)] {
        let converted = convert(&published(name), Method::Rotation).unwrap();
        assert_eq!(converted.white, Some(white));
        assert_eq!(converted.set.tiles().len(), white + black);
    }
}

#[test]
fn a_method_has_its_kind() {
    let set = published("ammann16");
    let error = convert(&set, Method::ToWang).unwrap_err().to_string();
    assert_eq!(error, "to-wang starts from corner tiles, but these are wang tiles");
    let corners = convert(&set, Method::Rotation).unwrap().set;
    assert!(convert(&corners, Method::Diagonal).is_err());
}
