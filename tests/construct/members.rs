//! Random members of the families: valid, the same for the same seed, different for others.

use crate::{check, corner, labels};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn any_seed_gives_a_packing(colors in 2usize..8, seed in any::<u64>()) {
        let side = colors * colors;
        let torus = corner(colors, side, side, Some(seed)).unwrap();
        check(&torus);
        let again = corner(colors, side, side, Some(seed)).unwrap();
        prop_assert_eq!(labels(&torus), labels(&again));
        let other = corner(colors, side, side, Some(seed.wrapping_add(1))).unwrap();
        prop_assert!(colors < 4 || labels(&torus) != labels(&other));
    }

    #[test]
    fn other_shapes_have_members_too(seed in any::<u64>()) {
        for (colors, w, h) in [(3, 3, 27), (4, 4, 64), (4, 32, 8), (6, 12, 108), (6, 108, 12)] {
            check(&corner(colors, w, h, Some(seed)).unwrap());
        }
    }
}
