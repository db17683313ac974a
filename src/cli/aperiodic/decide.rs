//! `aperiodic decide`: does a set fill the plane, and how?
//!
//! What is found is put into a certificate and checked by code that shares nothing with what
//! found it, before it is told.

use super::claims;
use super::published::published;
use crate::aperiodic::Set;
use crate::aperiodic::decide::torus::Torus;
use crate::aperiodic::decide::{Bounds, Gap, Verdict, decide, likeness, lonely, useful, wang};
use crate::cli::args::DecideArgs;
use crate::cli::exit::Exit;
use crate::cli::{describe, output, signal};
use crate::store::{check_writable, write_file};
use crate::tiles::Kind;
use crate::verify::{Claim, ClaimFault, check_claim};
use anyhow::bail;
use serde_json::{Value, json};
use std::io::{self, Write};
use std::time::Instant;

/// Tiles without neighbors that are told one by one.
const TOLD: usize = 5;
/// Columns and rows of a torus that is drawn.
const DRAWN: usize = 24;

/// Runs the command.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(args: &DecideArgs) -> anyhow::Result<Exit> {
    let begin = Instant::now();
    if let Some(file) = &args.certificate {
        check_writable(file)?;
    }
    let set = super::source::set(&args.file)?;
    let tiles = wang(&set);
    let lonely = lonely(&tiles);
    if !args.quiet {
        warn(&set, &lonely);
    }
    let bounds = Bounds { limit: args.limit.into(), ..Bounds::default() };
    let answer = match recognized(&set)? {
        Some(answer) => answer,
        None => {
            if !args.quiet {
                let mib = (bounds.arcs * 80) >> 20;
                output::remark(&format!(
                    "powers of up to {} rows and columns, each of at most {} arcs (about {mib} MiB)",
                    bounds.limit, bounds.arcs
                ));
            }
            let deadline = args.time_limit.and_then(|time| begin.checked_add(time));
            let stop = (signal::listen()?, deadline);
            Answer::new(decide(&tiles, &bounds, &stop), &bounds)
        }
    };
    let checked = match &answer.claim {
        None => false,
        Some(claim) => match check_claim(set.kind(), set.tiles(), claim, claims::MOST) {
            Ok(()) => true,
            Err(ClaimFault::TooLarge(_)) => false,
            Err(fault) => bail!("internal error: {fault}; please report this"),
        },
    };
    let written = match (&args.certificate, &answer.claim) {
        (Some(file), Some(claim)) if checked => {
            let fields = claims::fields(set.kind(), set.tiles(), claim, answer.name.as_deref());
            write_file(file, |out| writeln!(out, "{}", output::object_text(&fields)))?;
            Some(file)
        }
        (Some(file), _) => {
            output::remark(&format!("{}: not written: there is no certificate", file.display()));
            None
        }
        (None, _) => None,
    };
    let status = match (&answer.claim, checked) {
        (Some(_), false) => format!("{}; too large to be checked again", answer.status),
        (Some(_), true) => format!("{}; checked", answer.status),
        (None, _) => answer.status.clone(),
    };
    if args.json {
        let lonely: Vec<usize> = lonely.iter().map(|(tile, _)| *tile).collect();
        let mut fields = answer.fields(args.limit.into(), &status);
        fields.push(("useful", json!(useful(&tiles).len())));
        fields.push(("lonely", json!(lonely)));
        fields.push(("seconds", json!(begin.elapsed().as_secs_f64())));
        fields.push(("file", json!(written)));
        output::object(&fields)?;
    } else {
        output::result(|out| answer.write(out, &set, &status))?;
    }
    Ok(answer.exit)
}

fn warn(set: &Set, lonely: &[(usize, Vec<usize>)]) {
    for (tile, sides) in lonely.iter().take(TOLD) {
        let names: Vec<&str> =
            sides.iter().map(|&s| ["north", "east", "south", "west"][s]).collect();
        output::remark(&format!(
            "warning: tile {tile} {:?} has no neighbor to the {}, so it is in no tiling",
            set.tiles()[*tile],
            names.join(" and ")
        ));
    }
    if lonely.len() > TOLD {
        let more = describe::number((lonely.len() - TOLD) as u64, "more tile");
        output::remark(&format!("warning: {more} without a neighbor on some side"));
    }
}

