//! A lawn from above: blades that lie every way, the later the higher and the lighter.

use super::field::{Color, Dice, Field, blend, mix, noise};

/// Blades for so many texels.
const TEXELS_A_BLADE: usize = 9;
/// Space around the picture in which blades begin, too.
const AROUND: f64 = 24.0;

pub(super) fn field(width: usize, height: usize, seed: u32) -> Field {
    // Twice as fine, then halved.
    let mut field = Field::new(2 * width, 2 * height, [22.0, 34.0, 14.0], 10.0);
    let mut dice = Dice::new(seed ^ 0x6a55);
    let (wide, high) = (width as f64, height as f64);
    let area = (wide + 2.0 * AROUND) * (high + 2.0 * AROUND);
    let blades = (area / TEXELS_A_BLADE as f64) as usize;
    for blade in 0..blades {
        let depth = blade as f64 / blades as f64;
        let (x, y) = (dice.throw(-AROUND, wide + AROUND), dice.throw(-AROUND, high + AROUND));
        let (dx, dy) = dice.direction();
        let (bend, length) = (dice.throw(-0.7, 0.7), dice.throw(8.0, 19.0));
        let half = dice.throw(0.7, 1.25);
        let place = noise(seed ^ 0xbb, x / 34.0, y / 34.0);
        let dry = if dice.throw(0.0, 1.0) < 0.06 { 0.75 } else { 0.0 };
        let tone = dice.throw(0.0, 1.0);
        let lush = blend([46.0, 84.0, 22.0], [112.0, 158.0, 52.0], 0.25 * place + 0.75 * tone);
        let color = blend(lush, [186.0, 170.0, 94.0], dry);
        let light = mix(0.42, 1.12, depth * depth) * mix(0.9, 1.08, place);
        let color = color.map(|part| part * light);
        // Steps of half a texel of the fine picture.
        let steps = (length * 4.0) as usize;
        for step in 0..=steps {
            let t = step as f64 / steps as f64;
            let side = bend * t * t;
            let (u, v) = (x + length * (t * dx - side * dy), y + length * (t * dy + side * dx));
            let half = half * (1.0 - t * t) + 0.15;
            // A blade is folded: one half is in the light.
            dab(&mut field, (2.0 * u, 2.0 * v), 2.0 * half, (-dy, dx), color, 0.3 + 0.7 * depth);
        }
    }
    field.halved()
}

/// A dab of the brush, lighter on the side that looks north-west.
fn dab(
    field: &mut Field,
    (x, y): (f64, f64),
    half: f64,
    (across_x, across_y): (f64, f64),
    color: Color,
    high: f64,
) {
    let reach = half.ceil() as i64;
    for v in y as i64 - reach..=y as i64 + reach {
        for u in x as i64 - reach..=x as i64 + reach {
            let (dx, dy) = (u as f64 + 0.5 - x, v as f64 + 0.5 - y);
            let inside = u >= 0 && v >= 0 && u < field.width as i64 && v < field.height as i64;
            if !inside || dx * dx + dy * dy > half * half {
                continue;
            }
            let at = v as usize * field.width + u as usize;
            let side = (dx * across_x + dy * across_y) / half;
            let toward = if across_x + across_y < 0.0 { side } else { -side };
            field.color[at] = color.map(|part| part * (1.0 + 0.22 * toward));
            field.high[at] = high;
        }
    }
}
