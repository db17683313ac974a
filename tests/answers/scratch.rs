use crate::table::Words;
use tilepack::packing::*;
#[test]
fn scratch() {
    for s in ["32x1", "16x2", "8x4", "4x8", "2x16", "11x3", "3x11"] {
        let mut t = Words("corner", "3", "pruned:0-1", s, "").task();
        t.cover = true;
        for o in [tilepack::torus::Order::Row, tilepack::torus::Order::Column] {
            t.order = Some(o);
            let t0 = std::time::Instant::now();
            let stop = std::time::Instant::now() + std::time::Duration::from_secs(20);
            let st = Settings {
                limits: tilepack::search::Limits { stop: &stop, nodes: u64::MAX },
                ..Settings::PLAIN
            };
            let a = find(&t, &st).unwrap();
            println!("{s} {o} {:?} {:?} {:?}", a.value.is_some(), a.work, t0.elapsed());
        }
    }
}
