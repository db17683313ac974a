//! `aperiodic tables`: the sizes of all conversions of the published sets (Lagae 2007, tables 8.1
//! to 8.7), and which of them are sound.

use super::published::published;
use crate::aperiodic::Set;
use crate::aperiodic::convert::{Method, convert};
use crate::aperiodic::decide::{Bounds, Torus, Verdict as Decided, decide, wang};
use crate::aperiodic::sound;
use crate::cli::args::TablesArgs;
use crate::cli::exit::Exit;
use crate::cli::{output, signal};
use serde_json::{Value, json};
use std::io::{self, Write};

/// The columns of the tables.
const COLUMNS: [&str; 5] = ["culik", "kari", "ammann", "jeandel-rao", "jeandel-rao-5"];

/// Steps of the repeated tables: corner, Wang, corner, ...
const STEPS: usize = 7;

/// What a conversion proves.
#[derive(Debug, Clone)]
pub(super) struct Verdict {
    method: Method,
    /// Tiles that the corner tilings may have besides.
    pub(super) mixed: usize,
    /// Whether corner tilings are periodic only when tilings of the set are; `None` when that is
    /// not known.
    pub(super) sound: Option<bool>,
    /// A periodic tiling by the set with its mixed tiles.
    torus: Option<Torus>,
}

/// Decides a conversion.
pub(super) fn verdict(set: &Set, method: Method) -> Verdict {
    if method == Method::ToWang || set.kind() != method.from_kind() {
        return Verdict { method, mixed: 0, sound: Some(true), torus: None };
    }
    let mixed = sound::mixed(set, method).len();
    if mixed == 0 {
        return Verdict { method, mixed, sound: Some(true), torus: None };
    }
    let bounds = Bounds { limit: 8, ..Bounds::default() };
    let stop = signal::listen().ok();
    let never = std::sync::atomic::AtomicBool::new(false);
    let enlarged = wang(&sound::enlarged(set, method));
    let decided = decide(&enlarged, &bounds, stop.unwrap_or(&never));
    let (sound, torus) = match decided {
        Decided::Periodic(torus) => (Some(false), Some(torus)),
        Decided::Repeats(_) => (Some(false), None),
        Decided::NoSquare { .. } | Decided::NoStrip(_) => (Some(true), None),
        Decided::Undecided(_) => (None, None),
    };
    Verdict { method, mixed, sound, torus }
}

impl Verdict {
    /// In a sentence.
    pub(super) fn words(&self) -> String {
        let mixed = match self.mixed {
            1 => "1 mixed tile".to_owned(),
            mixed => format!("{mixed} mixed tiles"),
        };
        match (self.sound, self.mixed, &self.torus) {
            (Some(true), 0, _) if self.method == Method::ToWang => {
                "tilings by the Wang tiles are tilings by the corner tiles".to_owned()
            }
            (Some(true), 0, _) => {
                "no mixed tiles: the corner tiles are aperiodic if the Wang tiles are".to_owned()
            }
            (Some(true), ..) => format!("{mixed}, but with them nothing is tiled"),
            (Some(false), _, Some(torus)) => format!(
                "{mixed}: the corner tiles have a periodic tiling, {}x{}",
                torus.width, torus.height
            ),
            (Some(false), ..) => format!("{mixed}: the corner tiles have a periodic tiling"),
            (None, ..) => format!("{mixed}: undecided"),
        }
    }
}

/// One published set in all tables.
struct Column {
    name: &'static str,
    set: Set,
    /// By method, the sizes of the steps; they end where a step is not injective.
    steps: Vec<(Method, Vec<Step>)>,
    verdicts: Vec<Verdict>,
}

struct Step {
    tiles: usize,
    colors: usize,
    /// Pairs that gave these tiles, when there were more.
    failed: Option<usize>,
}

impl Column {
    fn new(name: &'static str, set: Set) -> anyhow::Result<Self> {
        let mut all = Vec::new();
        for method in Method::TO_CORNER {
            let mut steps = Vec::new();
            let mut from = set.clone();
            for step in 0..STEPS {
                let method = if step % 2 == 0 { method } else { Method::ToWang };
                let converted = convert(&from, method)?;
                let failed = converted.pairs.filter(|_| !converted.is_injective());
                let tiles = converted.set.tiles().len();
                steps.push(Step { tiles, colors: converted.colors, failed });
                if failed.is_some() {
                    break;
                }
                from = converted.set;
            }
            all.push((method, steps));
        }
        let verdicts = [Method::Horizontal, Method::Vertical];
        let verdicts = verdicts.map(|method| verdict(&set, method)).to_vec();
        Ok(Self { name, set, steps: all, verdicts })
    }
}

