//! The answers from the definition: every array of labels is tried, prefix by prefix.
//!
//! A prefix is kept when the tiles it completes belong to the set, none occurs too often, and
//! labels agree with what is given beforehand. Only the words of the definition are used: sides,
//! tile numbers, members and classes are written out here once more.

use tilepack::packing::Task;
use tilepack::search::naive;
use tilepack::tiles::{Kind, Members};

/// What the completed tiles of a prefix use up.
#[derive(Clone)]
struct Used {
    /// How often each tile occurs.
    tiles: Vec<u8>,
    /// How many different tiles of each class of a compact set occur.
    classes: Vec<u8>,
    /// Occurrences beyond the first of a tile.
    again: usize,
}

impl Used {
    const NOTHING: Self = Self { tiles: Vec::new(), classes: Vec::new(), again: 0 };
}

struct Oracle<'a> {
    task: &'a Task,
    /// For every label the number of its colors.
    radices: Vec<u8>,
    /// For every label the tiles it completes, as the labels of their sides.
    completes: Vec<Vec<Vec<usize>>>,
    /// For every label the earlier ones that the automorphism ties it to: `(earlier, map)`,
    /// where the label must be `map[earlier]`.
    ties: Vec<Vec<(usize, Vec<u8>)>>,
    /// Cells beyond the number of tiles of the set.
    spare: usize,
    /// By length of the prefix.
    used: Vec<Used>,
}

/// All packings (or coverings) that `task` asks for, as labels, in lexicographic order.
pub(crate) fn all(task: &Task) -> Vec<Vec<u8>> {
    let mut found = Vec::new();
    visit(task, &mut |labels| found.push(labels.to_vec()));
    found
}

/// The number of packings (or coverings) that `task` asks for.
pub(crate) fn count(task: &Task) -> u64 {
    let mut found = 0;
    visit(task, &mut |_| found += 1);
    found
}

fn visit(task: &Task, found: &mut dyn FnMut(&[u8])) {
    let Some(mut oracle) = Oracle::new(task) else { return };
    let (places, colors) = (oracle.radices.len(), oracle.radices.iter().max().copied());
    naive::search(places, colors.unwrap_or(0), &mut |prefix| oracle.accepts(prefix), found);
}

/// The labels of the sides of every tile, in the order of the digits of its number.
pub(crate) fn sides(task: &Task) -> Vec<Vec<usize>> {
    let (w, h) = (task.shape.width(), task.shape.height());
    let mut all = Vec::new();
    for row in 0..h {
        for column in 0..w {
            let at = |south: usize, east: usize| (row + south) % h * w + (column + east) % w;
            let (here, east, south) = (at(0, 0), at(0, 1), at(1, 0));
            all.push(match task.set.kind() {
                Kind::Corner => vec![east, at(1, 1), south, here],
                Kind::Wang => vec![2 * here, 2 * east + 1, 2 * south, 2 * here + 1],
                Kind::Domino => vec![here, if h > 1 { south } else { east }],
            });
        }
    }
    all
}

impl<'a> Oracle<'a> {
    /// `None` when the torus has the wrong size.
    fn new(task: &'a Task) -> Option<Self> {
        let cells = task.shape.width() * task.shape.height();
        let (h, v) = (task.set.colors().horizontal(), task.set.colors().vertical());
        let palettes: &[usize] = if task.set.kind() == Kind::Wang { &[h, v] } else { &[v] };
        let radices: Vec<u8> = palettes.repeat(cells).into_iter().map(|c| c as u8).collect();
        let sides = sides(task);
        let mut completes = vec![Vec::new(); radices.len()];
        for tile in &sides {
            completes[*tile.iter().max().unwrap()].push(tile.clone());
        }
        let size = match task.set.members() {
            Members::Compact if task.set.kind() == Kind::Wang => 2 * h * v,
            Members::Compact => 2 * h * h * h,
            Members::Explicit(tiles) => tiles.len(),
            _ => {
                let radices: Vec<usize> = sides[0].iter().map(|&at| radices[at].into()).collect();
                let tiles = arrays(&radices).into_iter();
                tiles.filter(|tile| is_member(task.set.members(), tile, 0)).count()
            }
        };
        let spare = cells.checked_sub(size)?;
        if spare > 0 && !task.cover {
            return None;
        }
        let ties = ties(task, radices.len());
        let tiles = sides[0].iter().map(|&at| usize::from(radices[at])).product();
        let none = Used { tiles: vec![0; tiles], classes: vec![0; h.max(v).pow(3)], again: 0 };
        let used = vec![none; radices.len() + 1];
        Some(Self { task, radices, completes, ties, spare, used })
    }

