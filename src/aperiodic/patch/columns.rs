//! The graph of columns of k tiles that fit below each other, from their W labels to their E
//! labels, by the N label of the first.

use super::super::decide::Tile;
use std::collections::{BTreeSet, HashMap};

/// A column: its W labels, its E labels (numbers of states), its N label, its first tile.
#[derive(Debug, Clone, Copy)]
struct Arc {
    from: u32,
    to: u32,
    tile: u32,
}

/// The columns of the most tiles that are worth it.
#[derive(Debug)]
pub(super) struct Columns {
    /// By the N label of the first tile.
    arcs: Vec<Vec<Arc>>,
    states: usize,
    ahead: usize,
    /// The S label of each tile.
    souths: Vec<u32>,
}

/// W labels, E labels, N label of columns.
type Below = BTreeSet<(u32, u32, u32)>;

impl Columns {
    /// Columns of as many tiles as give at most so many arcs, of one tile at least. Labels are
    /// small numbers.
    ///
    /// # Errors
    /// The number of rows of a strip that cannot be filled.
    pub(super) fn new(tiles: &[Tile], most: usize) -> Result<Self, usize> {
        let mut best: Option<Self> = None;
        // Columns of no tiles: one state, and any label.
        let labels: BTreeSet<u32> = tiles.iter().flat_map(|&[n, _, s, _]| [n, s]).collect();
        let mut below: Below = labels.iter().map(|&label| (0, 0, label)).collect();
        for ahead in 1..=32 {
            let mut by_north: HashMap<u32, Vec<(u32, u32)>> = HashMap::new();
            for &(from, to, north) in &below {
                by_north.entry(north).or_default().push((from, to));
            }
            let mut states: HashMap<(u32, u32), u32> = HashMap::new();
            let mut state = |label: u32, below: u32| {
                let next = states.len() as u32;
                *states.entry((label, below)).or_insert(next)
            };
            let mut arcs: Vec<(u32, u32, u32, u32)> = Vec::new();
            for (at, &[north, east, south, west]) in tiles.iter().enumerate() {
                for &(from, to) in by_north.get(&south).into_iter().flatten() {
                    arcs.push((state(west, from), state(east, to), north, at as u32));
                }
            }
            let states = states.len();
            cut(&mut arcs, states);
            if arcs.is_empty() {
                return Err(ahead);
            }
            if arcs.len() > most && best.is_some() {
                break;
            }
            below = arcs.iter().map(|&(from, to, north, _)| (from, to, north)).collect();
            best = Some(Self::of(&arcs, states, ahead, tiles));
        }
        best.ok_or(1)
    }

    fn of(arcs: &[(u32, u32, u32, u32)], states: usize, ahead: usize, tiles: &[Tile]) -> Self {
        // States that are left, numbered anew.
        let used: BTreeSet<u32> = arcs.iter().flat_map(|&(from, to, ..)| [from, to]).collect();
        let mut number = vec![0; states];
        for (new, &old) in used.iter().enumerate() {
            number[old as usize] = new as u32;
        }
        let labels = tiles.iter().flat_map(|&[n, _, s, _]| [n, s]).max().unwrap_or(0);
        let mut by_north = vec![Vec::new(); labels as usize + 1];
        for &(from, to, north, tile) in arcs {
            let [from, to] = [from, to].map(|state| number[state as usize]);
            by_north[north as usize].push(Arc { from, to, tile });
        }
        let souths = tiles.iter().map(|tile| tile[2]).collect();
        Self { arcs: by_north, states: used.len(), ahead, souths }
    }

    /// Tiles of a column.
    pub(super) fn ahead(&self) -> usize {
        self.ahead
    }

    /// A random row below another one, or anywhere, below which more rows fit; `None` when there
    /// is none. Every walk is as likely as any other.
    pub(super) fn row(
        &self,
        above: Option<&[usize]>,
        width: usize,
        mut random: impl FnMut() -> f64,
    ) -> Option<Vec<usize>> {
        let lists = |column: usize| -> &[Vec<Arc>] {
            match above {
                Some(above) => {
                    let label = self.souths[above[column]] as usize;
                    &self.arcs[label..=label]
                }
                None => &self.arcs,
            }
        };
        // The number of walks from each state to the end, column by column, but for a factor.
        let mut ways = vec![1f32; (width + 1) * self.states];
        for column in (0..width).rev() {
            let (here, there) = ways[column * self.states..].split_at_mut(self.states);
            here.fill(0.0);
            let mut sum = 0.0;
            for arc in lists(column).iter().flatten() {
                let more = there[arc.to as usize];
                here[arc.from as usize] += more;
                sum += more;
            }
            if sum == 0.0 {
                return None;
            }
            here.iter_mut().for_each(|ways| *ways /= sum);
        }
        let mut state = None;
        let mut row = Vec::with_capacity(width);
        for column in 0..width {
            let there = &ways[(column + 1) * self.states..][..self.states];
            let from = |arc: &&Arc| state.is_none_or(|state| state == arc.from);
            let arcs = || lists(column).iter().flatten().filter(from);
            let weight = |arc: &Arc| f64::from(there[arc.to as usize]);
            let total: f64 = arcs().map(weight).sum();
            let mut rest = random() * total;
            let mut chosen = None;
            for arc in arcs().filter(|arc| weight(arc) > 0.0) {
                chosen = Some(*arc);
                rest -= weight(arc);
                if rest < 0.0 {
                    break;
                }
            }
            let arc = chosen?;
            row.push(arc.tile as usize);
            state = Some(arc.to);
        }
        Some(row)
    }
}

/// Leaves only arcs that lie on walks without end, to both sides.
fn cut(arcs: &mut Vec<(u32, u32, u32, u32)>, states: usize) {
    loop {
        let (mut entered, mut left) = (vec![false; states], vec![false; states]);
        for &(from, to, ..) in arcs.iter() {
            left[from as usize] = true;
            entered[to as usize] = true;
        }
        let before = arcs.len();
        arcs.retain(|&(from, to, ..)| entered[from as usize] && left[to as usize]);
        if arcs.len() == before {
            return;
        }
    }
}
