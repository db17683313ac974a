//! `tile --stats`: how random a window is.

use super::args::TileArgs;
use super::output;
use super::tile::{Window, head};
use crate::tiling::stats;
use serde_json::json;

/// Counts a window and prints it.
///
/// # Errors
/// What the system says.
pub(super) fn print(args: &TileArgs, window: &Window) -> anyhow::Result<()> {
    let counted = stats(window.kind, window.colors, window.shape, &window.tiles, Some(&window.set));
    let chi2 = counted.chi2_per_df.filter(|_| window.even);
    let needed = counted.tiles.unwrap_or_default();
    if args.json {
        let mut fields = head(args, window)?;
        fields.extend([
            ("width", json!(window.shape.width())),
            ("height", json!(window.shape.height())),
            ("misfits", json!(counted.misfits)),
            ("seen", json!(counted.seen)),
            ("set", json!(needed)),
            ("chi2_per_df", json!(chi2)),
            ("equal_neighbors", json!(counted.equal_neighbors)),
            ("information", json!(counted.information)),
            ("lag", json!([counted.lag.0, counted.lag.1])),
            ("row_agreement", json!(counted.row_agreement)),
            ("column_agreement", json!(counted.column_agreement)),
            ("entropy", json!(window.entropy)),
        ]);
        return output::object(&fields);
    }
    output::result(|out| {
        writeln!(out, "{} tiles: {} misfits", window.tiles.len(), counted.misfits)?;
        let chi2 = chi2.map(|chi2| format!(", chi2/df {chi2:.2}")).unwrap_or_default();
        writeln!(out, "{} of {needed} tiles seen{chi2}", counted.seen)?;
        if let Some(equal) = counted.equal_neighbors {
            writeln!(out, "{equal:.4} of 8 neighbors have the color of a corner")?;
        }
        let (x, y) = counted.lag;
        writeln!(
            out,
            "mutual information of two colors: at most {:.4} bits, at ({x}, {y})",
            counted.information
        )?;
        writeln!(
            out,
            "two rows agree in at most {:.3} of their colors, two columns in {:.3}",
            counted.row_agreement, counted.column_agreement
        )?;
        writeln!(out, "{:.4} bits of freedom a tile", window.entropy)
    })
}
