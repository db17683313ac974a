//! Checking that a set of corner tiles fills the plane, but never periodically.
//!
//! 1. *The coding.* Convex polygons in a rectangle, apart from one another, whose areas add up to
//!    that of the rectangle, which is a fundamental domain of the lattice. So almost every point
//!    of the torus, and all its integer translates, lie inside of polygons: it codes a pattern.
//! 2. *The windows.* Each polygon of a window, moved to each cell, lies in the piece named there,
//!    and at the south-west cell within the rectangle. Pieces differ between any two windows, so
//!    their polygons are apart; areas add up: no other pattern occurs at almost every point.
//! 3. *The Wang tiling.* In every window neighbors fit. So every such pattern is a tiling.
//! 4. *The coloring.* The rule colors every vertex, and the corner tiles listed are those that it
//!    makes. So the corner tiles fill the plane.
//! 5. *The way back.* Each tiling by the corner tiles gives one by the Wang tiles, found cell by
//!    cell: see `condition`. A period of the one is one of the other, and the Wang tiles have no
//!    periodic tiling (Jeandel and Rao 2021), which is all that is taken on trust.
//!
//! Numbers are integers and exact; the code is shared with nothing.

mod condition;
mod number;
mod polygons;

use crate::torus::toral::ToralCertificate;
use number::{LIMIT, is_positive, plus, spot, times};
use polygons::Shape;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// The set of Jeandel and Rao 2021 (Advances in Combinatorics 2021:1, figure 4), [N, E, S, W].
const JEANDEL_RAO: &str = "0212 2202 1113 2123 1333 1013 0010 1320 2021 2101 3321";
/// The same in figure 3, before label 4 was merged with 0.
const JEANDEL_RAO_UNMERGED: &str = "4212 2202 1113 2123 1333 1013 0010 1320 2021 2141 3321";

/// Sizes beyond which a file is not looked at.
const MOST_PIECES: usize = 1000;
const MOST_WINDOWS: usize = 50_000;
const MOST_CELLS: usize = 400;
const MOST_TILES: usize = 1000;
/// The longest move by the lattice, either way.
const MOST_SHIFT: u64 = 1000;

/// What the tilings by the corner tiles have to do with those by the Wang tiles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum WayBack {
    /// A pair of colors says the label of a side.
    Pair,
    /// A tile and its four neighbors say the Wang tile.
    Radius1,
    /// The tiles up to two steps away say it.
    Radius2,
}

impl WayBack {
    /// `pair`, `radius1` or `radius2`.
    pub fn name(self) -> &'static str {
        match self {
            WayBack::Pair => "pair",
            WayBack::Radius1 => "radius1",
            WayBack::Radius2 => "radius2",
        }
    }
}

impl fmt::Display for WayBack {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            WayBack::Pair => "the pairs of colors of a tile",
            WayBack::Radius1 => "a tile and its four neighbors",
            WayBack::Radius2 => "the tiles up to two steps away",
        })
    }
}

/// What a certificate has been found to prove.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ProvedSet {
    /// Corner tiles.
    pub tiles: usize,
    /// Their colors.
    pub colors: usize,
    /// Polygons of the partition.
    pub pieces: usize,
    /// Windows.
    pub windows: usize,
    /// What gives the Wang tiling.
    pub way_back: WayBack,
    /// Corner tiles that stand for more than one Wang tile.
    pub ambiguous: usize,
}

/// Where a certificate fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// The Wang tiles are not the known ones.
    WangTiles,
    /// The lattice and the partition.
    Partition,
    /// The windows.
    Windows,
    /// Neighbors in a window do not fit.
    Fit,
    /// The colors of vertices.
    Rule,
    /// The corner tiles.
    Tiles,
    /// The way back to Wang tiles.
    WayBack,
}

/// Why a certificate proves nothing.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{}: {reason}", .step.name())]
pub struct CertificateFault {
    /// The step that fails.
    pub step: Step,
    /// What is wrong.
    pub reason: String,
}

impl Step {
    fn name(self) -> &'static str {
        match self {
            Step::WangTiles => "Wang tiles",
            Step::Partition => "partition",
            Step::Windows => "windows",
            Step::Fit => "neighbors",
            Step::Rule => "vertex rule",
            Step::Tiles => "corner tiles",
            Step::WayBack => "way back",
        }
    }

    fn fault(self, reason: impl Into<String>) -> CertificateFault {
        CertificateFault { step: self, reason: reason.into() }
    }
}

