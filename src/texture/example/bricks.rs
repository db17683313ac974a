//! A wall in stretcher bond: bricks of 32 x 16 texels, each of its own color, worn at the edges.

use super::field::{Field, blend, layers, noise, ramp, random};

/// Texels from course to course.
const COURSE: f64 = 16.0;
/// Texels from brick to brick.
const LENGTH: f64 = 32.0;
/// Half a joint.
const JOINT: f64 = 1.1;

pub(super) fn field(width: usize, height: usize, seed: u32) -> Field {
    let mut field = Field::new(width, height, [0.0; 3], 6.0);
    for at in 0..width * height {
        let (x, y) = ((at % width) as f64 + 0.5, (at / width) as f64 + 0.5);
        let wobble = |of: u32| 1.3 * (layers(seed ^ of, x / 7.0, y / 7.0, 2) - 0.5);
        let (u, v) = (x + wobble(0x1a), y + wobble(0x2b));
        let row = (v / COURSE).floor();
        let shift = if row as i64 % 2 == 0 { 0.0 } else { LENGTH / 2.0 };
        let column = ((u + shift) / LENGTH).floor();
        let (across, down) = (u + shift - column * LENGTH, v - row * COURSE);
        let edge = across.min(LENGTH - across).min(down.min(COURSE - down)) - JOINT;
        let of_brick =
            |salt: u32| random(seed ^ salt, column as i64 * 64 + row as i64 % 2, row as i64);
        let rough = layers(seed ^ 0x3c, x / 5.0, y / 5.0, 3);
        let grain = random(seed ^ 0x4d, x as i64, y as i64);
        let brick = ramp(-0.5, 1.2, edge + 0.5 * (rough - 0.5));
        let dome = ramp(0.0, 3.4, edge);
        let chip = ramp(0.76, 0.86, noise(seed ^ 0x5e, u / 3.0, v / 3.0));
        let body = 0.5 + 0.3 * dome + 0.3 * (rough - 0.5) - 0.07 * chip + 0.08 * of_brick(0x6f);
        let mortar = 0.2 + 0.14 * (rough - 0.5);
        field.high[at] = (mortar + (body - mortar) * brick).clamp(0.0, 1.0);
        let fired = blend([138.0, 76.0, 60.0], [178.0, 112.0, 86.0], of_brick(0x7a));
        let fired = blend(fired, [112.0, 70.0, 64.0], ramp(0.62, 0.95, of_brick(0x8b)) * 0.8);
        let flame = layers(seed ^ 0x9c, u / 14.0, v / 6.0, 3);
        let fired = fired.map(|part| part * (0.8 + 0.4 * flame) * (0.95 + 0.09 * grain));
        let lime = 0.86 + 0.18 * rough + 0.07 * grain;
        let lime = [176.0 * lime, 167.0 * lime, 152.0 * lime];
        field.color[at] = blend(lime, fired, brick).map(|part| part * (1.0 - 0.12 * chip * brick));
    }
    field.lit()
}
