//! `atlas`: a packing as a texture, with tables, a viewer, and the proof of what filtering does.

use super::args::{ArrangeArg, AtlasArgs, GutterArg};
use super::exit::Exit;
use super::tile_pictures::{self, Pictures};
use super::{describe, output, session, source};
use crate::atlas::filter::{Exactness, Filter};
use crate::atlas::{
    Arrangement, AtlasError, Gutter, Image, Layout, PngWriter, Scene, tables, viewer, write_png,
};
use crate::store::{AtomicFile, check_writable, write_file};
use anyhow::{Context, ensure};
use serde_json::{Value, json};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Bytes of an atlas that has to be in memory, at most.
const LIMIT: u64 = 4 << 30;

/// Runs the command.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(args: &AtlasArgs) -> anyhow::Result<Exit> {
    ensure!(
        args.output.is_some() || args.tables.is_some() || args.html.is_some() || args.check,
        "nothing to do: expected -o OUT.png, --tables DIR, --html OUT.html or --check"
    );
    for file in [&args.output, &args.html].into_iter().flatten() {
        check_writable(file)?;
    }
    session::threads(args.threads)?;
    let packing = source::packing(&args.file, &args.claim)?;
    let pictures = tile_pictures::pictures(&args.tiles, &packing)?;
    let arrangement = match args.arrange {
        ArrangeArg::Packed => Arrangement::Packed,
        ArrangeArg::ByNumber => Arrangement::ByNumber,
    };
    let gutter = match args.gutter_fill {
        GutterArg::Neighbor => Gutter::Neighbor,
        GutterArg::Clamp => Gutter::Clamp,
    };
    let layout = Layout::new(&packing, arrangement, pictures.images.side(), args.gutter)?;
    let scene = Scene { layout: &layout, packing: &packing, gutter, images: &*pictures.images };
    let in_memory = args.check || args.html.is_some();
    if in_memory {
        let texels = layout.width() as u64 * layout.height() as u64;
        let bytes = texels * pictures.images.format().bytes() as u64 * 4 / 3;
        ensure!(
            bytes <= LIMIT,
            "an atlas of {} x {} texels takes {} MiB; --check and --html hold it in memory, and \
             their limit is {}",
            layout.width(),
            layout.height(),
            bytes >> 20,
            LIMIT >> 20
        );
    }
    let about = about(args, &pictures);
    let levels = match in_memory {
        true => scene.levels(layout.levels())?,
        false => Vec::new(),
    };
    let mut written = Vec::new();
    if let Some(file) = &args.output {
        written = write_levels(file, args.mips, &scene, &levels, &about)?;
    }
    let mut table_files = Vec::new();
    if let Some(folder) = &args.tables {
        table_files = write_tables(folder, &layout, pictures.strip, args.quiet)?;
    }
    let exactness = match in_memory {
        true => Some(Filter::new(&layout, &levels)?.exactness()),
        false => None,
    };
    if let (Some(file), Some(exactness)) = (&args.html, &exactness) {
        let page = viewer::Scene {
            packing: &packing,
            layout: &layout,
            levels: levels.iter().map(png_bytes).collect::<io::Result<_>>()?,
            strip: pictures.strip,
            exact_to_lod: exactness.exact_to_lod(),
            light: pictures.images.format().light,
            seed: args.tiles.seed as u32,
            title: describe::set(&packing.set),
        };
        write_file(file, |out| viewer::write(out, &page))?;
    }
    let exactness = exactness.filter(|_| args.check);
    report(args, &layout, &pictures, &written, &table_files, exactness.as_ref())?;
    let promised = promised(&layout, pictures.strip);
    let kept = exactness.is_none_or(|exactness| exactness.exact_to_lod() >= promised);
    Ok(if kept { Exit::Yes } else { Exit::No })
}

fn png_bytes(image: &Image) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    write_png(&mut bytes, image, &[])?;
    Ok(bytes)
}

/// The level through which strip and gutter let filtering be exact.
fn promised(layout: &Layout, strip: usize) -> Option<u32> {
    let reach = if layout.gutter > 0 { strip.min(layout.gutter) } else { strip };
    reach.checked_ilog2().map(|level| level.min(layout.levels() as u32 - 1))
}

