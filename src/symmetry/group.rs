//! All symmetries of the packings of a tile set on a torus.
//!
//! A symmetry recolors, rotates or reflects, and translates ([`Symmetry`]). Which pairs of
//! recoloring and isometry keep the set:
//! * complete: all that fit the torus, every palette permuted on its own;
//! * compact corner: each (NW, SW, SE) has two tiles, so only what keeps the corner NE: the
//!   identity and the reflection through the diagonal from SW to NE, with all permutations;
//! * compact Wang: each (N, W) has two tiles: the identity and the reflection that exchanges N
//!   and W. (It needs `2 C^2` to be a square to fit a packing, so it serves coverings only.)
//! * pruned, explicit: those that map the tiles to the tiles, *jointly*; see [`keeping`].
//!
//! With an automorphism A only those g with g A g^-1 in the group that A generates: they map the
//! packings with this automorphism to such packings. Translations commute with A's and with each
//! other, so that is a condition on recoloring and isometry alone.
//!
//! The group is kept factored. Of the elements with one isometry, each is a recoloring that
//! keeps everything (the *kernel*) followed by one chosen representative. Where different
//! elements move every packing alike (a 1x1 torus, colors without effect), the order of the
//! group and all stabilizers grow by the same factor, and orbit sizes are still exact.
//!
//! [`keeping`]: super::keeping

use super::element::translated;
use super::{Automorphism, ColorMap, Isometry, PointSymmetry, Symmetry, keeping};
use crate::tiles::{Colors, Kind, Members, TileSet};
use crate::torus::{Lattice, Shape};
use num_bigint::BigUint;

/// Why the symmetries cannot be had.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GroupError {
    /// More color permutations than can be tried on every packing.
    #[error(
        "up to symmetry needs every color permutation that keeps the set, \
         but with {colors} colors there are more than {max}"
    )]
    TooManyColorMaps {
        /// The colors.
        colors: Colors,
        /// The largest number that is handled.
        max: usize,
    },
    /// Finding the color permutations takes too long.
    #[error(
        "up to symmetry needs every color permutation that keeps the set, \
         but with {colors} colors it takes too long to find them"
    )]
    TooMuchWork {
        /// The colors.
        colors: Colors,
    },
}

/// A group of symmetries of a torus of labels: all translations, and some recolorings joined
/// with isometries.
#[derive(Debug, Clone)]
pub struct Group {
    lattice: Lattice,
    colors: Colors,
    /// The recolorings that need no isometry.
    kernel: Vec<ColorMap>,
    /// One element of each coset of the kernel, the identity first.
    representatives: Vec<PointSymmetry>,
}

impl Group {
    /// All symmetries of the packings, and of the coverings, of `set` on a torus of this shape,
    /// or of those that have the automorphism, which must have passed [`Automorphism::check`].
    ///
    /// # Errors
    /// When there are too many color permutations to try or finding them takes too long.
    pub fn of(
        set: &TileSet,
        shape: Shape,
        automorphism: Option<&Automorphism>,
    ) -> Result<Self, GroupError> {
        let (lattice, colors) = (Lattice { kind: set.kind(), shape }, set.colors());
        let kernel = keeping::color_maps(set, Isometry::IDENTITY, usize::MAX)?;
        let mut representatives = vec![PointSymmetry::identity(colors)];
        for isometry in isometries(set, lattice).filter(|&i| i != Isometry::IDENTITY) {
            let map = keeping::color_maps(set, isometry, 1)?.pop();
            representatives.extend(map.map(|map| PointSymmetry { isometry, map }));
        }
        let group = Self { lattice, colors, kernel, representatives };
        Ok(match automorphism {
            None => group,
            Some(automorphism) => {
                let powers = Powers::of(automorphism, lattice, colors);
                group.restricted(|point| powers.are_kept_by(point))
            }
        })
    }

    /// The translations alone.
    pub fn translations(set: &TileSet, shape: Shape) -> Self {
        let (lattice, colors) = (Lattice { kind: set.kind(), shape }, set.colors());
        let kernel = vec![ColorMap::identity(colors)];
        let representatives = vec![PointSymmetry::identity(colors)];
        Self { lattice, colors, kernel, representatives }
    }

    /// The translations, and those other symmetries that `keep` accepts, which must be closed
    /// under composition. For instance `|point| point.isometry == Isometry::IDENTITY`, or the
    /// color permutations that fix a color.
    pub fn restricted(&self, keep: impl Fn(&PointSymmetry) -> bool) -> Self {
        let representatives = self.representatives.iter();
        let representatives = representatives
            .filter_map(|representative| {
                self.coset(representative).find(|point| {
                    // The identity stays the representative of the kernel.
                    keep(point) && (!is_recoloring(point) || point.map.is_identity())
                })
            })
            .collect();
        let recolors = |map: &&ColorMap| {
            keep(&PointSymmetry { isometry: Isometry::IDENTITY, map: (*map).clone() })
        };
        let kernel = self.kernel.iter().filter(recolors).cloned().collect();
        Self { kernel, representatives, ..*self }
    }

