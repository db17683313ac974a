//! Time of the constructions: cells a second row by row, tiles a second looked up, compact sets
//! constructed and annealed, and tiles of endless tilings a second.

#![allow(missing_docs, clippy::unwrap_used)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tilepack::anneal::compact_corner;
use tilepack::construct::{Constructed, construct};
use tilepack::search::Limits;
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
use tilepack::tiling::{Coloring, Compact, Halton, Permuted, Sums, Tiling};
use tilepack::torus::Shape;

fn set(kind: Kind, colors: u64, members: Members) -> TileSet {
    TileSet::new(kind, Colors::one(colors).unwrap(), members).unwrap()
}

fn constructed(kind: Kind, colors: u64) -> Constructed {
    let set = set(kind, colors, Members::Complete);
    construct(&set, Shape::default_for(&set).unwrap(), None).unwrap()
}

/// Every row of the lattice into one buffer; and the tiles between the rows.
fn rows(c: &mut Criterion) {
    let mut group = c.benchmark_group("rows");
    group.sample_size(10);
    for (name, kind, colors) in [
        ("corner C=64", Kind::Corner, 64),
        ("corner C=63", Kind::Corner, 63),
        ("wang C=64", Kind::Wang, 64),
    ] {
        let packing = constructed(kind, colors);
        let (width, height) = (packing.shape().width(), packing.shape().height());
        let mut labels = vec![0; if kind == Kind::Wang { 2 * width } else { width }];
        group.throughput(Throughput::Elements((width * height) as u64));
        group.bench_function(format!("{name}, colors"), |b| {
            b.iter(|| {
                for row in 0..height {
                    packing.row(row, &mut labels);
                    black_box(&mut labels);
                }
            });
        });
        group.bench_function(format!("{name}, tiles"), |b| {
            b.iter(|| {
                packing.try_for_each_row(|_, tiles| {
                    black_box(tiles);
                    Ok::<_, ()>(())
                })
            });
        });
    }
    group.finish();
}

/// Where tiles lie, in an order without pattern.
fn locate(c: &mut Criterion) {
    let mut group = c.benchmark_group("locate");
    const LOOKED_UP: u64 = 1 << 16;
    group.throughput(Throughput::Elements(LOOKED_UP));
    for (name, kind, colors) in [
        ("corner C=64", Kind::Corner, 64),
        ("corner C=63", Kind::Corner, 63),
        ("wang C=64", Kind::Wang, 64),
    ] {
        let packing = constructed(kind, colors);
        let tiles: Vec<TileId> = (0..LOOKED_UP)
            .map(|i| TileId((i * 0x9e37_79b9_7f4a_7c15 % packing.shape().cells() as u64) as u32))
            .collect();
        group.bench_function(name, |b| {
            b.iter(|| {
                let places = tiles.iter().map(|&tile| packing.locate(tile).unwrap());
                places.fold(0, |sum, (row, column)| sum ^ row ^ column)
            });
        });
    }
    group.finish();
}

/// Whole compact sets.
fn compact(c: &mut Criterion) {
    let mut group = c.benchmark_group("compact");
    group.sample_size(10);
    for (kind, colors) in
        [(Kind::Corner, 12), (Kind::Corner, 16), (Kind::Corner, 32), (Kind::Wang, 16)]
    {
        let set = set(kind, colors, Members::Compact);
        let shape = Shape::default_for(&set).unwrap();
        group.throughput(Throughput::Elements(set.size()));
        group.bench_function(format!("{kind} C={colors}, {shape}, constructed"), |b| {
            b.iter(|| construct(&set, shape, None).unwrap());
        });
    }
    let shape = Shape::new(9, 6).unwrap();
    let mut seed = 0;
    group.bench_function("corner C=3, 9x6, annealed", |b| {
        b.iter(|| {
            seed += 1;
            compact_corner(3, shape, seed, &Limits::NONE)
        });
    });
    group.finish();
}

/// Windows of endless tilings, row by row.
fn tilings(c: &mut Criterion) {
    let mut group = c.benchmark_group("tilings");
    group.sample_size(10);
    let shape = Shape::new(4096, 1024).unwrap();
    group.throughput(Throughput::Elements(shape.cells() as u64));
    let compact = |colors: usize| Coloring::Compact(Compact::of(colors, 1).unwrap());
    let grid = Halton::of_tiles(Kind::Corner, Shape::new(4096, 4096).unwrap()).unwrap();
    let one_hash = Sums::one_hash(Colors::one(3).unwrap(), 1).unwrap();
    for (name, kind, colors, coloring) in [
        ("corner hash C=3", Kind::Corner, 3, Coloring::Hash { seed: 1 }),
        ("wang hash C=3", Kind::Wang, 3, Coloring::Hash { seed: 1 }),
        ("wang compact C=3", Kind::Wang, 3, Coloring::Sums(one_hash)),
        ("corner halton C=6", Kind::Corner, 6, Coloring::Halton(grid)),
        ("corner compact C=3", Kind::Corner, 3, compact(3)),
        ("corner compact C=4", Kind::Corner, 4, compact(4)),
        ("corner compact C=5", Kind::Corner, 5, compact(5)),
        ("corner long period C=3", Kind::Corner, 3, Coloring::Permuted(Permuted::long(1))),
    ] {
        let tiling = Tiling::new(kind, Colors::one(colors).unwrap(), coloring).unwrap();
        group.bench_function(name, |b| {
            b.iter(|| {
                tiling.try_for_each_row(-100, 77, shape, |_, row| {
                    black_box(row);
                    Ok::<_, ()>(())
                })
            });
        });
    }
    group.finish();
}

criterion_group!(benches, rows, locate, compact, tilings);
criterion_main!(benches);
