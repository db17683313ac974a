// A number of the map.
fn NAME_entry(column: u32, row: i32, MAP_PARAMETER) -> u32 {
    return FETCH_MAP_X(vec2i(i32(column), row));
}
