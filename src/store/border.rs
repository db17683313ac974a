//! The border of a board: in a file of its own, in a solution, in the first line of a grid.
//!
//! A file has a line for every side with a prescribed color, its name and then its colors, from
//! west to east or from north to south: `north 0 0 . 1`, `.` where it is free. A solution has the
//! one color of all outer sides, or an object of lists by the names of the sides, with `null`. A
//! grid has the one color, or `north:0,0,.,1;east:...`.

use super::{Input, StoreError};
use crate::torus::board::SIDES;
use crate::torus::{Border, Shape, Topology};
use serde_json::{Map, Value, json};

/// The colors by side, not yet a border.
type Sides = [Vec<Option<u8>>; 4];

/// Reads a file of a border.
///
/// # Errors
/// A line that is none, a side that is not an outer one or has another length, a color that is
/// no number up to 254.
pub fn read_border(input: &Input, topology: Topology, shape: Shape) -> Result<Border, StoreError> {
    let mut sides = Sides::default();
    let mut at = 0;
    for line in input.text().split_inclusive('\n') {
        let start = at;
        at += line.len();
        let said = line.split('#').next().unwrap_or_default().trim_start_matches('\u{feff}');
        let offset = |word: &str| start + (word.as_ptr() as usize - line.as_ptr() as usize);
        let mut words = said.split_whitespace();
        let Some(name) = words.next() else { continue };
        let Some(side) = SIDES.iter().position(|&side| side == name) else {
            let message = format!("'{name}': expected a side: north, east, south or west");
            return Err(input.error_at(offset(name), message));
        };
        if !sides[side].is_empty() {
            return Err(input.error_at(offset(name), format!("{name}: said before")));
        }
        for word in words {
            let color = color(word).map_err(|message| input.error_at(offset(word), message))?;
            sides[side].push(color);
        }
        // Each side by itself, so that the error is at its line.
        let mut one = Sides::default();
        one[side].clone_from(&sides[side]);
        if one[side].is_empty() {
            return Err(input.error_at(offset(name), format!("{name}: expected its colors")));
        }
        Border::new(topology, shape, one)
            .map_err(|error| input.error_at(offset(name), error.to_string()))?;
    }
    Border::new(topology, shape, sides).map_err(|error| input.error(error.to_string()))
}

/// A color, or `.` for a free place.
fn color(word: &str) -> Result<Option<u8>, String> {
    let digits = !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_digit());
    match word {
        "." => Ok(None),
        _ => match word.parse::<u8>().ok().filter(|&color| digits && color < u8::MAX) {
            Some(color) => Ok(Some(color)),
            None => Err(format!("color '{word}': expected a number from 0 to 254, or .")),
        },
    }
}

/// The border as a value of a solution; `null` where all is free.
pub(super) fn border_value(border: &Border, topology: Topology, shape: Shape) -> Value {
    if border.is_free() {
        return Value::Null;
    }
    if let Some(color) = border.single(topology, shape) {
        return json!(color);
    }
    let lists = SIDES.iter().enumerate().filter(|(side, _)| !border.side(*side).is_empty());
    let lists = lists.map(|(side, name)| ((*name).to_owned(), json!(border.side(side))));
    Value::Object(lists.collect::<Map<_, _>>())
}

/// The border that a value of a solution says.
pub(super) fn border_of(value: &Value, topology: Topology, shape: Shape) -> Result<Border, String> {
    let expected = || "border: expected a color, or lists of colors by side".to_owned();
    let color = |value: &Value| {
        let color = value.as_u64().and_then(|color| u8::try_from(color).ok());
        color.filter(|&color| color < u8::MAX).ok_or_else(expected)
    };
    let lists = match value {
        Value::Null => return Ok(Border::default()),
        Value::Object(lists) => lists,
        value => {
            let border = Border::of_one(topology, shape, color(value)?);
            return match border.is_free() {
                true => Err(format!("a {topology} has no border")),
                false => Ok(border),
            };
        }
    };
    let mut sides = Sides::default();
    for (name, list) in lists {
        let Some(side) = SIDES.iter().position(|side| side == name) else {
            return Err(format!("border: {name:?}: expected north, east, south or west"));
        };
        for value in list.as_array().ok_or_else(expected)? {
            sides[side].push(if value.is_null() { None } else { Some(color(value)?) });
        }
    }
    Border::new(topology, shape, sides).map_err(|error| error.to_string())
}

/// The border as a word of a grid.
pub(super) fn border_word(border: &Border, topology: Topology, shape: Shape) -> String {
    if let Some(color) = border.single(topology, shape) {
        return color.to_string();
    }
    let word = |color: &Option<u8>| color.map_or(".".to_owned(), |color| color.to_string());
    let lists = SIDES.iter().enumerate().filter(|(side, _)| !border.side(*side).is_empty());
    let lists = lists.map(|(side, name)| {
        let colors: Vec<String> = border.side(side).iter().map(word).collect();
        format!("{name}:{}", colors.join(","))
    });
    lists.collect::<Vec<_>>().join(";")
}

/// The border that a word of a grid says.
pub(super) fn border_in(word: &str, topology: Topology, shape: Shape) -> Result<Border, String> {
    if !word.contains(':') {
        let one = color(word)?.ok_or("border: expected a color")?;
        return border_of(&json!(one), topology, shape);
    }
    let mut sides = Sides::default();
    for list in word.split(';') {
        let (name, colors) = list.split_once(':').unwrap_or((list, ""));
        let Some(side) = SIDES.iter().position(|&side| side == name) else {
            return Err(format!("border: '{name}': expected north, east, south or west"));
        };
        sides[side] = colors.split(',').map(color).collect::<Result<_, _>>()?;
    }
    Border::new(topology, shape, sides).map_err(|error| error.to_string())
}