impl Step {
    fn words(&self) -> String {
        match self.failed {
            Some(pairs) => format!("failed ({pairs} -> {})", self.tiles),
            None => format!("{}/{}", self.tiles, self.colors),
        }
    }
}

/// Runs the command.
///
/// # Errors
/// When standard output cannot be written.
pub fn run(args: &TablesArgs) -> anyhow::Result<Exit> {
    let mut columns = Vec::new();
    for known in published()?.into_iter().filter(|known| COLUMNS.contains(&known.short)) {
        columns.push(Column::new(known.short, known.set)?);
    }
    columns.sort_by_key(|column| COLUMNS.iter().position(|&name| name == column.name));
    match args.json {
        true => output::object(&[("sets", json!(columns.iter().map(object).collect::<Vec<_>>()))])?,
        false => output::result(|out| write(out, &columns))?,
    }
    Ok(Exit::Yes)
}

fn object(column: &Column) -> Value {
    let methods: serde_json::Map<String, Value> = column
        .steps
        .iter()
        .map(|(method, steps)| {
            let steps: Vec<Value> = steps
                .iter()
                .map(|step| {
                    json!({
                        "tiles": step.tiles, "colors": step.colors,
                        "injective": step.failed.is_none(),
                    })
                })
                .collect();
            (method.name().to_owned(), json!(steps))
        })
        .collect();
    let verdicts: serde_json::Map<String, Value> = column
        .verdicts
        .iter()
        .map(|verdict| {
            let about = json!({
                "mixed": verdict.mixed, "sound": verdict.sound, "status": verdict.words(),
            });
            (verdict.method.name().to_owned(), about)
        })
        .collect();
    json!({ "set": column.name, "steps": methods, "criterion": verdicts })
}

/// Cells of one width, the last without blanks behind it.
fn row(out: &mut dyn Write, first: &str, cells: &[String]) -> io::Result<()> {
    let cells: String = cells.iter().map(|cell| format!("{cell:<20}")).collect();
    writeln!(out, "{}", format!("{first:<13}{cells}").trim_end())
}

fn write(out: &mut dyn Write, columns: &[Column]) -> io::Result<()> {
    let heads: Vec<String> = columns
        .iter()
        .map(|column| format!("{} ({})", column.name, column.set.tiles().len()))
        .collect();
    writeln!(out, "Corner sets: tiles/colors (table 8.1)")?;
    row(out, "", &heads)?;
    let by_method = |method: usize, step: usize| -> Vec<String> {
        let steps = columns.iter().map(|column| column.steps[method].1.get(step));
        steps.map(|step| step.map_or_else(|| "-".to_owned(), Step::words)).collect()
    };
    for (at, method) in Method::TO_CORNER.into_iter().enumerate() {
        row(out, method.name(), &by_method(at, 0))?;
    }
    writeln!(out, "\nThose as Wang sets (table 8.2)")?;
    for (at, method) in Method::TO_CORNER.into_iter().enumerate() {
        row(out, method.name(), &by_method(at, 1))?;
    }
    for (number, method) in [(3, 0), (4, 1), (7, 2), (5, 3), (6, 4)] {
        let name = Method::TO_CORNER[method];
        writeln!(out, "\n{name}, repeated (table 8.{number})")?;
        for step in 0..STEPS {
            row(out, if step % 2 == 0 { "corner" } else { "Wang" }, &by_method(method, step))?;
        }
    }
    writeln!(
        out,
        "\nWhat the two translations prove: different pairs, different tiles is not enough"
    )?;
    for column in columns {
        for verdict in &column.verdicts {
            let at = if verdict.method == Method::Horizontal { 1 } else { 2 };
            let first = column.steps[at].1[0].words();
            writeln!(
                out,
                "{:<14}{:<11} {first:<19} {}",
                column.name,
                verdict.method.name(),
                verdict.words()
            )?;
        }
    }
    Ok(())
}
