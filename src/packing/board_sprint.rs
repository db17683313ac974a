//! Sprints on boards: along the lists, without looking anything up twice.
//!
//! The list of the next cell is known as soon as a tile is chosen: its place among the lists is
//! that of the colors laid before plus what the tile adds. So a tile after which there is no
//! list is counted and never laid. A tile laid writes only those of its colors that a cell other
//! than the next one reads, in row order that to the south. In the end the choices are pushed
//! the ordinary way, so that [`OnBoard`] itself stands where the sprint ended.

use super::board::{Labels, OnBoard, PLACES};
use super::board_caps::Caps;
use super::board_plan::{BoardPlan, Level, Place, Record};
use crate::search::{Alternatives, Problem, Sprint, Stretch, Words};
use std::sync::Arc;

/// Levels below which a sprint is not worth its while.
const FEWEST: usize = 3;

/// What is fixed about a level.
#[derive(Debug, Clone, Copy, Default)]
#[repr(align(32))]
struct Post {
    /// Where the table of the next level begins.
    base: u32,
    /// The keys of the next level that were laid before, and what they are multiplied by.
    before: [u16; 2],
    before_times: [u8; 2],
    /// The side of its tile that the next level has for a key, and what the color is multiplied
    /// by, 0 where it has none.
    side: u8,
    times: u8,
    /// Which of its colors a later level reads, and its place.
    write: Place,
    /// How many sides of the colors that it asks for are used up.
    costs: [u8; 2],
    /// Whether there is more to look at than its keys.
    checks: bool,
    /// Whether it writes or asks for more than that.
    more: bool,
}

/// What is kept of a level on the way down.
#[derive(Debug, Clone, Copy, Default)]
#[repr(align(16))]
struct Frame {
    /// The next tile of the list, and its end.
    at: u32,
    end: u32,
    /// Where the lists of the next level begin, but for what the tile adds.
    next: u32,
}

/// The tables of sprints.
#[derive(Debug, Clone)]
pub(super) struct Track {
    posts: Vec<Post>,
    frames: Vec<Frame>,
}

impl Track {
    /// `None` where two cells one after the other touch on two sides.
    pub(super) fn new(plan: &BoardPlan) -> Option<Self> {
        let dummy = plan.labels.len() as u16 - 1;
        let mut last_read = vec![0; plan.labels.len()];
        for (at, level) in plan.levels.iter().enumerate() {
            for place in level.keys.iter().chain(level.checks()) {
                last_read[usize::from(place.at)] = at;
            }
        }
        let mut posts = vec![Post::default(); plan.levels.len()];
        for (at, (level, post)) in plan.levels.iter().zip(&mut posts).enumerate() {
            post.before = [dummy; 2];
            post.write.at = (PLACES - 1) as u16;
            post.checks = !level.checks().is_empty();
            let next = plan.levels.get(at + 1);
            if let Some(next) = next {
                post.base = next.base;
                for (i, (key, times)) in next.keys.iter().zip([plan.stride as u8, 1]).enumerate() {
                    match level.fresh().find(|(fresh, _)| fresh.at == key.at) {
                        None => (post.before[i], post.before_times[i]) = (key.at, times),
                        Some(_) if post.times > 0 => return None,
                        Some((place, _)) => (post.side, post.times) = (place.side, times),
                    }
                }
            }
            let checked = |next: &Level, at: u16| next.checks().iter().any(|check| check.at == at);
            let read_later = |&place: &Place| {
                last_read[usize::from(place.at)] > at + 1
                    || next.is_some_and(|next| checked(next, place.at))
            };
            let mut writes = level.fresh().map(|(place, _)| place).filter(read_later);
            post.write = writes.next().unwrap_or(post.write);
            let fresh: Vec<u8> = level.fresh().map(|(_, cost)| cost).collect();
            // In the order of what a tile asks for.
            for (mine, &cost) in post.costs.iter_mut().zip(fresh.iter().rev()) {
                *mine = if plan.caps.counts() { cost } else { 0 };
            }
            post.more = writes.next().is_some() || plan.caps.counts() && fresh.len() > 2;
        }
        let length = plan.levels.len();
        Some(Self { posts, frames: vec![Frame::default(); length] })
    }
}

impl Post {
    /// Where the lists of the next level begin, but for what the tile adds.
    #[inline(always)]
    fn next(&self, labels: &Labels) -> u32 {
        let color = |i: usize| u32::from(labels[usize::from(self.before[i])]);
        let before = |i: usize| color(i) * u32::from(self.before_times[i]);
        self.base + before(0) + before(1)
    }
}

/// Writes all colors of a tile, and uses up those beyond the two.
#[inline(never)]
fn lay_more(level: &Level, record: &Record, labels: &mut Labels, caps: &mut Caps) {
    let beyond = level.fresh().count().saturating_sub(2);
    for (i, (place, cost)) in level.fresh().enumerate() {
        let color = record.sides[usize::from(place.side) % 4];
        labels[usize::from(place.at)] = color;
        if i < beyond {
            caps.take(color, cost);
        }
    }
}