/// What made the picture, for its text chunks: no path, no clock.
fn about(args: &AtlasArgs, pictures: &Pictures) -> String {
    let mut words = vec!["tilepack atlas".to_owned()];
    let name = args.file.file_name().unwrap_or_default().to_string_lossy();
    // Text chunks are Latin-1; other letters are of no use there.
    words.push(name.chars().map(|c| if c.is_ascii_graphic() { c } else { '_' }).collect());
    words.push(pictures.words.clone());
    if args.arrange == ArrangeArg::ByNumber {
        words.push("--arrange by-number".into());
    }
    if args.gutter > 0 {
        words.push(format!("--gutter {}", args.gutter));
        if args.gutter_fill == GutterArg::Clamp {
            words.push("--gutter-fill clamp".into());
        }
    }
    words.join(" ")
}

/// The file of a level: that of level 0 with the number before its ending.
fn level_file(file: &Path, level: usize) -> PathBuf {
    match level {
        0 => file.into(),
        _ => file.with_extension(format!("{level}.png")),
    }
}

/// Writes the atlas and, if asked for, its levels; the files are there when all are complete.
fn write_levels(
    file: &Path,
    mips: bool,
    scene: &Scene<'_>,
    levels: &[Image],
    about: &str,
) -> anyhow::Result<Vec<PathBuf>> {
    let count = if mips { scene.layout.levels() } else { 1 };
    let files: Vec<PathBuf> = (0..count).map(|level| level_file(file, level)).collect();
    files.iter().try_for_each(check_writable)?;
    let software = concat!("tilepack ", env!("CARGO_PKG_VERSION"));
    let text = [("Software", software), ("Comment", about)];
    let mut writers = Vec::new();
    for (level, file) in files.iter().enumerate() {
        let (width, height) = (scene.layout.width() >> level, scene.layout.height() >> level);
        let out = AtomicFile::create(file)?;
        let format = scene.images.format();
        let writer = PngWriter::new(out, width, height, format, &text);
        writers.push(writer.with_context(|| cannot(file))?);
    }
    if levels.is_empty() {
        // The file that is written to when an error comes up.
        let mut at = 0;
        let drawn = scene.draw(count, |level, band| {
            at = level;
            writers[level].rows(band.data())
        });
        drawn.map_err(|error| match error {
            AtlasError::Io(error) => anyhow::Error::new(error).context(cannot(&files[at])),
            other => other.into(),
        })?;
    } else {
        for ((writer, image), file) in writers.iter_mut().zip(levels).zip(&files) {
            writer.rows(image.data()).with_context(|| cannot(file))?;
        }
    }
    let mut complete = Vec::new();
    for (writer, file) in writers.into_iter().zip(&files) {
        complete.push(writer.finish().with_context(|| cannot(file))?);
    }
    complete.into_iter().try_for_each(AtomicFile::commit)?;
    Ok(files)
}

fn cannot(file: &Path) -> String {
    format!("{}: cannot be written", file.display())
}

/// Writes all tables; pictures that cannot hold the numbers are left out, with a remark.
fn write_tables(
    folder: &Path,
    layout: &Layout,
    strip: usize,
    quiet: bool,
) -> anyhow::Result<Vec<PathBuf>> {
    fs::create_dir_all(folder).with_context(|| cannot(folder))?;
    let mut files = Vec::new();
    let mut add = |name: &str, write: &dyn Fn(&mut dyn Write) -> io::Result<()>| {
        let file = folder.join(name);
        write_file(&file, |out| write(out))?;
        files.push(file);
        anyhow::Ok(())
    };
    add("atlas.json", &|out| tables::write_json(out, layout, strip))?;
    add("atlas.csv", &|out| tables::write_csv(out, layout))?;
    let left_out = |name: &str, error: &dyn std::fmt::Display| {
        if !quiet {
            output::remark(&format!("{name} is left out: {error}"));
        }
    };
    let mut header = Vec::new();
    match tables::write_header(&mut header, layout, "atlas") {
        Ok(()) => add("atlas.h", &|out| out.write_all(&header))?,
        Err(error) => left_out("atlas.h", &error),
    }
    let pictures =
        [("tiles.png", tables::tile_picture(layout)), ("cells.png", tables::cell_picture(layout))];
    for (name, picture) in pictures {
        match picture {
            Ok(image) => add(name, &|out| write_png(out, &image, &[]))?,
            Err(error) => left_out(name, &error),
        }
    }
    Ok(files)
}

