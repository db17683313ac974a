//! Weathered rock: lumps, thin cracks along the valleys of noise, grains, patches of two colors.

use super::field::{Field, blend, layers, noise, ramp, random};

pub(super) fn field(width: usize, height: usize, seed: u32) -> Field {
    let mut field = Field::new(width, height, [0.0; 3], 15.0);
    for at in 0..width * height {
        let (x, y) = ((at % width) as f64, (at / width) as f64);
        // Lines are bent by slow noise.
        let bend = |of: u32| 8.0 * (noise(seed ^ of, x / 19.0, y / 19.0) - 0.5);
        let (u, v) = (x + bend(0x11), y + bend(0x22));
        let lumps = layers(seed ^ 0x33, u / 26.0, v / 26.0, 5);
        let vein = (layers(seed ^ 0x44, u / 38.0, v / 38.0, 3) - 0.5).abs();
        // Cracks end where the rock is sound.
        let sound = ramp(0.46, 0.56, layers(seed ^ 0xaa, x / 17.0, y / 17.0, 2));
        let crack = (1.0 - ramp(0.0, 0.018, vein)) * (1.0 - sound);
        let rough = layers(seed ^ 0x55, x / 4.0, y / 4.0, 2);
        let pit = ramp(0.66, 0.74, layers(seed ^ 0x66, u / 6.0, v / 6.0, 3));
        field.high[at] =
            (0.1 + 0.75 * lumps + 0.1 * rough - 0.09 * crack - 0.06 * pit).clamp(0.0, 1.0);
        let tone = ramp(0.35, 0.68, layers(seed ^ 0x77, v / 31.0, u / 31.0, 3));
        let base = blend([139.0, 133.0, 124.0], [171.0, 156.0, 133.0], tone);
        let moss = ramp(0.6, 0.72, layers(seed ^ 0x88, u / 22.0, v / 22.0, 4)) * 0.35;
        let base = blend(base, [116.0, 124.0, 92.0], moss);
        let grain = random(seed ^ 0x99, x as i64, y as i64);
        let grain = 0.95 + 0.1 * grain - if grain > 0.975 { 0.22 } else { 0.0 };
        let dark = 1.0 - 0.3 * crack - 0.2 * pit;
        field.color[at] = base.map(|part| part * grain * dark * (0.82 + 0.3 * lumps));
    }
    field.lit()
}
