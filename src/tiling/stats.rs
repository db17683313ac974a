//! How random a window of tiles is: what is counted, for any tiling.
//!
//! * *Misfits*: neighbors that do not fit, and tiles outside the set.
//! * *chi2/df*: the squared deviations of the numbers of tiles from an even share, in units of their
//!   expectation: about 1 when tiles are as likely and nearly independent.
//! * *Equal neighbors*, of corner tiles: how many of the 8 points around a point have its color, in the
//!   mean over points inside the window (at its rim neighbors are missing). `8 / C` at random; less
//!   where colors keep apart.
//! * *Mutual information* of the colors of two points (of Wang tiles: two horizontal edges, two vertical
//!   ones) up to four steps apart; the largest, less what chance alone gives, `(C - 1)^2 / (2 n ln 2)`.
//! * *Agreement* of rows: of any two rows (of the first 512) the largest share of equal colors; the
//!   same for columns. 1 means a row that is repeated.

use crate::tiles::{Colors, Kind, TileId, TileSet};
use crate::torus::Shape;

/// What was counted in a window.
#[derive(Debug, Clone, PartialEq)]
pub struct Stats {
    /// Neighbors that do not fit, and tiles that are not in the set.
    pub misfits: u64,
    /// Different tiles seen.
    pub seen: u64,
    /// Tiles of the set, where there is one.
    pub tiles: Option<u64>,
    /// Of the numbers of tiles, against even shares of the set.
    pub chi2_per_df: Option<f64>,
    /// Of corner tiles.
    pub equal_neighbors: Option<f64>,
    /// The largest in bits, and the points it is of: so many to the east and to the north.
    pub information: f64,
    /// Where.
    pub lag: (i64, i64),
    /// Of two rows.
    pub row_agreement: f64,
    /// Of two columns.
    pub column_agreement: f64,
}

/// Colors in rows from the north.
struct Field {
    width: usize,
    height: usize,
    colors: usize,
    labels: Vec<u8>,
}

/// Steps between points whose dependence is looked at.
const LAGS: i64 = 4;

/// Rows that are held against each other.
const ROWS: usize = 512;

/// Counts a window of tiles, row by row from the north; `set` are the tiles that may be in it.
pub fn stats(
    kind: Kind,
    colors: Colors,
    shape: Shape,
    tiles: &[TileId],
    set: Option<&TileSet>,
) -> Stats {
    let (width, height) = (shape.width(), shape.height());
    let sides: Vec<[u8; 4]> = tiles.iter().map(|&tile| kind.unpack(tile, colors)).collect();
    let field = |side: usize, colors: usize| Field {
        width,
        height,
        colors,
        labels: sides.iter().map(|sides| sides[side]).collect(),
    };
    let fields = match kind {
        // South-west corners.
        Kind::Corner => vec![field(2, colors.horizontal())],
        _ => vec![field(0, colors.horizontal()), field(3, colors.vertical())],
    };
    let mut counts = vec![0u64; kind.tiles(colors) as usize];
    for tile in tiles {
        counts[tile.index()] += 1;
    }
    let foreign = |tile: &&TileId| set.is_some_and(|set| !set.allows(**tile));
    let outside = tiles.iter().filter(foreign).count() as u64;
    let lags = || (0..=LAGS).flat_map(|y| (-LAGS..=LAGS).map(move |x| (x, y)));
    let lags = lags().filter(|&(x, y)| y > 0 || x > 0);
    let all = lags.flat_map(|lag| fields.iter().map(move |field| (field.information(lag), lag)));
    let (information, lag) =
        all.fold((0.0, (0, 0)), |best, next| if next.0 > best.0 { next } else { best });
    let largest = |of: &dyn Fn(&Field) -> f64| fields.iter().map(of).fold(0.0, f64::max);
    Stats {
        misfits: misfits(kind, width, &sides) + outside,
        seen: counts.iter().filter(|&&count| count > 0).count() as u64,
        tiles: set.map(TileSet::size),
        chi2_per_df: set.and_then(|set| chi2_per_df(&counts, tiles.len(), set)),
        equal_neighbors: (kind == Kind::Corner).then(|| fields[0].equal_neighbors()).flatten(),
        information,
        lag,
        row_agreement: largest(&Field::row_agreement),
        column_agreement: largest(&|field| field.transposed().row_agreement()),
    }
}