    fn accepts(&mut self, prefix: &[u8]) -> bool {
        let place = prefix.len() - 1;
        let color = prefix[place];
        if color >= self.radices[place]
            || self.task.pins.get(place).is_some_and(|pin| pin != color)
            || self.ties[place].iter().any(|(other, map)| map[usize::from(prefix[*other])] != color)
        {
            return false;
        }
        let (before, after) = self.used.split_at_mut(place + 1);
        let (before, mut used) = (&before[place], std::mem::replace(&mut after[0], Used::NOTHING));
        used.tiles.copy_from_slice(&before.tiles);
        used.classes.copy_from_slice(&before.classes);
        used.again = before.again;
        let fits = self.completes[place].iter().all(|tile| self.place(prefix, tile, &mut used));
        self.used[place + 1] = used;
        fits
    }

    /// Whether the tile belongs to the set and may occur once more.
    fn place(&self, prefix: &[u8], sides: &[usize], used: &mut Used) -> bool {
        let mut colors = [0; 4];
        let colors = &mut colors[..sides.len()];
        let mut number = 0;
        for (color, &at) in colors.iter_mut().zip(sides) {
            *color = prefix[at];
            number = number * usize::from(self.radices[at]) + usize::from(*color);
        }
        if !is_member(self.task.set.members(), colors, number as u32) {
            return false;
        }
        let uses = &mut used.tiles[number];
        *uses += 1;
        if *uses > 1 {
            used.again += 1;
        } else if *self.task.set.members() == Members::Compact {
            let class = match self.task.set.kind() {
                // NW, SW, SE of NE, SE, SW, NW; N, W of N, E, S, W.
                Kind::Corner => [colors[3], colors[2], colors[1]],
                _ => [colors[0], colors[3], 0],
            };
            let largest = self.task.set.colors().largest();
            let class = class.iter().fold(0, |n, &color| n * largest + usize::from(color));
            let different = &mut used.classes[class];
            *different += 1;
            if *different > 2 {
                return false;
            }
        }
        used.again <= self.spare
    }
}

fn is_member(members: &Members, sides: &[u8], number: u32) -> bool {
    match members {
        Members::Complete | Members::Compact => true,
        Members::Explicit(tiles) => tiles.iter().any(|tile| tile.0 == number),
        Members::Pruned(pairs) => {
            !pairs.iter().any(|(a, b)| sides.contains(&a.0) && sides.contains(&b.0))
        }
    }
}

fn arrays(radices: &[usize]) -> Vec<Vec<u8>> {
    radices.iter().fold(vec![Vec::new()], |all, &radix| {
        let extended = |array: &Vec<u8>| -> Vec<Vec<u8>> {
            (0..radix as u8).map(|x| [&array[..], &[x]].concat()).collect()
        };
        all.iter().flat_map(extended).collect()
    })
}

/// `a[row + dy][column + dx] = map(a[row][column])`, said of the later of the two labels.
fn ties(task: &Task, labels: usize) -> Vec<Vec<(usize, Vec<u8>)>> {
    let mut ties = vec![Vec::new(); labels];
    let Some(automorphism) = &task.automorphism else { return ties };
    let (w, h) = (task.shape.width(), task.shape.height());
    let per_cell = labels / (w * h);
    for from in 0..labels {
        let (row, column, side) = (from / per_cell / w, from / per_cell % w, from % per_cell);
        let (dy, dx) = (automorphism.dy as usize, automorphism.dx as usize);
        let to = ((row + dy) % h * w + (column + dx) % w) * per_cell + side;
        let map = match (per_cell, side) {
            (2, 0) => automorphism.map.horizontal(),
            _ => automorphism.map.vertical(),
        };
        let mut inverse = vec![0; map.len()];
        for (color, &image) in map.iter().enumerate() {
            inverse[usize::from(image)] = color as u8;
        }
        if from < to {
            ties[to].push((from, map.to_vec()));
        } else {
            ties[from].push((to, inverse));
        }
    }
    ties
}
