// Draws the endless tiling. The functions of the tiling (tp_...) stand before this text.
//
// Packed, row by row, and assembled differ in one place, texel(): what lies across the border of a
// tile. Everything else, weights and order of summation too, is the same code, so where the three
// fetch the same texels they give the same bits. All of it is loops over one call of texel(), so that
// compilers, which put in every function where it is called, have little to do.

uniform usampler2D table;
uniform usampler2D map;
// For every cell its place when tiles lie in order of their numbers, and the cell of every place.
uniform usampler2D ranks;
uniform sampler2D atlas;

// The camera: the tile at the middle, the place in it, tiles per pixel, the middle in pixels.
uniform ivec2 base;
uniform vec2 offset;
uniform float scale;
uniform vec2 middle;

uniform int side;
uniform int gutter;
uniform int last_level;
uniform float lod;
uniform int probes;
uniform int view;
uniform float gain;
uniform bool hardware;
uniform bool encoded;
// Device pixels of a pixel of the page.
uniform float pixel;
uniform bool borders;
uniform ivec2 hover;
uniform bool hovering;
// All copies of the tile with this number stand out.
uniform bool repeats;
uniform uint marked;

out vec4 color;

const int PACKED = 0;
const int ROWS = 1;
const int ASSEMBLED = 2;
const int DIFFERENCE = 3;

ivec2 grid() {
    return ivec2(int(tp_WIDTH), int(tp_HEIGHT));
}

// Rounded down, also below zero.
ivec2 divided(ivec2 a, int by) {
    return ivec2(floor((vec2(a) + 0.5) / float(by)));
}

// The texel q of a level: counted from the north-west corner of a tile, x east, y south, and perhaps
// outside of it. `cell` is where the tile lies in the sheet of the view; around each is a gutter.
vec4 texel(int how, ivec2 tile, ivec2 cell, ivec2 q, int level) {
    int s = max(side >> level, 1);
    int g = gutter >> level;
    int block = s + 2 * g;
    if (how == ASSEMBLED) {
        ivec2 step = divided(q, s);
        ivec2 there = cell;
        if (step != ivec2(0)) {
            there = ivec2(tp_cell(tp_sides(tile.x + step.x, tile.y - step.y TP_MAP), table));
        }
        return texelFetch(atlas, there * block + g + q - step * s, level);
    }
    ivec2 at = cell * block + g + q;
    ivec2 there = divided(at, block);
    ivec2 inside = at - there * block;
    ivec2 around = grid();
    there = there - around * ivec2(floor((vec2(there) + 0.5) / vec2(around)));
    if (how == ROWS) {
        int found = int(texelFetch(ranks, there, 0).g);
        there = ivec2(found % around.x, found / around.x);
    }
    return texelFetch(atlas, there * block + inside, level);
}

// `at` goes from the north-west corner of the tile (0, 0) to its south-east one (1, 1). As many probes
// along the longer axis of the footprint as it is times as long; the axis is x. Each is the mean of
// four texels, or, between two levels, of four of either.
vec4 filtered(int how, ivec2 tile, ivec2 cell, vec2 at) {
    int level = int(floor(lod));
    float part = lod - float(level);
    int texels = part == 0.0 ? 4 : 8;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < probes; i++) {
        float along = (float(i) + 0.5 - 0.5 * float(probes)) * exp2(lod) / float(side);
        for (int k = 0; k < texels; k++) {
            int from = k < 4 ? level : min(level + 1, last_level);
            vec2 p = (at + vec2(along, 0.0)) * float(max(side >> from, 1)) - 0.5;
            vec2 whole = floor(p);
            ivec2 next = ivec2(k & 1, k >> 1 & 1);
            vec2 weights = mix(1.0 - p + whole, p - whole, vec2(next));
            float weight = weights.x * weights.y * (k < 4 ? 1.0 - part : part);
            sum += weight * texel(how, tile, cell, ivec2(whole) + next, from);
        }
    }
    return sum / float(probes);
}