fn misfits(kind: Kind, width: usize, sides: &[[u8; 4]]) -> u64 {
    let east = |a: &[u8; 4], b: &[u8; 4]| match kind {
        Kind::Corner => a[0] == b[3] && a[1] == b[2],
        _ => a[1] == b[3],
    };
    let south = |a: &[u8; 4], b: &[u8; 4]| match kind {
        Kind::Corner => a[1] == b[0] && a[2] == b[3],
        _ => a[2] == b[0],
    };
    let rows = sides.chunks(width);
    let across = rows.clone().flat_map(|row| row.windows(2)).filter(|p| !east(&p[0], &p[1]));
    let down = sides.iter().zip(sides.iter().skip(width)).filter(|(a, b)| !south(a, b));
    (across.count() + down.count()) as u64
}

fn chi2_per_df(counts: &[u64], total: usize, set: &TileSet) -> Option<f64> {
    let df = set.size().checked_sub(1).filter(|&df| df > 0)?;
    let mean = total as f64 / set.size() as f64;
    let terms = set.allowed().map(|tile| (counts[tile.index()] as f64 - mean).powi(2) / mean);
    Some(terms.sum::<f64>() / df as f64)
}

impl Field {
    /// The mean number of equal colors among the 8 neighbors of the points inside.
    fn equal_neighbors(&self) -> Option<f64> {
        let (mut equal, mut points) = (0u64, 0u64);
        let rows: Vec<&[u8]> = self.labels.chunks(self.width).collect();
        for three in rows.windows(3) {
            for x in 1..self.width.saturating_sub(1) {
                let own = three[1][x];
                let around = three.iter().flat_map(|row| &row[x - 1..=x + 1]);
                // The point itself is one of the nine.
                equal += around.filter(|&&color| color == own).count() as u64 - 1;
                points += 1;
            }
        }
        (points > 0).then(|| equal as f64 / points as f64)
    }

    /// Bits that a color tells of the one so many steps to the east and north.
    fn information(&self, (dx, dy): (i64, i64)) -> f64 {
        let c = self.colors;
        let mut pairs = vec![0u64; c * c];
        let (skip, dy) = (dx.unsigned_abs() as usize, dy as usize);
        if skip >= self.width || dy >= self.height {
            return 0.0;
        }
        let (from, to) = if dx < 0 { (skip, 0) } else { (0, skip) };
        let rows: Vec<&[u8]> = self.labels.chunks(self.width).collect();
        for (north, south) in rows.iter().zip(&rows[dy..]) {
            for (a, b) in south[from..].iter().zip(&north[to..]) {
                pairs[usize::from(*a) * c + usize::from(*b)] += 1;
            }
        }
        let total: u64 = pairs.iter().sum();
        let mut sums = [vec![0u64; c], vec![0u64; c]];
        for (at, count) in pairs.iter().enumerate() {
            sums[0][at / c] += count;
            sums[1][at % c] += count;
        }
        let n = total as f64;
        let bits = |(at, &count): (usize, &u64)| {
            let expected = sums[0][at / c] as f64 * sums[1][at % c] as f64 / n;
            if count == 0 { 0.0 } else { count as f64 / n * (count as f64 / expected).log2() }
        };
        let found: f64 = pairs.iter().enumerate().map(bits).sum();
        let by_chance = ((c - 1) * (c - 1)) as f64 / (2.0 * n * std::f64::consts::LN_2);
        (found - by_chance).max(0.0)
    }

    /// The largest share of equal colors in two rows.
    fn row_agreement(&self) -> f64 {
        let rows: Vec<&[u8]> = self.labels.chunks(self.width).take(ROWS).collect();
        let equal =
            |a: &[u8], b: &[u8]| a.iter().zip(b).map(|(a, b)| u32::from(a == b)).sum::<u32>();
        let pairs = rows
            .iter()
            .enumerate()
            .flat_map(|(at, a)| rows[at + 1..].iter().map(move |b| equal(a, b)));
        f64::from(pairs.max().unwrap_or(0)) / self.width as f64
    }

    fn transposed(&self) -> Self {
        let columns = (0..self.width).flat_map(|x| self.labels[x..].iter().step_by(self.width));
        Self {
            width: self.height,
            height: self.width,
            colors: self.colors,
            labels: columns.copied().collect(),
        }
    }
}
