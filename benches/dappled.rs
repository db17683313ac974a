//! Dappled tilings: cells a second of `make`, in both orders, against the algorithm as it is written
//! down, which looks back along both lines at every cell.
//!
//! Run with one thread (`RAYON_NUM_THREADS=1`) to compare orders on one core.

#![allow(clippy::unwrap_used, missing_docs)]

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use std::time::Duration;
use tilepack::dappled::make::{Options, Order, pass, start};
use tilepack::dappled::{Edges, FREE, Field, Rule, faults};

const SIDE: usize = 2000;

/// Algorithm 1, limits `p` and `q`, one anti-diagonal after the other.
fn obvious(field: &mut Field, p: usize, q: usize) {
    let (m, n) = (field.width(), field.height());
    let violates = |field: &Field, i: usize, j: usize| {
        let t = field.at(i, j);
        i >= p && (1..=p).all(|back| field.at(i - back, j) == t)
            || j >= q && (1..=q).all(|back| field.at(i, j - back) == t)
    };
    for weight in 0..m + n - 1 {
        for i in (weight + 1).saturating_sub(n)..m.min(weight + 1) {
            let j = weight - i;
            if violates(field, i, j) {
                field.set(i, j, 1 - field.at(i, j));
                if violates(field, i, j) {
                    let s = field.at(i - 1, j - 1);
                    field.set(i, j, s);
                    field.set(i - 1, j, 1 - s);
                    field.set(i, j - 1, 1 - s);
                }
            }
        }
    }
}

fn dappled(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("dappled");
    group.sample_size(10).measurement_time(Duration::from_secs(2));
    group.throughput(Throughput::Elements((SIDE * SIDE) as u64));
    let free = || Field::filled(SIDE, SIDE, FREE).unwrap();
    group.bench_function("random start", |bencher| {
        let fill = |mut field| {
            start::fill_randomly(&mut field, 2, 1);
            field
        };
        bencher.iter_batched(free, fill, BatchSize::LargeInput);
    });
    for limit in [2, 6] {
        let rule = Rule::uniform((SIDE, SIDE), 2, Edges::Free, Some(limit), Some(limit)).unwrap();
        let mut random = free();
        start::fill_randomly(&mut random, 2, 1);
        let setup = || random.clone();
        for order in [Order::Diagonal, Order::Wavefront] {
            group.bench_function(format!("limit {limit}, {order:?}"), |bencher| {
                let make = |field| pass(&rule, field, Options { order, seed: 0 });
                bencher.iter_batched(setup, make, BatchSize::LargeInput);
            });
        }
        group.bench_function(format!("limit {limit}, obvious"), |bencher| {
            let make = |mut field| {
                obvious(&mut field, limit as usize, limit as usize);
                field
            };
            bencher.iter_batched(setup, make, BatchSize::LargeInput);
        });
        let (made, _, _) = pass(&rule, setup(), Options { order: Order::Diagonal, seed: 0 });
        group.bench_function(format!("limit {limit}, check"), |bencher| {
            bencher.iter(|| faults::is_faultless(black_box(&rule), black_box(&made)));
        });
    }
    group.finish();
}

criterion_group!(benches, dappled);
criterion_main!(benches);
