//! All fillings of a small rectangle, one after the other, checked window by window.

use tilepack::dappled::{FREE, Field, Rule};

/// All tilings that keep a rule and agree with the cells given, in lexicographic order.
pub(crate) fn tilings(rule: &Rule, given: Option<&Field>) -> Vec<Field> {
    let windows: Vec<_> = rule.windows().collect();
    let cells = rule.width() * rule.height();
    let tiles = rule.tiles() as u8;
    let mut all = Vec::new();
    let mut field = vec![0u8; cells];
    loop {
        let fits = given.is_none_or(|given| {
            given.cells().iter().zip(&field).all(|(&given, &tile)| given == FREE || given == tile)
        });
        let broken = |set: u64, cells: &[u32]| {
            cells.iter().all(|&cell| set >> field[cell as usize] & 1 == 1)
        };
        if fits && !windows.iter().any(|window| broken(window.set, &window.cells)) {
            all.push(Field::new(rule.width(), rule.height(), field.clone()).unwrap());
        }
        let Some(last) = field.iter().rposition(|&tile| tile + 1 < tiles) else { return all };
        field[last] += 1;
        field[last + 1..].fill(0);
    }
}
