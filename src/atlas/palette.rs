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
/// every machine gives the same.
fn generated(color: u8) -> [u8; 3] {
    let hue = u32::from(color) * 2531 % 4096;
    let lightness = [150, 95, 200][usize::from(color) % 3];
    let spread = [105, 80, 50][usize::from(color) % 3];
    [0u32, 2731, 1365].map(|turn| {
        let at = (hue + turn) % 4096;
        // A wave of straight lines: up for a sixth of a turn, high for a third, and down.
        let rise = |at: u32| (at * 6).min(4096) as i32;
        let wave = if at < 2048 { rise(at) } else { rise(4095 - at) };
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
        assert!(seen.len() > 250, "{}", seen.len());
        let first: HashSet<[u8; 3]> = (0..64).map(rgb).collect();
        assert_eq!(first.len(), 64);
    }
}
