//! `push` and `pop` are exact inverses, and `alternatives` leaves the state alone.
//!
//! What a problem remembers is looked at from outside: its answers along a walk. Stale values
//! that no answer depends on may remain.

use crate::problems::{SMALL, Visitor, mix, task, with_problem};
use tilepack::packing::Labeled;
use tilepack::search::{Alternatives, Count, Plan, State, Values, run};

struct RandomWalks {
    what: String,
    pushes: usize,
}

impl Visitor for RandomWalks {
    fn visit<P: Labeled>(&mut self, fresh: P) {
        for seed in 0..8 {
            self.walk(fresh.clone(), &fresh, seed);
        }
    }
}

impl RandomWalks {
    /// Goes up and down at random. Whenever a level is left again, its alternatives must be
    /// what they were; in the end and now and then the answers must be those of a problem that
    /// was brought there directly.
    fn walk<P: Labeled>(&mut self, mut problem: P, fresh: &P, seed: u64) {
        let levels = problem.levels();
        let mut random = mix(seed + 1);
        let mut draw = |below: usize| {
            random = mix(random.wrapping_add(0x9e37_79b9_7f4a_7c15));
            (random >> 16) as usize % below
        };
        let mut choices: Vec<u32> = Vec::new();
        let mut known = vec![problem.alternatives(0)];
        for step in 0..400 {
            let level = choices.len();
            let open: Vec<u32> =
                if level < levels { known[level].numbers().collect() } else { Vec::new() };
            let up = !open.is_empty() && draw(8) > 0;
            if up {
                let choice = open[draw(open.len())];
                problem.push(level, choice);
                self.pushes += 1;
                choices.push(choice);
                if level + 1 < levels {
                    known.push(problem.alternatives(level + 1));
                    assert_eq!(problem.alternatives(level + 1), known[level + 1], "{}", self.what);
                }
            } else {
                for _ in 0..=draw(level + 1) {
                    let Some(choice) = choices.pop() else { break };
                    known.truncate(choices.len() + 1);
                    problem.pop(choices.len(), choice);
                    let again = problem.alternatives(choices.len());
                    assert_eq!(again, known[choices.len()], "{} {choices:?}", self.what);
                }
            }
            if step % 20 == 0 {
                self.compare(&mut problem.clone(), &mut fresh.clone(), &choices);
            }
        }
        for level in (0..choices.len()).rev() {
            problem.pop(level, choices[level]);
        }
        self.compare(&mut problem, &mut fresh.clone(), &[]);
    }

    /// That a problem at some choices answers as one newly brought there: here, on a few ways
    /// further down, and on all levels on the way back.
    fn compare<P: Labeled>(&self, problem: &mut P, fresh: &mut P, choices: &[u32]) {
        for (level, &choice) in choices.iter().enumerate() {
            assert!(fresh.alternatives(level).contains(choice), "{} {choices:?}", self.what);
            fresh.push(level, choice);
        }
        let mut way = choices.to_vec();
        while way.len() < problem.levels() {
            let (ours, theirs) = (problem.alternatives(way.len()), fresh.alternatives(way.len()));
            assert_eq!(ours, theirs, "{} {way:?}", self.what);
            let Some(choice) = ours.numbers().nth(way.len() % 2).or(ours.numbers().next()) else {
                break;
            };
            problem.push(way.len(), choice);
            fresh.push(way.len(), choice);
            way.push(choice);
        }
        if way.len() == problem.levels() {
            let mut labels = [Vec::new(), Vec::new()];
            problem.write_labels(&mut labels[0]);
            fresh.write_labels(&mut labels[1]);
            assert_eq!(labels[0], labels[1], "{} {way:?}", self.what);
        }
        while let Some(choice) = way.pop() {
            let level = way.len();
            problem.pop(level, choice);
            fresh.pop(level, choice);
            let (ours, theirs) = (problem.alternatives(level), fresh.alternatives(level));
            assert_eq!(ours, theirs, "{} {way:?}", self.what);
        }
        // Back to where it was called.
        for (level, &choice) in choices.iter().enumerate() {
            problem.push(level, choice);
        }
    }
}

#[test]
fn random_walks_on_every_problem() {
    for &words in SMALL {
        for reduce in [true, false] {
            let what = format!("{words:?} {reduce}");
            let mut walks = RandomWalks { what, pushes: 0 };
            with_problem(&task(words), reduce, &mut walks);
            assert!(walks.pushes > 500, "{}: {} pushes", walks.what, walks.pushes);
        }
    }
}

struct Totals(Vec<(u64, u64, usize)>);

impl Visitor for Totals {
    fn visit<P: Labeled>(&mut self, problem: P) {
        let whole = State::whole(&mut problem.clone());
        let (state, _) = run(&mut Plan::simple(problem, Values::Lexicographic), whole, || Count);
        assert!(state.is_complete());
        self.0.push((state.nodes, state.solutions, state.deepest));
    }
}

/// One word or four, with the machinery for orbits or without: the same tree.
#[test]
fn every_implementation_walks_the_same_tree() {
    for words in SMALL {
        let large = matches!(words[..4], ["corner", "3", ..] | ["wang", "2,3", ..])
            || ["1x18", "6x3", "16x1"].contains(&words[3]);
        if large {
            continue;
        }
        let mut totals = Totals(Vec::new());
        with_problem(&task(*words), false, &mut totals);
        assert!(totals.0.windows(2).all(|pair| pair[0] == pair[1]), "{words:?} {:?}", totals.0);
    }
}
