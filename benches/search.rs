//! Time of the search: whole problems, fixed prefixes of a number of nodes, and the naive
//! engine on the same problem in the same run.
//!
//! `cargo bench` prints times with intervals, and nodes a second as the throughput. Results
//! worth keeping stand under `benches/runs`, with machine and version.

#![allow(missing_docs, clippy::unwrap_used)]

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tilepack::packing::{Job, Settings, Task, count, find};
use tilepack::search::{Limits, Values, naive};
use tilepack::symmetry::Automorphism;
use tilepack::tiles::{Colors, Kind, Members, TileSet};
use tilepack::torus::Shape;

fn task(kind: Kind, colors: u64, members: Members, automorphism: &str) -> Task {
    let set = TileSet::new(kind, Colors::one(colors).unwrap(), members).unwrap();
    let shape = Shape::default_for(&set).unwrap();
    let mut task = Task::new(set, shape);
    if !automorphism.is_empty() {
        let colors = task.set.colors();
        task.automorphism = Some(Automorphism::parse(automorphism, colors, shape).unwrap());
    }
    task
}

/// Nothing removed before the search.
fn plain(task: &Task) -> Job {
    Job { reduce: false, ..Job::from(task) }
}

fn nodes(nodes: u64) -> Limits<'static> {
    Limits { nodes, ..Limits::NONE }
}

/// Whole counts. The answer is the checksum.
fn counts(c: &mut Criterion) {
    let mut group = c.benchmark_group("count");
    group.sample_size(20);
    let wang = task(Kind::Wang, 2, Members::Complete, "");
    let quotient = task(Kind::Corner, 3, Members::Complete, "3,0:+1");
    for (name, job, answer) in [
        ("wang C=2, no symmetry removed", plain(&wang), 203_520u32),
        ("wang C=2, symmetry removed", Job::from(&wang), 203_520),
        ("corner C=3 with a[i][j+3] = a[i][j]+1", Job::from(&quotient), 303_264),
    ] {
        let visited = count(job.clone(), &Settings::PLAIN, false).unwrap().work.nodes;
        group.throughput(Throughput::Elements(visited));
        for threads in [1, 2] {
            let settings = Settings { threads, ..Settings::PLAIN };
            group.bench_function(format!("{name}, {threads} threads"), |b| {
                b.iter(|| {
                    let counted = count(black_box(job.clone()), &settings, false).unwrap();
                    assert_eq!(counted.value.packings, answer.into());
                });
            });
        }
    }
    group.finish();
}

/// The first so many nodes of searches that do not end.
fn prefixes(c: &mut Criterion) {
    let mut group = c.benchmark_group("prefix");
    group.sample_size(10);
    for (name, task) in [
        ("corner C=3", task(Kind::Corner, 3, Members::Complete, "")),
        ("corner C=4", task(Kind::Corner, 4, Members::Complete, "")),
        ("compact corner C=3", task(Kind::Corner, 3, Members::Compact, "")),
        ("wang C=3", task(Kind::Wang, 3, Members::Complete, "")),
    ] {
        for (threads, visited) in [(1, 20_000_000), (2, 40_000_000)] {
            group.throughput(Throughput::Elements(visited));
            let settings = Settings { threads, limits: nodes(visited), ..Settings::PLAIN };
            group.bench_function(format!("{name}, {threads} threads"), |b| {
                b.iter(|| count(black_box(&task), &settings, false).unwrap());
            });
        }
    }
    group.finish();
}

/// First packings.
fn firsts(c: &mut Criterion) {
    let mut group = c.benchmark_group("first");
    group.sample_size(10);
    let corner = task(Kind::Corner, 3, Members::Complete, "");
    let compact = task(Kind::Corner, 3, Members::Compact, "");
    let quotient = task(Kind::Corner, 4, Members::Complete, "4,0:1,2,3,0");
    let random = |seed| Job { values: Values::Random(seed), ..Job::from(&quotient) };
    group.bench_function("corner C=3", |b| {
        b.iter(|| find(black_box(&corner), &Settings::PLAIN).unwrap());
    });
    group.bench_function("compact corner C=3", |b| {
        b.iter(|| find(black_box(&compact), &Settings::PLAIN).unwrap());
    });
    let mut seed = 0;
    group.bench_function("corner C=4 with a[i][j+4] = a[i][j]+1, random values", |b| {
        let next = || {
            seed = (seed + 1) % 20;
            seed
        };
        b.iter_batched(
            next,
            |seed| find(black_box(random(seed)), &Settings::PLAIN).unwrap(),
            BatchSize::PerIteration,
        );
    });
    group.finish();
}

/// The naive engine on the same problem: corner C=2, all packings.
fn against_naive(c: &mut Criterion) {
    let mut group = c.benchmark_group("corner C=2, all");
    let corner = task(Kind::Corner, 2, Members::Complete, "");
    let job = plain(&corner);
    group.bench_function("search", |b| {
        b.iter(|| count(job.clone(), &Settings::PLAIN, false).unwrap());
    });
    group.bench_function("naive", |b| {
        b.iter(|| {
            let mut found = 0;
            naive::search(16, 2, &mut |prefix| tiles_differ(prefix), &mut |_| found += 1);
            assert_eq!(found, 32);
        });
    });
    group.finish();
}

/// Whether the windows known from the first points of a 4x4 torus over two colors differ.
fn tiles_differ(prefix: &[u8]) -> bool {
    let at = |row: usize, column: usize| prefix.get(row % 4 * 4 + column % 4).copied();
    let mut seen = [false; 16];
    (0..16).all(|cell| {
        let (r, c) = (cell / 4, cell % 4);
        let corners = [at(r, c), at(r, c + 1), at(r + 1, c), at(r + 1, c + 1)];
        let [Some(a), Some(b), Some(c), Some(d)] = corners else { return true };
        let tile = usize::from(a) * 8 + usize::from(b) * 4 + usize::from(c) * 2 + usize::from(d);
        !std::mem::replace(&mut seen[tile], true)
    })
}

criterion_group!(benches, counts, prefixes, firsts, against_naive);
criterion_main!(benches);