/// Checks a certificate, step by step.
///
/// # Errors
/// The first step that fails, and why.
pub fn check_certificate(certificate: &ToralCertificate) -> Result<ProvedSet, CertificateFault> {
    check_wang_tiles(certificate)?;
    let pieces = check_partition(certificate)?;
    check_windows(certificate, &pieces)?;
    check_fit(certificate)?;
    let rule = check_rule(certificate)?;
    let occurring = check_tiles(certificate, &rule)?;
    let way_back = check_way_back(certificate, &occurring)?;
    let ambiguous = certificate.options.iter().filter(|options| options.len() > 1).count();
    let colors: BTreeSet<u32> = certificate.tiles.iter().flatten().copied().collect();
    Ok(ProvedSet {
        tiles: certificate.tiles.len(),
        colors: colors.len(),
        pieces: certificate.partition.len(),
        windows: certificate.windows.len(),
        way_back,
        ambiguous,
    })
}

fn check_wang_tiles(certificate: &ToralCertificate) -> Result<(), CertificateFault> {
    let text = |tiles: &[[u32; 4]]| {
        let tile = |tile: &[u32; 4]| tile.map(|label| label.to_string()).concat();
        tiles.iter().map(tile).collect::<Vec<_>>().join(" ")
    };
    let fault = |which: &str| {
        let reason = format!("{which} are not those of Jeandel and Rao 2021, in their order");
        Err(Step::WangTiles.fault(reason))
    };
    if text(&certificate.wang) != JEANDEL_RAO {
        return fault("the 11 tiles over 4 labels");
    }
    let unmerged = text(&certificate.wang_unmerged);
    if !unmerged.is_empty() && unmerged != JEANDEL_RAO_UNMERGED {
        return fault("the 11 tiles over 5 labels");
    }
    Ok(())
}

/// A rectangle that is a fundamental domain of the lattice, filled by the pieces.
fn check_partition(certificate: &ToralCertificate) -> Result<Vec<Shape>, CertificateFault> {
    let fault = |reason: String| Err(Step::Partition.fault(reason));
    let [first, second] = certificate.lattice;
    let all = [first, second, certificate.domain];
    if let Some(x) = all.iter().flatten().find(|x| !(-LIMIT..=LIMIT).contains(*x)) {
        return fault(format!("the lattice or the domain has the number {x}, beyond {LIMIT}"));
    }
    let ((w, zero), (_, h)) = (spot(first), spot(second));
    let (width, height) = spot(certificate.domain);
    if zero != (0, 0) || (w, h) != (width, height) || !is_positive(w) || !is_positive(h) {
        let expected = "expected vectors (w, 0) and (s, h) for a domain of width w and height h";
        return fault(format!("the lattice does not suit the domain: {expected}"));
    }
    let count = certificate.partition.len();
    if count > MOST_PIECES {
        return fault(format!("{count} pieces, more than {MOST_PIECES}"));
    }
    let origin = (0, 0);
    let corners = [(origin, origin), (w, origin), (w, h), (origin, h)];
    let domain = Shape(corners.to_vec());
    let mut pieces: Vec<Shape> = Vec::with_capacity(count);
    let mut area = (0, 0);
    for (k, piece) in certificate.partition.iter().enumerate() {
        if piece.label >= certificate.wang.len() {
            return fault(format!("piece {k} has label {}, which is no tile", piece.label));
        }
        let shape = match Shape::read(&piece.polygon) {
            Ok(shape) => shape,
            Err(reason) => return fault(format!("piece {k} {reason}")),
        };
        if let Some(vertex) = shape.first_outside(&domain) {
            return fault(format!("piece {k}: vertex {vertex} is outside of the domain"));
        }
        if let Some(other) = pieces.iter().position(|other| !other.is_apart_from(&shape)) {
            return fault(format!("pieces {other} and {k} overlap: no side separates them"));
        }
        area = plus(area, shape.double_area());
        pieces.push(shape);
    }
    let expected = times((2, 0), times(w, h));
    if area != expected {
        return fault(format!(
            "twice the areas add up to {}, expected {}",
            say(area),
            say(expected)
        ));
    }
    Ok(pieces)
}

fn say((a, b): (i128, i128)) -> String {
    format!("{a} + {b} phi")
}