// The same by the graphics card.
vec4 sampled(ivec2 cell, vec2 at) {
    vec2 scale = float(side) / vec2(grid() * (side + 2 * gutter));
    vec2 start = vec2(cell * (side + 2 * gutter) + gutter) / float(side);
    vec2 texel_size = scale * exp2(lod) / float(side);
    vec2 along = vec2(float(probes) * texel_size.x, 0.0);
    return textureGrad(atlas, (start + at) * scale, along, vec2(0.0, texel_size.y));
}

vec3 for_the_eye(vec3 light) {
    vec3 curved = 1.055 * pow(max(light, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055;
    vec3 shown = mix(curved, 12.92 * light, vec3(lessThanEqual(light, vec3(0.0031308))));
    return encoded ? shown : light;
}

vec4 shown(int how, ivec2 tile, ivec2 cell, vec2 at) {
    if (how == ROWS) {
        int rank = int(texelFetch(ranks, cell, 0).r);
        cell = ivec2(rank % grid().x, rank / grid().x);
    }
    vec4 found = hardware && how == PACKED ? sampled(cell, at) : filtered(how, tile, cell, at);
    return vec4(for_the_eye(found.rgb), found.a);
}

void main() {
    vec2 position = offset + (gl_FragCoord.xy - middle) * scale;
    vec2 whole = floor(position);
    ivec2 tile = base + ivec2(whole);
    vec2 inside = position - whole;
    uvec4 sides = tp_sides(tile.x, tile.y TP_MAP);
    ivec2 cell = ivec2(tp_cell(sides, table));
    vec4 found = vec4(0.0);
    for (int i = 0; i < (view == DIFFERENCE ? 2 : 1); i++) {
        int how = view == DIFFERENCE ? i * ASSEMBLED : view;
        found = shown(how, tile, cell, vec2(inside.x, 1.0 - inside.y)) - found;
    }
    if (view == DIFFERENCE) {
        // Differences of opacity are shown as gray.
        color = vec4(gain * max(abs(found.rgb), vec3(abs(found.a))), 1.0);
    } else {
        // What is transparent shows squares of gray, eight pixels each.
        ivec2 square = ivec2(gl_FragCoord.xy) / 8;
        float gray = ((square.x + square.y) & 1) == 0 ? 0.75 : 0.55;
        color = vec4(mix(vec3(gray), found.rgb, found.a), 1.0);
    }
    vec2 edge = min(inside, 1.0 - inside) / scale;
    float near = min(edge.x, edge.y) / pixel;
    bool here = hovering && tile == hover;
    if (repeats) {
        if (tp_number(sides) == marked) {
            // Small tiles are all ring.
            float ring = 1.0 - smoothstep(here ? 4.0 : 2.0, here ? 5.0 : 3.0, near);
            color.rgb = mix(color.rgb, here ? vec3(1.0) : vec3(1.0, 0.72, 0.0), ring);
            return;
        }
        float gray = dot(color.rgb, vec3(0.3, 0.59, 0.11));
        color.rgb = mix(vec3(0.09, 0.1, 0.12), mix(vec3(gray), color.rgb, 0.3), 0.3);
    }
    if (borders && here && !repeats) {
        float ring = 1.0 - smoothstep(2.0, 3.0, near);
        color.rgb = mix(color.rgb, vec3(1.0, 0.72, 0.0), ring);
    } else if (borders) {
        // Dark with a light seam on each side, to be seen on anything.
        float seam = 1.0 - smoothstep(1.5, 2.5, near);
        float line = 1.0 - smoothstep(0.5, 1.5, near);
        color.rgb = mix(color.rgb, vec3(1.0), 0.3 * seam);
        color.rgb = mix(color.rgb, vec3(view == DIFFERENCE ? 0.8 : 0.05), 0.8 * line);
    }
}
