//! Quilts woven along cheapest cuts, against all ways to weave them.

use crate::{GRAY, RGB, noise};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use tilepack::texture::staircase::staircase;
use tilepack::texture::weave::{Hold, price, weave};
use tilepack::texture::{Quilt, Stock, Texel};

/// A quilt of a patch at a place of the first example.
fn patch(stock: &Stock, (x, y): (usize, usize), width: usize, height: usize) -> Quilt {
    Quilt::new(width, height, |u, v| stock.texel(x + u, stock.places()[0].top + y + v))
}

#[test]
fn no_other_choice_costs_less() {
    let mut random = Pcg64::seed_from_u64(2);
    for round in 0..60 {
        let format = if round % 2 == 0 { GRAY } else { RGB };
        let stock = Stock::new(vec![vec![noise(24, 24, format, round)]], None).unwrap();
        let (width, height) = (random.random_range(2..6), random.random_range(2..6));
        let mut place = || (random.random_range(0..18), random.random_range(0..18));
        let (a, b, c) = (place(), place(), place());
        let (mut first, second) =
            (patch(&stock, a, width, height), patch(&stock, b, width, height));
        // A seam of old in the first, that a cut may hide.
        let old = patch(&stock, c, width, height);
        for at in (0..width * height).filter(|at| at % width >= width / 2) {
            first.texels[at] = old.texels[at];
        }
        let mut free = 0;
        let hold: Vec<Hold> = (0..width * height)
            .map(|at| match random.random_range(0..8) {
                0 => Hold::First,
                1 => Hold::Second,
                _ if free < 12 => {
                    free += 1;
                    Hold::Free
                }
                _ if at % 2 == 0 => Hold::First,
                _ => Hold::Second,
            })
            .collect();
        let places: Vec<usize> = (0..hold.len()).filter(|&at| hold[at] == Hold::Free).collect();
        let all = (0..1u32 << places.len()).map(|bits| {
            let mut chosen: Vec<bool> = hold.iter().map(|&hold| hold == Hold::Second).collect();
            for (bit, &at) in places.iter().enumerate() {
                chosen[at] = bits >> bit & 1 == 1;
            }
            price(&stock, &first, &second, &chosen)
        });
        let woven = weave(&stock, &first, &second, &hold);
        assert_eq!(woven.price, all.min().unwrap(), "round {round}");
        for (at, &second) in woven.second.iter().enumerate() {
            assert!(hold[at] == Hold::Free || second == (hold[at] == Hold::Second));
        }
    }
}

#[test]
fn pieces_of_one_picture_come_back_together() {
    let stock = Stock::new(vec![vec![noise(40, 40, RGB, 5)]], None).unwrap();
    let whole = patch(&stock, (3, 4), 20, 20);
    let woven = weave(&stock, &whole, &whole.clone(), &vec![Hold::Free; 400]);
    assert_eq!(woven.price, 0);
    assert_eq!(whole.seams(&stock).count(), 0);
    // What is drawn is what lies there.
    let drawn = whole.draw(&stock, 0);
    assert_eq!(drawn, stock.images(0)[0].part(3, 4, 20, 20));
}

#[test]
fn steps_in_an_example_cost_nothing_and_others_do() {
    let images = vec![vec![noise(9, 7, GRAY, 1)], vec![noise(12, 5, GRAY, 2)]];
    let stock = Stock::new(images, None).unwrap();
    let all: Vec<Texel> = stock.all().collect();
    assert_eq!(all.len(), 9 * 7 + 12 * 5);
    assert_eq!(stock.texels(), all.len());
    for &a in &all {
        let (example, x, y) = stock.locate(a);
        let place = stock.places()[example];
        assert!(x < place.width && y < place.height);
        assert_eq!(stock.texel(x, place.top + y), a);
        for &b in &all {
            for step in [1, stock.stride()] {
                let beside = b == a + step as Texel;
                assert_eq!(stock.price(a, b, step) == 0, beside, "{a} {b}");
                assert!(!beside || stock.mismatch(a, b, step) == 0);
            }
        }
    }
}

/// All staircases, the slow way.
fn all_staircases(at: (usize, usize), radius: usize, price: &dyn Fn(usize, usize) -> u64) -> u64 {
    let end = radius - 1;
    let (u, v) = at;
    let line = |at: usize| (2 * at + 1) * (2 * at + 1);
    let outside = u > end || v > end;
    if outside || !(line(u) + line(v) < 4 * radius * radius || u + v == end) {
        return u64::MAX;
    }
    if at == (end, 0) {
        return price(u, v);
    }
    let mut next = vec![(u + 1, v)];
    if v > 0 {
        next.extend([(u, v - 1), (u + 1, v - 1)]);
    }
    let least = next.into_iter().map(|at| all_staircases(at, radius, price)).min().unwrap();
    least.saturating_add(price(u, v))
}

#[test]
fn staircases_are_the_cheapest() {
    let mut random = Pcg64::seed_from_u64(3);
    for radius in [2, 3, 4, 5, 6, 7] {
        for _ in 0..20 {
            let prices: Vec<u64> =
                (0..radius * radius).map(|_| random.random_range(0..50u64)).collect();
            let price = |u: usize, v: usize| prices[v * radius + u];
            let columns = staircase(radius, price);
            // It begins and ends on the lines through the middle and never steps back.
            assert!(columns[0] == radius && columns[radius - 1] > 0);
            assert!(columns.windows(2).all(|pair| pair[0] >= pair[1]));
            // The cheapest way along it: where it turns, the corner may be left out.
            let paid = all_staircases((0, radius - 1), radius, &|u, v| {
                let within = u < columns[v];
                let border = within && (v + 1 == radius || u >= columns[v + 1].saturating_sub(1));
                if border { price(u, v) } else { 1 << 40 }
            });
            assert_eq!(paid, all_staircases((0, radius - 1), radius, &price), "{columns:?}");
        }
    }
}
