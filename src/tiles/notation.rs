//! Tile sets in text: `complete`, `compact`, `pruned:0-1,2-3`.
//!
//! The same words stand on the command line and in the header of a text grid. Anything else on
//! the command line names a tile set file; see [`crate::store`].

use super::{Color, Members, TileError};

/// The members that `text` describes, or `None` when it is none of the words of the notation.
///
/// # Errors
/// When it starts like one of the words but goes on wrongly.
pub fn parse_members(text: &str) -> Result<Option<Members>, TileError> {
    match text {
        "complete" => Ok(Some(Members::Complete)),
        "compact" => Ok(Some(Members::Compact)),
        _ => match text.strip_prefix("pruned:") {
            Some(pairs) => parse_pairs(text, pairs).map(Some),
            None => Ok(None),
        },
    }
}

fn parse_pairs(text: &str, pairs: &str) -> Result<Members, TileError> {
    let wrong = || TileError::SetSyntax(text.to_owned());
    let color = |digits: &str| {
        let plain = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
        if plain { digits.parse().map(Color).map_err(|_| wrong()) } else { Err(wrong()) }
    };
    pairs
        .split(',')
        .map(|pair| {
            let (a, b) = pair.split_once('-').ok_or_else(wrong)?;
            Ok((color(a)?, color(b)?))
        })
        .collect::<Result<_, _>>()
        .map(Members::Pruned)
}

/// The notation of `members`; an explicit set gives the number of its tiles.
pub fn write_members(members: &Members) -> String {
    match members {
        Members::Complete => "complete".to_owned(),
        Members::Compact => "compact".to_owned(),
        Members::Pruned(pairs) => {
            let pairs: Vec<_> = pairs.iter().map(|(a, b)| format!("{a}-{b}")).collect();
            format!("pruned:{}", pairs.join(","))
        }
        Members::Explicit(tiles) => format!("{} tiles", tiles.len()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_pairs() {
        for text in ["complete", "compact", "pruned:0-1,2-3", "pruned:7-250"] {
            let members = parse_members(text).unwrap().unwrap();
            assert_eq!(write_members(&members), text);
        }
        assert_eq!(parse_members("tiles.json"), Ok(None));
        for text in
            ["pruned:", "pruned:0", "pruned:0-", "pruned:0-1,", "pruned:0-256", "pruned:+0-1"]
        {
            assert_eq!(parse_members(text), Err(TileError::SetSyntax(text.to_owned())));
        }
    }
}
