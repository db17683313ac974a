// The color of a point by tables of permutations: row i of the map is the size N of table i, then its
// N entries. (Lagae 2007, equations 3.3 and 3.6.)
fn NAME_color(x: i32, y: i32, colors: u32, MAP_PARAMETER) -> u32 {
    var sum: u32 = 0u;
    for (var i: i32 = 0; i < i32(NAME_TABLES); i = i + 1) {
        let size: u32 = NAME_entry(0u, i, map);
        let first: u32 = NAME_entry(1u + NAME_around(x, size), i, map);
        sum = sum + NAME_entry(1u + (first + NAME_around(y, size)) % size, i, map);
    }
    return (sum % 24u) % colors;
}
