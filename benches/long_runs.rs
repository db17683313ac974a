//! What safety costs: checkpoints against none, parts against the undivided search, each pair in
//! one run on the same problem.
//!
//! A checkpoint is asked for as often as the search lets it (every tick of 50 ms), so that its
//! cost shows at all; at one a minute it is a thousandth of that.

#![allow(missing_docs, clippy::unwrap_used)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::time::Duration;
use tilepack::packing::{Cut, Job, Question, Settings, Standing, Task, frontier, run};
use tilepack::search::{Limits, Part};
use tilepack::store::{Keeping, Writer, write_job};
use tilepack::symmetry::Automorphism;
use tilepack::tiles::{Colors, Kind, Members, TileSet};
use tilepack::torus::Shape;

fn count(kind: Kind, colors: u64, automorphism: &str) -> Job {
    let set = TileSet::new(kind, Colors::one(colors).unwrap(), Members::Complete).unwrap();
    let shape = Shape::default_for(&set).unwrap();
    let mut task = Task::new(set, shape);
    if !automorphism.is_empty() {
        let colors = task.set.colors();
        task.automorphism = Some(Automorphism::parse(automorphism, colors, shape).unwrap());
    }
    Job::new(task, Question::Count { up_to_symmetry: false })
}

/// Runs a prefix of a search, saved to a temporary folder whenever that is possible.
fn saved(job: &Job, settings: Settings<'_>) -> Standing {
    let folder = tempfile::tempdir().unwrap();
    let writer = Writer {
        file: folder.path().join("x.checkpoint"),
        job: write_job(job),
        request: String::new(),
        generation: 0,
        kept: None,
        waiting: Vec::new(),
    };
    let keeping = Keeping::start(
        writer,
        Duration::ZERO,
        Box::new(|written| {
            written.as_ref().unwrap();
        }),
    );
    let standing = run(job, None, &Settings { keeper: Some(&keeping), ..settings }).unwrap();
    keeping.finish().write(standing.clone()).unwrap();
    standing
}

fn checkpoints(c: &mut Criterion) {
    let mut group = c.benchmark_group("checkpoint");
    group.sample_size(10);
    for (name, job, nodes) in [
        ("corner C=3", count(Kind::Corner, 3, ""), 40_000_000),
        ("wang C=8, 4096 tiles", count(Kind::Wang, 8, ""), 4_000_000),
    ] {
        let limits = Limits { nodes, ..Limits::NONE };
        let settings = Settings { threads: 2, limits, ..Settings::PLAIN };
        group.throughput(Throughput::Elements(nodes));
        group.bench_function(format!("{name}, none"), |b| {
            b.iter(|| run(&job, None, &settings).unwrap());
        });
        group.bench_function(format!("{name}, every 50 ms"), |b| b.iter(|| saved(&job, settings)));
    }
    group.finish();
}

/// All parts of a search, one after the other.
fn in_parts(job: &Job, depth: usize, of: u64) -> u64 {
    let part = |number| Job { part: Some(Part { depth, number, of }), ..job.clone() };
    let met = |number| run(&part(number), None, &Settings::PLAIN).unwrap().state.solutions;
    (0..of).map(met).sum()
}

fn parts(c: &mut Criterion) {
    let mut group = c.benchmark_group("parts");
    group.sample_size(10);
    for (name, job) in [
        ("wang C=2", count(Kind::Wang, 2, "")),
        ("corner C=3 with a[i][j+3] = a[i][j]+1", count(Kind::Corner, 3, "3,0:+1")),
    ] {
        let whole = run(&job, None, &Settings::PLAIN).unwrap();
        let depth = frontier(&job, Cut::Nodes(1 << 16)).unwrap().depth;
        group.throughput(Throughput::Elements(whole.state.nodes));
        group.bench_function(format!("{name}, undivided"), |b| {
            b.iter(|| run(&job, None, &Settings::PLAIN).unwrap());
        });
        for of in [7, 64] {
            group.bench_function(format!("{name}, {of} parts"), |b| {
                b.iter(|| assert_eq!(in_parts(&job, depth, of), whole.state.solutions));
            });
        }
        group.bench_function(format!("{name}, finding the frontier"), |b| {
            b.iter(|| frontier(&job, Cut::Nodes(1 << 16)).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, checkpoints, parts);
criterion_main!(benches);
