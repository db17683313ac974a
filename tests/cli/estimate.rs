//! `estimate`: the fields of the contract, the same seed the same numbers, exactness, limits.

use crate::{names, run};

const PROBED: &str = "estimate --kind wang --colors 2 --node-limit 60000";

#[test]
fn fields() {
    let object = run(&format!("{PROBED} --seed 3 --json")).exits(0).json();
    assert_eq!(
        names(&object),
        [
            "core_years",
            "exact",
            "method",
            "nodes",
            "nodes_high",
            "nodes_low",
            "nodes_per_second",
            "nodes_probed",
            "reason",
            "replicates",
            "result",
            "seconds",
            "seed",
            "solutions",
            "solutions_high",
            "solutions_low",
            "stopped_by",
        ]
    );
    let number = |name: &str| object[name].as_str().unwrap().parse::<f64>().unwrap();
    for (name, truth) in [("nodes", 537_503.0), ("solutions", 203_520.0)] {
        let (low, high) = (number(&format!("{name}_low")), number(&format!("{name}_high")));
        assert!(low < number(name) && number(name) < high && high < 2.0 * truth, "{object}");
    }
    assert_eq!((&object["result"], &object["method"]), (&"complete".into(), &"probes".into()));
    assert_eq!((object["seed"].as_u64(), object["replicates"].as_u64()), (Some(3), Some(64)));
    assert!(object["core_years"].as_f64().unwrap() > 0.0);
}

#[test]
fn the_seed_decides_and_threads_do_not() {
    let result = |options: &str| {
        let text = run(&format!("{PROBED} {options}")).exits(0).stdout;
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        assert_eq!(lines.len(), 4, "{text}");
        assert!(lines[3].starts_with("an exact count would take "), "{text}");
        lines[..3].to_vec()
    };
    let one = result("--seed 5 --threads 1");
    assert_eq!(one, result("--seed 5 --threads 2"));
    assert_eq!(one, result("--seed 5 --threads 3"));
    assert_ne!(one[0], result("--seed 6")[0]);
    assert!(one[0].starts_with("about ") && one[0].ends_with(") packings"), "{one:?}");
    assert!(one[1].ends_with(" nodes in the search tree of count"), "{one:?}");
    assert!(one[2].ends_with("seed 5; intervals of 95 %"), "{one:?}");
}

#[test]
fn small_trees_are_exact() {
    let object = run("estimate --kind corner --colors 2 --json").exits(0).json();
    for name in ["solutions", "solutions_low", "solutions_high"] {
        assert_eq!(object[name], "32");
    }
    assert_eq!((&object["nodes"], &object["nodes_low"]), (&"176".into(), &"176".into()));
    assert_eq!((&object["exact"], &object["method"]), (&true.into(), &"search".into()));
    let words = run("estimate --kind corner --colors 2").exits(0);
    assert!(words.stdout.starts_with("32 packings\n176 nodes"), "{words:?}");
    let none = run("estimate --kind corner --colors 2 --size 8x2 --json").exits(1).json();
    assert_eq!((&none["solutions"], &none["exact"]), (&"0".into(), &true.into()));
}

#[test]
fn where_no_probe_reaches_a_packing() {
    let args = "estimate --kind corner --colors 4 --node-limit 200000";
    let object = run(&format!("{args} --json")).exits(0).json();
    assert!(object["solutions"].is_null() && object["solutions_high"].is_null(), "{object}");
    assert!(object["nodes"].is_string());
    let words = run(args).exits(0).stdout;
    assert!(
        words.starts_with("packings: no probe reached one, so there is no estimate"),
        "{words}"
    );
}

#[test]
fn stopped_early() {
    let args = "estimate --kind corner --colors 3 --time-limit 700ms";
    let stopped = run(args).exits(75);
    assert!(stopped.stderr.contains("stopped early by the time limit"), "{stopped:?}");
    let object = run(&format!("{args} --json --quiet")).exits(75).json();
    assert_eq!(
        (&object["result"], &object["stopped_by"]),
        (&"stopped".into(), &"time-limit".into())
    );
}
