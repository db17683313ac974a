//! Packings of tiny problems, found by trying every array of labels and reading the definition.

use std::collections::{BTreeMap, BTreeSet};
use tilepack::symmetry::{Anchor, Automorphism, Group};
use tilepack::tiles::{Color, Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::{Lattice, Shape};

/// A tile set on a torus.
#[derive(Clone, Debug)]
pub(crate) struct Problem {
    pub(crate) set: TileSet,
    pub(crate) shape: Shape,
}

pub(crate) fn problem(
    kind: Kind,
    (ch, cv): (u64, u64),
    members: Members,
    size: (u64, u64),
) -> Problem {
    let set = TileSet::new(kind, Colors::pair(ch, cv).unwrap(), members).unwrap();
    Problem { set, shape: Shape::new(size.0, size.1).unwrap() }
}

pub(crate) fn pairs(pairs: &[(u8, u8)]) -> Members {
    Members::Pruned(pairs.iter().map(|&(a, b)| (Color(a), Color(b))).collect())
}

impl Problem {
    pub(crate) fn lattice(&self) -> Lattice {
        Lattice { kind: self.set.kind(), shape: self.shape }
    }

    /// How many colors each label has.
    pub(crate) fn radices(&self) -> Vec<u8> {
        let colors = self.set.colors();
        let [h, v] = [colors.horizontal() as u8, colors.vertical() as u8];
        match self.set.kind() {
            Kind::Wang => [h, v].repeat(self.shape.cells()),
            _ => vec![v; self.shape.cells()],
        }
    }

    /// The sides of the tile in a cell, from the definition.
    pub(crate) fn sides(&self, labels: &[u8], row: usize, column: usize) -> [u8; 4] {
        let (w, h) = (self.shape.width(), self.shape.height());
        let at = |r: usize, c: usize| (row + r) % h * w + (column + c) % w;
        match self.set.kind() {
            Kind::Corner => [at(0, 1), at(1, 1), at(1, 0), at(0, 0)].map(|i| labels[i]),
            Kind::Wang => {
                [2 * at(0, 0), 2 * at(0, 1) + 1, 2 * at(1, 0), 2 * at(0, 0) + 1].map(|i| labels[i])
            }
            Kind::Domino => {
                let next = if h > 1 { at(1, 0) } else { at(0, 1) };
                [labels[at(0, 0)], labels[next], 0, 0]
            }
        }
    }

    pub(crate) fn tiles(&self, labels: &[u8]) -> Vec<TileId> {
        let (w, h) = (self.shape.width(), self.shape.height());
        let kind = self.set.kind();
        let pack =
            |sides: [u8; 4]| kind.pack(&sides[..kind.sides().len()], self.set.colors()).unwrap();
        (0..h * w).map(|i| pack(self.sides(labels, i / w, i % w))).collect()
    }

    pub(crate) fn is_packing(&self, labels: &[u8]) -> bool {
        let mut tiles = self.tiles(labels);
        tiles.sort_unstable();
        if tiles.len() as u64 != self.set.size() || tiles.windows(2).any(|pair| pair[0] == pair[1])
        {
            return false;
        }
        match self.set.members() {
            Members::Complete => true,
            Members::Explicit(list) => tiles == *list,
            Members::Pruned(pairs) => tiles.iter().all(|&tile| {
                let sides = self.set.kind().unpack(tile, self.set.colors());
                let sides = &sides[..self.set.kind().sides().len()];
                pairs.iter().all(|(a, b)| !sides.contains(&a.0) || !sides.contains(&b.0))
            }),
            // All tiles are different, and as many as two for each class.
            Members::Compact => self.class_counts(labels).iter().all(|&count| count == (2, 2)),
        }
    }

    /// For every class of a compact set that occurs, how many tiles and how many different ones
    /// are in it, sorted.
    pub(crate) fn class_counts(&self, labels: &[u8]) -> Vec<(usize, usize)> {
        let mut classes = BTreeMap::<_, Vec<_>>::new();
        for tile in self.tiles(labels) {
            let sides = self.set.kind().unpack(tile, self.set.colors());
            let class = match self.set.kind() {
                Kind::Corner => [sides[3], sides[2], sides[1]],
                _ => [sides[0], sides[3], 0],
            };
            classes.entry(class).or_default().push(tile);
        }
        let different = |tiles: &Vec<TileId>| tiles.iter().collect::<BTreeSet<_>>().len();
        let mut counts: Vec<_> = classes.values().map(|t| (t.len(), different(t))).collect();
        counts.sort_unstable();
        counts
    }

    /// Whether every tile of the set occurs and no other does.
    pub(crate) fn is_covering(&self, labels: &[u8]) -> bool {
        let tiles: BTreeSet<_> = self.tiles(labels).into_iter().collect();
        tiles.into_iter().eq(self.set.allowed())
    }

    /// All packings.
    pub(crate) fn packings(&self) -> Vec<Vec<u8>> {
        self.arrays(|labels| self.is_packing(labels))
    }

    /// All arrays of labels that are as they should be, by trying every one.
    pub(crate) fn arrays(&self, is_wanted: impl Fn(&[u8]) -> bool) -> Vec<Vec<u8>> {
        let radices = self.radices();
        let mut found = Vec::new();
        let mut labels = vec![0; radices.len()];
        loop {
            if is_wanted(&labels) {
                found.push(labels.clone());
            }
            let Some(i) = (0..labels.len()).rev().find(|&i| labels[i] + 1 < radices[i]) else {
                return found;
            };
            labels[i] += 1;
            labels[i + 1..].fill(0);
        }
    }

    pub(crate) fn group(&self) -> Group {
        Group::of(&self.set, self.shape, None).unwrap()
    }

    pub(crate) fn automorphism(&self, text: &str) -> Automorphism {
        let automorphism = Automorphism::parse(text, self.set.colors(), self.shape).unwrap();
        automorphism.check(&self.set, self.shape, false).unwrap();
        automorphism
    }

    /// Whether `a[row + dy][col + dx] = map(a[row][col])` for all labels.
    pub(crate) fn has(&self, labels: &[u8], automorphism: &Automorphism) -> bool {
        let (w, h) = (self.shape.width(), self.shape.height());
        let per_cell = labels.len() / (w * h);
        (0..labels.len()).all(|i| {
            let (row, column, k) = (i / per_cell / w, i / per_cell % w, i % per_cell);
            let (dx, dy) = (automorphism.dx as usize, automorphism.dy as usize);
            let there = ((row + dy) % h * w + (column + dx) % w) * per_cell + k;
            let map = if self.set.kind() == Kind::Wang && k == 0 {
                automorphism.map.horizontal()
            } else {
                automorphism.map.vertical()
            };
            labels[there] == map[usize::from(labels[i])]
        })
    }

    pub(crate) fn has_anchor(&self, labels: &[u8], anchor: Anchor) -> bool {
        let sides = self.sides(labels, 0, 0);
        match (anchor, self.set.kind()) {
            (Anchor::Everywhere, _) => true,
            (Anchor::Tile(tile), _) => self.tiles(labels)[0] == tile,
            (Anchor::Class, Kind::Corner) => sides[1..] == [0, 0, 0],
            (Anchor::Class, _) => (sides[0], sides[3]) == (0, 0),
        }
    }

    /// The anchors under which every packing has a translate.
    pub(crate) fn anchors(&self) -> Vec<Anchor> {
        if self.set.is_compact() {
            return vec![Anchor::Everywhere, Anchor::Class];
        }
        let tiles: Vec<_> = self.set.allowed().collect();
        let some = [0, tiles.len() / 2, tiles.len() - 1].map(|i| Anchor::Tile(tiles[i]));
        [vec![Anchor::Everywhere], some.to_vec()].concat()
    }
}
