//! `export`: a packing in the formats of other programs. It is checked first.
//!
//! What is written is a text or a file of bytes; a result of two files appears whole or not at
//! all, too.

use super::args::{ExportArgs, To};
use super::exit::Exit;
use super::{describe, export_shader, output, set, source};
use crate::atlas::demo::{self, Demo, How};
use crate::atlas::formats::texturepacker::{Frames, write_frames};
use crate::atlas::formats::{Sheet, dds, godot, ktx2, obj, puzzle::Puzzle, tiled, tsj};
use crate::atlas::light::Decoder;
use crate::atlas::picture::{Scene, raster, sheets, svg};
use crate::atlas::{AtlasError, Light, chain, open_png, write_png};
use crate::store::{AtomicFile, check_writable, read_solution};
use crate::tiles::Kind;
use crate::torus::{Packing, Shape, Topology};
use crate::verify;
use anyhow::{Context, bail};
use serde_json::{Value, json};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Tiles of the tiling in a map or model at most.
const MAX_DEMO: usize = 1 << 20;

/// Texels of a picture at most: 8192 x 8192.
const MAX_TEXELS: f64 = (1 << 26) as f64;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &ExportArgs) -> anyhow::Result<Exit> {
    let to = args.to.name();
    if let Some(option) = args.misplaced() {
        let known = args.to.options().join(", ");
        bail!("{option}: {to} does not know it; it knows {known}");
    }
    let names = [("--image", &args.image), ("--tileset", &args.tileset)];
    for (option, name) in names {
        if name.as_ref().is_some_and(|name| name.is_empty() || name.contains(char::is_control)) {
            bail!("{option}: expected a name without control characters");
        }
    }
    if args.output.is_none() && (is_binary(args.to) || args.json) {
        let what = if args.json { "--json".to_owned() } else { to };
        bail!("{what} needs -o FILE: without it, standard output is for text");
    }
    let packing = read(args)?;
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    let told = write(args, &packing)?;
    if args.json {
        let file = args.output.as_ref().map(|file| file.to_string_lossy());
        let mut fields =
            vec![("result", json!("written")), ("format", json!(to)), ("file", json!(file))];
        fields.extend(told.fields);
        output::object(&fields)?;
    }
    if !args.quiet && (args.output.is_some() || !told.remark.is_empty()) {
        let to = match &args.output {
            Some(file) => format!("written to {}", file.display()),
            None => "written".to_owned(),
        };
        let before = if told.remark.is_empty() { String::new() } else { told.remark + "; " };
        output::remark(&format!("{before}{to}"));
    }
    Ok(Exit::Yes)
}