/// Says what was made and found.
fn report(
    args: &AtlasArgs,
    layout: &Layout,
    pictures: &Pictures,
    written: &[PathBuf],
    tables: &[PathBuf],
    exactness: Option<&Exactness>,
) -> anyhow::Result<()> {
    let names = |files: &[PathBuf]| -> Vec<String> {
        files.iter().map(|file| file.to_string_lossy().into_owned()).collect()
    };
    if args.json {
        let mut fields = vec![
            ("result", json!("made")),
            ("file", json!(args.output.as_ref().map(|file| file.to_string_lossy()))),
            ("width", json!(layout.width())),
            ("height", json!(layout.height())),
            ("tiles", json!(layout.tiles.len())),
            ("tile_size", json!(layout.side)),
            ("strip", json!(pictures.strip)),
            ("gutter", json!(layout.gutter)),
            ("levels", json!(layout.levels())),
            ("files", json!(names(written))),
            ("tables", json!(names(tables))),
            ("html", json!(args.html.as_ref().map(|file| file.to_string_lossy()))),
        ];
        fields.extend(exactness.map(exactness_fields).unwrap_or_default());
        return output::object(&fields);
    }
    if !args.quiet {
        let made = match written {
            [] => String::new(),
            [file] => format!("; written to {}", file.display()),
            [file, .., last] => format!("; written to {} ... {}", file.display(), last.display()),
        };
        output::remark(&format!(
            "{} tiles of {} texels, {} x {}, strip {}, levels 0 to {}{made}",
            layout.tiles.len(),
            layout.side,
            layout.width(),
            layout.height(),
            pictures.strip,
            layout.levels() - 1
        ));
    }
    match exactness {
        Some(exactness) => output::result(|out| write_exactness(out, exactness)),
        None => Ok(()),
    }
}

/// The figures for programs.
pub fn exactness_fields(exactness: &Exactness) -> Vec<(&'static str, Value)> {
    let rounded = |error: &f64| json!((error * 1e6).round() / 1e6);
    let list = |errors: &[f64]| errors.iter().map(rounded).collect::<Vec<Value>>();
    let anisotropic: Vec<Value> = exactness
        .anisotropic
        .iter()
        .map(|(ratio, error)| json!({ "ratio": ratio, "error": rounded(error) }))
        .collect();
    vec![
        ("exact_to_lod", json!(exactness.exact_to_lod())),
        ("errors", json!(list(&exactness.bilinear))),
        ("trilinear", json!(list(&exactness.trilinear))),
        ("anisotropic", json!(anisotropic)),
    ]
}

/// The figures for people.
///
/// # Errors
/// What `out` reports.
pub fn write_exactness(out: &mut dyn Write, exactness: &Exactness) -> io::Result<()> {
    match exactness.exact_to_lod() {
        Some(level) => writeln!(out, "filtering is exact through LOD {level}")?,
        None => writeln!(out, "filtering is exact at no LOD")?,
    }
    writeln!(out, "largest difference between the atlas and any tiling, in 1/255 of full light:")?;
    let figure = |error: f64| match error {
        0.0 => "0".to_owned(),
        error if error < 0.01 => format!("{error:.1e}"),
        error => format!("{error:.2}"),
    };
    for (level, &error) in exactness.bilinear.iter().enumerate() {
        writeln!(out, "  LOD {level:<4} bilinear   {:>8}", figure(error))?;
        if let Some(&error) = exactness.trilinear.get(level) {
            writeln!(out, "  LOD {:<4} trilinear  {:>8}", format!("{level}.5"), figure(error))?;
        }
    }
    for &(ratio, error) in &exactness.anisotropic {
        let ratio = format!("{ratio}:1");
        writeln!(out, "  LOD 0    {ratio:<5}      {:>8}", figure(error))?;
    }
    Ok(())
}
