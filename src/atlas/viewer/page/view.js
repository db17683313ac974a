// The camera, and pictures of what it sees. Positions are in tiles, x east and y north; sizes in
// device pixels.

const VIEWS = ["packed", "row-major", "assembled", "difference"];
const FARTHEST = 2 ** 30 - 4096;

class View {
    constructor(canvas, gl, scene, levels, tilings) {
        Object.assign(this, { canvas, gl, scene, levels, tilings });
        this.x = this.y = 0;
        // Pixels of a tile.
        this.zoom = scene.side;
        this.view = 0;
        this.bias = 0;
        this.probes = 1;
        this.gain = 1;
        this.borders = false;
        this.repeats = false;
        this.hardware = false;
        // The pixel under the pointer, from the north-west; the tile that is held, by its number.
        this.pointer = null;
        this.held = null;
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

    zoomTo(zoom) {
        this.zoom = Math.min(Math.max(zoom, 2), 64 * this.scene.side);
    }

    // What is at this pixel, from the north-west, stays there.
    zoomAt(factor, px, py) {
        const [x, y] = this.positionAt(px, py);
        const before = this.zoom;
        this.zoomTo(this.zoom * factor);
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
        const key = [this.tilings.name, x, y].join();
        if (this.found?.key !== key) {
            const [tile] = this.tilings.window(x, y, 1, 1);
            this.found = { key, tile: { x, y, ...this.tilings.about(tile) } };
        }
        return this.found.tile;
    }

    // The tile under the pointer; without one, where repeats are shown, that in the middle.
    get looked() {
        if (!this.pointer && !this.repeats) return null;
        const [x, y] = this.pointer ? this.positionAt(...this.pointer) : [this.x, this.y];
        return this.tileAt(Math.floor(x), Math.floor(y));
    }

    // The number of the tile whose copies are shown.
    get marked() {
        return this.repeats ? this.held ?? this.looked.tile : null;
    }

    // The tiles in view, also those of which but a part is: south-west one, width and height.
    get extent() {
        const { width, height } = this.canvas;
        const [west, north] = this.positionAt(0, 0), [east, south] = this.positionAt(width, height);
        const [x, y] = [Math.floor(west), Math.floor(south)];
        return [x, y, Math.ceil(east) - x, Math.ceil(north) - y];
    }

    // How often a tile is in view, and how many tiles are.
    count(tile) {
        const extent = this.extent, key = [this.tilings.name, ...extent].join();
        if (this.seen?.key !== key) this.seen = { key, tiles: this.tilings.window(...extent) };
        const tiles = this.seen.tiles;
        return [tiles.reduce((copies, other) => copies + (other === tile), 0), tiles.length];
    }

    draw() {
        // What reads tiles back comes first: it draws, too.
        const marked = this.marked, looked = this.repeats || this.borders ? this.looked : null;
        const gl = this.gl, places = this.tilings.use("drawing");
        const base = [Math.floor(this.x), Math.floor(this.y)];
        gl.viewport(0, 0, this.canvas.width, this.canvas.height);
        gl.uniform2i(places.base, ...base);
        gl.uniform2f(places.offset, this.x - base[0], this.y - base[1]);
        gl.uniform1f(places.scale, 1 / this.zoom);
        gl.uniform2f(places.middle, this.canvas.width / 2, this.canvas.height / 2);
        gl.uniform1i(places.side, this.scene.side);
        gl.uniform1i(places.gutter, this.scene.gutter);
        gl.uniform1i(places.last_level, this.levels - 1);
        gl.uniform1f(places.lod, this.lod);
        gl.uniform1i(places.probes, this.probes);
        gl.uniform1i(places.view, this.view);
        gl.uniform1f(places.gain, this.gain);
        gl.uniform1i(places.hardware, this.hardware ? 1 : 0);
        gl.uniform1i(places.encoded, this.scene.srgb ? 1 : 0);
        gl.uniform1f(places.pixel, window.devicePixelRatio || 1);
        gl.uniform1i(places.borders, this.borders ? 1 : 0);
        gl.uniform1i(places.repeats, this.repeats ? 1 : 0);
        gl.uniform1ui(places.marked, marked ?? 0);
        gl.uniform1i(places.hovering, looked ? 1 : 0);
        gl.uniform2i(places.hover, looked?.x ?? 0, looked?.y ?? 0);
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
