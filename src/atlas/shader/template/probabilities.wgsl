// The color of a point by the probabilities of its cell of the map, SCALE_X by SCALE_Y points: every
// color has a texel, its threshold and its alias. (A. J. Walker, 1977.)
fn NAME_color(x: i32, y: i32, colors: u32, MAP_PARAMETER) -> u32 {
    let cell: u32 = NAME_around(x, NAME_MAP_W * NAME_SCALE_X) / NAME_SCALE_X;
    let up: u32 = NAME_around(y, NAME_MAP_H * NAME_SCALE_Y) / NAME_SCALE_Y;
    let choice: u32 = NAME_uni(NAME_hash(x, y, NAME_KEY), colors);
    let own: vec2u = FETCH_MAP_XY(vec2i(i32(cell * colors + choice), i32(NAME_MAP_H - 1u - up)));
    if (NAME_hash(x, y, NAME_KEY_SECOND) < own.x) {
        return choice;
    }
    return own.y;
}
