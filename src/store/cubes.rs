//! Packings of cubes: one JSON object, `tilepack/1`, with `layers` in place of `tiles`.
//!
//! As for other solutions, fields may come in any order, unknown ones are ignored, and the
//! provenance is kept but never trusted. The sides must be those of all the cubes before a layer
//! is looked at, so that a file cannot ask for more memory than it has numbers. Errors in a layer
//! name the layer, and the row and column in it.

use super::json::{Field, List, Number, json_error};
use super::{FORMAT, Input, StoreError};
use crate::torus::{CubeKind, CubeSet, Cubes, MAX_CUBES};
use serde::Deserialize;
use serde::de::{self, DeserializeSeed, Deserializer, IgnoredAny, SeqAccess, Visitor};
use serde_json::value::RawValue;
use serde_json::{Value, json};
use std::fmt;
use std::io::{self, Write};

/// A packing of cubes from a file. Not verified.
#[derive(Debug, Clone, PartialEq)]
pub struct CubeSolution {
    /// The cubes.
    pub packing: Cubes,
    /// What the file says about where it comes from, `null` if nothing. Not to be trusted.
    pub provenance: Value,
}

/// The fields as text.
#[derive(Debug, Deserialize)]
struct Document<'a> {
    #[serde(borrow)]
    format: Option<&'a RawValue>,
    #[serde(borrow)]
    kind: Option<&'a RawValue>,
    #[serde(borrow)]
    colors: Option<&'a RawValue>,
    #[serde(borrow)]
    set: Option<&'a RawValue>,
    #[serde(borrow)]
    width: Option<&'a RawValue>,
    #[serde(borrow)]
    height: Option<&'a RawValue>,
    #[serde(borrow)]
    depth: Option<&'a RawValue>,
    #[serde(borrow)]
    topology: Option<&'a RawValue>,
    #[serde(borrow)]
    layers: Option<&'a RawValue>,
    #[serde(borrow)]
    provenance: Option<&'a RawValue>,
}

const KINDS: [CubeKind; 2] = [CubeKind::Corner, CubeKind::Wang];

/// Whether a file says that it holds cubes; what else it says may be wrong.
pub fn holds_cubes(input: &Input) -> bool {
    // Most files do not have the word at all, and need not be read twice.
    let named = KINDS.iter().any(|kind| input.text().contains(kind.name()));
    if !named || !input.is_json() {
        return false;
    }
    #[derive(Deserialize)]
    struct Kind<'a> {
        #[serde(borrow)]
        kind: Option<&'a RawValue>,
    }
    let text = &input.text()[input.start()..];
    let first = serde_json::Deserializer::from_str(text).into_iter::<Kind<'_>>().next();
    match first {
        Some(Ok(Kind { kind: Some(kind) })) => {
            KINDS.iter().any(|known| kind.get() == format!("\"{known}\""))
        }
        Some(Err(_)) => KINDS.iter().any(|kind| text.contains(&format!("\"{kind}\""))),
        _ => false,
    }
}

/// The one packing of cubes of a file.
///
/// # Errors
/// A malformed file, or sides that do not suit the cubes.
pub fn read_cubes(input: &Input) -> Result<CubeSolution, StoreError> {
    let start = input.start();
    let text = &input.text()[start..];
    let mut objects = serde_json::Deserializer::from_str(text).into_iter::<Document<'_>>();
    let document = match objects.next() {
        Some(Ok(document)) => document,
        Some(Err(error)) => return Err(json_error(input, start, text, &error)),
        None => return Err(input.error_at(start, "expected a packing of cubes")),
    };
    let end = start + objects.byte_offset();
    let rest = input.text()[end..].trim_start();
    if !rest.is_empty() {
        return Err(input.error_at(input.text().len() - rest.len(), "expected the end of the file"));
    }
    let field = |name: &str, raw| Field::required(input, start, name, raw);
    field("format", document.format)?.word("format", &[FORMAT])?;
    field("topology", document.topology)?.word("topology", &["torus"])?;
    field("set", document.set)?.word("set", &["complete"])?;
    let named = field("kind", document.kind)?;
    named.word("kind", &KINDS.map(CubeKind::name))?;
    let name = named.string()?;
    let kind = if name == CubeKind::Corner.name() { CubeKind::Corner } else { CubeKind::Wang };
    let colors = field("colors", document.colors)?;
    let palettes: [u64; 3] = colors.read(Palettes)?;
    let set = palettes.map(u8::try_from);
    let set = match set {
        [Ok(h), Ok(v), Ok(z)] => CubeSet::new(kind, [h, v, z]),
        _ => None,
    };
    let set = set.ok_or_else(|| {
        colors.error(format!("expected 1 or more colors, one number of them for corner cubes, and at most {MAX_CUBES} cubes"))
    })?;
    let number = Number { what: "a number of cells", max: MAX_CUBES };
    let side = |name: &str, raw| field(name, raw)?.read(number);
    let depth = side("depth", document.depth)?;
    let height = side("height", document.height)?;
    let width = side("width", document.width)?;
    if depth.checked_mul(height).and_then(|wall| wall.checked_mul(width)) != Some(set.cubes()) {
        let message = format!("size {width}x{height}x{depth}, but there are {} cubes", set.cubes());
        return Err(input.error_at(start, message));
    }
    let sides = [depth, height, width].map(|side| side as usize);
    let mut cubes = Vec::with_capacity(set.cubes() as usize);
    let mut take = |cube: u64| cubes.push(cube as u32);
    let cube = Number { what: "the number of a cube", max: set.cubes() - 1 };
    let nest = Nest { sides: &sides, at: Vec::new(), cube, take: &mut take };
    field("layers", document.layers)?.read(nest)?;
    let provenance = match Field::optional(input, document.provenance) {
        None => Value::Null,
        Some(field) => field.read(std::marker::PhantomData)?,
    };
    Ok(CubeSolution { packing: Cubes { set, sides, cubes }, provenance })
}

