//! Batches: many subtrees at once, level by level.
//!
//! A walk goes down and up one node at a time, and at every node a branch decides which way:
//! nothing predicts that branch, and each time it costs as much as the work of the node. But
//! how many nodes lie below some others, and how many are solutions, does not depend on the
//! order in which they are visited. So nodes of the same level are put on a *pile*, and a
//! [`Kernel`] makes the children of a whole *handful* in one loop without such branches; the
//! children go on the pile of the next level.
//!
//! The deepest pile with a full handful comes first, so that no pile grows beyond what one
//! handful adds; when there is none, the shallowest, so that what it gives fills the others up.
//!
//! Everything else about a tree (order, budgets, paths) is the matter of the walk; see
//! `bulk`.

/// Nodes expanded at once.
pub const HANDFUL: usize = 64;

/// The children of nodes, all of one level.
pub trait Kernel {
    /// What is known at a node: all it takes to make its children.
    type Node: Copy + Default + Send + Sync;

    /// The most children that a node has.
    fn most(&self) -> usize;

    /// Makes the children of nodes at `level`, no more than a handful; gives their number.
    ///
    /// There is room for as many as there may be. What is beyond those made means nothing.
    fn expand(&mut self, level: usize, nodes: &[Self::Node], children: &mut [Self::Node]) -> usize;
}

/// How a batch may go on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bounds {
    /// The number of choices that make a solution.
    pub levels: usize,
    /// It visits no more nodes than this.
    pub budget: u64,
    /// Whether there may be solutions.
    pub solutions: bool,
}

/// What was visited.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Visited {
    /// Nodes.
    pub nodes: u64,
    /// Solutions among them.
    pub solutions: u64,
    /// The largest number of choices made at once; 0 without nodes.
    pub deepest: usize,
}

/// Nodes of one level.
#[derive(Debug, Clone, Default)]
struct Pile<T> {
    nodes: Vec<T>,
    count: usize,
}

/// Nodes waiting to be expanded.
#[derive(Debug)]
pub struct Batch<K: Kernel> {
    kernel: K,
    /// By level.
    piles: Vec<Pile<K::Node>>,
}

/// A copy waits for nodes of its own.
impl<K: Kernel + Clone> Clone for Batch<K> {
    fn clone(&self) -> Self {
        Self::new(self.kernel.clone(), self.piles.len() - 1)
    }
}

impl<K: Kernel> Batch<K> {
    /// Nothing waits, in a tree of so many levels.
    pub fn new(kernel: K, levels: usize) -> Self {
        Self { kernel, piles: vec![Pile { nodes: Vec::new(), count: 0 }; levels + 1] }
    }

    /// The kernel.
    pub fn kernel(&self) -> &K {
        &self.kernel
    }

    /// Adds a node; at most a handful between two times that all are expanded.
    pub fn add(&mut self, level: usize, node: K::Node) {
        let room = self.room();
        let pile = &mut self.piles[level];
        pile.make(room);
        pile.nodes[pile.count] = node;
        pile.count += 1;
    }

    /// What a pile must hold.
    fn room(&self) -> usize {
        HANDFUL * (self.kernel.most() + 1)
    }

    /// Visits all nodes below those added, and forgets them.
    ///
    /// # Errors
    /// When these are more than the budget, or a solution is among them and may not be: how many
    /// were visited in vain.
    pub fn expand(&mut self, bounds: Bounds) -> Result<Visited, u64> {
        let visited = self.visit(bounds);
        if visited.is_err() {
            self.piles.iter_mut().for_each(|pile| pile.count = 0);
        }
        visited
    }

    fn visit(&mut self, Bounds { levels, budget, solutions }: Bounds) -> Result<Visited, u64> {
        let room = self.room();
        let mut visited = Visited::default();
        let mut top = 0;
        let mut level = levels - 1;
        loop {
            while level > top && self.piles[level].count < HANDFUL {
                level -= 1;
            }
            if self.piles[level].count < HANDFUL {
                top += self.piles[top..levels].iter().take_while(|pile| pile.count == 0).count();
                if top == levels {
                    return Ok(visited);
                }
                level = top;
            }
            let made = match self.piles.get_disjoint_mut([level, level + 1]) {
                Ok([pile, next]) => {
                    next.make(room);
                    let nodes = pile.take();
                    let made = self.kernel.expand(level, nodes, &mut next.nodes[next.count..]);
                    next.count += made;
                    made
                }
                // Below the last level nothing is expanded, so its children need no pile.
                Err(_) => 0,
            };
            visited.nodes += made as u64;
            if visited.nodes > budget {
                return Err(visited.nodes);
            }
            if made > 0 {
                visited.deepest = visited.deepest.max(level + 1);
            }
            if level + 1 < levels {
                level += 1;
                continue;
            }
            self.piles[levels].count = 0;
            visited.solutions += made as u64;
            if made > 0 && !solutions {
                return Err(visited.nodes);
            }
        }
    }
}

impl<T: Copy + Default> Pile<T> {
    fn make(&mut self, room: usize) {
        if self.nodes.is_empty() {
            self.nodes.resize(room, T::default());
        }
    }

    /// The last handful.
    fn take(&mut self) -> &[T] {
        let end = self.count;
        self.count = end.saturating_sub(HANDFUL);
        &self.nodes[self.count..end]
    }
}