/// Gives back what [`lay_more`] used up.
#[inline(never)]
fn lift_more(level: &Level, record: &Record, caps: &mut Caps) {
    let beyond = level.fresh().count().saturating_sub(2);
    for (place, cost) in level.fresh().take(beyond) {
        caps.give(record.sides[usize::from(place.side) % 4], cost);
    }
}

/// Where a sprint begins, and the alternatives it is to visit there.
struct First<const N: usize> {
    level: usize,
    list: usize,
    left: Words<N>,
}

impl<const N: usize> First<N> {
    /// The rarer conditions for a tile: what is known at more places than keys, and that it is
    /// to be visited at all.
    #[inline(never)]
    fn looks(&self, plan: &BoardPlan, level: usize, at: usize, labels: &Labels) -> bool {
        plan.levels[level].matches(&plan.records[at], labels)
            && (level != self.level || self.left.contains((at - self.list) as u32))
    }
}

impl<const N: usize> OnBoard<N> {
    /// Walks a stretch; `None` when that is left to the walk.
    pub(super) fn run(&mut self, stretch: Stretch<'_, Words<N>>) -> Option<Sprint> {
        let Stretch { level: base, choices, left, budget, counts } = stretch;
        let last = choices.len() - 1;
        if base + FEWEST > last + 1 {
            return None;
        }
        let mut track = self.track.take()?;
        let plan = Arc::clone(&self.plan);
        let (records, lists) = (&plan.records[..], &plan.lists[..]);
        let (posts, frames) = (&track.posts[..last + 1], &mut track.frames[..last + 1]);
        let Self { labels, free, caps, .. } = self;
        let (mut unused, mut solutions) = (budget, 0);
        let (mut level, mut deepest) = (base, base);
        let list = plan.list(&plan.levels[base], labels);
        let first = First { level: base, list: list.start, left: left[base] };
        let (mut at, mut end) = (list.start, list.end);
        let mut post = &posts[base];
        let mut next = post.next(labels);
        'walk: loop {
            let looks = post.checks || level == base;
            if level == last {
                for record in &records[at..end] {
                    let open = free[usize::from(record.class)] > 0 && !caps.are_closed(record.asks);
                    if open && plan.levels[level].matches(record, labels) {
                        if unused == 0 || !counts {
                            break 'walk;
                        }
                        (unused, solutions, deepest) = (unused - 1, solutions + 1, last + 1);
                    }
                    at += 1;
                }
            }
            while at < end {
                let record = &records[at];
                at += 1;
                if free[usize::from(record.class)] == 0 || caps.are_closed(record.asks) {
                    continue;
                }
                if looks && !first.looks(&plan, level, at - 1, labels) {
                    continue;
                }
                if unused == 0 {
                    at -= 1;
                    break 'walk;
                }
                unused -= 1;
                deepest = deepest.max(level + 1);
                let adds = u32::from(record.sides[usize::from(post.side) % 4]);
                let (from, to) = lists[(next + u32::from(post.times) * adds) as usize];
                let taken =
                    |class: u16| free[usize::from(class)] <= u16::from(class == record.class);
                let mut from = from as usize;
                while from < to as usize && taken(records[from].class) {
                    from += 1;
                }
                if from == to as usize {
                    continue;
                }
                frames[level] = Frame { at: at as u32, end: end as u32, next };
                free[usize::from(record.class)] -= 1;
                caps.take_both(record.asks, post.costs);
                labels[usize::from(post.write.at)] = record.sides[usize::from(post.write.side) % 4];
                if post.more {
                    lay_more(&plan.levels[level], record, labels, caps);
                }
                level += 1;
                (at, end) = (from, to as usize);
                post = &posts[level];
                next = post.next(labels);
                continue 'walk;
            }
            if level == base {
                break;
            }
            level -= 1;
            post = &posts[level];
            let frame = frames[level];
            (at, end, next) = (frame.at as usize, frame.end as usize, frame.next);
            let record = &records[at - 1];
            free[usize::from(record.class)] += 1;
            caps.give_both(record.asks, post.costs);
            if post.more {
                lift_more(&plan.levels[level], record, caps);
            }
        }
        frames[level].at = at as u32;
        self.stop(base, level, frames, choices, left);
        self.track = Some(track);
        Some(Sprint { level, nodes: budget - unused, solutions, deepest })
    }

    /// Makes choices and alternatives left of where a sprint ended.
    fn stop(
        &mut self,
        base: usize,
        level: usize,
        frames: &[Frame],
        choices: &mut [u32],
        left: &mut [Words<N>],
    ) {
        // Without what the sprint laid.
        for at in (base..level).rev() {
            let record = self.plan.records[frames[at].at as usize - 1];
            self.free[usize::from(record.class)] += 1;
            for (place, cost) in self.plan.levels[at].fresh() {
                self.caps.give(record.sides[usize::from(place.side)], cost);
            }
        }
        for at in base..=level {
            let list = self.plan.list(&self.plan.levels[at], &self.labels);
            let tried = frames[at].at - list.start as u32;
            let offered = if at == base { left[base] } else { self.alternatives(at) };
            left[at] = Words::EMPTY;
            for choice in offered.numbers().filter(|&choice| choice >= tried) {
                left[at].insert(choice);
            }
            if at < level {
                choices[at] = tried - 1;
                self.push(at, tried - 1);
            }
        }
    }
}
