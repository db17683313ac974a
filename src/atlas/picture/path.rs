//! Lines and curves in the plane: x to the right, y downward, as in SVG.

/// A point.
pub type Point = (f64, f64);

/// A step of a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Command {
    /// A new part begins here.
    Move(Point),
    /// A straight line to here.
    Line(Point),
    /// A parabola: its control point and its end.
    Quadratic(Point, Point),
    /// A cubic Bézier curve: two control points and its end.
    Cubic(Point, Point, Point),
    /// Back to where the part began.
    Close,
}

/// Any number of lines and curves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Path {
    /// The steps, the first of them a [`Command::Move`].
    pub commands: Vec<Command>,
}

/// How far the control points of a quarter of a circle are from its ends, in radii; the curve is
/// off by less than 0.03 % of the radius.
pub const QUARTER: f64 = 0.5523;

/// Straight lines that a curve is made of where only lines can be drawn.
const PIECES: u32 = 8;

impl Path {
    /// Whether nothing is in it.
    pub fn is_empty(&self) -> bool {
        self.commands.is_empty()
    }

    /// Begins a part.
    pub fn move_to(&mut self, to: Point) {
        self.commands.push(Command::Move(to));
    }

    /// Goes straight.
    pub fn line_to(&mut self, to: Point) {
        self.commands.push(Command::Line(to));
    }

    /// Goes along a cubic curve.
    pub fn cubic_to(&mut self, first: Point, second: Point, to: Point) {
        self.commands.push(Command::Cubic(first, second, to));
    }

    /// Ends a part where it began.
    pub fn close(&mut self) {
        self.commands.push(Command::Close);
    }

    /// Adds a closed part with these corners.
    pub fn polygon(&mut self, corners: &[Point]) {
        for (i, &corner) in corners.iter().enumerate() {
            if i == 0 { self.move_to(corner) } else { self.line_to(corner) }
        }
        self.close();
    }

    /// Adds a rectangle.
    pub fn rectangle(&mut self, x: f64, y: f64, width: f64, height: f64) {
        self.polygon(&[(x, y), (x + width, y), (x + width, y + height), (x, y + height)]);
    }

    /// Adds a rectangle whose left and right sides are half circles.
    pub fn pill(&mut self, center: Point, width: f64, height: f64) {
        let (x, y) = center;
        let r = height / 2.0;
        let k = r * QUARTER;
        let (left, right) = (x - width / 2.0 + r, x + width / 2.0 - r);
        self.move_to((left, y - r));
        self.line_to((right, y - r));
        self.cubic_to((right + k, y - r), (right + r, y - k), (right + r, y));
        self.cubic_to((right + r, y + k), (right + k, y + r), (right, y + r));
        self.line_to((left, y + r));
        self.cubic_to((left - k, y + r), (left - r, y + k), (left - r, y));
        self.cubic_to((left - r, y - k), (left - k, y - r), (left, y - r));
        self.close();
    }

    /// Adds a quarter of a disc around a corner; `sx` and `sy` are 1 or -1, toward the quarter.
    pub fn quarter(&mut self, corner: Point, radius: f64, sx: f64, sy: f64) {
        let (x, y) = corner;
        let (rx, ry) = (sx * radius, sy * radius);
        self.move_to((x, y));
        self.line_to((x + rx, y));
        self.cubic_to((x + rx, y + ry * QUARTER), (x + rx * QUARTER, y + ry), (x, y + ry));
        self.close();
    }

    /// The parts as straight lines, enlarged; and whether they are closed.
    pub fn flattened(&self, scale: f64) -> Vec<(Vec<Point>, bool)> {
        let scaled = |(x, y): Point| (x * scale, y * scale);
        let mut parts: Vec<(Vec<Point>, bool)> = Vec::new();
        let mut at = (0.0, 0.0);
        for &command in &self.commands {
            match command {
                Command::Move(to) => parts.push((vec![scaled(to)], false)),
                Command::Close => {
                    if let Some((_, closed)) = parts.last_mut() {
                        *closed = true;
                    }
                }
                Command::Line(to) => extend(&mut parts, scaled(to)),
                Command::Quadratic(control, to) => {
                    for i in 1..=PIECES {
                        let t = f64::from(i) / f64::from(PIECES);
                        let [a, b] = [mix(at, control, t), mix(control, to, t)];
                        extend(&mut parts, scaled(mix(a, b, t)));
                    }
                }
                Command::Cubic(first, second, to) => {
                    for i in 1..=PIECES {
                        let t = f64::from(i) / f64::from(PIECES);
                        let [a, b, c] =
                            [mix(at, first, t), mix(first, second, t), mix(second, to, t)];
                        let [a, b] = [mix(a, b, t), mix(b, c, t)];
                        extend(&mut parts, scaled(mix(a, b, t)));
                    }
                }
            }
            if let Command::Move(to)
            | Command::Line(to)
            | Command::Quadratic(_, to)
            | Command::Cubic(_, _, to) = command
            {
                at = to;
            }
        }
        parts
    }
}

fn extend(parts: &mut [(Vec<Point>, bool)], to: Point) {
    if let Some((points, _)) = parts.last_mut() {
        points.push(to);
    }
}

/// The point that divides a line from `a` to `b` at `t` of it; exact at both ends.
fn mix(a: Point, b: Point, t: f64) -> Point {
    (a.0 * (1.0 - t) + b.0 * t, a.1 * (1.0 - t) + b.1 * t)
}
