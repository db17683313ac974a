//! What a color looks like in pictures.
//!
//! The first eight colors are those of Okabe and Ito (*Color Universal Design*, 2008), which
//! people of every color vision tell apart; black is left for lines and white for glyphs. Later
//! ones go around the hues by the golden angle, in turns lighter and darker, and need the glyphs
//! that pictures put beside them.

/// Red, green and blue of the first colors, from 0 to 255.
const FIRST: [[u8; 3]; 8] = [
    [230, 159, 0],
    [86, 180, 233],
    [0, 158, 115],
    [240, 228, 66],
    [0, 114, 178],
    [213, 94, 0],
    [204, 121, 167],
    [130, 130, 130],
];

/// Red, green and blue of a color, encoded for the eye.
pub fn rgb(color: u8) -> [u8; 3] {
    match FIRST.get(usize::from(color)) {
        Some(&rgb) => rgb,
        None => generated(color),
    }
}

/// `#rrggbb`.
pub fn hex(color: u8) -> String {
    let [r, g, b] = rgb(color);
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Hue by the golden angle in 1/4096 turns, three degrees of lightness; whole numbers, so that
/// every machine gives the same. Lightness, its spread and the first hue are those, of some
/// hundred tried, with which the first 16 colors are farthest apart (43 of 255, Euclidean).
fn generated(color: u8) -> [u8; 3] {
    let hue = (u32::from(color) * 2531 + 1536) % 4096;
    let lightness = [160, 75, 205][usize::from(color) % 3];
    let spread = [85, 65, 50][usize::from(color) % 3];
    [0u32, 1365, 2731].map(|primary| {
        let at = (hue + 4096 - primary) % 4096;
        // Full within a sixth of a turn from the primary, nothing beyond a third, straight between.
        let away = at.min(4096 - at) as i32;
        let wave = ((1365 - away) * 6).clamp(0, 4096);
        (lightness + spread * (wave - 2048) / 2048).clamp(0, 255) as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn colors_are_different() {
        let seen: HashSet<[u8; 3]> = (0..=255).map(rgb).collect();
        assert_eq!(seen.len(), 256);
        let first: HashSet<[u8; 3]> = (0..64).map(rgb).collect();
        assert_eq!(first.len(), 64);
        let apart = |a: u8, b: u8| {
            let pairs = rgb(a).into_iter().zip(rgb(b));
            pairs.map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum::<u32>()
        };
        for a in 0..16 {
            assert!((0..a).all(|b| apart(a, b) >= 40 * 40), "{a}");
        }
    }
}
