//! How far a search has come, on standard error: a bar on a terminal, else a line every few
//! seconds. A search of less than a second shows nothing.
//!
//! The only user of `indicatif`. The part of the tree that is done is Knuth's measure, in which
//! every alternative of a node counts the same; the tree is not even, so it is called "about".

use super::eta::{self, Eta};
use super::{describe, duration, output};
use crate::search::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::cell::{Cell, OnceCell, RefCell};
use std::io::{self, IsTerminal};
use std::time::Duration;

/// Before this time nothing is shown on a terminal.
const PATIENCE: Duration = Duration::from_secs(1);
/// Time between two lines where there is no terminal.
const BETWEEN_LINES: Duration = Duration::from_secs(5);
/// Steps of the bar.
const STEPS: u64 = 10_000;
/// Characters beside a bar on the usual terminal of 80.
const BESIDE_BAR: usize = 80 - "[==========] ".len();

/// Shows progress, and remembers the last it was told.
#[derive(Debug)]
pub struct Display {
    mode: Mode,
    /// What the search meets: solutions, or choices that stand for many.
    leaf: &'static str,
    last: Cell<Option<Progress>>,
    eta: RefCell<Eta>,
}

#[derive(Debug)]
enum Mode {
    Quiet,
    /// The bar, once there is one.
    Bar(OnceCell<ProgressBar>),
    /// When the next line is due.
    Lines(Cell<Duration>),
}

impl Display {
    /// A display for standard error as it is; `leaf` is what the search meets.
    pub fn new(quiet: bool, leaf: &'static str) -> Self {
        let mode = match (quiet, io::stderr().is_terminal()) {
            (true, _) => Mode::Quiet,
            (false, true) => Mode::Bar(OnceCell::new()),
            (false, false) => Mode::Lines(Cell::new(BETWEEN_LINES)),
        };
        Self { mode, leaf, last: Cell::new(None), eta: RefCell::default() }
    }

    /// Takes a look at the search; called some twenty times a second.
    pub fn show(&self, progress: &Progress) {
        self.last.set(Some(*progress));
        self.eta.borrow_mut().add(progress.elapsed, progress.fraction);
        match &self.mode {
            Mode::Quiet => {}
            Mode::Bar(bar) if progress.elapsed >= PATIENCE => {
                let bar = bar.get_or_init(new_bar);
                bar.set_position((progress.fraction * STEPS as f64) as u64);
                bar.set_message(few_words(progress, self.left(), self.leaf));
            }
            Mode::Bar(_) => {}
            Mode::Lines(due) => {
                if progress.elapsed >= due.get() {
                    due.set(progress.elapsed + BETWEEN_LINES);
                    output::remark(&words(progress, self.left(), self.leaf));
                }
            }
        }
    }

    /// The time left, from the shortest to the longest that is likely, if there is any telling;
    /// see [`Eta::left`]. Told also when nothing is shown.
    pub fn left(&self) -> Option<(Duration, Duration)> {
        self.eta.borrow().left()
    }

    /// Takes the display away and gives the last progress shown, if there was time for any.
    pub fn finish(&self) -> Option<Progress> {
        if let Mode::Bar(bar) = &self.mode
            && let Some(bar) = bar.get()
        {
            bar.finish_and_clear();
        }
        self.last.get()
    }
}

fn new_bar() -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(STEPS), ProgressDrawTarget::stderr());
    // Plain blocks; should the template ever be refused, the default one does as well.
    if let Ok(style) = ProgressStyle::with_template("[{bar:10}] {wide_msg}") {
        bar.set_style(style.progress_chars("=> "));
    }
    bar
}

/// All there is to say, the most telling first, in one line.
fn words(progress: &Progress, left: Option<(Duration, Duration)>, leaf: &str) -> String {
    let Progress { nodes, solutions, deepest, levels, fraction, elapsed } = *progress;
    let rate = nodes as f64 / elapsed.as_secs_f64().max(1e-3);
    let left = left.map_or(String::new(), |left| format!(", {}", eta::words(left)));
    format!(
        "about {} of the tree, {} nodes, {} nodes/s, deepest level {deepest} of {levels}, \
         {} met, {}{left}",
        percent(fraction),
        rounded(nodes as f64),
        rounded(rate),
        describe::number(solutions, leaf),
        duration::words(elapsed)
    )
}

