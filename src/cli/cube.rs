//! `cube`: all corner cubes or all Wang cubes on a torus in space, constructed and checked.
//!
//! The other half of this file tells `verify` what became of a file of cubes.

use super::args::{CubeArgs, CubeKindArg};
use super::exit::Exit;
use super::{duration, output};
use crate::construct::{CubeStack, Seed, WangCubes, cube_binary};
use crate::store::{
    CubeSolution, Input, StoreError, check_writable, cube_fields, read_cubes, write_cubes,
    write_file,
};
use crate::torus::{CubeKind, CubeSet, Cubes, MAX_CUBES};
use crate::verify::{CubesFault, check_cube_packing};
use anyhow::{anyhow, bail};
use serde_json::{Value, json};
use std::time::Instant;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &CubeArgs) -> anyhow::Result<Exit> {
    let begin = Instant::now();
    let set = set(args)?;
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    let (packing, name) = construct(args, set)?;
    check_cube_packing(&packing).map_err(|fault| {
        anyhow!("internal error: what was constructed is no packing: {fault}; please report this")
    })?;
    let how = match args.seed {
        0 => name.to_owned(),
        seed => format!("{name}, member chosen by seed {seed}"),
    };
    let provenance = json!({
        "method": format!("constructed: {how}"),
        "program": "tilepack",
        "version": env!("CARGO_PKG_VERSION"),
        "seed": args.seed,
    });
    if let Some(file) = &args.output {
        write_file(file, |out| write_cubes(out, &packing, &provenance))?;
    }
    if args.json {
        print_json(args, &packing, name, begin)?;
    } else if args.output.is_none() {
        output::result(|out| write_cubes(out, &packing, &provenance))?;
    }
    if !args.quiet {
        let written = match &args.output {
            Some(file) => format!("; written to {}", file.display()),
            None => String::new(),
        };
        let (cubes, time) = (packing.cubes.len(), duration::words(begin.elapsed()));
        output::remark(&format!("constructed: {how}: {cubes} cubes in {time}{written}"));
    }
    Ok(Exit::Yes)
}

/// The cubes that the options describe.
fn set(args: &CubeArgs) -> anyhow::Result<CubeSet> {
    let (kind, most) = match args.kind {
        CubeKindArg::Corner => (CubeKind::Corner, 1),
        CubeKindArg::Wang => (CubeKind::Wang, 3),
    };
    let text = &args.colors;
    let counts: Option<Vec<u8>> =
        text.split(',').map(|count| count.parse().ok().filter(|&count| count > 0)).collect();
    let colors = match counts.as_deref() {
        Some(&[count]) => [count; 3],
        Some(&[h, v, z]) if most == 3 => [h, v, z],
        _ if most == 3 => bail!("--colors '{text}': expected C or CH,CV,CZ, each from 1 to 255"),
        _ => bail!("--colors '{text}': expected a number from 1 to 255"),
    };
    let too_many = || anyhow!("--colors {text}: more than {MAX_CUBES} cubes");
    CubeSet::new(kind, colors).ok_or_else(too_many)
}

/// The packing and the name of its construction.
fn construct(args: &CubeArgs, set: CubeSet) -> anyhow::Result<(Cubes, &'static str)> {
    let mut seed = (args.seed != 0).then(|| Seed::new(args.seed));
    let wanted = args.size.as_deref().map(sides).transpose()?;
    let suits = |sides: [usize; 3]| wanted.is_none_or(|wanted| wanted == sides);
    match set.kind {
        CubeKind::Wang => {
            let product = WangCubes::new(set, seed);
            if suits(product.sides()) {
                return Ok((product.packing(), "product of three rings"));
            }
        }
        CubeKind::Corner => {
            let colors = usize::from(set.colors[0]);
            let side = colors * colors;
            if suits([side * side, side, side])
                && let Some(stack) = CubeStack::new(colors, seed.as_mut())
            {
                let sides = [stack.layers(), side, side];
                let color = |[l, r, c]: [usize; 3]| stack.color(l, r, c);
                return Ok((Cubes::of_points(set, sides, color), "stack of shifted tori"));
            }
            if colors == 2 && args.seed == 0 && suits(cube_binary::SIDES) {
                let color = |[l, r, c]: [usize; 3]| cube_binary::color(l, r, c);
                return Ok((Cubes::of_points(set, cube_binary::SIDES, color), "four layers"));
            }
        }
    }
    let size = args.size.as_deref().unwrap_or_default();
    bail!(
        "--size {size}: no construction is known for it; without --size there is one (and 8x8x4 \
         for corner cubes over 2 colors)"
    )
}

