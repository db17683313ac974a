//! `lint`: do the tiles of a sheet fit?

use super::args::LintArgs;
use super::atlas::{exactness_fields, write_exactness};
use super::exit::Exit;
use super::{describe, output, tile_pictures};
use crate::atlas::filter::{Exactness, Filter};
use crate::atlas::light::Decoder;
use crate::atlas::lint::{Deviation, Findings, Question, Seam, heat_map, lint};
use crate::atlas::{Image, Layout, Sheet, chain, open_png, write_png};
use crate::store::{check_writable, write_file};
use crate::tiles::Side;
use crate::tiles::TileId;
use anyhow::{Context, ensure};
use serde_json::{Value, json};
use std::io::{self, Write};

/// Things that are off and told one by one.
const TOLD: usize = 10;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &LintArgs) -> anyhow::Result<Exit> {
    ensure!(args.tolerance >= 0.0, "--tolerance {}: expected 0 or more", args.tolerance);
    for file in [&args.heat, &args.seams].into_iter().flatten() {
        check_writable(file)?;
    }
    let image = open_png(&args.image)?;
    let sheet = tile_pictures::sheet(&image, &args.tiles, args.columns, args.gutter)
        .with_context(|| args.image.display().to_string())?;
    let question = Question { strip: args.strip, tolerance: args.tolerance };
    let findings = lint(&sheet, question)?;
    let missing = if args.complete { missing(sheet.layout()) } else { Vec::new() };
    let exactness = match args.filter {
        true => Some(filter(&sheet)?),
        false => None,
    };
    if let Some(file) = &args.heat {
        let map = heat_map(&sheet, &findings);
        write_file(file, |out| write_png(out, &map, &[]))?;
    }
    if let Some(file) = &args.seams {
        write_file(file, |out| write_seams(out, sheet.layout(), &findings))?;
    }
    let fits = findings.deviations.is_empty()
        && findings.visible().next().is_none()
        && findings.twice.is_empty()
        && findings.lonely.is_empty()
        && missing.is_empty();
    let all = Report { args, layout: sheet.layout(), findings, missing, exactness, fits };
    match args.json {
        true => all.print_json()?,
        false => output::result(|out| all.write(out))?,
    }
    Ok(if fits { Exit::Yes } else { Exit::No })
}

/// Tiles over the colors that the sheet does not show.
fn missing(layout: &Layout) -> Vec<TileId> {
    let all = (0..layout.kind.tiles(layout.colors)).map(|tile| TileId(tile as u32));
    all.filter(|&tile| layout.cell(tile).is_none()).collect()
}

/// How far filtering in the sheet is off, with levels made of it.
fn filter(sheet: &Sheet) -> anyhow::Result<Exactness> {
    let image = sheet.image();
    let levels: Vec<Image> =
        chain(image.clone(), sheet.layout().levels(), &Decoder::new(image.format()));
    Ok(Filter::new(sheet.layout(), &levels)?.exactness())
}

/// One line for each pair of tiles that may lie side by side.
fn write_seams(out: &mut dyn Write, layout: &Layout, findings: &Findings) -> io::Result<()> {
    writeln!(out, "first,second,side,largest,step,inside,visible,strip_largest,strip_rms")?;
    // The worst of the strips that meet.
    let strip_of = |cell: usize, side: Side| {
        let strips = findings.deviations.iter();
        strips
            .filter(|d| !d.corner && d.cell == cell && d.side == side)
            .map(|d| (d.largest, d.rms))
            .next()
    };
    for seam in &findings.seams {
        let Seam { first, second, side, largest, step, inside } = *seam;
        let none = (0.0, 0.0);
        let one = strip_of(first, side).unwrap_or(none);
        let other = strip_of(second, side.opposite()).unwrap_or(none);
        let strip_largest = one.0.max(other.0);
        let strip_rms = ((one.1 * one.1 + other.1 * other.1) / 2.0).sqrt();
        writeln!(
            out,
            "{},{},{},{largest:.2},{step:.3},{inside:.3},{},{strip_largest:.2},{strip_rms:.3}",
            layout.tiles[first],
            layout.tiles[second],
            side.name(),
            u8::from(seam.is_visible())
        )?;
    }
    Ok(())
}

/// What there is to say.
struct Report<'a> {
    args: &'a LintArgs,
    layout: &'a Layout,
    findings: Findings,
    missing: Vec<TileId>,
    exactness: Option<Exactness>,
    fits: bool,
}

