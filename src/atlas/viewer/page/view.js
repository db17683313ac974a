// The camera, and pictures of what it sees. Positions are in tiles, x east and y north; sizes in
// device pixels.

const VIEWS = ["packed", "row-major", "assembled", "difference"];
const FARTHEST = 2 ** 30 - 4096;

class View {
    constructor(canvas, gl, scene, levels, texts) {
        Object.assign(this, { canvas, gl, scene, levels });
        this.table = tilingTextures(gl, scene);
        const head = texts.tiling + "\n#define TP_MAP" + (scene.map ? " , map" : "") + "\n";
        this.drawing = makeProgram(gl, head + texts.filter);
        this.looking = makeProgram(gl, head + `uniform usampler2D map; uniform ivec2 tile;
            out uvec4 sides;
            void main() { sides = tp_sides(tile.x, tile.y TP_MAP); }`);
        gl.activeTexture(gl.TEXTURE0 + UNITS.probe);
        const probe = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, probe);
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, 1, 1);
        this.framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, probe, 0);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        this.x = this.y = 0;
        // Pixels of a tile.
        this.zoom = scene.side;
        this.view = 0;
        this.bias = 0;
        this.probes = 1;
        this.gain = 1;
        this.borders = false;
        this.hardware = false;
        this.hover = null;
    }

    get texelsPerPixel() {
        return this.scene.side / this.zoom;
    }

    get lod() {
        const lod = Math.max(0, Math.log2(this.texelsPerPixel)) + this.bias;
        return Math.min(Math.max(lod, 0), this.levels - 1);
    }

    resize(width, height) {
        this.canvas.width = Math.max(1, width);
        this.canvas.height = Math.max(1, height);
    }

    // By pixels, as the hand goes: y down.
    pan(dx, dy) {
        this.moveTo(this.x - dx / this.zoom, this.y + dy / this.zoom);
    }

    moveTo(x, y) {
        const inReach = at => Math.min(Math.max(at, -FARTHEST), FARTHEST);
        this.x = inReach(x);
        this.y = inReach(y);
    }

    // What is at this pixel, from the north-west, stays there.
    zoomAt(factor, px, py) {
        const [x, y] = this.positionAt(px, py);
        const before = this.zoom;
        this.zoom = Math.min(Math.max(this.zoom * factor, 2), 64 * this.scene.side);
        const kept = before / this.zoom;
        this.moveTo(x + (this.x - x) * kept, y + (this.y - y) * kept);
    }

    positionAt(px, py) {
        return [
            this.x + (px - this.canvas.width / 2) / this.zoom,
            this.y + (this.canvas.height / 2 - py) / this.zoom,
        ];
    }

    // The tile at a place: its number, colors and cell, from the functions that draw it.
    tileAt(x, y) {
        const gl = this.gl, { program, places } = this.looking;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
        gl.viewport(0, 0, 1, 1);
        gl.useProgram(program);
        if (places.map) gl.uniform1i(places.map, UNITS.map);
        gl.uniform2i(places.tile, x, y);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const found = new Uint32Array(4);
        gl.readPixels(0, 0, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, found);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        const sides = Array.from(found), [h, v] = this.scene.colors;
        const tile = ((sides[0] * v + sides[1]) * h + sides[2]) * v + sides[3];
        const cell = this.table[tile], width = this.scene.width;
        return { x, y, tile, sides, row: Math.floor(cell / width), column: cell % width };
    }

    draw() {
        const gl = this.gl, { program, places } = this.drawing;
        const base = [Math.floor(this.x), Math.floor(this.y)];
        gl.viewport(0, 0, this.canvas.width, this.canvas.height);
        gl.useProgram(program);
        for (const name of ["table", "map", "ranks", "atlas"]) {
            if (places[name]) gl.uniform1i(places[name], UNITS[name]);
        }
        gl.uniform2i(places.base, ...base);
        gl.uniform2f(places.offset, this.x - base[0], this.y - base[1]);
        gl.uniform1f(places.scale, 1 / this.zoom);
        gl.uniform2f(places.middle, this.canvas.width / 2, this.canvas.height / 2);
        gl.uniform1i(places.side, this.scene.side);
        gl.uniform1i(places.last_level, this.levels - 1);
        gl.uniform1f(places.lod, this.lod);
        gl.uniform1i(places.probes, this.probes);
        gl.uniform1i(places.view, this.view);
        gl.uniform1f(places.gain, this.gain);
        gl.uniform1i(places.hardware, this.hardware ? 1 : 0);
        gl.uniform1i(places.encoded, this.scene.srgb ? 1 : 0);
        gl.uniform1f(places.borders, this.borders ? window.devicePixelRatio || 1 : 0);
        gl.uniform1i(places.hovering, this.hover && this.borders ? 1 : 0);
        gl.uniform2i(places.hover, ...(this.hover || [0, 0]));
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    // The picture now: red, green, blue and opacity, rows from the south.
    pixels() {
        const gl = this.gl, { width, height } = this.canvas;
        this.draw();
        const data = new Uint8Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
        return data;
    }
}