/// `2`, or `[2, 3, 4]`.
struct Palettes;

impl<'de> DeserializeSeed<'de> for Palettes {
    type Value = [u64; 3];

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<[u64; 3], D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Palettes {
    type Value = [u64; 3];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number of colors, or [CH, CV, CZ] for Wang cubes")
    }

    fn visit_u64<E: de::Error>(self, count: u64) -> Result<[u64; 3], E> {
        Ok([count; 3])
    }

    fn visit_seq<A: SeqAccess<'de>>(self, counts: A) -> Result<[u64; 3], A::Error> {
        let number = Number { what: "a number of colors", max: u64::MAX };
        let list = List { what: "three numbers of colors", item: number };
        let list = list.deserialize(de::value::SeqAccessDeserializer::new(counts))?;
        let given = list.len();
        <[u64; 3]>::try_from(list).map_err(|_| de::Error::invalid_length(given, &self))
    }
}

/// What the lists at the three depths hold, and which side says how many.
const HELD: [(&str, &str); 3] = [("layers", "depth"), ("rows", "height"), ("cubes", "width")];

/// A list of lists of lists of cubes, or one of those inside, at some layer and row.
struct Nest<'a> {
    sides: &'a [usize; 3],
    /// Layer and row, as far as the list is inside them.
    at: Vec<usize>,
    cube: Number,
    take: &'a mut dyn FnMut(u64),
}

impl Nest<'_> {
    /// `layer 2, row 3 has 5 of 8 cubes, the width`.
    fn wrong(&self, found: Option<usize>) -> String {
        let (what, side) = HELD[self.at.len()];
        let place = match self.at[..] {
            [] => "the packing".to_owned(),
            [layer] => format!("layer {layer}"),
            [layer, row, ..] => format!("layer {layer}, row {row}"),
        };
        let wanted = self.sides[self.at.len()];
        match found {
            Some(found) => format!("{place} has {found} of {wanted} {what}, the {side}"),
            None => format!("{place} has more than {wanted} {what}, the {side}"),
        }
    }
}

impl<'de> DeserializeSeed<'de> for Nest<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Nest<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a list of {}", HELD[self.at.len()].0)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<(), A::Error> {
        let depth = self.at.len();
        for i in 0..self.sides[depth] {
            let there = if depth < 2 {
                let at = self.at.iter().copied().chain([i]).collect();
                let inside = Nest { sides: self.sides, at, cube: self.cube, take: &mut *self.take };
                items.next_element_seed(inside)?.is_some()
            } else {
                items.next_element_seed(self.cube)?.map(&mut *self.take).is_some()
            };
            if !there {
                return Err(de::Error::custom(self.wrong(Some(i))));
            }
        }
        match items.next_element::<IgnoredAny>()? {
            None => Ok(()),
            Some(_) => Err(de::Error::custom(self.wrong(None))),
        }
    }
}

/// What a packing is: the fields of its file before the layers, in the order in which they are
/// written.
pub fn cube_fields(packing: &Cubes) -> Vec<(&'static str, Value)> {
    let [depth, height, width] = packing.sides;
    let colors = match packing.set.single() {
        Some(count) => json!(count),
        None => json!(packing.set.colors),
    };
    vec![
        ("format", json!(FORMAT)),
        ("kind", json!(packing.set.kind.name())),
        ("colors", colors),
        ("set", json!("complete")),
        ("width", json!(width)),
        ("height", json!(height)),
        ("depth", json!(depth)),
        ("topology", json!("torus")),
    ]
}

/// Writes a packing of cubes, one row a line, ending in a newline; equal arguments give equal
/// bytes. `provenance` is written as it is, unless it is `null`.
///
/// # Errors
/// What `out` reports.
pub fn write_cubes(mut out: impl Write, packing: &Cubes, provenance: &Value) -> io::Result<()> {
    let mut begin = '{';
    for (name, value) in cube_fields(packing) {
        writeln!(out, "{begin}")?;
        write!(out, "  \"{name}\": {value}")?;
        begin = ',';
    }
    write!(out, ",\n  \"layers\": [")?;
    let mut comma = "";
    for layer in packing.layers() {
        write!(out, "{comma}\n    [")?;
        let mut between = "";
        for row in layer.chunks(packing.sides[2]) {
            let row: Vec<String> = row.iter().map(u32::to_string).collect();
            write!(out, "{between}\n      [{}]", row.join(", "))?;
            between = ",";
        }
        write!(out, "\n    ]")?;
        comma = ",";
    }
    write!(out, "\n  ]")?;
    if !provenance.is_null() {
        write!(out, ",\n  \"provenance\": {provenance}")?;
    }
    writeln!(out, "\n}}")
}
