// How long a frame takes, smoothed. Where the graphics card has a clock, it is asked, and answers some
// frames later; else the time is taken until a pixel can be read back (browsers do not wait in finish).

class FrameTime {
    constructor(gl) {
        this.gl = gl;
        this.clock = gl.getExtension("EXT_disjoint_timer_query_webgl2");
        this.waiting = [];
        this.what = null;
        this.of("");
    }

    // What is drawn from now on; the mean is of that alone.
    of(what) {
        if (what === this.what) return;
        Object.assign(this, { what, mean: 0, frames: 0 });
    }

    get kind() {
        return this.clock ? "GPU" : "CPU";
    }

    // Draws, and calls `told` when there is a new mean.
    measure(draw, told) {
        const gl = this.gl;
        if (!this.clock) {
            const start = performance.now();
            draw();
            gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
            this.add(performance.now() - start);
            told();
        } else if (this.waiting.length < 4) {
            const query = gl.createQuery();
            gl.beginQuery(this.clock.TIME_ELAPSED_EXT, query);
            draw();
            gl.endQuery(this.clock.TIME_ELAPSED_EXT);
            this.waiting.push(query);
            if (this.waiting.length === 1) this.ask(told);
        } else {
            draw();
        }
    }

    ask(told) {
        setTimeout(() => {
            const gl = this.gl, before = this.waiting.length;
            const broken = gl.getParameter(this.clock.GPU_DISJOINT_EXT);
            while (this.waiting.length && gl.getQueryParameter(this.waiting[0], gl.QUERY_RESULT_AVAILABLE)) {
                const query = this.waiting.shift();
                if (!broken) this.add(gl.getQueryParameter(query, gl.QUERY_RESULT) / 1e6);
                gl.deleteQuery(query);
            }
            if (this.waiting.length < before && this.frames > 0) told();
            if (this.waiting.length && !gl.isContextLost()) this.ask(told);
        }, 30);
    }

    // The first frame does not count: programs are made ready in it.
    add(time) {
        const weight = Math.max(0.2, 1 / Math.max(this.frames, 1));
        if (this.frames > 0) this.mean += weight * (time - this.mean);
        this.frames++;
    }

    get words() {
        return this.frames < 2 ? "" : this.mean.toFixed(this.mean < 10 ? 2 : 0) + " ms " + this.kind;
    }
}
