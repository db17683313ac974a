//! The largest flow through a grid, and with it the cheapest cut.
//!
//! Nodes are the cells of a rectangle; arcs lead to the four neighbors, from the source and to
//! the sink. The method is that of Boykov and Kolmogorov (2004): a tree grows from either end
//! until they touch, the path between them is filled, and branches that lost their arc look for
//! another parent. All is kept in plain arrays, with a rim of empty cells around the grid, so that
//! no neighbor needs a test.
//!
//! Certificate: flow never exceeds a cut, so a cut of the size of the flow is the cheapest one and
//! the flow the largest. [`Grid::solve`] adds up its cut from the capacities it was given, and
//! compares.

use std::collections::VecDeque;

/// Directions: east, south, west, north. The opposite is two further.
const BACK: [usize; 4] = [2, 3, 0, 1];

/// No parent: the node is in no tree.
const NONE: u8 = 255;
/// The parent is the source or the sink.
const ROOT: u8 = 254;
/// The parent was lost.
const ORPHAN: u8 = 253;

/// A grid with capacities.
#[derive(Debug, Clone)]
pub struct Grid {
    stride: usize,
    step: [isize; 4],
    /// What each arc can still carry, by direction.
    left: [Vec<i32>; 4],
    /// What can still come from the source, or, below 0, go to the sink.
    ends: Vec<i32>,
    /// What goes straight from the source to the sink.
    flow: i64,
}

/// A cheapest cut.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cut {
    /// What it costs, which is the largest flow.
    pub value: i64,
    /// For each cell, row by row, whether it is cut off from the source.
    pub sink: Vec<bool>,
}

impl Grid {
    /// A grid without arcs.
    pub fn new(width: usize, height: usize) -> Self {
        let stride = width + 2;
        let nodes = stride * (height + 2);
        let step = [1, stride as isize, -1, -(stride as isize)];
        let left = std::array::from_fn(|_| vec![0; nodes]);
        Self { stride, step, left, ends: vec![0; nodes], flow: 0 }
    }

    fn node(&self, x: usize, y: usize) -> usize {
        (y + 1) * self.stride + x + 1
    }

    /// An arc from the source and one to the sink. At most once a cell.
    pub fn join_ends(&mut self, x: usize, y: usize, source: i32, sink: i32) {
        let node = self.node(x, y);
        self.flow += i64::from(source.min(sink));
        self.ends[node] = source - sink;
    }

    /// Arcs to the eastern neighbor and back.
    pub fn join_east(&mut self, x: usize, y: usize, there: i32, back: i32) {
        let node = self.node(x, y);
        self.left[0][node] += there;
        self.left[2][node + 1] += back;
    }

    /// Arcs to the southern neighbor and back.
    pub fn join_south(&mut self, x: usize, y: usize, there: i32, back: i32) {
        let node = self.node(x, y);
        self.left[1][node] += there;
        self.left[3][node + self.stride] += back;
    }

    /// The cheapest cut; of several the one nearest to the source.
    pub fn solve(self) -> Cut {
        let given = cfg!(debug_assertions).then(|| self.clone());
        let (stride, straight) = (self.stride, self.flow);
        let mut forest = Forest::new(self);
        forest.run();
        let width = stride - 2;
        let rows = forest.parent.len() / stride - 2;
        let is_sink = |node: usize| forest.parent[node] == NONE || forest.in_sink[node];
        let cells = (0..width * rows).map(|at| (at / width + 1) * stride + at % width + 1);
        let cut = Cut { value: forest.grid.flow, sink: cells.map(is_sink).collect() };
        if let Some(given) = given {
            debug_assert_eq!(given.cost(&cut.sink) + straight, cut.value, "cut and flow differ");
        }
        cut
    }

