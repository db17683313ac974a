// The tilings that the page can show. Each has programs of its own, made when they are first wanted;
// a seed is a number handed over, so another seed is no other program.

// As the library does it: a bijection of 32 bits, and what a hash begins with.
function mix(x) {
    x = Math.imul(x ^ x >>> 16, 0x7feb352d);
    x = Math.imul(x ^ x >>> 15, 0x846ca68b);
    return (x ^ x >>> 16) >>> 0;
}
const seedKey = seed => mix(seed + 0x9e3779b9 | 0);

// The patterns of 16 bits in order of their class, which is the sums of four rows and three columns
// modulo 3; then where every class begins: what the blocks of the difference set are chosen from.
function patterns() {
    const ones = bits => bits ? (bits & 1) + ones(bits >> 1) : 0;
    const classOf = pattern => {
        let found = 0;
        for (let u = 2; u >= 0; u--) found = 3 * found + ones(pattern >> u & 0x1111) % 3;
        for (let v = 3; v >= 0; v--) found = 3 * found + ones(pattern >> 4 * v & 15) % 3;
        return found;
    };
    const classes = Uint16Array.from({ length: 65536 }, (_, pattern) => classOf(pattern));
    const begins = new Uint32Array(2188);
    for (const found of classes) begins[found + 1]++;
    begins.forEach((count, at) => { if (at > 0) begins[at] = begins[at - 1] + count; });
    const data = new Uint32Array(65536 + 9 * 256);
    data.set(begins, 65536);
    classes.forEach((found, pattern) => { data[begins[found]++] = pattern; });
    return { width: 256, height: data.length / 256, channels: 1, data };
}

class Tilings {
    constructor(gl, scene, filter) {
        const one = { internal: gl.R32UI, format: gl.RED_INTEGER, type: gl.UNSIGNED_INT };
        const two = { internal: gl.RG32UI, format: gl.RG_INTEGER, type: gl.UNSIGNED_INT };
        const { width, height, tiles } = scene;
        const [tableWidth, tableHeight] = scene.table;
        Object.assign(this, { gl, scene, filter, one, two });
        // The cell of every tile number; of several the first.
        this.table = new Uint32Array(tableWidth * tableHeight);
        for (let cell = tiles.length - 1; cell >= 0; cell--) this.table[tiles[cell]] = cell;
        numbersTexture(gl, UNITS.table, one, tableWidth, tableHeight, this.table);
        // For every cell its place when tiles lie in order of their numbers, and the other way.
        const order = tiles.map((tile, cell) => cell).sort((a, b) => tiles[a] - tiles[b] || a - b);
        const ranks = new Uint32Array(2 * tiles.length);
        order.forEach((cell, rank) => {
            ranks[2 * cell] = rank;
            ranks[2 * rank + 1] = cell;
        });
        numbersTexture(gl, UNITS.ranks, two, width, height, ranks);
        this.different = new Set(tiles).size;
        this.framebuffer = gl.createFramebuffer();
        this.room = [0, 0];
        this.made = scene.tilings.map(() => ({}));
        this.which = 0;
        this.seed = scene.seed;
    }

    get now() {
        return this.scene.tilings[this.which];
    }

    get seeded() {
        return this.now.keys.length > 0;
    }

    // What tells this tiling from all others.
    get name() {
        return this.seeded ? this.now.name + " " + this.seed : this.now.name;
    }

    // Where a tiling stands in the list, by its name.
    find(name) {
        return this.scene.tilings.findIndex(tiling => tiling.name === name);
    }

    // A program of a tiling, as it is.
    make(which, purpose) {
        const made = this.made[which], tiling = this.scene.tilings[which];
        if (made[purpose]) return made[purpose];
        const head = document.getElementById("tiling-" + tiling.name).textContent +
            "\n#define TP_MAP" + (tiling.map ? " , map" : "") + "\n";
        if (tiling.map && !made.map) made.map = this.mapTexture(tiling.map === "patterns" ? patterns() : tiling.map);
        // Four tiles a texel; their number is handed over so that the loop stays one.
        const numbers = `uniform usampler2D map; uniform ivec2 corner; uniform int four; out uvec4 numbers;
            void main() {
                ivec2 at = ivec2(gl_FragCoord.xy) * ivec2(4, 1) + corner;
                numbers = uvec4(0u);
                for (int i = 0; i < four; i++)
                    numbers = uvec4(numbers.yzw, tp_number(tp_sides(at.x + i, at.y TP_MAP)));
            }`;
        made[purpose] = makeProgram(this.gl, head + (purpose === "drawing" ? this.filter : numbers));
        return made[purpose];
    }

    mapTexture({ width, height, channels, data }) {
        const format = channels === 2 ? this.two : this.one;
        return numbersTexture(this.gl, UNITS.map, format, width, height, Uint32Array.from(data));
    }

    // Makes the program of the tiling the one to draw with; the places of its uniforms.
    use(purpose) {
        const gl = this.gl, { program, places } = this.make(this.which, purpose);
        gl.useProgram(program);
        if (this.now.map) {
            gl.activeTexture(gl.TEXTURE0 + UNITS.map);
            gl.bindTexture(gl.TEXTURE_2D, this.made[this.which].map);
        }
        for (const name of ["table", "map", "ranks", "atlas"]) {
            if (places[name]) gl.uniform1i(places[name], UNITS[name]);
        }
        for (const [name, more] of this.now.keys) {
            if (places[name]) gl.uniform1ui(places[name], seedKey(this.seed + more));
        }
        return places;
    }

    // The numbers of the tiles of a window, row by row from the south.
    window(x, y, width, height) {
        const gl = this.gl, texels = Math.ceil(width / 4);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
        if (this.room[0] < texels || this.room[1] < height) {
            this.room = [Math.max(this.room[0], texels), Math.max(this.room[1], height)];
            gl.deleteTexture(this.target);
            gl.activeTexture(gl.TEXTURE0 + UNITS.window);
            this.target = gl.createTexture();
            gl.bindTexture(gl.TEXTURE_2D, this.target);
            gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, ...this.room);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.target, 0);
        }
        const places = this.use("numbers");
        gl.viewport(0, 0, texels, height);
        gl.uniform2i(places.corner, x, y);
        gl.uniform1i(places.four, 4);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const rows = new Uint32Array(4 * texels * height);
        gl.readPixels(0, 0, texels, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, rows);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        if (width === 4 * texels) return rows;
        return rows.filter((_, at) => at % (4 * texels) < width);
    }

    // The colors of a tile, and where it lies in the atlas.
    about(tile) {
        const [h, v] = this.scene.colors, width = this.scene.width, cell = this.table[tile];
        const sides = [
            Math.floor(tile / (v * h * v)), Math.floor(tile / (h * v)) % v, Math.floor(tile / v) % h, tile % v,
        ];
        return { tile, sides, row: Math.floor(cell / width), column: cell % width };
    }
}
