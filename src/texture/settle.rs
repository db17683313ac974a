//! Where patches are taken from the examples, so that they go together.
//!
//! Patches that will lie side by side overlap in a band. There both show a texel for each place, and
//! the difference of the two, in some random places of every band, is what a choice of positions
//! costs. It is made small by a walk that moves one patch at a time and never goes uphill. Equal
//! patches would fit best and show nothing new, so what patches share of an example costs, too.

use super::stock::{Stock, Texel};
use rand::RngExt;
use rand_pcg::Pcg64;

/// A patch to be placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Site {
    /// The example it is taken from.
    pub example: usize,
    /// Texels that it reaches from its middle in each direction.
    pub reach: usize,
}

/// A band in which two patches overlap.
#[derive(Debug, Clone)]
pub struct Contact {
    /// The two sites; they may be the same.
    pub sites: [usize; 2],
    /// Places of the band, from the middle of either patch.
    pub places: Vec<[(isize, isize); 2]>,
}

/// Patches may share this part of their area for nothing.
const SHARED: f64 = 0.2;
/// What sharing all costs, in mean differences of texels side by side for each place of a band.
const DEAR: f64 = 12.0;

/// The positions of patches on the board as they are moved.
pub struct Settling<'a> {
    stock: &'a Stock,
    sites: &'a [Site],
    contacts: Vec<([usize; 2], Vec<[isize; 2]>)>,
    /// For each site its contacts.
    of_site: Vec<Vec<usize>>,
    gradient: f64,
    /// Columns and rows of the middles.
    at: Vec<(usize, usize)>,
}

impl<'a> Settling<'a> {
    /// Begins with patches anywhere. Every example is larger than its patches.
    pub fn new(
        stock: &'a Stock,
        sites: &'a [Site],
        contacts: &[Contact],
        random: &mut Pcg64,
    ) -> Self {
        let stride = stock.stride() as isize;
        let linear = |(x, y): (isize, isize)| y * stride + x;
        let mut of_site = vec![Vec::new(); sites.len()];
        for (at, contact) in contacts.iter().enumerate() {
            of_site[contact.sites[0]].push(at);
            if contact.sites[1] != contact.sites[0] {
                of_site[contact.sites[1]].push(at);
            }
        }
        let contacts = contacts
            .iter()
            .map(|contact| (contact.sites, contact.places.iter().map(|p| p.map(linear)).collect()));
        let mut settling = Self {
            stock,
            sites,
            contacts: contacts.collect(),
            of_site,
            gradient: stock.mean_gradient(),
            at: Vec::new(),
        };
        settling.at = (0..sites.len()).map(|site| settling.anywhere(site, random)).collect();
        settling
    }

    /// Columns and rows where the middle of a patch may be: the first of each, and how many.
    fn range(&self, site: usize) -> [(usize, usize); 2] {
        let Site { example, reach } = self.sites[site];
        let place = self.stock.places()[example];
        [(reach, place.width - 2 * reach + 1), (place.top + reach, place.height - 2 * reach + 1)]
    }

    fn anywhere(&self, site: usize, random: &mut Pcg64) -> (usize, usize) {
        let [(left, columns), (top, rows)] = self.range(site);
        (left + random.random_range(0..columns), top + random.random_range(0..rows))
    }

    /// A place some texels from where the patch is.
    fn nearby(&self, site: usize, random: &mut Pcg64) -> (usize, usize) {
        let far = 1 << random.random_range(0..5);
        let [(left, columns), (top, rows)] = self.range(site);
        let mut moved = |at: usize, first: usize, count: usize| {
            let to = at as i64 + random.random_range(-far..=far);
            to.clamp(first as i64, (first + count - 1) as i64) as usize
        };
        let (x, y) = self.at[site];
        (moved(x, left, columns), moved(y, top, rows))
    }

    /// Tries some moves; gives the positions as texels, and what they cost.
    pub fn walk(mut self, moves: usize, random: &mut Pcg64) -> (Vec<Texel>, f64) {
        for step in 0..moves {
            let site = random.random_range(0..self.sites.len());
            let before = self.cost_of(site);
            // At first far, later near.
            let far = random.random_range(0..moves) > step;
            let to = if far { self.anywhere(site, random) } else { self.nearby(site, random) };
            let from = std::mem::replace(&mut self.at[site], to);
            if self.cost_of(site) > before {
                self.at[site] = from;
            }
        }
        let contacts: f64 = (0..self.contacts.len()).map(|at| self.cost_of_contact(at)).sum();
        let shared: f64 = (0..self.sites.len()).map(|site| self.shared(site)).sum();
        let positions = self.at.iter().map(|&(x, y)| self.stock.texel(x, y)).collect();
        (positions, contacts + shared / 2.0)
    }

    fn cost_of(&self, site: usize) -> f64 {
        let contacts = self.of_site[site].iter().map(|&at| self.cost_of_contact(at));
        contacts.sum::<f64>() + self.shared(site)
    }

    fn cost_of_contact(&self, at: usize) -> f64 {
        let (sites, places) = &self.contacts[at];
        let [a, b] = sites.map(|site| {
            let (x, y) = self.at[site];
            self.stock.texel(x, y) as isize
        });
        let difference = |p: &[isize; 2]| {
            u64::from(self.stock.difference((a + p[0]) as Texel, (b + p[1]) as Texel))
        };
        places.iter().map(difference).sum::<u64>() as f64
    }

    /// What the area that a patch shares with others costs.
    fn shared(&self, site: usize) -> f64 {
        let (x, y) = self.at[site];
        let weight: usize = self.of_site[site].iter().map(|&at| self.contacts[at].1.len()).sum();
        let mut cost = 0.0;
        for (other, &(u, v)) in self.at.iter().enumerate() {
            if other == site || self.sites[other].example != self.sites[site].example {
                continue;
            }
            let reach = self.sites[site].reach.min(self.sites[other].reach) * 2;
            let along = |a: usize, b: usize| reach.saturating_sub(a.abs_diff(b)) as f64;
            let part = along(x, u) * along(y, v) / (reach * reach) as f64;
            cost += (part - SHARED).max(0.0);
        }
        cost * DEAR * self.gradient * weight as f64 / self.sites.len() as f64
    }
}

/// Random places of a rectangle: columns and rows from and to.
pub fn scattered(
    columns: std::ops::Range<isize>,
    rows: std::ops::Range<isize>,
    count: usize,
    random: &mut Pcg64,
) -> Vec<(isize, isize)> {
    let mut one =
        |of: &std::ops::Range<isize>| random.random_range(of.start as i64..of.end as i64) as isize;
    (0..count).map(|_| (one(&columns), one(&rows))).collect()
}
