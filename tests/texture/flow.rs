//! Largest flows in grids against shortest augmenting paths (Edmonds and Karp) on a matrix.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::collections::VecDeque;
use tilepack::texture::flow::Grid;

/// The largest flow of a graph given by its capacities.
fn largest_flow(mut left: Vec<Vec<i64>>, source: usize, sink: usize) -> i64 {
    let mut flow = 0;
    loop {
        let mut from = vec![usize::MAX; left.len()];
        from[source] = source;
        let mut next = VecDeque::from([source]);
        while let Some(node) = next.pop_front() {
            for to in 0..left.len() {
                if left[node][to] > 0 && from[to] == usize::MAX {
                    from[to] = node;
                    next.push_back(to);
                }
            }
        }
        if from[sink] == usize::MAX {
            return flow;
        }
        let path = std::iter::successors(Some(sink), |&at| (at != source).then(|| from[at]));
        let path: Vec<usize> = path.collect();
        let amount = path.windows(2).map(|arc| left[arc[1]][arc[0]]).min().unwrap();
        for arc in path.windows(2) {
            left[arc[1]][arc[0]] -= amount;
            left[arc[0]][arc[1]] += amount;
        }
        flow += amount;
    }
}

/// What a cut costs.
fn cost(capacities: &[Vec<i64>], cut_off: &dyn Fn(usize) -> bool) -> i64 {
    let nodes = 0..capacities.len();
    let arcs = nodes.clone().flat_map(|a| nodes.clone().map(move |b| (a, b)));
    arcs.filter(|&(a, b)| !cut_off(a) && cut_off(b)).map(|(a, b)| capacities[a][b]).sum()
}

#[test]
fn flow_is_that_of_another_algorithm_and_the_cut_costs_as_much() {
    let mut random = Pcg64::seed_from_u64(1);
    for round in 0..1500 {
        let (width, height) = (random.random_range(1..8usize), random.random_range(1..7usize));
        let cells = width * height;
        let (source, sink) = (cells, cells + 1);
        let mut capacities = vec![vec![0i64; cells + 2]; cells + 2];
        let mut grid = Grid::new(width, height);
        // Small capacities make ties and empty arcs, large ones long paths.
        let most = [1, 3, 1000][round % 3];
        let dense = random.random_range(0.2..1.0);
        let mut capacity = || match random.random_bool(dense) {
            true => random.random_range(0..=most),
            false => 0,
        };
        for cell in 0..cells {
            let (x, y) = (cell % width, cell / width);
            let ends = [capacity(), capacity()];
            grid.join_ends(x, y, ends[0], ends[1]);
            capacities[source][cell] = ends[0].into();
            capacities[cell][sink] = ends[1].into();
            for (east, there, step) in [(true, x + 1 < width, 1), (false, y + 1 < height, width)] {
                if !there {
                    continue;
                }
                let arcs = [capacity(), capacity()];
                match east {
                    true => grid.join_east(x, y, arcs[0], arcs[1]),
                    false => grid.join_south(x, y, arcs[0], arcs[1]),
                }
                capacities[cell][cell + step] += i64::from(arcs[0]);
                capacities[cell + step][cell] += i64::from(arcs[1]);
            }
        }
        let cut = grid.solve();
        assert_eq!(cut.value, largest_flow(capacities.clone(), source, sink), "round {round}");
        let cut_off = |node: usize| if node < cells { cut.sink[node] } else { node == sink };
        assert_eq!(cost(&capacities, &cut_off), cut.value, "round {round}");
    }
}

#[test]
fn a_large_grid_is_cut_where_it_is_weak() {
    // Arcs of 5 everywhere but along a wandering line, where they are 1.
    let (width, height) = (90, 70);
    let line = |y: usize| 40 + (y * 7 % 23) / 4;
    let mut grid = Grid::new(width, height);
    let mut weak = 0;
    for y in 0..height {
        for x in 0..width {
            let (source, sink) =
                (if x == 0 { 100 } else { 0 }, if x == width - 1 { 100 } else { 0 });
            grid.join_ends(x, y, source, sink);
            if x + 1 < width {
                let arc = if x == line(y) { 1 } else { 5 };
                grid.join_east(x, y, arc, arc);
                weak += i64::from(arc == 1);
            }
            if y + 1 < height {
                let crossed =
                    (line(y).min(line(y + 1)) + 1..=line(y).max(line(y + 1))).contains(&x);
                let arc = if crossed { 1 } else { 5 };
                grid.join_south(x, y, arc, arc);
                weak += i64::from(arc == 1);
            }
        }
    }
    let cut = grid.solve();
    assert!(cut.value >= height as i64 && cut.value <= weak, "{} {weak}", cut.value);
    let first = (0..height).map(|y| (0..width).position(|x| cut.sink[y * width + x]).unwrap());
    assert!(first.enumerate().all(|(y, x)| x.abs_diff(line(y) + 1) <= 6));
}
