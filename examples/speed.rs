#![allow(clippy::unwrap_used, missing_docs)]
use tilepack::packing::*;
use tilepack::search::*;
use tilepack::symmetry::*;
use tilepack::tiles::*;
use tilepack::torus::*;
fn task(kind: Kind, c: u64, members: Members) -> Task {
    let set = TileSet::new(kind, Colors::one(c).unwrap(), members).unwrap();
    let shape = Shape::default_for(&set).unwrap();
    Task::new(set, shape)
}
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let which = args[1].as_str();
    let limit: u64 = args.get(2).map_or(u64::MAX, |s| s.parse().unwrap());
    let threads: usize = args.get(3).map_or(1, |s| s.parse().unwrap());
    let mut t = match which {
        "wang2" => task(Kind::Wang, 2, Members::Complete),
        "corner3" | "quot3" => task(Kind::Corner, 3, Members::Complete),
        "corner4" => task(Kind::Corner, 4, Members::Complete),
        "compact3" => task(Kind::Corner, 3, Members::Compact),
        _ => panic!(),
    };
    if which == "quot3" { t.automorphism = Some(Automorphism::parse("3,0:+1", t.set.colors(), t.shape).unwrap()); }
    let s = Settings { threads, reduce: which != "wang2", limits: Limits { stop: &(), nodes: limit }, ..Settings::PLAIN };
    let t0 = std::time::Instant::now();
    let a = count(&t, &s, false).unwrap();
    let d = t0.elapsed().as_secs_f64();
    println!("{which} packings {} nodes {} {d:.3} s {:.1} M/s deepest {}", a.value.packings, a.work.nodes, a.work.nodes as f64 / d / 1e6, a.work.deepest);
}
