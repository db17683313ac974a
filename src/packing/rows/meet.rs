//! The two halves for one choice of line 0 and of line `a`.
//!
//! Both halves are themselves put together of two short walks that meet in a line between
//! ([`join`]). Kinds of lines must add up: of the second half only those pairs count whose
//! dominoes leave what some walk of the first half has. That halves the work.

use super::join::join;
use super::line::{Dominoes, Lines, State};
use super::table::{Desk, Entry, Query, Table};
use super::walks::{Sums, Walks, Wanted};
use std::collections::HashSet;

/// How the lines around the torus are shared out: pairs from line 0 to a line between, from
/// there to line `a`, on to another line between, and back to line 0.
#[derive(Debug, Clone, Copy)]
struct Pairs([usize; 4]);

impl Pairs {
    fn new(lines: usize) -> Self {
        let (first, second) = (lines / 2, lines - lines / 2);
        Self([first / 2, first - first / 2, second / 2, second - second / 2])
    }
}

/// What all choices of line `a` share: the walks that begin or end in line 0.
#[derive(Debug)]
pub struct Side {
    /// The class of line 0.
    class: u8,
    start: State,
    pairs: Pairs,
    from_start: Walks,
    to_start: Walks,
    /// Sums of the lines within the walks of each of the four parts; the lines between belong to
    /// the first and the last.
    sums: [Sums; 4],
}

/// What came of a choice.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Met {
    /// Packings, by the number of lines of the class of line 0.
    pub packings: [u64; super::MOST_LINES + 1],
    /// Walks of the second half that were looked up.
    pub steps: u64,
}

/// Room to work in.
#[derive(Debug, Default)]
pub struct Room {
    desk: Desk,
    first_half: Vec<(u64, Entry)>,
}

impl Side {
    /// For a class of lines, represented by its first state.
    pub fn new(lines: &Lines, class: u8) -> Self {
        let pairs = Pairs::new(lines.frame.lines);
        let Pairs([one, two, three, four]) = pairs;
        let sums = [one, two - 1, three - 1, four].map(|terms| Sums::new(lines, terms));
        let start = lines.classes[usize::from(class)].first;
        let walks = |towards, pairs, sums| {
            Wanted { lines, class, sums, end: start, towards, pairs, counts: true }.walks()
        };
        let from_start = walks(false, one, &sums[0]);
        let to_start = walks(true, four, &sums[3]);
        Self { class, start, pairs, from_start, to_start, sums }
    }

    /// The packings with this line `a`.
    pub fn meet(&self, lines: &Lines, line: State, room: &mut Room) -> Met {
        let mut met = Met::default();
        if lines.class[usize::from(line)] < self.class {
            return met;
        }
        let Pairs([_, two, three, _]) = self.pairs;
        let wanted = |towards, pairs, sums| {
            let class = self.class;
            Wanted { lines, class, sums, end: line, towards, pairs, counts: false }.walks()
        };
        let left = self.first_half(lines, &wanted(true, two, &self.sums[1]), room);
        if room.first_half.is_empty() {
            return met;
        }
        let table = Table::new(&room.first_half);
        let fits = self.fits(lines, line, &left);
        let fits = |sum: u32| fits[sum as usize];
        let (law, whole) = (&lines.law, lines.law.whole());
        // Line 0, and line `a` if it is alike.
        let alike = 1 + u8::from(lines.class[usize::from(line)] == self.class);
        let third = wanted(false, three, &self.sums[2]);
        let flush = |(desk, met): &mut (&mut Desk, &mut Met)| {
            let Met { packings, steps } = met;
            *steps += desk.look_up(&table, |query, entry| {
                if law.join(query.mask, entry.mask()).is_some() {
                    packings[usize::from(alike + query.alike + entry.alike)] += 1;
                }
            });
        };
        let mut state = (&mut room.desk, &mut met);
        for between in 0..lines.states() as State {
            let groups = (third.of(between), self.to_start.of(between));
            let before = |state: &mut (&mut Desk, &mut Met), most| {
                if state.0.is_full(most) {
                    flush(state);
                }
            };
            join(law, groups, fits, &mut state, before, |(desk, _), x, y, real| {
                let key = whole.wrapping_sub(x.key).wrapping_sub(y.key);
                let (mask, alike) = (x.mask | y.mask, x.alike + y.alike);
                desk.put(Query { key, mask, alike }, real);
            });
        }
        flush(&mut state);
        met
    }

    /// Puts all walks from line 0 to line `a` into the room; gives the dominoes along their lines.
    fn first_half(&self, lines: &Lines, second: &Walks, room: &mut Room) -> HashSet<Dominoes> {
        room.first_half.clear();
        let [first_sums, second_sums, ..] = &self.sums;
        let columns = second_sums.dominoes.len();
        let mut state = (&mut room.first_half, vec![false; first_sums.dominoes.len() * columns]);
        for between in 0..lines.states() as State {
            let groups = (second.of(between), self.from_start.of(between));
            let all = |_| u128::MAX;
            join(
                &lines.law,
                groups,
                all,
                &mut state,
                |_, _| {},
                |(walks, seen), x, y, real| {
                    if real {
                        let key = x.key.wrapping_add(y.key);
                        walks.push((key, Entry::new(x.mask | y.mask, key, x.alike + y.alike)));
                        seen[y.sum as usize * columns + x.sum as usize] = true;
                    }
                },
            );
        }
        let place =
            |at: usize| first_sums.dominoes[at / columns] + second_sums.dominoes[at % columns];
        let seen = state.1.iter().enumerate().filter(|&(_, &seen)| seen);
        seen.map(|(at, _)| place(at)).collect()
    }

    /// By sum of the last part: the sums of the part before, as bits, with which it leaves what
    /// the first half has. Everything where there are too many for bits.
    fn fits(&self, lines: &Lines, line: State, left: &HashSet<Dominoes>) -> Vec<u128> {
        let [_, _, third, fourth] = &self.sums;
        if third.dominoes.len() > u128::BITS as usize {
            return vec![u128::MAX; fourth.dominoes.len()];
        }
        let ends = lines.dominoes(self.start) + lines.dominoes(line);
        let fits = |&fourth: &Dominoes| {
            let goes = |&third: &Dominoes| {
                // Where some domino is used more often than there are, the difference has no
                // meaning and is found nowhere: no byte of a sum is that large.
                left.contains(&lines.target.wrapping_sub(ends + third + fourth))
            };
            let bits = third.dominoes.iter().enumerate();
            bits.fold(0, |bits, (at, sum)| bits | u128::from(goes(sum)) << at)
        };
        fourth.dominoes.iter().map(fits).collect()
    }
}
