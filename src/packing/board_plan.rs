//! What a square in a cell of a board decides, prepared before the search.
//!
//! The tiles that fit a cell depend on the colors known around it: those prescribed, the same
//! for every visit, and those of the neighbors laid before. So for every cell there is a table
//! by the colors of two such neighbors (north and west in row order) of lists of all tiles that
//! show them and what is prescribed, the way of the programs for Eternity II. Cells of which the
//! same is known share a table. What further neighbors ask (at the seams of a torus, or when a
//! spiral closes) is looked at for each tile of a list.
//!
//! Squares that cannot be told apart are one *class* with a number of copies, and a list holds
//! every tile once, however many squares show it: so a search meets every picture once.

use super::Task;
use super::board::Labels;
use super::board_caps::Caps;
use crate::tiles::{Kind, TileId, turn};
use crate::torus::Cell;
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

/// A tile that fits.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Record {
    /// Its colors N, E, S, W.
    pub(super) sides: [u8; 4],
    /// The class of its square.
    pub(super) class: u16,
    /// The colors that it asks of neighbors not yet laid; see [`Caps`].
    pub(super) asks: [u8; 2],
}

/// A side of the cell of a level, and the place of its color.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Place {
    pub(super) side: u8,
    pub(super) at: u16,
}

/// A cell to be filled.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Level {
    /// Where its table begins.
    pub(super) base: u32,
    /// The places whose colors, the first times the stride, say which list it is; the dummy
    /// place is of color 0.
    pub(super) keys: [Place; 2],
    /// Other places known by then.
    checks: [Place; 2],
    checked: u8,
    /// The places that get their colors here, and what that uses up; see [`Caps`].
    fresh: [Place; 4],
    costs: [u8; 4],
    written: u8,
}

impl Level {
    /// Places known by then, besides the keys.
    #[inline(always)]
    pub(super) fn checks(&self) -> &[Place] {
        &self.checks[..usize::from(self.checked) % 3]
    }

    /// Whether a tile shows what is known at places besides the keys.
    #[inline(always)]
    pub(super) fn matches(&self, record: &Record, labels: &Labels) -> bool {
        let shows = |check: &Place| {
            record.sides[usize::from(check.side) % 4] == labels[usize::from(check.at)]
        };
        self.checks().iter().all(shows)
    }

    /// The places that get their colors here, each with what that uses up.
    #[inline(always)]
    pub(super) fn fresh(&self) -> impl Iterator<Item = (Place, u8)> + '_ {
        self.fresh.iter().copied().zip(self.costs).take(usize::from(self.written))
    }
}

/// All that does not change in a search.
#[derive(Debug, Clone)]
pub(super) struct BoardPlan {
    /// What the keys are multiplied by.
    pub(super) stride: usize,
    /// Lists one after the other.
    pub(super) records: Vec<Record>,
    /// By table and keys: where a list begins and ends.
    pub(super) lists: Vec<(u32, u32)>,
    pub(super) levels: Vec<Level>,
    /// By class: how many squares there are.
    pub(super) squares: Vec<u16>,
    /// By place: the color prescribed, else 0; at the end the dummy.
    pub(super) labels: Vec<u8>,
    /// What may still be asked of neighbors at the beginning.
    pub(super) caps: Caps,
}

/// What the tiles of a table have in common; cells that agree in it share one.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Common {
    /// The sides of the keys, of the checks, and of the colors that are new.
    keys: Vec<u8>,
    fresh: Vec<u8>,
    given: [Option<u8>; 4],
    /// Pairs of sides that are one place.
    same: Vec<(u8, u8)>,
}

