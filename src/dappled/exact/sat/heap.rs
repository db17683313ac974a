//! The variable that took part in most conflicts lately: a binary heap in which entries move.
//!
//! Invariant: `place[v]` is where `v` lies in `heap`, or [`OUT`]; nobody is busier than its parent.
//! Of equally busy variables the one that was put in first tends to come first.

/// Not in the heap.
const OUT: u32 = u32::MAX;

/// Variables by how busy they are.
#[derive(Debug, Clone)]
pub(super) struct Heap {
    heap: Vec<u32>,
    place: Vec<u32>,
    busy: Vec<f64>,
    step: f64,
}

impl Heap {
    /// All variables, equally busy.
    pub(super) fn new(variables: usize) -> Self {
        let all: Vec<u32> = (0..variables as u32).collect();
        Self { heap: all.clone(), place: all, busy: vec![0.0; variables], step: 1.0 }
    }

    /// One more variable.
    pub(super) fn grow(&mut self) {
        let variable = self.place.len() as u32;
        self.place.push(OUT);
        self.busy.push(0.0);
        self.insert(variable);
    }

    /// Puts a variable in, if it is not.
    pub(super) fn insert(&mut self, variable: u32) {
        if self.place[variable as usize] == OUT {
            self.place[variable as usize] = self.heap.len() as u32;
            self.heap.push(variable);
            self.up(self.heap.len() - 1);
        }
    }

    /// Takes out the busiest.
    pub(super) fn pop(&mut self) -> Option<u32> {
        let first = *self.heap.first()?;
        let last = self.heap.pop()?;
        self.place[first as usize] = OUT;
        if last != first {
            self.heap[0] = last;
            self.place[last as usize] = 0;
            self.down(0);
        }
        Some(first)
    }

    /// A variable took part in a conflict.
    pub(super) fn bump(&mut self, variable: u32) {
        let busy = &mut self.busy[variable as usize];
        *busy += self.step;
        if *busy > 1e100 {
            self.busy.iter_mut().for_each(|busy| *busy *= 1e-100);
            self.step *= 1e-100;
        }
        if self.place[variable as usize] != OUT {
            self.up(self.place[variable as usize] as usize);
        }
    }

    /// What comes later counts more.
    pub(super) fn decay(&mut self) {
        self.step /= 0.95;
    }

    fn up(&mut self, mut at: usize) {
        let variable = self.heap[at];
        while at > 0 {
            let parent = (at - 1) / 2;
            let above = self.heap[parent];
            if self.busy[above as usize] >= self.busy[variable as usize] {
                break;
            }
            self.put(at, above);
            at = parent;
        }
        self.put(at, variable);
    }

    fn down(&mut self, mut at: usize) {
        let variable = self.heap[at];
        loop {
            let child = 2 * at + 1;
            let Some(&left) = self.heap.get(child) else { break };
            let mut best = (child, left);
            if let Some(&right) = self.heap.get(child + 1)
                && self.busy[right as usize] > self.busy[left as usize]
            {
                best = (child + 1, right);
            }
            if self.busy[best.1 as usize] <= self.busy[variable as usize] {
                break;
            }
            self.put(at, best.1);
            at = best.0;
        }
        self.put(at, variable);
    }

    fn put(&mut self, at: usize, variable: u32) {
        self.heap[at] = variable;
        self.place[variable as usize] = at as u32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_busiest_comes_first() {
        let mut heap = Heap::new(9);
        for (variable, times) in [(3, 5), (7, 2), (1, 9), (8, 1)] {
            (0..times).for_each(|_| heap.bump(variable));
        }
        let first: Vec<u32> = (0..4).filter_map(|_| heap.pop()).collect();
        assert_eq!(first, [1, 3, 7, 8]);
        heap.insert(3);
        heap.insert(3);
        assert_eq!(heap.pop(), Some(3));
        let rest: Vec<u32> = std::iter::from_fn(|| heap.pop()).collect();
        assert_eq!(rest.len(), 5);
    }
}
