//! Two quilts woven into one along the cheapest cut (Kwatra et al. 2003).
//!
//! Every place shows the texel of the first quilt or of the second. What is paid is the sum of
//! the prices of all steps ([`Stock::price`]), those over seams that either quilt has of itself
//! included: so a cut is worth more where it removes an old seam. With two labels and prices
//! between neighbors that is a cheapest cut in a grid (Kolmogorov and Zabih 2004), if taking
//! turns is never cheaper than keeping to one side. Prices by gradients break that now and then;
//! turns are then made as dear as needed, which is exact everywhere else.

use super::flow::Grid;
use super::quilt::Quilt;
use super::stock::{Stock, Texel};

/// Where a place has to show one of the quilts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hold {
    /// Either will do.
    Free,
    /// The first.
    First,
    /// The second.
    Second,
}

/// Which places show the second quilt, and what is paid for all steps.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Woven {
    /// By place, row by row.
    pub second: Vec<bool>,
    /// The sum of the prices.
    pub price: u64,
}

/// Prices of a step with the first (0) or second (1) quilt before and after it.
type Prices = [[i64; 2]; 2];

/// The prices of a step, such that taking turns is never cheaper.
fn prices(stock: &Stock, before: [Texel; 2], after: [Texel; 2], step: usize) -> Prices {
    let mut prices = before.map(|a| after.map(|b| i64::from(stock.price(a, b, step))));
    let lack = prices[0][0] + prices[1][1] - prices[0][1] - prices[1][0];
    if lack > 0 {
        prices[0][1] += (lack + 1) / 2;
        prices[1][0] += lack / 2;
    }
    prices
}

/// Weaves two quilts of one size, where `hold` leaves it open.
pub fn weave(stock: &Stock, first: &Quilt, other: &Quilt, hold: &[Hold]) -> Woven {
    let (width, height) = (first.width, first.height);
    let mut grid = Grid::new(width, height);
    // What showing the second quilt costs more than showing the first.
    let mut more = vec![0i64; width * height];
    for (p, q, step) in first.pairs(stock) {
        if hold[p] != Hold::Free && hold[q] != Hold::Free {
            continue;
        }
        let before = [first.texels[p], other.texels[p]];
        let after = [first.texels[q], other.texels[q]];
        let [[a, b], [c, d]] = prices(stock, before, after, step);
        match (hold[p], hold[q]) {
            (Hold::First, _) => more[q] += b - a,
            (Hold::Second, _) => more[q] += d - c,
            (_, Hold::First) => more[p] += c - a,
            (_, Hold::Second) => more[p] += d - b,
            _ => {
                more[p] += c - a;
                more[q] += d - c;
                let turn = (b + c - a - d) as i32;
                let (x, y) = (p % width, p / width);
                match step {
                    1 => grid.join_east(x, y, turn, 0),
                    _ => grid.join_south(x, y, turn, 0),
                }
            }
        }
    }
    for (at, &more) in more.iter().enumerate() {
        if hold[at] == Hold::Free {
            let (dear, cheap) = (more.max(0) as i32, (-more).max(0) as i32);
            grid.join_ends(at % width, at / width, dear, cheap);
        }
    }
    let cut = grid.solve().sink;
    let chosen: Vec<bool> = hold
        .iter()
        .zip(cut)
        .map(|(hold, sink)| match hold {
            Hold::Free => sink,
            Hold::First => false,
            Hold::Second => true,
        })
        .collect();
    let price = price(stock, first, other, &chosen);
    Woven { second: chosen, price }
}

/// What is paid for a choice, by the prices that the cut goes by.
pub fn price(stock: &Stock, first: &Quilt, second: &Quilt, chosen: &[bool]) -> u64 {
    let of_pair = |(p, q, step)| {
        let before = [first.texels[p], second.texels[p]];
        let after = [first.texels[q], second.texels[q]];
        prices(stock, before, after, step)[usize::from(chosen[p])][usize::from(chosen[q])] as u64
    };
    first.pairs(stock).map(of_pair).sum()
}

impl Woven {
    /// The quilt that shows what was chosen.
    pub fn quilt(&self, first: &Quilt, second: &Quilt) -> Quilt {
        let texels = self.second.iter().zip(first.texels.iter().zip(&second.texels));
        let texels = texels.map(|(&other, (&a, &b))| if other { b } else { a }).collect();
        Quilt { width: first.width, height: first.height, texels }
    }
}
