use super::*;

/// A formula of random clauses, as lists of signed variables from 1.
fn random(state: &mut u64, variables: u32, clauses: usize) -> Vec<Vec<i32>> {
    let mut next = |bound: u32| {
        *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (*state >> 33) as u32 % bound
    };
    let mut literal = || (next(variables) as i32 + 1) * [1, -1][next(2) as usize];
    (0..clauses).map(|i| (0..2 + i % 3).map(|_| literal()).collect()).collect()
}

fn literal(signed: i32) -> Literal {
    Literal::new(signed.unsigned_abs() - 1, signed > 0)
}

/// Whether some values make all clauses hold.
fn possible(variables: u32, clauses: &[Vec<i32>]) -> bool {
    (0..1u32 << variables).any(|values| {
        let holds = |&l: &i32| (values >> (l.unsigned_abs() - 1) & 1 == 1) == (l > 0);
        clauses.iter().all(|clause| clause.iter().any(holds))
    })
}

#[test]
fn the_answers_are_those_of_all_values() {
    let mut state = 7;
    let mut verdicts = [0, 0];
    for round in 0..600 {
        let variables = 4 + round % 8;
        let clauses = random(&mut state, variables, (3 * variables + round % 9) as usize);
        let mut solver = Solver::new(variables as usize);
        for clause in &clauses {
            solver.add(&clause.iter().map(|&l| literal(l)).collect::<Vec<_>>());
        }
        // The same solver is asked several times, under different assumptions.
        for assumed in [vec![], vec![1, -2, 3], vec![-1, 4], vec![2, 3, -4, 1]] {
            let literals: Vec<Literal> = assumed.iter().map(|&l| literal(l)).collect();
            let with = |some: &[i32]| {
                [&clauses[..], &some.iter().map(|&l| vec![l]).collect::<Vec<_>>()].concat()
            };
            match solver.solve(&literals, &()) {
                Answer::Model => {
                    let holds = |&l: &i32| solver.holds(literal(l));
                    assert!(with(&assumed).iter().all(|clause| clause.iter().any(holds)));
                    verdicts[0] += 1;
                }
                Answer::Failed(failed) => {
                    assert!(failed.iter().all(|l| literals.contains(l)));
                    let signed: Vec<i32> =
                        assumed.iter().copied().filter(|&l| failed.contains(&literal(l))).collect();
                    assert!(!possible(variables, &with(&signed)));
                    verdicts[1] += 1;
                }
                Answer::Stopped => unreachable!("nobody asked to stop"),
            }
        }
    }
    assert!(verdicts.iter().all(|&n| n > 300), "{verdicts:?}");
}

/// `pigeons` in one hole less.
fn crowded(pigeons: u32) -> Solver {
    let holes = pigeons - 1;
    let mut solver = Solver::new((pigeons * holes) as usize);
    let sits = |pigeon: u32, hole: u32| Literal::new(pigeon * holes + hole, true);
    solver.keep_record();
    for pigeon in 0..pigeons {
        solver.add(&(0..holes).map(|hole| sits(pigeon, hole)).collect::<Vec<_>>());
        for other in 0..pigeon {
            (0..holes).for_each(|hole| solver.add(&[!sits(pigeon, hole), !sits(other, hole)]));
        }
    }
    solver
}

#[test]
fn pigeons_need_a_search_that_learns_and_forgets() {
    let mut solver = crowded(8);
    assert_eq!(solver.solve(&[], &()), Answer::Failed(vec![]));
    assert!(solver.conflicts() > 1000);
    assert_eq!(solver.record().unwrap().learned.last(), Some(&vec![]));
    let stop = std::sync::atomic::AtomicBool::new(true);
    assert_eq!(crowded(11).solve(&[], &stop), Answer::Stopped);
}

#[test]
fn luby_is_as_printed() {
    let first: Vec<u64> = (1..=15).map(luby).collect();
    assert_eq!(first, [1, 1, 2, 1, 1, 2, 4, 1, 1, 2, 1, 1, 2, 4, 8]);
}
