//! `dapple check`: whether a tiling is dappled, from the definition.

use super::rule;
use crate::cli::args::DappleCheckArgs;
use crate::cli::exit::Exit;
use crate::cli::output;
use serde_json::json;

/// Runs the command.
///
/// # Errors
/// Bad input.
pub fn run(args: &DappleCheckArgs) -> anyhow::Result<Exit> {
    let field = rule::field(&args.file, args.rule.tiles)?;
    let (width, height) = (field.width(), field.height());
    let rule = rule::rule(&args.rule, (width, height))?;
    let free = field.cells().iter().filter(|&&tile| tile == crate::dappled::FREE).count();
    let fault = rule.first_fault(&field);
    let dappled = fault.is_none() && free == 0;
    let reason = match (&fault, free) {
        (Some(fault), _) => Some(fault.to_string()),
        (None, 0) => None,
        (None, free) => Some(format!("{free} cells are free (dapple decide completes them)")),
    };
    if args.json {
        output::object(&[
            ("result", json!(if dappled { "dappled" } else { "not-dappled" })),
            ("width", json!(width)),
            ("height", json!(height)),
            ("free", json!(free)),
            ("error", json!(reason)),
        ])?;
    } else {
        let file = args.file.display();
        match &reason {
            None => output::line(&format!("{file}: dappled, {width}x{height}"))?,
            Some(reason) => output::line(&format!("{file}: not dappled: {reason}"))?,
        }
    }
    Ok(if dappled { Exit::Yes } else { Exit::No })
}
