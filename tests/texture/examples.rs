//! The pictures that come with the project.

use std::fs;
use std::io::Cursor;
use std::path::Path;
use tilepack::atlas::{read_png, write_png};
use tilepack::texture::example::{Aspect, Subject, draw, named};

#[test]
fn files_are_what_is_drawn() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/textures");
    let mut found = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|end| end != "png") {
            continue;
        }
        let name = path.file_stem().unwrap().to_str().unwrap();
        let (subject, aspect) = named(name).unwrap();
        let file = fs::read(&path).unwrap();
        assert!(file.len() < 150_000, "{name}: {} bytes", file.len());
        let image = draw(subject, aspect, (256, 256), 0).unwrap();
        assert!(
            read_png(Cursor::new(&file), 1 << 30).unwrap() == image,
            "{name} is drawn otherwise"
        );
        // As the command in the README of the folder writes it.
        let mut bytes = Vec::new();
        let comment = format!("tilepack fill --example {name} --size 256x256 --seed 0");
        write_png(&mut bytes, &image, &[("Comment", &comment)]).unwrap();
        assert!(bytes == file, "{name} is written otherwise");
        found += 1;
    }
    assert!(found >= 4, "{found}");
}

#[test]
fn pictures_are_rich_and_their_maps_make_sense() {
    for subject in Subject::ALL {
        let size = (96, 64);
        let color = draw(subject, Aspect::Color, size, 3).unwrap();
        assert_eq!((color.width(), color.height()), size);
        assert_ne!(color, draw(subject, Aspect::Color, size, 4).unwrap());
        let mut levels: Vec<u8> = color.data().to_vec();
        levels.sort_unstable();
        let (low, high) = (levels[levels.len() / 50], levels[levels.len() * 49 / 50]);
        assert!(high - low > 80, "{}: {low} to {high}", subject.name());
        let normal = draw(subject, Aspect::Normal, size, 3).unwrap();
        for texel in normal.data().chunks(3) {
            let length: f64 = texel.iter().map(|&s| (f64::from(s) / 127.5 - 1.0).powi(2)).sum();
            assert!((length.sqrt() - 1.0).abs() < 0.02 && texel[2] > 127, "{texel:?}");
        }
        let height = draw(subject, Aspect::Height, size, 3).unwrap();
        assert!(height.data().iter().max() > height.data().iter().min());
    }
    assert_eq!(named("stone-normal"), Some((Subject::Stone, Aspect::Normal)));
    assert_eq!(named("stones"), None);
    assert!(draw(Subject::Stone, Aspect::Color, (5000, 20), 0).is_err());
}
