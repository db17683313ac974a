//! Colors and heights on a grid, noise to make them of, and light.
//!
//! Colors are codes for the eye (0 to 255), heights run from 0 to 1.

use crate::tiling::hash::hash3;

/// A color.
pub(super) type Color = [f64; 3];

/// A picture that knows how high it is.
#[derive(Debug, Clone)]
pub(super) struct Field {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) color: Vec<Color>,
    pub(super) high: Vec<f64>,
    /// How steep a step of 1 in height is, in texels.
    pub(super) steep: f64,
}

impl Field {
    /// All of one color and height.
    pub(super) fn new(width: usize, height: usize, color: Color, steep: f64) -> Self {
        let texels = width * height;
        Self { width, height, color: vec![color; texels], high: vec![0.0; texels], steep }
    }

    /// The height of a texel or, beyond the border, of the nearest.
    pub(super) fn high(&self, x: isize, y: isize) -> f64 {
        let clamp = |at: isize, count: usize| at.clamp(0, count as isize - 1) as usize;
        self.high[clamp(y, self.height) * self.width + clamp(x, self.width)]
    }

    /// The direction that a texel faces.
    pub(super) fn normal(&self, x: usize, y: usize) -> [f64; 3] {
        let (x, y) = (x as isize, y as isize);
        let slope = |a: f64, b: f64| (a - b) * self.steep / 2.0;
        let east = slope(self.high(x - 1, y), self.high(x + 1, y));
        let north = slope(self.high(x, y + 1), self.high(x, y - 1));
        let length = (east * east + north * north + 1.0).sqrt();
        [east / length, north / length, 1.0 / length]
    }

    /// Lets light fall on it, from the north-west; hollows get less of it.
    pub(super) fn lit(mut self) -> Self {
        for y in 0..self.height {
            for x in 0..self.width {
                let [east, north, up] = self.normal(x, y);
                let light = 0.62 * up - 0.5 * east + 0.6 * north;
                let here = self.high(x as isize, y as isize);
                let mut around = 0.0;
                for (dx, dy) in
                    [(-3, 0), (3, 0), (0, -3), (0, 3), (-2, -2), (2, 2), (-2, 2), (2, -2)]
                {
                    around += self.high(x as isize + dx, y as isize + dy) / 8.0;
                }
                let hollow = 1.0 - ((around - here) * 2.2).clamp(-0.15, 0.55);
                let factor = (0.42 + light.max(0.0)) * hollow;
                for part in &mut self.color[y * self.width + x] {
                    *part *= factor;
                }
            }
        }
        self
    }

    /// Means of 2 x 2 texels.
    pub(super) fn halved(&self) -> Self {
        let (width, height) = (self.width / 2, self.height / 2);
        let mut half = Self::new(width, height, [0.0; 3], self.steep / 2.0);
        for y in 0..height {
            for x in 0..width {
                let first = 2 * y * self.width + 2 * x;
                for at in [first, first + 1, first + self.width, first + self.width + 1] {
                    half.high[y * width + x] += self.high[at] / 4.0;
                    for (part, of) in half.color[y * width + x].iter_mut().zip(self.color[at]) {
                        *part += of / 4.0;
                    }
                }
            }
        }
        half
    }
}

/// A number from 0 to 1 for a place.
pub(super) fn random(seed: u32, x: i64, y: i64) -> f64 {
    f64::from(hash3(seed, x as u32, y as u32)) / 4_294_967_296.0
}

/// Smooth noise from 0 to 1, that changes over a unit.
pub(super) fn noise(seed: u32, x: f64, y: f64) -> f64 {
    let (left, top) = (x.floor(), y.floor());
    let ease = |t: f64| t * t * t * (t * (6.0 * t - 15.0) + 10.0);
    let (u, v) = (ease(x - left), ease(y - top));
    let (left, top) = (left as i64, top as i64);
    let row = |y: i64| mix(random(seed, left, y), random(seed, left + 1, y), u);
    mix(row(top), row(top + 1), v)
}

/// Noise over several scales, each half of the one before and half as strong.
pub(super) fn layers(seed: u32, x: f64, y: f64, count: u32) -> f64 {
    let (mut sum, mut weight, mut scale, mut all) = (0.0, 1.0, 1.0, 0.0);
    for layer in 0..count {
        // Turned by a 3-4-5 triangle, so that the grids do not line up.
        let (a, b) = if layer % 2 == 0 { (x, y) } else { (0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y) };
        sum += weight * noise(seed.wrapping_add(layer * 7919), a * scale, b * scale);
        all += weight;
        weight *= 0.5;
        scale *= 2.0;
    }
    sum / all
}

/// Between two numbers.
pub(super) fn mix(a: f64, b: f64, part: f64) -> f64 {
    a + (b - a) * part
}

/// Between two colors.
pub(super) fn blend(a: Color, b: Color, part: f64) -> Color {
    [mix(a[0], b[0], part), mix(a[1], b[1], part), mix(a[2], b[2], part)]
}

/// From 0 below `low` to 1 above `high`.
pub(super) fn ramp(low: f64, high: f64, at: f64) -> f64 {
    let t = ((at - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Random numbers one after the other.
#[derive(Debug)]
pub(super) struct Dice {
    seed: u32,
    thrown: i64,
}

impl Dice {
    pub(super) fn new(seed: u32) -> Self {
        Self { seed, thrown: 0 }
    }

    /// A number from `low` to `high`.
    pub(super) fn throw(&mut self, low: f64, high: f64) -> f64 {
        self.thrown += 1;
        mix(low, high, random(self.seed, self.thrown, 0x0dd))
    }

    /// A direction.
    pub(super) fn direction(&mut self) -> (f64, f64) {
        loop {
            let (x, y) = (self.throw(-1.0, 1.0), self.throw(-1.0, 1.0));
            let length = (x * x + y * y).sqrt();
            if length > 0.1 && length <= 1.0 {
                return (x / length, y / length);
            }
        }
    }
}
