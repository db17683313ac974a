//! `aperiodic classify --merge`: the results of parts, added.

use super::classify::{Answer, sums, words};
use crate::aperiodic::classify::Tally;
use crate::cli::exit::Exit;
use crate::cli::{output, source};
use anyhow::{Context, bail, ensure};
use serde::Deserialize;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// Parts that are missing and named.
const NAMED: usize = 20;

/// The result of a part, as it was written.
#[derive(Debug, Deserialize)]
struct Part {
    result: String,
    kind: String,
    tiles: u8,
    up_to: String,
    limit: u16,
    part: usize,
    parts: usize,
    sets: String,
    periodic: String,
    no_tiling: String,
    undecided: String,
    undecided_sets: Vec<Value>,
    seconds: f64,
}

impl Part {
    fn tally(&self) -> anyhow::Result<Tally> {
        let number = |name: &str, text: &str| {
            text.parse::<u64>().with_context(|| format!("{name} {text:?}: expected a number"))
        };
        let tally = Tally {
            sets: number("sets", &self.sets)?,
            periodic: number("periodic", &self.periodic)?,
            no_tiling: number("no_tiling", &self.no_tiling)?,
            undecided: number("undecided", &self.undecided)?,
        };
        let sum = [tally.periodic, tally.no_tiling, tally.undecided];
        let sum = sum.into_iter().try_fold(0u64, u64::checked_add);
        ensure!(sum == Some(tally.sets), "the sums do not add up to {} sets", tally.sets);
        Ok(tally)
    }

    /// What must be the same in all parts.
    fn question(&self) -> (&str, u8, &str, u16, usize) {
        (&self.kind, self.tiles, &self.up_to, self.limit, self.parts)
    }
}

/// Adds results.
///
/// # Errors
/// A file that is no result of a part, parts of different questions, a part given twice.
pub(super) fn merge(files: &[PathBuf]) -> anyhow::Result<Answer> {
    let mut tally = Tally::default();
    let (mut seen, mut undecided) = (BTreeSet::new(), Vec::new());
    let (mut seconds, mut first) = (0.0, None::<Part>);
    for file in files {
        let name = file.display();
        let input = source::open(file)?;
        let text = input.text().trim_start();
        let mut part: Part = serde_json::from_str(text)
            .with_context(|| format!("{name}: expected the result of a part, from --json"))?;
        ensure!(part.result == "complete", "{name}: part {} is not complete", part.part);
        ensure!(part.part < part.parts, "{name}: part {} of {}", part.part, part.parts);
        tally += part.tally().with_context(|| name.to_string())?;
        undecided.append(&mut part.undecided_sets);
        seconds += part.seconds;
        if let Some(first) = &first
            && first.question() != part.question()
        {
            bail!("{name}: of another classification than {}", files[0].display());
        }
        ensure!(seen.insert(part.part), "{name}: part {} is given twice", part.part);
        first.get_or_insert(part);
    }
    let first = first.context("--merge: no files")?;
    let missing: Vec<usize> = (0..first.parts).filter(|part| !seen.contains(part)).collect();
    if !missing.is_empty() {
        let named: Vec<String> = missing.iter().take(NAMED).map(usize::to_string).collect();
        let more = if missing.len() > NAMED { ", ..." } else { "" };
        output::remark(&format!("missing: parts {}{more}", named.join(", ")));
    }
    let complete = missing.is_empty();
    let mut fields = vec![("result", json!(if complete { "complete" } else { "stopped" }))];
    fields.extend([("kind", json!(first.kind)), ("tiles", json!(first.tiles))]);
    fields.extend([("up_to", json!(first.up_to)), ("limit", json!(first.limit))]);
    fields.extend([("parts", json!(first.parts)), ("done", json!(seen.len()))]);
    fields.extend(sums(tally));
    fields.push(("undecided_sets", json!(undecided)));
    fields.push(("missing", json!(missing)));
    fields.push(("seconds", json!(seconds)));
    let words = match complete {
        true => words(tally),
        false => format!("{} in {} of {} parts", words(tally), seen.len(), first.parts),
    };
    Ok(Answer { exit: if complete { Exit::Yes } else { Exit::Stopped }, fields, words })
}