    /// What the symmetries act on.
    pub fn lattice(&self) -> Lattice {
        self.lattice
    }

    /// The palettes.
    pub fn colors(&self) -> Colors {
        self.colors
    }

    /// The number of elements without their translations.
    pub fn point_count(&self) -> usize {
        self.kernel.len() * self.representatives.len()
    }

    /// The number of elements.
    pub fn order(&self) -> BigUint {
        BigUint::from(self.point_count()) * BigUint::from(self.lattice.shape.cells())
    }

    /// The elements without their translations, each once.
    pub fn points(&self) -> impl Iterator<Item = PointSymmetry> + '_ {
        self.representatives.iter().flat_map(|representative| self.coset(representative))
    }

    /// All elements, each once: every element of [`Group::points`] with every translation.
    pub fn elements(&self) -> impl Iterator<Item = Symmetry> + '_ {
        let shape = self.lattice.shape;
        self.points().flat_map(move |point| {
            (0..shape.cells()).map(move |cell| Symmetry {
                point: point.clone(),
                rows: cell / shape.width(),
                columns: cell % shape.width(),
            })
        })
    }

    /// The images of `labels` under all elements; an image comes as often as there are elements
    /// that give it.
    pub fn images<'a>(&'a self, labels: &'a [u8]) -> impl Iterator<Item = Vec<u8>> + 'a {
        let (lattice, shape) = (self.lattice, self.lattice.shape);
        self.points().flat_map(move |point| {
            let image = Symmetry { point, rows: 0, columns: 0 }.image(lattice, labels);
            (0..shape.cells()).map(move |cell| {
                translated(&image, lattice, cell / shape.width(), cell % shape.width())
            })
        })
    }

    fn coset<'a>(
        &'a self,
        representative: &'a PointSymmetry,
    ) -> impl Iterator<Item = PointSymmetry> + 'a {
        self.kernel.iter().map(|map| PointSymmetry {
            isometry: representative.isometry,
            map: map.then(&representative.map),
        })
    }
}

fn is_recoloring(point: &PointSymmetry) -> bool {
    point.isometry == Isometry::IDENTITY
}

/// The isometries that fit the torus and may keep the set.
fn isometries(set: &TileSet, lattice: Lattice) -> impl Iterator<Item = Isometry> {
    let (kind, colors) = (set.kind(), set.colors());
    let mirror = match kind {
        Kind::Corner => Isometry::MIRROR_ANTIDIAGONAL,
        Kind::Wang | Kind::Domino => Isometry::MIRROR_DIAGONAL,
    };
    let compact = *set.members() == Members::Compact;
    let keeps =
        move |isometry: &Isometry| !compact || [Isometry::IDENTITY, mirror].contains(isometry);
    Isometry::ALL.into_iter().filter(move |i| i.fits(lattice, colors)).filter(keeps)
}

/// The powers of an automorphism, from the identity on.
struct Powers {
    shape: Shape,
    /// Rows, columns and recoloring of each.
    powers: Vec<(usize, usize, PointSymmetry)>,
}

impl Powers {
    fn of(automorphism: &Automorphism, lattice: Lattice, colors: Colors) -> Self {
        let shape = lattice.shape;
        let order = automorphism.order(shape);
        let (dx, dy) = (automorphism.dx as usize, automorphism.dy as usize);
        let maps = automorphism.powers(order, colors).into_iter();
        let powers = maps.enumerate().map(|(k, map)| {
            let map = if lattice.kind == Kind::Wang { map } else { map.of_one_palette() };
            let recoloring = PointSymmetry { isometry: Isometry::IDENTITY, map };
            (dy * k % shape.height(), dx * k % shape.width(), recoloring)
        });
        Self { shape, powers: powers.collect() }
    }

    /// Whether first the automorphism, then `point`, is first `point`, then one of the powers.
    fn are_kept_by(&self, point: &PointSymmetry) -> bool {
        let Some((rows, columns, recoloring)) = self.powers.get(1) else { return true };
        let step = point.isometry.translation(self.shape, *rows, *columns);
        let first = recoloring.then(point);
        let mut powers = self.powers.iter();
        powers.any(|(rows, columns, power)| step == (*rows, *columns) && first == point.then(power))
    }
}