/// What is said about a result.
#[derive(Debug, Default)]
struct Told {
    fields: Vec<(&'static str, Value)>,
    remark: String,
}

/// Whether standard output is no place for it: bytes, or two files.
fn is_binary(to: To) -> bool {
    matches!(to, To::PreviewPng | To::DemoPng | To::Obj | To::Ktx2 | To::Dds)
}

/// The packing, which must be one, of squares that are not turned, on a torus.
fn read(args: &ExportArgs) -> anyhow::Result<Packing> {
    let claim = set::packing_claim(&args.claim)?;
    let input = source::open(&args.file)?;
    let packing = read_solution(&input, &claim)?.packing;
    let file = args.file.display();
    let (kind, board) = (packing.set.kind(), &packing.board);
    if kind == Kind::Domino {
        bail!("{file}: a ring of dominoes has no square tiles: expected corner or Wang tiles");
    }
    if board.topology != Topology::Torus {
        let board = board.topology;
        bail!("{file}: on a {board} the tiles at opposite sides need not fit: expected a torus");
    }
    if board.rotations {
        bail!(
            "{file}: squares that may be turned need not fit as they lie in the set: expected tiles that are not turned"
        );
    }
    let verdict = verify::check(&packing);
    if !verdict.is_valid() {
        let what = if packing.cover { "covering" } else { "packing" };
        bail!("{file}: not a {what}: {verdict}");
    }
    Ok(packing)
}

fn write(args: &ExportArgs, packing: &Packing) -> anyhow::Result<Told> {
    let image = args.image.clone().unwrap_or_else(|| named(args, "png"));
    let length = |texels: Option<u32>| u64::from(texels.unwrap_or(0));
    let size = args.tile_size.unwrap_or(64);
    let sheet = Sheet {
        packing,
        image: &image,
        tile: size.into(),
        margin: length(args.margin),
        spacing: length(args.spacing),
    };
    let name = args.output.as_deref().and_then(Path::file_stem);
    let name = name.map_or("tilepack".into(), |stem| stem.to_string_lossy());
    match args.to {
        To::PreviewSvg | To::PreviewPng | To::ContactSheet => {
            if packing.tiles.len() > sheets::MAX_TILES {
                let tiles = packing.tiles.len();
                bail!("{tiles} tiles: pictures have at most {}", sheets::MAX_TILES);
            }
            let scene = match args.to {
                To::ContactSheet => sheets::contact_sheet(packing, size),
                _ => sheets::preview(packing, size, args.indices),
            };
            picture(args, &scene, size, &title(packing))?;
            Ok(Told::default())
        }
        To::DemoSvg | To::DemoPng => {
            let demo = tiling(args, packing, sheets::MAX_TILES)?;
            let scene = sheets::tiling(packing, &demo, size, args.indices);
            let title = format!("tiling, {}", title(packing));
            picture(args, &scene, size, &title)?;
            Ok(laid(&demo))
        }
        To::PuzzleSvg => {
            let puzzle = Puzzle::new(packing, args.tile_size.unwrap_or(40).into())?;
            give(args, |out| Ok(puzzle.write_svg(out, &title(packing))?))?;
            Ok(Told::default())
        }
        To::TiledTmx => {
            let demo = tiling(args, packing, MAX_DEMO)?;
            let tileset = args.tileset.clone().unwrap_or_else(|| named(args, "tsx"));
            give(args, |out| Ok(tiled::write_tmx(out, &sheet, &demo, &tileset)?))?;
            Ok(laid(&demo))
        }
        To::Obj => model(args, &sheet),
        To::Ktx2 | To::Dds => texture(args, packing),
        To::Glsl330 | To::GlslEs300 | To::Hlsl | To::Wgsl => {
            let (text, title) = export_shader::text(args, packing)?;
            give(args, |out| Ok(out.write_all(text.as_bytes())?))?;
            Ok(Told { fields: Vec::new(), remark: title.to_owned() })
        }
        sheets => {
            give(args, |out| match sheets {
                To::TiledTsx => tiled::write_tsx(out, &sheet, &name),
                To::TiledTsj => tsj::write_tsj(out, &sheet, &name),
                To::GodotTres => Ok(godot::write_tres(out, &sheet)?),
                To::TexturepackerHash => Ok(write_frames(out, &sheet, Frames::Named)?),
                _ => Ok(write_frames(out, &sheet, Frames::Listed)?),
            })?;
            let (width, height) = sheet.size();
            let fields = vec![
                ("image", json!(image)),
                ("image_width", json!(width)),
                ("image_height", json!(height)),
            ];
            Ok(Told { fields, remark: format!("for a picture {image} of {width}x{height} texels") })
        }
    }
}

/// What a picture shows.
fn title(packing: &Packing) -> String {
    let what = if packing.cover { "covering" } else { "packing" };
    let torus = describe::torus(packing.set.kind(), packing.shape);
    format!("{what}, {}, {torus}", describe::set(&packing.set))
}

/// The name of the result with another ending.
fn named(args: &ExportArgs, ending: &str) -> String {
    let stem = args.output.as_deref().and_then(Path::file_stem);
    format!("{}.{ending}", stem.map_or("atlas".into(), |stem| stem.to_string_lossy()))
}

/// The tiling that was asked for.
fn tiling(args: &ExportArgs, packing: &Packing, most: usize) -> anyhow::Result<Demo> {
    let shape: Shape = args.size.as_deref().unwrap_or("16x16").parse()?;
    if shape.cells() > most {
        bail!("--size {shape}: {} tiles, expected {most} or fewer", shape.cells());
    }
    Ok(demo::tiling(packing, shape, args.seed.unwrap_or(0)))
}

/// How a tiling was laid.
fn laid(demo: &Demo) -> Told {
    let how = match demo.how {
        How::Colors => "by random colors",
        How::TileByTile => "tile by tile",
        How::Repeated => "as the packing repeated",
    };
    Told { fields: vec![("tiling", json!(how))], remark: format!("a tiling laid {how}") }
}

/// Writes text or bytes, whole or not at all.
fn give(
    args: &ExportArgs,
    write: impl FnOnce(&mut dyn Write) -> Result<(), AtlasError>,
) -> anyhow::Result<()> {
    match &args.output {
        Some(file) => {
            let mut out = AtomicFile::create(file)?;
            write(&mut out).with_context(|| file.display().to_string())?;
            Ok(out.commit()?)
        }
        None => {
            let mut text = Vec::new();
            write(&mut text)?;
            output::result(|out| out.write_all(&text))
        }
    }
}

fn picture(args: &ExportArgs, scene: &Scene, size: u32, title: &str) -> anyhow::Result<()> {
    if !matches!(args.to, To::PreviewPng | To::DemoPng) {
        return give(args, |out| Ok(svg::write_svg(out, scene, size, title)?));
    }
    let (width, height) = (scene.width * f64::from(size), scene.height * f64::from(size));
    if width * height > MAX_TEXELS {
        bail!(
            "a picture of {width}x{height} texels: expected {MAX_TEXELS} or fewer; see --tile-size"
        );
    }
    let image = raster::draw(scene, size);
    give(args, |out| Ok(write_png(out, &image, &[])?))
}

/// A model and its material, beside it.
fn model(args: &ExportArgs, sheet: &Sheet<'_>) -> anyhow::Result<Told> {
    let demo = tiling(args, sheet.packing, MAX_DEMO)?;
    let file = args.output.clone().unwrap_or_default();
    let material: PathBuf = file.with_extension("mtl");
    if material == file {
        bail!("{}: the material of the model goes there: expected another ending", file.display());
    }
    let name = named(args, "mtl");
    let mut model = AtomicFile::create(&file)?;
    let mut beside = AtomicFile::create(&material)?;
    let path = || file.display().to_string();
    obj::write_obj(&mut model, sheet, &demo, &name).with_context(path)?;
    obj::write_mtl(&mut beside, sheet.image).with_context(path)?;
    beside.commit()?;
    model.commit()?;
    let mut told = laid(&demo);
    told.fields.push(("material", json!(material.to_string_lossy())));
    told.remark = format!("{}; its material is {}", told.remark, material.display());
    Ok(told)
}

/// A PNG file in a format of graphics cards.
fn texture(args: &ExportArgs, packing: &Packing) -> anyhow::Result<Told> {
    let Some(file) = &args.image else {
        bail!("{} needs --image FILE, the picture of the packing as PNG", args.to.name());
    };
    let image = open_png(Path::new(file))?;
    let image = if args.linear { image.with_light(Light::Linear) } else { image };
    let (width, height) = (image.width(), image.height());
    let shape = packing.shape;
    if !width.is_multiple_of(shape.width())
        || !height.is_multiple_of(shape.height())
        || width / shape.width() != height / shape.height()
    {
        bail!("{file}: {width}x{height} texels are not {shape} square tiles");
    }
    // To one texel a tile: no texel of a level shows two tiles.
    let halvings = (width / shape.width()).trailing_zeros() as usize;
    let decoder = Decoder::new(image.format());
    let levels = chain(image, halvings + 1, &decoder);
    give(args, |out| match args.to {
        To::Ktx2 => ktx2::write_ktx2(out, &levels),
        _ => dds::write_dds(out, &levels),
    })?;
    let count = levels.len();
    let fields = vec![("width", json!(width)), ("height", json!(height)), ("levels", json!(count))];
    let levels = describe::number(count as u64, "level");
    Ok(Told { fields, remark: format!("{width}x{height} texels, {levels}") })
}
