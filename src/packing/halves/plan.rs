//! What happens at each cell of a sweep, prepared beforehand.
//!
//! Cells are filled along the short side, so that few colors are open at a time. Every open
//! place has a slot, a few bits of a word; a cell reads the slots of the sides that neighbors
//! have decided, and writes those of the sides that it decides for others.

use crate::packing::{Task, board_plan};
use crate::torus::{Cell, Order};

/// A tile in a cell: a square and how it is turned.
#[derive(Debug, Clone, Copy)]
pub(super) struct Laid {
    /// The bits of its square and of those that look the same: one more of them is used.
    pub(super) class: u64,
    /// What it writes into the slots.
    pub(super) shown: u64,
}

/// A cell to be filled.
#[derive(Debug, Clone)]
pub(super) struct Stage {
    /// The slots of sides already decided, from the first side on.
    reads: Vec<usize>,
    bits: usize,
    /// The slots that are read or written.
    cleared: u64,
    /// By the colors read: the tiles that fit.
    lists: Vec<Vec<Laid>>,
    /// For each color that is counted: sides prescribed in cells still empty.
    pub(super) awaited: u128,
    /// The slots in use afterwards.
    pub(super) open: Vec<usize>,
}

/// Colors whose sides are counted, each in a lane of 16 bits of one number; more are not.
const COUNTED: usize = 8;
/// One in the lane of each of these colors.
pub(super) const LANES: [u128; COUNTED] =
    [1, 1 << 16, 1 << 32, 1 << 48, 1 << 64, 1 << 80, 1 << 96, 1 << 112];
/// One in every lane.
pub(super) const ONES: u128 = u128::MAX / 0xffff;
/// More than any lane counts, in every lane.
pub(super) const ENOUGH: u128 = ONES << 15;

fn lane(color: u8) -> u128 {
    LANES.get(usize::from(color)).copied().unwrap_or(0)
}

/// A sweep from either end.
#[derive(Debug)]
pub(super) struct Plan {
    /// The first half of the cells, and the others from the last one on.
    pub(super) halves: [Vec<Stage>; 2],
    pub(super) bits: usize,
    /// By class of squares: its bits, as many as there are squares, side by side.
    classes: Vec<u64>,
    /// All squares.
    pub(super) all: u64,
    /// By byte of a set of squares: how many sides of each color these squares have; empty where
    /// tiles are not turned, or outer sides are free.
    pub(super) sides: Vec<[u128; 256]>,
    slots: usize,
}

impl Plan {
    pub(super) fn new(task: &Task) -> Self {
        let colors = task.set.colors().largest();
        let bits = (usize::BITS - (colors - 1).leading_zeros()).max(1) as usize;
        let (tiles, squares) = board_plan::tiles(task);
        let classes = sets(&squares);
        let (edges, shape) = (task.edges(), task.shape);
        let mut given = edges.given(&task.board.border);
        for (given, pin) in given.iter_mut().zip(task.pins.labels()) {
            *given = given.or(*pin);
        }
        let order = if shape.height() <= shape.width() { Order::Column } else { Order::Row };
        let cells = order.cells(shape);
        let mut meets = vec![0u16; edges.labels()];
        for &cell in &cells {
            edges.sides(cell).into_iter().for_each(|place| meets[place] += 1);
        }
        let bounded = edges.outer().all(|(_, _, place)| given[place].is_some());
        let counts = task.board.rotations && bounded;
        let all = classes.iter().fold(0, |all, class| all | class);
        let sides = if counts { sides_by_byte(&tiles, &classes) } else { Vec::new() };
        let mut plan = Self { halves: Default::default(), bits, classes, all, sides, slots: 0 };
        let middle = cells.len().div_ceil(2);
        let reversed: Vec<Cell> = cells[middle..].iter().rev().copied().collect();
        for (half, cells) in [&cells[..middle], &reversed[..]].into_iter().enumerate() {
            // Places open, in the order of their slots; free slots are `None`.
            let mut slots: Vec<Option<usize>> = Vec::new();
            let prescribed = given.iter().zip(&meets);
            let mut awaited = prescribed
                .filter_map(|(color, &meets)| color.map(|color| lane(color) * u128::from(meets)))
                .sum();
            for &cell in cells {
                let stage = plan.stage(
                    &edges.sides(cell),
                    &tiles,
                    (&given, &meets),
                    &mut slots,
                    &mut awaited,
                );
                plan.halves[half].push(stage);
            }
            plan.slots = plan.slots.max(slots.len());
            // Both halves name what is open in the same order.
            if let Some(last) = plan.halves[half].last_mut() {
                last.open.sort_by_key(|&slot| slots[slot]);
            }
        }
        plan
    }