/// `WxHxD` as layers, rows and columns.
fn sides(text: &str) -> anyhow::Result<[usize; 3]> {
    let numbers: Option<Vec<usize>> = text.split('x').map(|side| side.parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[width, height, depth]) => Ok([depth, height, width]),
        _ => bail!("--size '{text}': expected WxHxD, as in 8x8x4"),
    }
}

fn print_json(args: &CubeArgs, packing: &Cubes, name: &str, begin: Instant) -> anyhow::Result<()> {
    let file = args.output.as_deref().map(|file| file.to_string_lossy());
    let mut fields = vec![
        ("result", json!("found")),
        ("method", json!("construct")),
        ("construction", json!(name)),
        ("cubes", json!(packing.cubes.len().to_string())),
        ("seed", json!(args.seed)),
        ("seconds", json!(begin.elapsed().as_secs_f64())),
        ("file", json!(file)),
    ];
    fields.extend(cube_fields(packing));
    if args.output.is_none() {
        let row = |row: &[u32]| json!(row);
        let layer = |layer: &[u32]| Value::from_iter(layer.chunks(packing.sides[2]).map(row));
        fields.push(("layers", packing.layers().map(layer).collect()));
    }
    output::object(&fields)
}

/// What `verify` has to say about a file of cubes.
pub struct CubeReport {
    name: String,
    checked: Result<(CubeSolution, Option<CubesFault>), StoreError>,
}

impl CubeReport {
    /// Reads and checks a file; refuses it when options say something about tiles.
    pub fn new(name: String, input: &Input, about_tiles: bool) -> Self {
        if about_tiles {
            let message = "holds cubes, but the options are about tiles".to_owned();
            let checked = Err(StoreError::Content { file: input.file().into(), message });
            return Self { name, checked };
        }
        let checked = read_cubes(input).map(|solution| {
            let fault = check_cube_packing(&solution.packing).err();
            (solution, fault)
        });
        Self { name, checked }
    }

    /// The exit code for this file alone.
    pub fn exit(&self) -> Exit {
        match &self.checked {
            Err(_) => Exit::Bad,
            Ok((_, Some(fault))) if fault.is_size() => Exit::Bad,
            Ok((_, fault)) => Exit::of(fault.is_none()),
        }
    }

    /// The verdict to standard output; what could not be read to standard error.
    ///
    /// # Errors
    /// When standard output cannot be written to.
    pub fn print(&self, quiet: bool) -> anyhow::Result<()> {
        let name = if self.name == "-" { "standard input" } else { &self.name };
        match &self.checked {
            Err(error) => output::remark(&error.to_string()),
            Ok((_, Some(fault))) => output::line(&format!("{name}: not a packing: {fault}"))?,
            Ok(_) if quiet => {}
            Ok((solution, None)) => {
                let Cubes { set, sides: [depth, height, width], cubes } = &solution.packing;
                let kind = set.kind;
                let colors = match set.single() {
                    Some(1) => "1 color".to_owned(),
                    Some(count) => format!("{count} colors"),
                    None => format!("{:?} colors", set.colors),
                };
                output::line(&format!(
                    "{name}: valid: complete {kind} set over {colors}, {width}x{height}x{depth} \
                     torus, each of {} cubes once",
                    cubes.len()
                ))?;
            }
        }
        Ok(())
    }

    /// The JSON object of the file, with the fields of other packings, and `depth`.
    pub fn object(&self) -> String {
        let (about, error) = match &self.checked {
            Err(error) => (Vec::new(), Some(error.to_string())),
            Ok((solution, fault)) => {
                (cube_fields(&solution.packing), fault.as_ref().map(ToString::to_string))
            }
        };
        let field = |wanted: &str| {
            let found = about.iter().find(|(name, _)| *name == wanted);
            found.map_or(Value::Null, |(_, value)| value.clone())
        };
        let mut fields = vec![("file", json!(self.name)), ("valid", json!(error.is_none()))];
        for name in ["kind", "colors", "width", "height", "depth", "set", "topology"] {
            fields.push((name, field(name)));
        }
        fields.push(("packings", json!(usize::from(self.checked.is_ok()))));
        fields.push(("error", json!(error)));
        output::object_text(&fields)
    }
}
