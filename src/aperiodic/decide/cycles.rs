//! Which arcs of a directed graph lie on a cycle: those whose ends are in one strongly connected
//! component.
//!
//! A walk that goes on for ever in both directions passes from one component to another only
//! finitely often. Source: Tarjan, *Depth-first search and linear graph algorithms*, 1972; here
//! without recursion, for a graph may be a path of a million vertices.

/// For every vertex the number of its strongly connected component.
pub fn components(vertices: usize, arcs: &[(u32, u32)]) -> Vec<u32> {
    const NONE: u32 = u32::MAX;
    let mut start = vec![0usize; vertices + 1];
    for &(from, _) in arcs {
        start[from as usize + 1] += 1;
    }
    for v in 0..vertices {
        start[v + 1] += start[v];
    }
    let mut heads = vec![0u32; arcs.len()];
    let mut next = start.clone();
    for &(from, to) in arcs {
        heads[next[from as usize]] = to;
        next[from as usize] += 1;
    }
    next.copy_from_slice(&start);
    let mut component = vec![NONE; vertices];
    let (mut found, mut low) = (vec![NONE; vertices], vec![0u32; vertices]);
    let (mut open, mut path) = (Vec::new(), Vec::new());
    let (mut time, mut count) = (0, 0);
    for root in 0..vertices as u32 {
        if found[root as usize] != NONE {
            continue;
        }
        path.push(root);
        while let Some(&vertex) = path.last() {
            let v = vertex as usize;
            if found[v] == NONE {
                (found[v], low[v]) = (time, time);
                time += 1;
                open.push(vertex);
            }
            if next[v] < start[v + 1] {
                let w = heads[next[v]] as usize;
                next[v] += 1;
                if found[w] == NONE {
                    path.push(w as u32);
                } else if component[w] == NONE {
                    low[v] = low[v].min(found[w]);
                }
                continue;
            }
            path.pop();
            if let Some(&parent) = path.last() {
                let p = parent as usize;
                low[p] = low[p].min(low[v]);
            }
            if low[v] == found[v] {
                while let Some(w) = open.pop() {
                    component[w as usize] = count;
                    if w == vertex {
                        break;
                    }
                }
                count += 1;
            }
        }
    }
    component
}

/// For every arc whether it lies on a cycle.
pub fn on_cycles(vertices: usize, arcs: &[(u32, u32)]) -> Vec<bool> {
    let component = components(vertices, arcs);
    arcs.iter().map(|&(from, to)| component[from as usize] == component[to as usize]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_cycles_and_bridges() {
        let arcs = [(0, 1), (1, 2), (2, 0), (2, 3), (3, 3), (3, 4), (4, 5), (5, 4), (0, 6)];
        let expected = [true, true, true, false, true, false, true, true, false];
        assert_eq!(on_cycles(7, &arcs), expected);
        let long: Vec<_> = (0..200_000).map(|v| (v, v + 1)).collect();
        assert!(!on_cycles(200_001, &long).contains(&true));
    }
}
