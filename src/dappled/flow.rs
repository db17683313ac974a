//! Streams through a tiling by two tiles.
//!
//! Every row is a street, eastward if its number is even and westward if not; every column is one,
//! southward or northward. Two streams come into each cell, one by its row and one by its column.
//! Tile 0 lets them cross, straight on; tile 1 makes both turn into the other's street. So every way
//! out of a cell is used once, and streams never end but at free edges.
//!
//! Where no more than `p` tiles 0 stand in a row and `q` in a column, no stream runs straight
//! through more than so many cells. If at crossings the row lies above where row and column have
//! numbers of the same parity, and below where not, then every stream of a rectangle goes over and
//! under in turns, for turning instead of crossing keeps a drawing of knots alternating; so it does
//! where edges meet that are of even length.

use super::{Edges, FREE, Field};

/// A stream: the strands that it goes through, in order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stream {
    /// Strands: twice the cell (its index, row by row), and one more if it comes in by its column.
    pub strands: Vec<u32>,
    /// Whether the last leads to the first.
    pub closed: bool,
}

/// All streams.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Flow {
    /// Those that come in from outside first, then closed ones.
    pub streams: Vec<Stream>,
    /// Through how many cells at most a stream goes straight: in a row, in a column.
    pub straight: (usize, usize),
}

/// Whether a row leads eastward, or a column southward.
pub fn forward(street: usize) -> bool {
    street.is_multiple_of(2)
}

/// The streams of a tiling; none if it has free cells or other tiles than 0 and 1.
pub fn flow(field: &Field, edges: Edges) -> Option<Flow> {
    if field.cells().iter().any(|&tile| tile == FREE || tile > 1) {
        return None;
    }
    let strands = 2 * field.cells().len();
    let next: Vec<Option<u32>> = (0..strands).map(|strand| next(field, edges, strand)).collect();
    let mut first = vec![true; strands];
    next.iter().flatten().for_each(|&strand| first[strand as usize] = false);
    let mut seen = vec![false; strands];
    let mut streams = Vec::new();
    let begins = (0..strands).filter(|&strand| first[strand]).chain(0..strands);
    for begin in begins {
        let mut stream = Vec::new();
        let mut at = Some(begin as u32);
        while let Some(strand) = at.filter(|&strand| !seen[strand as usize]) {
            seen[strand as usize] = true;
            stream.push(strand);
            at = next[strand as usize];
        }
        if !stream.is_empty() {
            streams.push(Stream { strands: stream, closed: at.is_some() });
        }
    }
    let straight = streams.iter().map(|stream| straight(field, stream));
    let straight = straight.fold((0, 0), |a, b| (a.0.max(b.0), a.1.max(b.1)));
    Some(Flow { streams, straight })
}

/// Where a strand leads: by its own street from tile 0, by the other one from tile 1.
fn next(field: &Field, edges: Edges, strand: usize) -> Option<u32> {
    let (width, height) = (field.width(), field.height());
    let (cell, by_column) = (strand / 2, strand % 2 == 1);
    let (column, row) = (cell % width, cell / width);
    let leaves_by_column = by_column != (field.cells()[cell] == 1);
    let step = |at: usize, length: usize, forward: bool, meet: bool| match forward {
        true if at + 1 < length => Some(at + 1),
        true => meet.then_some(0),
        false if at > 0 => Some(at - 1),
        false => meet.then_some(length - 1),
    };
    let (column, row) = match leaves_by_column {
        true => (column, step(row, height, forward(column), edges == Edges::Torus)?),
        false => (step(column, width, forward(row), edges != Edges::Free)?, row),
    };
    Some(2 * (row * width + column) as u32 + u32::from(leaves_by_column))
}

/// The longest ways straight on, in a row and in a column.
fn straight(field: &Field, stream: &Stream) -> (usize, usize) {
    let strands = &stream.strands;
    let turns = |strand: u32| field.cells()[strand as usize / 2] == 1;
    // A closed stream is looked at from a turn on, if it has one.
    let from = match stream.closed {
        true => strands.iter().position(|&strand| turns(strand)).unwrap_or(0),
        false => 0,
    };
    let (mut run, mut most) = (0, [0, 0]);
    for &strand in strands[from..].iter().chain(&strands[..from]) {
        run = if turns(strand) { 0 } else { run + 1 };
        let most = &mut most[strand as usize % 2];
        *most = run.max(*most);
    }
    (most[0], most[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dappled::Rule;
    use crate::dappled::exact::{Completion, complete};

    #[test]
    fn all_strands_are_in_one_stream_and_straight_ways_are_as_short_as_the_tiling_says() {
        for (edges, size) in
            [(Edges::Free, (9, 6)), (Edges::Cylinder, (8, 5)), (Edges::Torus, (10, 8))]
        {
            for (p, q) in [(1, 1), (2, 3), (3, 2)] {
                let rule = Rule::uniform(size, 2, edges, Some(p), Some(q)).unwrap();
                let free = Field::filled(size.0, size.1, FREE).unwrap();
                let Ok(Completion::Found(field)) = complete(&rule, &free, 5, &()) else {
                    continue;
                };
                let flow = flow(&field, edges).unwrap();
                let mut all: Vec<u32> =
                    flow.streams.iter().flat_map(|stream| stream.strands.clone()).collect();
                all.sort_unstable();
                assert!(all.iter().copied().eq(0..2 * field.cells().len() as u32));
                assert!(flow.straight.0 <= p as usize && flow.straight.1 <= q as usize);
                assert!(edges != Edges::Torus || flow.streams.iter().all(|s| s.closed));
            }
        }
    }

    #[test]
    fn crossings_only_are_streets_and_turns_only_are_circles() {
        let streets = flow(&Field::filled(4, 6, 0).unwrap(), Edges::Free).unwrap();
        assert_eq!((streets.streams.len(), streets.straight), (10, (4, 6)));
        let circles = flow(&Field::filled(4, 6, 1).unwrap(), Edges::Torus).unwrap();
        assert!(circles.streams.iter().all(|s| s.closed && s.strands.len() == 4));
        assert_eq!((circles.streams.len(), circles.straight), (12, (0, 0)));
        assert_eq!(flow(&Field::filled(2, 2, 2).unwrap(), Edges::Free), None);
        assert_eq!(flow(&Field::filled(2, 2, FREE).unwrap(), Edges::Free), None);
    }

    #[test]
    fn streams_go_over_and_under_in_turns() {
        let rule = Rule::uniform((12, 10), 2, Edges::Torus, Some(3), Some(3)).unwrap();
        let free = Field::filled(12, 10, FREE).unwrap();
        let Ok(Completion::Found(field)) = complete(&rule, &free, 1, &()) else {
            unreachable!("there are many");
        };
        for stream in flow(&field, Edges::Torus).unwrap().streams {
            let over: Vec<bool> = stream
                .strands
                .iter()
                .map(|&strand| (strand as usize / 2, strand % 2 == 0))
                .filter(|&(cell, _)| field.cells()[cell] == 0)
                .map(|(cell, by_row)| (cell % 12 + cell / 12).is_multiple_of(2) == by_row)
                .collect();
            let next = over.iter().cycle().skip(1);
            assert!(over.len() < 2 || over.iter().zip(next).all(|(a, b)| a != b));
        }
    }
}
