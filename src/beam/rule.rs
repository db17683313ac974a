//! Which windows a partial packing may still complete.
//!
//! A fixed set has a bit for every tile that is left, a multiset four. Of a compact set at most two tiles with
//! the same (NW, SW, SE) and different NE are taken: a word for each triple says which NE was
//! the first, or that there were two.

/// Four colors: NW, NE, SW, SE.
pub(super) type Window = [usize; 4];

/// What is kept, in words of a state, about the tiles used.
pub(super) trait Rule: Sync {
    /// The words when no tile is used.
    fn start(&self) -> Vec<u16>;
    /// Adds a tile, when some may occur again.
    fn give(&self, words: &mut [u16], window: Window);
    /// Whether this window may be completed.
    fn open(&self, words: &[u16], window: Window) -> bool;
    /// Completes it.
    fn take(&self, words: &mut [u16], window: Window);
    /// Whether two tiles that differ from this one in NE at most are left.
    fn fresh(&self, words: &[u16], window: Window) -> bool;
}

/// Every tile of a set once.
pub(super) struct Once {
    colors: usize,
    left: Vec<u16>,
}

impl Once {
    /// For the tiles, given by their colors, over a number of colors.
    pub(super) fn new(colors: usize, tiles: &[Window]) -> Self {
        let mut once = Self { colors, left: vec![0; colors.pow(4).div_ceil(16)] };
        for &tile in tiles {
            let (word, bit) = once.place(tile);
            once.left[word] |= bit;
        }
        once
    }

    #[inline(always)]
    fn place(&self, [nw, ne, sw, se]: Window) -> (usize, u16) {
        let tile = ((nw * self.colors + ne) * self.colors + sw) * self.colors + se;
        (tile / 16, 1 << (tile % 16))
    }
}

impl Rule for Once {
    fn start(&self) -> Vec<u16> {
        self.left.clone()
    }

    fn give(&self, words: &mut [u16], window: Window) {
        let (word, bit) = self.place(window);
        words[word] |= bit;
    }

    #[inline(always)]
    fn open(&self, words: &[u16], window: Window) -> bool {
        let (word, bit) = self.place(window);
        words[word] & bit != 0
    }

    #[inline(always)]
    fn take(&self, words: &mut [u16], window: Window) {
        let (word, bit) = self.place(window);
        words[word] &= !bit;
    }

    #[inline(always)]
    fn fresh(&self, _: &[u16], _: Window) -> bool {
        false
    }
}

/// Every tile so many times, up to 15.
pub(super) struct Times {
    colors: usize,
    left: Vec<u16>,
}

impl Times {
    /// The most times.
    pub(super) const MOST: u16 = 15;

    /// The tiles once, over a number of colors.
    pub(super) fn new(colors: usize, tiles: &[Window]) -> Self {
        let mut times = Self { colors, left: vec![0; colors.pow(4).div_ceil(4)] };
        for &tile in tiles {
            let (word, shift) = times.place(tile);
            times.left[word] |= 1 << shift;
        }
        times
    }

    #[inline(always)]
    fn place(&self, [nw, ne, sw, se]: Window) -> (usize, u32) {
        let tile = ((nw * self.colors + ne) * self.colors + sw) * self.colors + se;
        (tile / 4, 4 * (tile % 4) as u32)
    }
}

impl Rule for Times {
    fn start(&self) -> Vec<u16> {
        self.left.clone()
    }

    fn give(&self, words: &mut [u16], window: Window) {
        let (word, shift) = self.place(window);
        words[word] += 1 << shift;
    }

    #[inline(always)]
    fn open(&self, words: &[u16], window: Window) -> bool {
        let (word, shift) = self.place(window);
        words[word] >> shift & Self::MOST != 0
    }

    #[inline(always)]
    fn take(&self, words: &mut [u16], window: Window) {
        let (word, shift) = self.place(window);
        words[word] -= 1 << shift;
    }

    #[inline(always)]
    fn fresh(&self, _: &[u16], _: Window) -> bool {
        false
    }
}

/// Two tiles for each (NW, SW, SE).
pub(super) struct Compact {
    colors: usize,
}

impl Compact {
    const BOTH: u16 = u16::MAX;

    /// Over a number of colors.
    pub(super) fn new(colors: usize) -> Self {
        Self { colors }
    }

    #[inline(always)]
    fn place(&self, [nw, _, sw, se]: Window) -> usize {
        (nw * self.colors + sw) * self.colors + se
    }
}

impl Rule for Compact {
    fn start(&self) -> Vec<u16> {
        vec![0; self.colors.pow(3)]
    }

    /// There is nothing to add: no tile occurs again.
    fn give(&self, _: &mut [u16], _: Window) {}

    #[inline(always)]
    fn open(&self, words: &[u16], window: Window) -> bool {
        let first = words[self.place(window)];
        first != Self::BOTH && usize::from(first) != window[1] + 1
    }

    #[inline(always)]
    fn take(&self, words: &mut [u16], window: Window) {
        let first = &mut words[self.place(window)];
        *first = if *first == 0 { window[1] as u16 + 1 } else { Self::BOTH };
    }

    #[inline(always)]
    fn fresh(&self, words: &[u16], window: Window) -> bool {
        words[self.place(window)] == 0
    }
}