    fn stage(
        &self,
        sides: &[usize; 4],
        tiles: &[([u8; 4], u16)],
        (given, meets): (&[Option<u8>], &[u16]),
        slots: &mut Vec<Option<usize>>,
        awaited: &mut u128,
    ) -> Stage {
        let slot_of = |slots: &[Option<usize>], place| slots.iter().position(|&s| s == Some(place));
        let mut reads = Vec::new();
        let mut read_sides = Vec::new();
        for (side, &place) in sides.iter().enumerate() {
            if let Some(slot) = slot_of(slots, place) {
                reads.push(slot);
                read_sides.push(side);
            }
        }
        // A slot that is read may be written again at once.
        reads.iter().for_each(|&slot| slots[slot] = None);
        let mut written = Vec::new();
        for (side, &place) in sides.iter().enumerate() {
            if let Some(color) = given[place] {
                *awaited -= lane(color);
            } else if !read_sides.contains(&side) && meets[place] == 2 {
                let free = slots.iter().position(Option::is_none).unwrap_or_else(|| {
                    slots.push(None);
                    slots.len() - 1
                });
                slots[free] = Some(place);
                written.push((side, free));
            }
        }
        let bits = self.bits;
        let field = (1u64 << bits) - 1;
        let at = |slot: usize| (slot * bits).min(63);
        let touched = written.iter().map(|&(_, slot)| slot).chain(reads.iter().copied());
        let cleared = touched.fold(0, |word, slot| word | field << at(slot));
        let mut lists = vec![Vec::new(); 1 << (bits * reads.len())];
        for &(shown, class) in tiles {
            let fits = sides
                .iter()
                .zip(shown)
                .all(|(&place, color)| given[place].is_none_or(|g| g == color));
            if fits {
                let known = read_sides.iter().enumerate();
                let index = known
                    .fold(0, |index, (i, &side)| index | usize::from(shown[side]) << (i * bits));
                let word = written
                    .iter()
                    .fold(0, |w, &(side, slot)| w | u64::from(shown[side]) << at(slot));
                lists[index].push(Laid { class: self.classes[usize::from(class)], shown: word });
            }
        }
        let open = (0..slots.len()).filter(|&slot| slots[slot].is_some()).collect();
        Stage { reads, bits, cleared, lists, awaited: *awaited, open }
    }

    /// Whether what is shown fits into a word.
    pub(super) fn fits(&self) -> bool {
        self.slots * self.bits <= super::MOST_BITS
    }

    /// The squares not used, of those that look the same the first ones.
    pub(super) fn complement(&self, used: u64) -> u64 {
        let left = |&class: &u64| {
            let left = (class & !used).count_ones();
            // The lowest bits of the class.
            bits_of(class).take(left as usize).fold(0, |set, bit| set | 1 << bit)
        };
        self.classes.iter().map(left).fold(0, |all, class| all | class)
    }
}

impl Stage {
    /// The tiles that fit, by the colors shown to this cell.
    #[inline(always)]
    pub(super) fn list(&self, shown: u64) -> &[Laid] {
        let field = (1u64 << self.bits) - 1;
        let reads = self.reads.iter().enumerate();
        let index = reads.fold(0, |index, (i, &slot)| {
            index | (shown >> (slot * self.bits) & field) << (i * self.bits)
        });
        &self.lists[index as usize]
    }

    /// What is shown after this tile.
    #[inline(always)]
    pub(super) fn after(&self, shown: u64, laid: &Laid) -> u64 {
        shown & !self.cleared | laid.shown
    }
}

fn bits_of(mut set: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        (set != 0).then(|| {
            let bit = set.trailing_zeros() as usize;
            set &= set - 1;
            bit
        })
    })
}

/// By byte of a set of squares and its value: how many sides of each color they have.
fn sides_by_byte(tiles: &[([u8; 4], u16)], classes: &[u64]) -> Vec<[u128; 256]> {
    let mut by_bit = [0u128; super::MOST_TILES];
    for (shown, class) in tiles {
        for bit in bits_of(classes[usize::from(*class)]) {
            by_bit[bit] = shown.iter().map(|&color| lane(color)).sum();
        }
    }
    let sum = |byte: usize, value: usize| {
        bits_of(value as u64).map(|bit| by_bit[8 * byte + bit]).sum::<u128>()
    };
    let used = classes.iter().fold(0, |all, class| all | class);
    let bytes = (u64::BITS - used.leading_zeros()).div_ceil(8) as usize;
    (0..bytes).map(|byte| std::array::from_fn(|value| sum(byte, value))).collect()
}

/// By class of squares its bits.
fn sets(squares: &[u16]) -> Vec<u64> {
    let mut next = 0;
    let mut set = |&squares: &u16| {
        let bits = next..next + u32::from(squares);
        next = bits.end;
        bits.filter(|&bit| bit < u64::BITS).fold(0, |set, bit| set | 1 << bit)
    };
    squares.iter().map(&mut set).collect()
}
