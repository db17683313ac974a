//! The wangsets of a tile set of Tiled in XML, or of those in a map.

use super::wangsets::{Malformed, Raw, RawSet, RawTile, malformed};
use roxmltree::{Document, Node};

/// Reads all wangsets.
///
/// # Errors
/// Text that is no XML, or another document; numbers that are none.
pub(super) fn read(text: &str) -> Result<Raw, Malformed> {
    let document = Document::parse(text).map_err(|error| {
        let at = error.pos();
        let mut message = error.to_string();
        // It says the place itself.
        if let Some(end) = message.rfind(" at ") {
            message.truncate(end);
        }
        Malformed { line: at.row as usize, column: at.col as usize, message }
    })?;
    let root = document.root_element();
    if !["tileset", "map"].contains(&root.tag_name().name()) {
        let message = format!("<{}>: expected <tileset> or <map>", root.tag_name().name());
        return Err(malformed(text, root.range().start, message));
    }
    let mut raw = Raw::default();
    for tileset in root.descendants().filter(|node| node.has_tag_name("tileset")) {
        if let Some(source) = tileset.attribute("source") {
            raw.elsewhere.push(source.to_owned());
        }
        let children = |name| tileset.children().filter(move |node| node.has_tag_name(name));
        let turned = ["hflip", "vflip", "rotate"];
        raw.transformed |= children("transformations")
            .any(|node| turned.iter().any(|name| node.attribute(*name).is_some_and(|v| v != "0")));
        for wangsets in children("wangsets") {
            for node in wangsets.children().filter(|node| node.has_tag_name("wangset")) {
                raw.wangsets.push(wangset(text, node)?);
            }
        }
    }
    Ok(raw)
}

fn wangset(text: &str, node: Node<'_, '_>) -> Result<RawSet, Malformed> {
    let mut tiles = Vec::new();
    for tile in node.children().filter(|node| node.has_tag_name("wangtile")) {
        let at = tile.range().start;
        let attribute = |name| {
            let missing = || malformed(text, at, format!("<wangtile> without {name}"));
            tile.attribute(name).ok_or_else(missing)
        };
        let id = attribute("tileid")?;
        let wrong = |_| malformed(text, at, format!("tileid '{id}': expected a number"));
        let id = id.parse().map_err(wrong)?;
        tiles.push(RawTile { id, wangid: attribute("wangid")?.to_owned(), at });
    }
    Ok(RawSet {
        name: node.attribute("name").unwrap_or_default().to_owned(),
        kind: node.attribute("type").unwrap_or_default().to_owned(),
        colors: node.children().filter(|node| node.has_tag_name("wangcolor")).count(),
        tiles,
        at: node.range().start,
    })
}
