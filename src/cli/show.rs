//! `show`: draws the packings of a file, in color when standard output is a terminal.

use super::args::{ShowArgs, When};
use super::draw::{self, Style};
use super::exit::Exit;
use super::{describe, output, set, source};
use crate::store::solutions;
use crate::verify;
use std::env;
use std::io::{self, IsTerminal};

/// Runs the command.
///
/// # Errors
/// A file that cannot be read; what comes before the mistake is drawn.
pub fn run(args: &ShowArgs) -> anyhow::Result<Exit> {
    let claim = set::packing_claim(&args.claim)?;
    let style = Style { color: wants_color(args.color), indices: args.indices };
    let input = source::open(&args.file)?;
    for (number, solution) in solutions(&input, &claim).enumerate() {
        let solution = solution?;
        let packing = &solution.packing;
        let what = if packing.cover { "covering" } else { "packing" };
        let verdict = verify::check(packing);
        if !verdict.is_valid() {
            let (file, line) = (input.file().display(), solution.line);
            output::remark(&format!("{file}, line {line}: not a {what}: {verdict}"));
        }
        let what = if verdict.is_valid() { what } else { "tiles" };
        let set = describe::set(&packing.set);
        let torus = describe::board(packing.set.kind(), packing.shape, &packing.board);
        output::result(|out| {
            if number > 0 {
                writeln!(out)?;
            }
            writeln!(out, "{what}, {set}, {torus}")?;
            draw::draw(out, packing, style)
        })?;
    }
    Ok(Exit::Yes)
}

/// Whether to draw in color. `NO_COLOR` is that of no-color.org.
fn wants_color(when: When) -> bool {
    let is_set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
    let dumb = || env::var_os("TERM").is_some_and(|term| term == "dumb");
    match when {
        When::Always => true,
        When::Never => false,
        When::Auto => io::stdout().is_terminal() && !is_set("NO_COLOR") && !dumb(),
    }
}
