//! Fallen leaves, one on the other, each with its shadow, its rib and its veins.

use super::field::{Color, Dice, Field, blend, layers, mix, ramp, random};

/// Leaves for so many texels.
const TEXELS_A_LEAF: f64 = 68.0;
/// Space around the picture in which leaves lie, too.
const AROUND: f64 = 20.0;
/// What leaves are colored like, from ripe to dry.
const COLORS: [Color; 7] = [
    [206.0, 142.0, 44.0],
    [188.0, 96.0, 38.0],
    [164.0, 62.0, 36.0],
    [150.0, 104.0, 56.0],
    [128.0, 84.0, 50.0],
    [196.0, 164.0, 78.0],
    [122.0, 124.0, 54.0],
];

/// A leaf, in texels of the fine picture.
struct Leaf {
    middle: (f64, f64),
    along: (f64, f64),
    half_length: f64,
    half_width: f64,
    bend: f64,
    color: Color,
    seed: u32,
}

pub(super) fn field(width: usize, height: usize, seed: u32) -> Field {
    // Twice as fine, then halved.
    let mut field = Field::new(2 * width, 2 * height, [0.0; 3], 12.0);
    for at in 0..field.color.len() {
        let (x, y) = ((at % field.width) as f64, (at / field.width) as f64);
        let soil = layers(seed ^ 0x501, x / 9.0, y / 9.0, 4);
        field.color[at] = [62.0, 48.0, 36.0].map(|part| part * (0.5 + 0.9 * soil));
    }
    let mut dice = Dice::new(seed ^ 0x1eaf);
    let (wide, high) = (width as f64, height as f64);
    let leaves = ((wide + 2.0 * AROUND) * (high + 2.0 * AROUND) / TEXELS_A_LEAF) as usize;
    for number in 0..leaves {
        let at = (dice.throw(-AROUND, wide + AROUND), dice.throw(-AROUND, high + AROUND));
        let half_length = dice.throw(14.0, 24.0);
        let kind = dice.throw(0.0, COLORS.len() as f64) as usize;
        let other = dice.throw(0.0, COLORS.len() as f64) as usize;
        let tone = dice.throw(0.0, 0.5);
        let bright = dice.throw(0.72, 1.12);
        let color = blend(COLORS[kind], COLORS[other], tone).map(|part| part * bright);
        let leaf = Leaf {
            middle: (2.0 * at.0, 2.0 * at.1),
            along: dice.direction(),
            half_length,
            half_width: half_length * dice.throw(0.36, 0.54),
            bend: dice.throw(-0.25, 0.25),
            color,
            seed: seed ^ (number as u32).wrapping_mul(0x9e37_79b9),
        };
        leaf.shadow(&mut field);
        leaf.paint(&mut field, 0.25 + 0.75 * number as f64 / leaves as f64);
    }
    field.halved()
}

impl Leaf {
    /// Where a place lies on the leaf: along from -1 to 1, and across in half widths.
    fn place(&self, x: f64, y: f64) -> Option<(f64, f64)> {
        let (dx, dy) = (x - self.middle.0, y - self.middle.1);
        let t = (dx * self.along.0 + dy * self.along.1) / self.half_length;
        if t.abs() >= 1.0 {
            return None;
        }
        let across = dy * self.along.0 - dx * self.along.1;
        // Bent, broadest before the middle, with a point.
        let middle = self.bend * self.half_length * (1.0 - t * t);
        let width = self.half_width * (1.0 - t * t) * (1.0 - 0.28 * t);
        Some((t, (across - middle) / width.max(0.4)))
    }

    fn bounds(&self, field: &Field, shift: f64) -> [std::ops::Range<usize>; 2] {
        let reach = self.half_length * 1.1 + 2.0;
        let range = |at: f64, count: usize| {
            let end = |to: f64| to.clamp(0.0, count as f64) as usize;
            end(at - reach + shift)..end(at + reach + shift)
        };
        [range(self.middle.0, field.width), range(self.middle.1, field.height)]
    }

    /// Darkens what lies to the south-east.
    fn shadow(&self, field: &mut Field) {
        let [columns, rows] = self.bounds(field, 4.0);
        for y in rows {
            for x in columns.clone() {
                let place = self.place(x as f64 - 3.5, y as f64 - 3.5);
                if let Some((t, across)) = place.filter(|(_, across)| across.abs() < 1.25) {
                    let soft = ramp(1.25, 0.6, across.abs()) * ramp(1.0, 0.8, t.abs());
                    let width = field.width;
                    for part in &mut field.color[y * width + x] {
                        *part *= 1.0 - 0.55 * soft;
                    }
                }
            }
        }
    }

    fn paint(&self, field: &mut Field, high: f64) {
        let [columns, rows] = self.bounds(field, 0.0);
        // Which half is in the light: the one toward the north-west.
        let lit = if self.along.1 - self.along.0 > 0.0 { 1.0 } else { -1.0 };
        for y in rows {
            for x in columns.clone() {
                let place = self.place(x as f64, y as f64);
                let Some((t, across)) = place.filter(|(_, across)| across.abs() < 1.0) else {
                    continue;
                };
                let side = across.abs();
                let mut light = 1.0 + 0.16 * lit * across.clamp(-1.0, 1.0) * (1.0 - 0.4 * side);
                light *= mix(1.0, 0.72, ramp(0.82, 1.0, side));
                let blotch = layers(self.seed, x as f64 / 11.0, y as f64 / 11.0, 3);
                light *= 0.8 + 0.4 * blotch;
                // Veins leave the rib toward the point.
                let vein = (t - 0.42 * side) * 4.5;
                let near = (vein - (vein + 0.5).floor()).abs();
                light *= 1.0 - 0.16 * ramp(0.13, 0.03, near) * ramp(1.0, 0.6, side);
                let rib = ramp(0.13, 0.04, side) * ramp(1.0, 0.7, t);
                let grain = 0.97 + 0.06 * random(self.seed, x as i64, y as i64);
                let at = y * field.width + x;
                let brown = ramp(0.55, 0.75, blotch) * 0.35;
                let color = blend(self.color, [96.0, 62.0, 38.0], brown);
                let color = color.map(|part| part * light * grain);
                field.color[at] = blend(color, self.color.map(|part| part * 1.18), 0.7 * rib);
                field.high[at] = high - 0.05 * side;
            }
        }
    }
}
