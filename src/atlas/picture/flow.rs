//! Streams through a dappled tiling, as ribbons that go over and under each other.
//!
//! A strand is a line straight through a cell, or a quarter of a circle around one of its corners.
//! Streams that cross have different colors, if the colors are enough. The same as a page, on which
//! particles follow the streams ([`page`]).

use super::path::QUARTER;
use super::{Paint, Path, Point, Scene};
use crate::dappled::Field;
use crate::dappled::flow::{Flow, forward};
use std::io::{self, Write};

/// The ground.
const GROUND: [u8; 3] = [21, 32, 43];
/// The colors of streams.
const COLORS: [[u8; 3]; 7] = [
    [233, 196, 106],
    [42, 157, 143],
    [231, 111, 81],
    [142, 202, 230],
    [244, 162, 97],
    [168, 201, 87],
    [196, 138, 168],
];
/// How wide a ribbon is, and with the gaps beside it where it goes over another.
const RIBBON: f64 = 0.34;
const GAP: f64 = 0.5;
/// How far a ribbon that goes over reaches from the middle of a cell, before its round end; how far
/// its light does, and its gaps.
const REACH: [f64; 3] = [0.34, 0.47, 0.2];
/// The light along the middle of a ribbon: width, and opacity in percent.
const LIGHT: (f64, u8) = (0.08, 28);

/// A color for every strand: streams that cross have different ones, if that is possible in the
/// order of their length.
fn colors(field: &Field, flow: &Flow) -> Vec<u8> {
    let mut stream_of = vec![0; 2 * field.cells().len()];
    for (number, stream) in flow.streams.iter().enumerate() {
        stream.strands.iter().for_each(|&strand| stream_of[strand as usize] = number);
    }
    let mut order: Vec<usize> = (0..flow.streams.len()).collect();
    order.sort_by_key(|&stream| std::cmp::Reverse(flow.streams[stream].strands.len()));
    let mut color: Vec<Option<usize>> = vec![None; flow.streams.len()];
    let mut used = [0; COLORS.len()];
    for stream in order {
        let mut near = [0; COLORS.len()];
        for &strand in &flow.streams[stream].strands {
            if let Some(color) = color[stream_of[strand as usize ^ 1]] {
                near[color] += 1;
            }
        }
        let best = (0..COLORS.len()).min_by_key(|&c| (near[c], used[c])).unwrap_or(0);
        color[stream] = Some(best);
        used[best] += flow.streams[stream].strands.len();
    }
    stream_of.iter().map(|&stream| color[stream].unwrap_or(0) as u8).collect()
}

/// Where a strand comes into its cell and where it leaves, each with the direction there.
fn ends(field: &Field, strand: u32) -> [(Point, Point); 2] {
    let cell = strand as usize / 2;
    let (column, row) = (cell % field.width(), cell / field.width());
    let center = (column as f64 + 0.5, row as f64 + 0.5);
    let sign = |street: usize| if forward(street) { 1.0 } else { -1.0 };
    let along = |by_column: bool| match by_column {
        true => (0.0, sign(column)),
        false => (sign(row), 0.0),
    };
    let by_column = strand % 2 == 1;
    let (into, out) = (along(by_column), along(by_column != (field.cells()[cell] == 1)));
    [
        ((center.0 - 0.5 * into.0, center.1 - 0.5 * into.1), into),
        ((center.0 + 0.5 * out.0, center.1 + 0.5 * out.1), out),
    ]
}

/// The streams as a picture.
pub fn scene(field: &Field, flow: &Flow) -> Scene {
    let (width, height) = (field.width() as f64, field.height() as f64);
    let mut scene = Scene::new(width, height);
    let mut ground = Path::default();
    ground.rectangle(0.0, 0.0, width, height);
    scene.draw(ground, Paint::Fill, GROUND);
    let colors = colors(field, flow);
    let mut ribbons: [Path; COLORS.len()] = Default::default();
    let mut over: [Path; COLORS.len()] = Default::default();
    let mut gaps = Path::default();
    let [mut light, mut light_over] = [Path::default(), Path::default()];
    for stream in &flow.streams {
        let mut last = None;
        for &strand in &stream.strands {
            let color = usize::from(colors[strand as usize]);
            let [(from, into), (to, out)] = ends(field, strand);
            for path in [&mut ribbons[color], &mut light] {
                // Across a seam it goes on at the other side.
                if last != Some(from) {
                    path.move_to(from);
                }
                match into == out {
                    true => path.line_to(to),
                    false => path.cubic_to(
                        (from.0 + into.0 * QUARTER / 2.0, from.1 + into.1 * QUARTER / 2.0),
                        (to.0 - out.0 * QUARTER / 2.0, to.1 - out.1 * QUARTER / 2.0),
                        to,
                    ),
                }
            }
            last = Some(to);
            let cell = strand as usize / 2;
            let even = (cell % field.width() + cell / field.width()).is_multiple_of(2);
            if into == out && even == (strand % 2 == 0) {
                let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
                for (path, reach) in
                    [&mut over[color], &mut light_over, &mut gaps].into_iter().zip(REACH)
                {
                    path.move_to((middle.0 - reach * into.0, middle.1 - reach * into.1));
                    path.line_to((middle.0 + reach * into.0, middle.1 + reach * into.1));
                }
            }
        }
    }
    for (path, color) in ribbons.into_iter().zip(COLORS) {
        scene.draw(path, Paint::Stroke(RIBBON), color);
    }
    let white = [255; 3];
    scene.draw_through(light, Paint::Stroke(LIGHT.0), white, LIGHT.1);
    scene.draw(gaps, Paint::Stroke(GAP), GROUND);
    for (path, color) in over.into_iter().zip(COLORS) {
        scene.draw(path, Paint::Stroke(RIBBON), color);
    }
    scene.draw_through(light_over, Paint::Stroke(LIGHT.0), white, LIGHT.1);
    scene
}

/// Writes a page on which particles follow the streams: one file, nothing else is loaded.
///
/// # Errors
/// What `out` reports.
pub fn page(
    out: &mut dyn Write,
    field: &Field,
    flow: &Flow,
    size: u32,
    title: &str,
) -> io::Result<()> {
    let mut next: Vec<u32> = vec![0; 2 * field.cells().len()];
    for stream in &flow.streams {
        // What leaves the rectangle comes in again where its stream does.
        let following = stream.strands.iter().skip(1).chain(&stream.strands[..1]);
        for (&strand, &following) in stream.strands.iter().zip(following) {
            next[strand as usize] = following;
        }
    }
    let digits = |digits: &[u8]| digits.iter().map(u8::to_string).collect::<String>();
    let picture = {
        let mut text = Vec::new();
        super::svg::write_svg(&mut text, &scene(field, flow), size, title)?;
        String::from_utf8(text).map_err(io::Error::other)?
    };
    let data = format!(
        "{{\"width\":{},\"height\":{},\"size\":{size},\"tiles\":\"{}\",\"next\":{next:?}}}",
        field.width(),
        field.height(),
        digits(field.cells()),
    );
    let text = include_str!("flow.html")
        .replace("@title@", &crate::atlas::formats::escape(title))
        .replace("@ratio@", &super::svg::number(field.width() as f64 / field.height() as f64))
        .replace("@data@", &data)
        .replace("@picture@", &picture);
    out.write_all(text.as_bytes())
}
