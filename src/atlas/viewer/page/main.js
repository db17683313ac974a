// The page: it draws when something changed.

function fail(error) {
    element("failure").hidden = false;
    element("failure").textContent = error.message;
    element("panel").hidden = element("status").hidden = true;
}

// What a link asks for after #: tiling=halton&seed=7&x=3&y=2&zoom=48&view=assembled&bias=1&repeats=1
// with borders, hardware, folded.
function follow(link, view, controls) {
    const asked = new URLSearchParams(link.replace(/^#/, ""));
    const number = (name, otherwise) => {
        const value = asked.get(name);
        return value === null || value === "" || Number.isNaN(Number(value)) ? otherwise : Number(value);
    };
    const tiling = view.tilings.find(asked.get("tiling"));
    if (tiling >= 0) controls.tiling(tiling);
    if (asked.has("seed")) controls.seed(number("seed", NaN));
    view.moveTo(number("x", view.x), number("y", view.y));
    view.zoomTo(number("zoom", view.zoom));
    const which = VIEWS.indexOf(asked.get("view"));
    if (which >= 0) controls.view(which);
    if (asked.has("bias")) controls.set("bias", number("bias", 0));
    for (const id of ["borders", "repeats", "hardware"]) {
        if (asked.has(id)) controls.flip(id, asked.get(id) !== "0");
    }
    if (asked.has("folded")) controls.fold(asked.get("folded") !== "0");
}

// Makes the programs of the other tilings while nothing else is to do, so that choosing one is quick.
function warm(tilings) {
    const later = window.requestIdleCallback || (work => setTimeout(work, 200));
    const next = which => later(() => {
        if (which >= tilings.made.length || tilings.gl.isContextLost()) return;
        tilings.make(which, "drawing");
        tilings.make(which, "numbers");
        next(which + 1);
    });
    setTimeout(() => next(0), 1000);
}

async function begin() {
    const scene = JSON.parse(element("scene").textContent);
    const canvas = element("canvas");
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: false });
    if (!gl) throw new Error("This browser or graphics card has no WebGL 2.");
    canvas.addEventListener("webglcontextlost", () => fail(new Error("The graphics card was lost: load the page again.")));
    const levels = await atlasTexture(gl, scene);
    const tilings = new Tilings(gl, scene, element("filter-text").textContent);
    const view = new View(canvas, gl, scene, levels, tilings);
    const time = new FrameTime(gl);
    let waiting = false;
    const tellTime = () => {
        element("time").textContent = time.words;
        // The first one tells nothing yet.
        if (time.frames === 1) changed();
    };
    const changed = () => {
        if (waiting) return;
        waiting = true;
        requestAnimationFrame(() => {
            waiting = false;
            // What has to be read back first is not counted, nor what is said.
            tilings.make(tilings.which, "drawing");
            tell(view, scene);
            time.of([tilings.now.name, view.view, view.probes, view.hardware].join());
            time.measure(() => view.draw(), tellTime);
        });
    };
    const fit = () => {
        const ratio = window.devicePixelRatio || 1;
        view.resize(Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio));
        changed();
    };
    const controls = makeControls(view, scene, changed);
    listenToPointers(canvas, view, controls, changed);
    listenToKeys(view, controls, changed);
    window.addEventListener("resize", fit);
    window.addEventListener("hashchange", () => follow(location.hash, view, controls));
    controls.fold(canvas.clientWidth <= 480);
    follow(location.hash, view, controls);
    fit();
    warm(tilings);
    return { view, scene, controls, time };
}

// For scripts, as that of our tests: resolves to the view, the scene, the controls and the clock.
window.tilepack = begin();
window.tilepack.catch(fail);