    /// What a cut costs, but for what goes straight through.
    fn cost(&self, sink: &[bool]) -> i64 {
        let width = self.stride - 2;
        let mut cost = 0;
        for (at, &is_sink) in sink.iter().enumerate() {
            let (x, y) = (at % width, at / width);
            let node = self.node(x, y);
            let end = self.ends[node];
            cost += i64::from(if is_sink { end.max(0) } else { (-end).max(0) });
            if x + 1 < width && sink[at + 1] != is_sink {
                let arc = if is_sink { self.left[2][node + 1] } else { self.left[0][node] };
                cost += i64::from(arc);
            }
            if at + width < sink.len() && sink[at + width] != is_sink {
                let below = node + self.stride;
                let arc = if is_sink { self.left[3][below] } else { self.left[1][node] };
                cost += i64::from(arc);
            }
        }
        cost
    }
}

/// The two trees as they grow.
struct Forest {
    grid: Grid,
    /// The direction of the parent, or [`NONE`], [`ROOT`], [`ORPHAN`].
    parent: Vec<u8>,
    in_sink: Vec<bool>,
    /// Steps to the root, as of the time below.
    distance: Vec<u32>,
    time: Vec<u32>,
    now: u32,
    active: VecDeque<usize>,
    waits: Vec<bool>,
    orphans: VecDeque<usize>,
}

impl Forest {
    fn new(grid: Grid) -> Self {
        let nodes = grid.ends.len();
        let mut forest = Self {
            parent: vec![NONE; nodes],
            in_sink: vec![false; nodes],
            distance: vec![0; nodes],
            time: vec![0; nodes],
            now: 0,
            active: VecDeque::new(),
            waits: vec![false; nodes],
            orphans: VecDeque::new(),
            grid,
        };
        for node in 0..nodes {
            let end = forest.grid.ends[node];
            if end != 0 {
                forest.in_sink[node] = end < 0;
                forest.parent[node] = ROOT;
                forest.distance[node] = 1;
                forest.wake(node);
            }
        }
        forest
    }

    fn wake(&mut self, node: usize) {
        if !self.waits[node] {
            self.waits[node] = true;
            self.active.push_back(node);
        }
    }

    fn to(&self, node: usize, direction: usize) -> usize {
        node.wrapping_add_signed(self.grid.step[direction])
    }

    /// What can flow between a node and its neighbor, away from the source or toward the sink.
    fn room(&self, node: usize, direction: usize) -> i32 {
        if self.in_sink[node] {
            self.grid.left[BACK[direction]][self.to(node, direction)]
        } else {
            self.grid.left[direction][node]
        }
    }

    fn run(&mut self) {
        while let Some(&node) = self.active.front() {
            if self.parent[node] == NONE {
                self.active.pop_front();
                self.waits[node] = false;
                continue;
            }
            match self.grow(node) {
                Some(direction) => {
                    self.now += 1;
                    self.fill(node, direction);
                    self.adopt();
                }
                None => {
                    self.active.pop_front();
                    self.waits[node] = false;
                }
            }
        }
    }

    /// Takes in free neighbors; gives the direction of one in the other tree, if there is one.
    fn grow(&mut self, node: usize) -> Option<usize> {
        for direction in 0..4 {
            if self.room(node, direction) == 0 {
                continue;
            }
            let next = self.to(node, direction);
            if self.parent[next] == NONE {
                self.in_sink[next] = self.in_sink[node];
                self.hang(next, node, direction);
                self.wake(next);
            } else if self.in_sink[next] != self.in_sink[node] {
                return Some(direction);
            } else if self.time[next] <= self.time[node]
                && self.distance[next] > self.distance[node] + 1
            {
                // A shorter way to the root.
                self.hang(next, node, direction);
            }
        }
        None
    }

    fn hang(&mut self, child: usize, parent: usize, direction: usize) {
        self.parent[child] = BACK[direction] as u8;
        self.time[child] = self.time[parent];
        self.distance[child] = self.distance[parent] + 1;
    }