/// The same in as few characters as will do, so that it fits beside a bar; the time left is worth
/// more than the number of nodes, and that more than the deepest level.
fn few_words(progress: &Progress, left: Option<(Duration, Duration)>, leaf: &str) -> String {
    let Progress { nodes, solutions, deepest, levels, fraction, elapsed } = *progress;
    let rate = nodes as f64 / elapsed.as_secs_f64().max(1e-3);
    let left = left.map_or(String::new(), |left| format!(" {},", eta::words(left)));
    let begin = format!("about {}, {},{left}", percent(fraction), duration::words(elapsed));
    let (count, rate) = (format!("{} nodes, ", short(nodes as f64)), short(rate));
    let level = format!("deepest {deepest}/{levels}, ");
    let met = match leaf {
        describe::SOLUTION => format!("{solutions} met"),
        leaf => describe::number(solutions, leaf),
    };
    let all = format!("{begin} {count}{rate}/s, {level}{met}");
    if all.len() <= BESIDE_BAR || left.is_empty() {
        return all;
    }
    let fewer = format!("{begin} {count}{rate}/s, {met}");
    if fewer.len() <= BESIDE_BAR { fewer } else { format!("{begin} {rate} nodes/s, {met}") }
}

/// A part of 1 as a percentage, however small.
pub fn percent(part: f64) -> String {
    let percent = 100.0 * part;
    if percent == 0.0 || percent >= 0.01 {
        // Never "100.00 %" before the end.
        format!("{:.2} %", (percent * 100.0).floor() / 100.0)
    } else {
        format!("{percent:.1e} %")
    }
}

/// A large number in few characters, with the prefixes of the SI: `41.3M`.
fn short(number: f64) -> String {
    for (unit, prefix) in [(1e12, "T"), (1e9, "G"), (1e6, "M"), (1e3, "k")] {
        if number >= unit {
            return format!("{:.1}{prefix}", number / unit);
        }
    }
    format!("{number:.0}")
}

/// A large number for people: `41.3 million`.
fn rounded(number: f64) -> String {
    for (unit, name) in [(1e12, "trillion"), (1e9, "billion"), (1e6, "million")] {
        if number >= unit {
            return format!("{:.2} {name}", number / unit);
        }
    }
    format!("{number:.0}")
}

#[cfg(test)]
mod tests {
    use super::describe::SOLUTION;
    use super::*;

    #[test]
    fn numbers_for_people() {
        assert_eq!(rounded(999_999.0), "999999");
        assert_eq!(rounded(41_250_000.0), "41.25 million");
        assert_eq!(rounded(2.5e12), "2.50 trillion");
        assert_eq!(short(999.0), "999");
        assert_eq!(short(41_250_000.0), "41.2M");
        assert_eq!(percent(0.0), "0.00 %");
        assert_eq!(percent(0.12345), "12.34 %");
        assert_eq!(percent(0.99999), "99.99 %");
        assert_eq!(percent(3.2e-9), "3.2e-7 %");
    }

    #[test]
    fn a_line_says_everything() {
        let progress = Progress {
            nodes: 2_000_000,
            solutions: 3,
            deepest: 40,
            levels: 81,
            fraction: 0.25,
            elapsed: Duration::from_secs(4),
        };
        assert_eq!(
            words(&progress, None, SOLUTION),
            "about 25.00 % of the tree, 2.00 million nodes, 500000 nodes/s, \
             deepest level 40 of 81, 3 solutions met, 4.00 s"
        );
        let few = "about 25.00 %, 4.00 s, 2.0M nodes, 500.0k/s, deepest 40/81, 3 met";
        assert_eq!(few_words(&progress, None, SOLUTION), few);
        assert!("[==========] ".len() + few.len() <= 80);
        let choices = few_words(&progress, None, "choice");
        assert!(choices.ends_with(", deepest 40/81, 3 choices"), "{choices}");
        assert!(words(&progress, None, "choice").contains(", 3 choices met, "));
        let minutes = |minutes: u64| Duration::from_secs(60 * minutes);
        let left = Some((minutes(3), minutes(5)));
        assert!(
            words(&progress, left, SOLUTION)
                .ends_with(", 3 solutions met, 4.00 s, 3 to 5 min left")
        );
        let few = "about 25.00 %, 4.00 s, 3 to 5 min left, 2.0M nodes, 500.0k/s, 3 met";
        assert_eq!(few_words(&progress, left, SOLUTION), few);
        // The longest there is.
        let progress = Progress {
            nodes: 432_100_000_000,
            solutions: 1234,
            fraction: 1.2345e-7,
            elapsed: Duration::from_secs(5995),
            ..progress
        };
        let few = few_words(&progress, Some((minutes(50), minutes(143))), SOLUTION);
        assert_eq!(
            few,
            "about 1.2e-5 %, 99 min 55 s, 50 min to 2.5 h left, 72.1M nodes/s, 1234 met"
        );
    }
}