impl Report<'_> {
    /// A tile and where it lies.
    fn cell(&self, cell: usize) -> String {
        let (column, row) = self.layout.position(cell);
        format!("tile {} (column {column}, row {row})", self.layout.tiles[cell])
    }

    fn area(deviation: &Deviation) -> String {
        match deviation.corner {
            true => format!("{} corner", ["NE", "SE", "SW", "NW"][deviation.side as usize]),
            false => format!("{} side", deviation.side.name()),
        }
    }

    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let (layout, findings) = (self.layout, &self.findings);
        writeln!(
            out,
            "{}: {} {} tiles of {} texels, {} x {} cells",
            self.args.image.display(),
            layout.tiles.len(),
            layout.kind,
            layout.side,
            layout.columns,
            layout.rows()
        )?;
        for (tile, cells) in findings.twice.iter().take(TOLD) {
            let places: Vec<String> = cells.iter().map(|&cell| self.cell(cell)).collect();
            writeln!(out, "tile {tile} shows {} times: {}", cells.len(), places.join(", "))?;
        }
        for (first, second) in findings.alike.iter().take(TOLD) {
            writeln!(out, "{} and {} look the same", self.cell(*first), self.cell(*second))?;
        }
        for (cell, side) in findings.lonely.iter().take(TOLD) {
            writeln!(out, "nothing fits the {} side of {}", side.name(), self.cell(*cell))?;
        }
        if !self.missing.is_empty() {
            let some: Vec<String> =
                self.missing.iter().take(TOLD).map(|tile| tile.to_string()).collect();
            let more = if self.missing.len() > TOLD { ", ..." } else { "" };
            writeln!(out, "{} are missing: {}{more}", self.missing.len(), some.join(", "))?;
        }
        if self.args.strip > 0 {
            let off = findings.deviations.len();
            let (strip, areas) = (self.args.strip, findings.areas);
            writeln!(
                out,
                "strips of {}: {off} of {areas} are off",
                describe::number(strip as u64, "texel")
            )?;
            for deviation in findings.deviations.iter().take(TOLD) {
                let (area, (column, row)) = (Self::area(deviation), deviation.at);
                let cell = self.cell(deviation.cell);
                let (largest, rms) = (deviation.largest, deviation.rms);
                writeln!(
                    out,
                    "  {cell}, {area}: by up to {largest:.0}/255 at texel {column}, {row}; {rms:.1} RMS"
                )?;
            }
        }
        let visible = findings.visible().count();
        writeln!(
            out,
            "seams: {} pairs may lie side by side, {visible} with a visible seam",
            findings.seams.len()
        )?;
        for seam in findings.visible().take(TOLD) {
            let (first, second) = (self.cell(seam.first), self.cell(seam.second));
            let place = if seam.side == Side::East { "beside" } else { "above" };
            writeln!(
                out,
                "  {first} {place} {second}: step {:.1}, within the tiles {:.1} (RMS), largest {:.0}",
                seam.step, seam.inside, seam.largest
            )?;
        }
        if let Some(&(cell, _)) = findings.redraw.first() {
            writeln!(out, "draw again first: {}", self.cell(cell))?;
        }
        if let Some(exactness) = &self.exactness {
            write_exactness(out, exactness)?;
        }
        writeln!(out, "{}", if self.fits { "all fits" } else { "not all fits" })
    }

    fn print_json(&self) -> anyhow::Result<()> {
        let (layout, findings) = (self.layout, &self.findings);
        let place = |cell: usize| {
            let (column, row) = layout.position(cell);
            json!({ "tile": layout.tiles[cell].0, "column": column, "row": row })
        };
        let off: Vec<Value> = findings
            .deviations
            .iter()
            .map(|d| {
                json!({
                    "cell": place(d.cell), "side": Self::area(d), "corner": d.corner,
                    "largest": d.largest, "rms": d.rms,
                })
            })
            .collect();
        let visible: Vec<Value> = findings
            .visible()
            .map(|seam| {
                json!({
                    "first": place(seam.first), "second": place(seam.second),
                    "side": seam.side.name(), "largest": seam.largest, "step": seam.step,
                    "inside": seam.inside,
                })
            })
            .collect();
        let tiles = |tiles: &[TileId]| tiles.iter().map(|tile| tile.0).collect::<Vec<u32>>();
        let twice: Vec<u32> = findings.twice.iter().map(|(tile, _)| tile.0).collect();
        let alike: Vec<Value> =
            findings.alike.iter().map(|&(a, b)| json!([place(a), place(b)])).collect();
        let lonely: Vec<Value> = findings
            .lonely
            .iter()
            .map(|&(cell, side)| json!({ "cell": place(cell), "side": side.name() }))
            .collect();
        let redraw: Vec<Value> = findings.redraw.iter().map(|&(cell, _)| place(cell)).collect();
        let mut fields = vec![
            ("result", json!(if self.fits { "fits" } else { "off" })),
            ("tiles", json!(layout.tiles.len())),
            ("tile_size", json!(layout.side)),
            ("strip", json!(self.args.strip)),
            ("areas", json!(findings.areas)),
            ("off", json!(off)),
            ("seams", json!(findings.seams.len())),
            ("visible", json!(visible)),
            ("missing", json!(tiles(&self.missing))),
            ("twice", json!(twice)),
            ("alike", json!(alike)),
            ("lonely", json!(lonely)),
            ("redraw", json!(redraw)),
        ];
        fields.extend(self.exactness.as_ref().map(exactness_fields).unwrap_or_default());
        output::object(&fields)
    }
}
