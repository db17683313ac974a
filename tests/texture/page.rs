//! The pictures of docs/texture.md.
//!
//! `cargo test --release --test texture -- --ignored` makes them again, with a headless Chromium.

use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};
use tilepack::atlas::{Image, read_png};

const PAGE: &str = include_str!("../../docs/texture.md");
/// Columns and rows of a picture of the viewer.
const WINDOW: (usize, usize) = (640, 420);

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs")
}

fn picture(file: &Path) -> Image {
    let bytes = fs::read(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    read_png(Cursor::new(bytes), 1 << 30).unwrap()
}

/// The files of the pictures on the page.
fn pictures() -> Vec<PathBuf> {
    let links = PAGE.split("![").skip(1).map(|rest| {
        let (_, rest) = rest.split_once("](").unwrap();
        rest.split_once(')').unwrap().0
    });
    links.map(|link| docs().join(link)).collect()
}

#[test]
fn the_page_shows_pictures_that_show_something() {
    let pictures = pictures();
    assert!(pictures.len() >= 5, "{pictures:?}");
    for file in pictures {
        let image = picture(&file);
        let viewer = file.to_string_lossy().contains("texture-");
        let expected = if viewer { WINDOW } else { (256, 256) };
        assert_eq!((image.width(), image.height()), expected, "{}", file.display());
        // Many colors, in every quarter.
        for (left, top) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let (width, height) = (image.width() / 2, image.height() / 2);
            let part = image.part(left * width, top * height, width, height);
            let texels: std::collections::HashSet<&[u8]> =
                part.data().chunks(part.format().bytes()).collect();
            assert!(texels.len() > 200, "{}: {} colors", file.display(), texels.len());
        }
    }
}

/// The commands of the page up to its viewer, then a look at that.
#[test]
#[ignore = "rewrites the pictures in docs/pictures"]
fn rewrite_the_pictures() {
    let folder = tempfile::tempdir().unwrap();
    for (example, picture) in [("leaves", "texture-leaves.png"), ("bricks", "texture-bricks.png")] {
        for args in [
            format!("fill --example {example} -o {example}.png"),
            format!("fill {example}.png --kind corner --colors 3 -o {example} --quiet"),
            "find --kind corner --colors 3 --quiet -o three.json".to_owned(),
            format!("atlas three.json --fill {example} --html {example}.html --quiet"),
        ] {
            let mut command = assert_cmd::cargo::cargo_bin_cmd!("tilepack");
            command.current_dir(&folder).args(args.split_whitespace()).assert().success();
        }
        let shot = docs().join("pictures").join(picture);
        let (width, height) = WINDOW;
        let run = Command::new("chromium")
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"])
            .args(["--hide-scrollbars", "--timeout=4000"])
            .arg(format!("--window-size={width},{height}"))
            .arg(format!("--user-data-dir={}", folder.path().join("profile").display()))
            .arg(format!("--screenshot={}", shot.display()))
            .arg(format!(
                "file://{}#folded=1",
                folder.path().join(format!("{example}.html")).display()
            ))
            .output()
            .unwrap();
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    }
}
