#![allow(clippy::unwrap_used)]
use tilepack::packing::*;
use tilepack::symmetry::*;
use tilepack::tiles::*;
use tilepack::torus::*;

fn task(kind: Kind, c: u64, members: Members, size: Option<(u64, u64)>) -> Task {
    let set = TileSet::new(kind, Colors::one(c).unwrap(), members).unwrap();
    let shape = match size {
        Some((w, h)) => Shape::new(w, h).unwrap(),
        None => Shape::default_for(&set).unwrap(),
    };
    Task::new(set, shape)
}

#[test]
fn quick() {
    let plain = Settings { reduce: false, ..Settings::PLAIN };
    for (kind, c, m, size) in [
        (Kind::Corner, 2, Members::Complete, None),
        (Kind::Wang, 2, Members::Complete, None),
        (Kind::Domino, 3, Members::Complete, None),
        (Kind::Domino, 4, Members::Complete, None),
        (Kind::Corner, 2, Members::Compact, None),
        (Kind::Wang, 2, Members::Compact, None),
    ] {
        let t = task(kind, c, m, size);
        let t0 = std::time::Instant::now();
        let a = count(&t, &Settings::PLAIN, false).unwrap();
        let t1 = std::time::Instant::now();
        let b = count(&t, &plain, false).unwrap();
        let t2 = std::time::Instant::now();
        let d = count(&t, &Settings::PLAIN, true).unwrap();
        println!(
            "{kind} {c} {:?} {:?} reduced {} nodes {} {:?}; plain {} nodes {} {:?} {:.1} M/s; fundamental {:?}",
            t.set.members(),
            t.shape.to_string(),
            a.value.packings,
            a.work.nodes,
            t1 - t0,
            b.value.packings,
            b.work.nodes,
            t2 - t1,
            b.work.nodes as f64 / (t2 - t1).as_secs_f64() / 1e6,
            d.value.fundamental
        );
    }
    for (kind, c, m, auto) in [
        (Kind::Corner, 3, Members::Complete, None),
        (Kind::Corner, 3, Members::Compact, None),
        (Kind::Wang, 3, Members::Complete, None),
        (Kind::Corner, 4, Members::Complete, Some("4,0:1,2,3,0")),
        (Kind::Corner, 4, Members::Compact, Some("4,0:1,2,3,0")),
    ] {
        let mut t = task(kind, c, m, None);
        t.automorphism = auto.map(|a| Automorphism::parse(a, t.set.colors(), t.shape).unwrap());
        for random in [None, Some(1), Some(2), Some(3)] {
            if auto.is_some() && random.is_none() {
                continue;
            }
            let t0 = std::time::Instant::now();
            let a = find(&t, &Settings { random, ..Settings::PLAIN }).unwrap();
            println!(
                "{kind} {c} {:?} {random:?} found {} nodes {} deepest {} {:?}",
                t.set.members(),
                a.value.is_some(),
                a.work.nodes,
                a.work.deepest,
                t0.elapsed()
            );
        }
    }
}