impl BoardPlan {
    /// Plans the visits of all cells, those whose tile is given first; without caps, nothing is
    /// looked at but what touches.
    pub(super) fn new(task: &Task, with_caps: bool) -> Self {
        let (tiles, squares) = tiles(task);
        let edges = task.edges();
        let mut given = edges.given(&task.board.border);
        for (given, pin) in given.iter_mut().zip(task.pins.labels()) {
            *given = given.or(*pin);
        }
        let colors = task.set.colors().largest();
        let dummy = edges.labels();
        let mut labels: Vec<u8> = given.iter().map(|color| color.unwrap_or(0)).collect();
        labels.push(0);
        let caps = match with_caps && task.board.rotations {
            true => Caps::new(task, &given),
            false => Caps::none(),
        };
        let mut plan = Self {
            stride: colors,
            records: Vec::new(),
            lists: Vec::new(),
            levels: Vec::new(),
            squares,
            labels,
            caps,
        };
        let mut cells = task.visiting_order().cells(task.shape);
        let all_given = |cell| edges.sides(cell).into_iter().all(|place| given[place].is_some());
        cells.sort_by_key(|&cell: &Cell| !all_given(cell));
        let mut touching = vec![0; edges.labels()];
        for &cell in &cells {
            edges.sides(cell).into_iter().for_each(|place| touching[place] += 1);
        }
        let mut known = vec![false; edges.labels()];
        let mut tables = HashMap::new();
        for cell in cells {
            let sides = edges.sides(cell);
            let (mut known_sides, mut common) = (Vec::new(), Common::of(sides, &given));
            for (side, place) in (0..).zip(sides) {
                let place = Place { side, at: place as u16 };
                let first = sides.iter().position(|&at| at == usize::from(place.at));
                match (known[usize::from(place.at)], given[usize::from(place.at)]) {
                    (_, Some(_)) => {}
                    _ if first != Some(usize::from(side)) => {}
                    (true, _) => known_sides.push(place),
                    (false, _) => common.fresh.push(side),
                }
            }
            // North and west before east and south: the same for most cells.
            known_sides.sort_by_key(|place| [0, 2, 3, 1][usize::from(place.side)]);
            let mut level = Level::default();
            let nothing = Place { side: 0, at: dummy as u16 };
            level.keys = [nothing; 2];
            for (key, &place) in level.keys.iter_mut().zip(&known_sides) {
                *key = place;
                common.keys.push(place.side);
            }
            for (check, &place) in level.checks.iter_mut().zip(known_sides.iter().skip(2)) {
                *check = place;
                level.checked += 1;
            }
            for (i, &side) in common.fresh.iter().enumerate() {
                let at = sides[usize::from(side)];
                level.fresh[i] = Place { side, at: at as u16 };
                level.costs[i] = if touching[at] > 1 { 2 } else { 1 };
                level.written += 1;
                known[at] = true;
            }
            level.base =
                *tables.entry(common).or_insert_with_key(|common| plan.table(&tiles, common));
            plan.levels.push(level);
        }
        plan
    }

    /// Adds a table.
    fn table(&mut self, tiles: &[([u8; 4], u16)], common: &Common) -> u32 {
        let base = self.lists.len();
        let entries = match common.keys.len() {
            0 => 1,
            1 => (self.stride - 1) * self.stride + 1,
            _ => self.stride * self.stride,
        };
        let mut lists: Vec<Vec<Record>> = vec![Vec::new(); entries];
        let fits = |&&(sides, _): &&([u8; 4], u16)| {
            let given = sides.iter().zip(common.given);
            given.into_iter().all(|(&color, given)| given.is_none_or(|given| given == color))
                && common.same.iter().all(|&(a, b)| sides[usize::from(a)] == sides[usize::from(b)])
        };
        for &(sides, class) in tiles.iter().filter(fits) {
            let color = |side: &u8| sides[usize::from(*side)];
            let asks = self.caps.asked(common.fresh.iter().rev().map(color));
            if self.caps.are_closed(asks) {
                continue;
            }
            let key = |at: usize| common.keys.get(at).map_or(0, |side| usize::from(color(side)));
            lists[key(0) * self.stride + key(1)].push(Record { sides, class, asks });
        }
        for list in lists {
            let begin = self.records.len() as u32;
            self.records.extend(list);
            self.lists.push((begin, self.records.len() as u32));
        }
        base as u32
    }

    /// The number of tiles of the longest list.
    pub(super) fn longest(&self) -> usize {
        self.lists.iter().map(|(begin, end)| (end - begin) as usize).max().unwrap_or(0)
    }

    /// The tiles that fit the cell of a level, with these colors laid before.
    #[inline(always)]
    pub(super) fn list(&self, level: &Level, labels: &Labels) -> Range<usize> {
        let [first, second] = level.keys.map(|key| usize::from(labels[usize::from(key.at)]));
        let (begin, end) = self.lists[level.base as usize + first * self.stride + second];
        begin as usize..end as usize
    }
}

impl Common {
    fn of(sides: [usize; 4], given: &[Option<u8>]) -> Self {
        let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
        let same = |&(a, b): &(u8, u8)| sides[usize::from(a)] == sides[usize::from(b)];
        Self {
            keys: Vec::new(),
            fresh: Vec::new(),
            given: sides.map(|place| given[place]),
            same: pairs.into_iter().filter(same).collect(),
        }
    }
}

/// All different tiles, in increasing order, each with the class of the squares that show it;
/// and the number of squares of every class.
pub(super) fn tiles(task: &Task) -> (Vec<([u8; 4], u16)>, Vec<u16>) {
    let colors = task.set.colors();
    let mut classes: BTreeMap<TileId, ([TileId; 4], u16)> = BTreeMap::new();
    for tile in task.set.allowed() {
        let shown = match task.board.rotations {
            // A task with two palettes has been refused.
            true => turn::turns(tile, colors).unwrap_or([tile; 4]),
            false => [tile; 4],
        };
        let least = shown.into_iter().min().unwrap_or(tile);
        classes.entry(least).or_insert((shown, 0)).1 += 1;
    }
    let mut tiles = BTreeMap::new();
    for (class, (shown, _)) in classes.values().enumerate() {
        for &tile in shown {
            tiles.insert(tile, class as u16);
        }
    }
    let sides = |(&tile, &class): (&TileId, &u16)| (Kind::Wang.unpack(tile, colors), class);
    (tiles.iter().map(sides).collect(), classes.values().map(|&(_, squares)| squares).collect())
}