/// What is told.
struct Answer {
    verdict: &'static str,
    exit: Exit,
    status: String,
    claim: Option<Claim>,
    /// What the set is called.
    name: Option<String>,
    more: Vec<(&'static str, Value)>,
}

/// Whether the set was published.
fn recognized(set: &Set) -> anyhow::Result<Option<Answer>> {
    for known in published()? {
        let Some(like) = likeness(set, &known.set) else { continue };
        let other = known.set.tiles().to_vec();
        let claim = Claim::Like { other, sides: like.sides, images: like.tiles };
        let status = format!(
            "the published set \"{}\" up to symmetry and the names of labels; its proof is in \
             print: {}",
            known.name, known.source
        );
        let (name, more) = (Some(known.name), vec![("source", json!(known.source))]);
        let (claim, exit) = (Some(claim), Exit::Yes);
        return Ok(Some(Answer { verdict: "aperiodic", exit, status, claim, name, more }));
    }
    Ok(None)
}

impl Answer {
    fn new(verdict: Verdict, bounds: &Bounds) -> Self {
        let (verdict, exit, status, claim, more) = match verdict {
            Verdict::Periodic(torus) => {
                let Torus { width, height, cells, smallest } = torus;
                let how =
                    if smallest { "no torus has fewer cells" } else { "perhaps not the smallest" };
                let status = format!("a torus of {width} x {height} is filled; {how}");
                let more = vec![("smallest", json!(smallest))];
                let claim = Claim::Torus { width, height, cells };
                ("periodic", Exit::Yes, status, Some(claim), more)
            }
            Verdict::Repeats(strip) => {
                let status = format!(
                    "a power of {} {} writes what it reads; the torus is too large to be shown",
                    strip.power,
                    lines(strip.rows)
                );
                ("periodic", Exit::Yes, status, None, Vec::new())
            }
            Verdict::NoSquare { side, nodes } => {
                let status = format!(
                    "no {side} x {side} square can be filled, by exhaustive search ({} placed), \
                     and every smaller one can",
                    describe::number(nodes, "tile")
                );
                let more = vec![("square", json!(side)), ("nodes", json!(nodes.to_string()))];
                ("no-tiling", Exit::No, status, Some(Claim::NoSquare { side }), more)
            }
            Verdict::NoStrip(strip) => {
                let (power, lines) = (strip.power, lines(strip.rows));
                let status = format!("the power of {power} {lines} is empty");
                let claim = Claim::NoStrip { rows: strip.rows, power };
                ("no-tiling", Exit::No, status, Some(claim), vec![(lines, json!(power))])
            }
            Verdict::Undecided(gap) => {
                ("undecided", Exit::Stopped, undecided(gap, bounds), None, Vec::new())
            }
        };
        Self { verdict, exit, status, claim, name: None, more }
    }

    fn fields(&self, limit: u64, status: &str) -> Vec<(&'static str, Value)> {
        let (mut size, mut torus) = ((None, None), None);
        if let Some(Claim::Torus { width, height, cells }) = &self.claim {
            size = (Some(*width), Some(*height));
            torus = Some(cells.chunks(*width).collect::<Vec<_>>());
        }
        let mut fields = vec![
            ("verdict", json!(self.verdict)),
            ("width", json!(size.0)),
            ("height", json!(size.1)),
            ("limit", json!(limit)),
            ("status", json!(status)),
        ];
        if let Some(torus) = torus {
            fields.push(("torus", json!(torus)));
        }
        if let Some(name) = &self.name {
            fields.push(("name", json!(name)));
        }
        fields.extend(self.more.iter().cloned());
        fields
    }

    fn write(&self, out: &mut dyn Write, set: &Set, status: &str) -> io::Result<()> {
        writeln!(out, "{}: {status}", self.verdict)?;
        match &self.claim {
            Some(Claim::Torus { width, height, cells }) if (*width).max(*height) <= DRAWN => {
                draw(out, set, *width, cells)
            }
            _ => Ok(()),
        }
    }
}

fn lines(rows: bool) -> &'static str {
    if rows { "rows" } else { "columns" }
}

fn undecided(gap: Gap, bounds: &Bounds) -> String {
    let Gap { rows, columns, arcs, stopped } = gap;
    let mut status = format!(
        "the powers of up to {rows} rows and up to {columns} columns neither are empty nor repeat"
    );
    match (stopped, arcs) {
        (true, _) => status.push_str("; stopped by a signal or the time limit"),
        (false, Some(arcs)) => {
            status += &format!("; the next one would have {arcs} arcs, more than {}", bounds.arcs);
        }
        (false, None) => {}
    }
    status
}

/// The labels of a torus, on edges with the numbers of tiles between, or on corners.
fn draw(out: &mut dyn Write, set: &Set, width: usize, cells: &[usize]) -> io::Result<()> {
    let tile = |&number: &usize| set.tiles()[number];
    let labels = set.tiles().iter().flatten().max().copied().unwrap_or(0);
    let digits = labels.to_string().len().max((set.tiles().len()).to_string().len() + 1);
    for row in cells.chunks(width) {
        if set.kind() == Kind::Corner {
            let colors: Vec<String> =
                row.iter().map(|cell| format!("{:>digits$}", tile(cell)[0])).collect();
            writeln!(out, "{}", colors.join(" "))?;
            continue;
        }
        let north: Vec<String> =
            row.iter().map(|cell| format!("{:>digits$}", tile(cell)[0])).collect();
        writeln!(out, "{:digits$} {}", "", north.join(&format!(" {:digits$} ", "")))?;
        let middle = row.iter().map(|cell| {
            let number = format!("#{cell}");
            format!("{:>digits$} {number:>digits$}", tile(cell)[3])
        });
        writeln!(out, "{}", middle.collect::<Vec<_>>().join(" "))?;
    }
    Ok(())
}