/// The windows are all there are, but for points of area nothing.
fn check_windows(certificate: &ToralCertificate, pieces: &[Shape]) -> Result<(), CertificateFault> {
    let fault = |reason: String| Err(Step::Windows.fault(reason));
    let [rows, columns] = certificate.window_shape;
    let cells = rows.saturating_mul(columns);
    if cells == 0 || cells > MOST_CELLS {
        return fault(format!("{rows} rows of {columns}: expected 1 to {MOST_CELLS} cells"));
    }
    if certificate.windows.len() > MOST_WINDOWS {
        return fault(format!("{}, more than {MOST_WINDOWS}", certificate.windows.len()));
    }
    let [first, second] = certificate.lattice.map(spot);
    let mut area = (0, 0);
    let mut seen = BTreeMap::new();
    for (i, window) in certificate.windows.iter().enumerate() {
        if window.labels.len() != cells || window.pieces.len() != cells {
            let (labels, pieces) = (window.labels.len(), window.pieces.len());
            return fault(format!(
                "window {i} has {labels} labels and {pieces} pieces, expected {cells}"
            ));
        }
        let shape = match Shape::read(&window.polygon) {
            Ok(shape) => shape,
            Err(reason) => return fault(format!("window {i} {reason}")),
        };
        for (cell, &[k, m, n]) in window.pieces.iter().enumerate() {
            let (row, column) = (cell / columns, cell % columns);
            let here = format!("window {i}, row {row}, column {column}");
            let piece = usize::try_from(k).ok().filter(|&k| k < pieces.len());
            let Some(piece) = piece else { return fault(format!("{here}: there is no piece {k}")) };
            if [m, n].iter().any(|shift| shift.unsigned_abs() > MOST_SHIFT) {
                return fault(format!("{here}: piece {k} is moved too far"));
            }
            if (row + 1, column) == (rows, 0) && (m, n) != (0, 0) {
                return fault(format!("{here}: the piece of the south-west cell is moved"));
            }
            if window.labels[cell] != certificate.partition[piece].label {
                let (label, other) = (window.labels[cell], certificate.partition[piece].label);
                return fault(format!("{here}: label {label}, but that of piece {k} is {other}"));
            }
            // Against the lattice instead of the piece with it.
            let (m, n) = (-i128::from(m), -i128::from(n));
            let back = |x, y| plus(times((m, 0), x), times((n, 0), y));
            let (dx, dy) = (column as i128, (rows - 1 - row) as i128);
            let by =
                (plus((dx, 0), back(first.0, second.0)), plus((dy, 0), back(first.1, second.1)));
            if let Some(vertex) = shape.moved(by).first_outside(&pieces[piece]) {
                return fault(format!("{here}: vertex {vertex} is not in piece {k} as moved"));
            }
        }
        if let Some(before) = seen.insert(&window.pieces, i) {
            return fault(format!("windows {before} and {i} have the same pieces"));
        }
        area = plus(area, shape.double_area());
    }
    let (width, height) = spot(certificate.domain);
    let expected = times((2, 0), times(width, height));
    if area != expected {
        return fault(format!(
            "twice the areas add up to {}, expected {}",
            say(area),
            say(expected)
        ));
    }
    Ok(())
}

/// The labels of neighbors in windows agree on the side they share.
fn check_fit(certificate: &ToralCertificate) -> Result<(), CertificateFault> {
    let [rows, columns] = certificate.window_shape;
    if rows < 2 || columns < 2 {
        return Err(Step::Fit.fault("windows of one row or column do not show all neighbors"));
    }
    for (i, window) in certificate.windows.iter().enumerate() {
        let tile =
            |row: usize, column: usize| certificate.wang[window.labels[row * columns + column]];
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |c| (row, c))) {
            let here = tile(row, column);
            let east = column + 1 == columns || here[1] == tile(row, column + 1)[3];
            let south = row + 1 == rows || here[2] == tile(row + 1, column)[0];
            if !(east && south) {
                let side = if east { "south" } else { "east" };
                return Err(Step::Fit.fault(format!(
                    "window {i}, row {row}, column {column}: the tile does not fit its neighbor \
                     to the {side}"
                )));
            }
        }
    }
    Ok(())
}

/// The colors by pattern; every vertex of a window has one, and none is there for nothing.
fn check_rule(certificate: &ToralCertificate) -> Result<BTreeMap<&[usize], u32>, CertificateFault> {
    let fault = |reason: String| Err(Step::Rule.fault(reason));
    let rule = &certificate.rule;
    let [rows, columns] = certificate.window_shape;
    let reach = [rule.above, rule.below, rule.left, rule.right];
    if reach.iter().any(|&reach| reach == 0 || reach > MOST_CELLS) {
        return fault(format!("it looks at {reach:?} rows and columns, expected at least 1 each"));
    }
    let expected = [rule.above + rule.below + 1, rule.left + rule.right + 1];
    if [rows, columns] != expected {
        return fault(format!(
            "the four vertices of a tile see {} rows of {}, but windows have {rows} of {columns}",
            expected[0], expected[1]
        ));
    }
    let mut table = BTreeMap::new();
    for (i, (labels, color)) in rule.table.iter().enumerate() {
        if table.insert(labels.as_slice(), *color).is_some() {
            return fault(format!("entry {i}: the pattern {labels:?} has a color already"));
        }
    }
    let mut used = BTreeSet::new();
    for (i, window) in certificate.windows.iter().enumerate() {
        for (dy, dx) in VERTICES {
            let seen = around(certificate, &window.labels, dy, dx);
            let Some((&labels, _)) = table.get_key_value(seen.as_slice()) else {
                return fault(format!("window {i}: the pattern {seen:?} has no color"));
            };
            used.insert(labels);
        }
    }
    match rule.table.iter().position(|(labels, _)| !used.contains(labels.as_slice())) {
        Some(i) => fault(format!("entry {i}: the pattern does not occur")),
        None => Ok(table),
    }
}