    /// Fills the path through an arc between the trees.
    fn fill(&mut self, node: usize, direction: usize) {
        let (mut from, mut to, mut along) = (node, self.to(node, direction), direction);
        if self.in_sink[node] {
            (from, to, along) = (to, from, BACK[direction]);
        }
        let mut amount = self.grid.left[along][from];
        for mut at in [from, to] {
            while let Some(up) = self.up(at) {
                let parent = self.to(at, up);
                amount = amount.min(match self.in_sink[at] {
                    true => self.grid.left[up][at],
                    false => self.grid.left[BACK[up]][parent],
                });
                at = parent;
            }
            amount = amount.min(self.grid.ends[at].abs());
        }
        self.grid.left[along][from] -= amount;
        self.grid.left[BACK[along]][to] += amount;
        for mut at in [from, to] {
            while let Some(up) = self.up(at) {
                let parent = self.to(at, up);
                // The arc as the flow goes: down to the node, or up from it.
                let (tail, way, head) = match self.in_sink[at] {
                    true => (at, up, parent),
                    false => (parent, BACK[up], at),
                };
                self.grid.left[way][tail] -= amount;
                self.grid.left[BACK[way]][head] += amount;
                if self.grid.left[way][tail] == 0 {
                    self.lose(at);
                }
                at = parent;
            }
            self.grid.ends[at] -= if self.in_sink[at] { -amount } else { amount };
            if self.grid.ends[at] == 0 {
                self.lose(at);
            }
        }
        self.grid.flow += i64::from(amount);
    }

    fn up(&self, node: usize) -> Option<usize> {
        (self.parent[node] < 4).then_some(usize::from(self.parent[node]))
    }

    fn lose(&mut self, node: usize) {
        self.parent[node] = ORPHAN;
        self.orphans.push_front(node);
    }

    /// Finds new parents for nodes that lost theirs, or frees them.
    fn adopt(&mut self) {
        while let Some(node) = self.orphans.pop_front() {
            let mut best: Option<(u32, usize)> = None;
            for (direction, back) in BACK.into_iter().enumerate() {
                let next = self.to(node, direction);
                // Room on the way from the root to the node.
                let room = match self.in_sink[node] {
                    true => self.grid.left[direction][node],
                    false => self.grid.left[back][next],
                };
                if room == 0
                    || self.parent[next] >= ORPHAN && self.parent[next] != ROOT
                    || self.in_sink[next] != self.in_sink[node]
                {
                    continue;
                }
                if let Some(distance) = self.root_distance(next)
                    && best.is_none_or(|(known, _)| distance < known)
                {
                    best = Some((distance, direction));
                }
            }
            match best {
                Some((distance, direction)) => {
                    self.parent[node] = direction as u8;
                    self.time[node] = self.now;
                    self.distance[node] = distance + 1;
                }
                None => self.free(node),
            }
        }
    }

    /// Steps from a node to its root, if it has one; remembers them along the way.
    fn root_distance(&mut self, node: usize) -> Option<u32> {
        let (mut at, mut steps) = (node, 0);
        let distance = loop {
            if self.time[at] == self.now && self.parent[at] != ORPHAN {
                break steps + self.distance[at];
            }
            match self.parent[at] {
                ROOT => {
                    self.time[at] = self.now;
                    self.distance[at] = 1;
                    break steps + 1;
                }
                ORPHAN | NONE => return None,
                up => at = self.to(at, usize::from(up)),
            }
            steps += 1;
        };
        let (mut at, mut left) = (node, distance);
        while self.time[at] != self.now {
            self.time[at] = self.now;
            self.distance[at] = left;
            left -= 1;
            match self.up(at) {
                Some(up) => at = self.to(at, up),
                None => break,
            }
        }
        Some(distance)
    }

    /// A node without parent leaves its tree; its children look for others.
    fn free(&mut self, node: usize) {
        for (direction, back) in BACK.into_iter().enumerate() {
            let next = self.to(node, direction);
            if self.parent[next] == NONE || self.in_sink[next] != self.in_sink[node] {
                continue;
            }
            let room = match self.in_sink[node] {
                true => self.grid.left[direction][node],
                false => self.grid.left[back][next],
            };
            // It may take the node in again, also if it is an orphan that is adopted yet.
            if room > 0 {
                self.wake(next);
            }
            if self.parent[next] == back as u8 {
                self.lose_last(next);
            }
        }
        self.parent[node] = NONE;
    }

    fn lose_last(&mut self, node: usize) {
        self.parent[node] = ORPHAN;
        self.orphans.push_back(node);
    }
}
