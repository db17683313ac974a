// The number of the tile with these sides.
fn NAME_number(sides: vec4u) -> u32 {
    return ((sides.x * NAME_CV + sides.y) * NAME_CH + sides.z) * NAME_CV + sides.w;
}