/// The vertices NW, NE, SE, SW of a cell, as steps to the south and to the east.
const VERTICES: [(usize, usize); 4] = [(0, 0), (0, 1), (1, 1), (1, 0)];

/// The tiles around a vertex of the middle cell of a window.
fn around(certificate: &ToralCertificate, labels: &[usize], dy: usize, dx: usize) -> Vec<usize> {
    let [rows, columns] = certificate.window_shape;
    let rows = dy..dy + rows - 1;
    rows.flat_map(|row| &labels[row * columns + dx..row * columns + dx + columns - 1])
        .copied()
        .collect()
}

/// The corner tiles are those that the rule makes. Gives the Wang tiles that each occurs with.
fn check_tiles(
    certificate: &ToralCertificate,
    rule: &BTreeMap<&[usize], u32>,
) -> Result<Vec<BTreeSet<usize>>, CertificateFault> {
    let fault = |reason: String| Err(Step::Tiles.fault(reason));
    let tiles = &certificate.tiles;
    if tiles.len() > MOST_TILES {
        return fault(format!("{} tiles, more than {MOST_TILES}", tiles.len()));
    }
    let mut number = BTreeMap::new();
    for (i, &tile) in tiles.iter().enumerate() {
        if let Some(before) = number.insert(tile, i) {
            return fault(format!("tiles {before} and {i} are the same, {tile:?}"));
        }
    }
    let columns = certificate.window_shape[1];
    let middle = certificate.rule.above * columns + certificate.rule.left;
    let mut occurring = vec![BTreeSet::new(); tiles.len()];
    for (i, window) in certificate.windows.iter().enumerate() {
        let color = |(dy, dx)| {
            let seen = around(certificate, &window.labels, dy, dx);
            rule.get(seen.as_slice()).copied().unwrap_or(u32::MAX)
        };
        let made = VERTICES.map(color);
        match number.get(&made) {
            Some(&tile) => occurring[tile].insert(window.labels[middle]),
            None => return fault(format!("window {i} makes {made:?}, which is not listed")),
        };
    }
    if let Some(tile) = occurring.iter().position(BTreeSet::is_empty) {
        return fault(format!("tile {tile}, {:?}, does not occur", tiles[tile]));
    }
    if certificate.image.len() != tiles.len() {
        return fault(format!("{} images, expected {}", certificate.image.len(), tiles.len()));
    }
    for (tile, (image, found)) in certificate.image.iter().zip(&occurring).enumerate() {
        if !image.iter().eq(found) {
            return fault(format!("tile {tile} has the image {image:?}, but stands for {found:?}"));
        }
    }
    Ok(occurring)
}

/// The options are those listed, and there is a way back.
fn check_way_back(
    certificate: &ToralCertificate,
    occurring: &[BTreeSet<usize>],
) -> Result<WayBack, CertificateFault> {
    let (options, way_back) = condition::check(&certificate.wang, &certificate.tiles, occurring);
    let listed = &certificate.options;
    if listed.len() != options.len() {
        let (given, expected) = (listed.len(), options.len());
        return Err(Step::WayBack.fault(format!("{given} lists of options, expected {expected}")));
    }
    if let Some(i) = (0..options.len()).find(|&i| options[i] != listed[i]) {
        let (found, given) = (&options[i], &listed[i]);
        let reason = format!("tile {i} has the options {found:?}, but {given:?} are listed");
        return Err(Step::WayBack.fault(reason));
    }
    way_back.map_err(|reason| Step::WayBack.fault(reason))
}

/// The way back alone: corner tiles [NW, NE, SE, SW] that are known to occur with some Wang tiles
/// [N, E, S, W], given by their numbers.
///
/// # Errors
/// Why there is none, or a number that is no Wang tile.
pub fn check_corner_tiles(
    wang: &[[u32; 4]],
    tiles: &[[u32; 4]],
    image: &[Vec<usize>],
) -> Result<WayBack, CertificateFault> {
    let occurring: Vec<BTreeSet<usize>> =
        image.iter().map(|numbers| numbers.iter().copied().collect()).collect();
    let unknown = occurring.iter().flatten().any(|&number| number >= wang.len());
    if unknown || occurring.len() != tiles.len() || occurring.iter().any(BTreeSet::is_empty) {
        return Err(Step::Tiles.fault("a corner tile does not name Wang tiles it occurs with"));
    }
    condition::check(wang, tiles, &occurring).1.map_err(|reason| Step::WayBack.fault(reason))
}
