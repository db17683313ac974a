//! All permutations of a few things, numbered.

/// Permutations of at most this many things: three bits for each in a table.
pub(super) const MOST: usize = 7;

/// The permutations of n things in lexicographic order.
pub(super) struct Permutations {
    /// The images, one permutation after the other.
    pub(super) all: Vec<Vec<u8>>,
    /// Their numbers, by images packed in three bits each.
    numbers: Vec<u16>,
}

fn packed(images: impl Iterator<Item = u8>) -> usize {
    images.fold(0, |packed, image| packed << 3 | usize::from(image))
}

impl Permutations {
    /// Of n things, at most [`MOST`].
    pub(super) fn new(n: usize) -> Self {
        let mut all: Vec<Vec<u8>> = vec![Vec::new()];
        for _ in 0..n {
            let longer = all.iter().flat_map(|begun| {
                let left = (0..n as u8).filter(|image| !begun.contains(image));
                left.map(|image| [&begun[..], &[image]].concat())
            });
            all = longer.collect();
        }
        let mut numbers = vec![0; 1 << (3 * n)];
        for (number, images) in (0..).zip(&all) {
            numbers[packed(images.iter().copied())] = number;
        }
        Self { all, numbers }
    }

    /// The number of the permutation with these images.
    pub(super) fn number(&self, images: impl Iterator<Item = u8>) -> usize {
        self.numbers[packed(images)].into()
    }
}
