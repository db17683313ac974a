//! How a color is shown: by a label, and by one of sixteen colors of the terminal.

/// Sixteen colors of the 256-color palette, told apart best at the front: red, yellow, green
/// and blue first, as in Lagae's figures.
const COLORS: [u8; 16] = [203, 220, 71, 68, 208, 134, 80, 218, 94, 250, 22, 19, 190, 88, 231, 240];

/// Labels of one character.
const LABELS: &[u8; 62] = b"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// The terminal color of a color. After sixteen they come again; labels tell those apart.
pub fn background(color: u8) -> u8 {
    COLORS[usize::from(color) % COLORS.len()]
}

/// Black or white, whichever reads better on [`background`].
pub fn foreground(color: u8) -> u8 {
    if luminance(background(color)) > 110.0 { 16 } else { 231 }
}

/// The brightness, 0 to 255, of a color of the cube or the gray ramp.
fn luminance(color: u8) -> f64 {
    if color >= 232 {
        return f64::from(8 + 10 * u16::from(color - 232));
    }
    let level = |digit: u8| if digit == 0 { 0.0 } else { 55.0 + 40.0 * f64::from(digit) };
    let cube = color - 16;
    0.299 * level(cube / 36) + 0.587 * level(cube / 6 % 6) + 0.114 * level(cube % 6)
}

/// Characters of the labels of that many colors.
pub fn label_width(colors: usize) -> usize {
    if colors <= LABELS.len() { 1 } else { (colors - 1).to_string().len() }
}

/// The label of a color: 0-9, a-z, A-Z, or its number where that is not enough.
pub fn label(color: u8, width: usize) -> String {
    match LABELS.get(usize::from(color)) {
        Some(&label) if width == 1 => char::from(label).to_string(),
        _ => format!("{color:>width$}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_different() {
        for colors in [1, 10, 36, 62, 63, 100, 101, 255] {
            let width = label_width(colors);
            let labels: std::collections::HashSet<String> =
                (0..colors).map(|color| label(color as u8, width)).collect();
            assert_eq!(labels.len(), colors);
            assert!(labels.iter().all(|label| label.chars().count() == width));
        }
    }

    #[test]
    fn sixteen_colors_are_different() {
        let different: std::collections::HashSet<u8> = (0..16).map(background).collect();
        assert_eq!(different.len(), 16);
        assert_eq!(background(16), background(0));
    }
}
