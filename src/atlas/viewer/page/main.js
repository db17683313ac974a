// The page: panel and status line, what they say, and drawing when something changed.

const element = id => document.getElementById(id);

function makeControls(view, scene, changed) {
    const values = {
        bias: value => { view.bias = value; return (value > 0 ? "+" : "") + value.toFixed(2); },
        probes: value => { view.probes = 2 ** value; return view.probes + " : 1"; },
        gain: value => { view.gain = 2 ** value; return "× " + view.gain; },
    };
    const apply = id => {
        element(id + "-value").textContent = values[id](Number(element(id).value));
        changed();
    };
    const buttons = [...element("views").children];
    const controls = {
        view(which) {
            view.view = which;
            buttons.forEach((button, at) => {
                button.setAttribute("aria-checked", String(at === which));
                button.tabIndex = at === which ? 0 : -1;
            });
            element("gain-row").hidden = VIEWS[which] !== "difference";
            changed();
        },
        step(id, by) {
            by > 0 ? element(id).stepUp() : element(id).stepDown();
            apply(id);
        },
        flip(id) {
            element(id).checked = !element(id).checked;
            view[id] = element(id).checked;
            changed();
        },
        fold() {
            const folded = !element("controls").hidden;
            element("controls").hidden = folded;
            element("fold").textContent = folded ? "+" : "–";
            element("fold").setAttribute("aria-expanded", String(!folded));
        },
        help() {
            element("help").showModal();
        },
    };
    buttons.forEach((button, at) => button.addEventListener("click", () => controls.view(at)));
    element("views").addEventListener("keydown", event => {
        const by = { ArrowLeft: 3, ArrowRight: 1 }[event.key];
        if (!by) return;
        event.stopPropagation();
        controls.view((view.view + by) % 4);
        buttons[view.view].focus();
    });
    for (const id of Object.keys(values)) {
        element(id).addEventListener("input", () => apply(id));
        apply(id);
    }
    for (const id of ["borders", "hardware"]) {
        element(id).addEventListener("change", () => {
            view[id] = element(id).checked;
            changed();
        });
    }
    element("fold").addEventListener("click", controls.fold);
    element("help-button").addEventListener("click", controls.help);
    element("claim").textContent = scene.exact === null
        ? "Packed and assembled differ at every level: these tiles have no common strip."
        : `Packed and assembled agree bit for bit through LOD ${scene.exact}: ` +
          `the common strip is ${scene.strip} texels wide.`;
    controls.view(0);
    return controls;
}

function tell(view, scene) {
    const lod = view.lod;
    const within = scene.exact !== null && lod <= scene.exact;
    const own = view.probes === 1 && !view.hardware;
    const said = VIEWS[view.view] === "assembled" ? "the truth"
        : VIEWS[view.view] === "row-major" ? "not exact"
        : !within ? "beyond exact LODs"
        : own ? "exact" : "within exact LODs";
    const word = document.createElement("span");
    word.className = ["the truth", "exact"].includes(said) ? "exact" : "beyond";
    word.textContent = said;
    element("lod").replaceChildren(`LOD ${lod.toFixed(2)} · `, word);
    if (!view.hover) {
        element("tile").textContent = scene.coloring;
        return;
    }
    const { x, y, tile, sides, row, column } = view.tileAt(...view.hover);
    const names = scene.sides.map((name, at) => `${name} ${sides[at]}`).join(" ");
    const number = document.createElement("b");
    number.textContent = `tile ${tile}`;
    element("tile").replaceChildren(`(${x}, ${y}) `, number, ` · ${names} · row ${row}, column ${column}`);
}

function fail(error) {
    element("failure").hidden = false;
    element("failure").textContent = error.message;
    element("panel").hidden = element("status").hidden = true;
}

async function begin() {
    const scene = JSON.parse(element("scene").textContent);
    const canvas = element("canvas");
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: false });
    if (!gl) throw new Error("This browser or graphics card has no WebGL 2.");
    canvas.addEventListener("webglcontextlost", () => fail(new Error("The graphics card was lost: load the page again.")));
    const levels = await atlasTexture(gl, scene);
    const texts = { tiling: element("tiling-text").textContent, filter: element("filter-text").textContent };
    const view = new View(canvas, gl, scene, levels, texts);
    let waiting = false;
    const changed = () => {
        if (waiting) return;
        waiting = true;
        requestAnimationFrame(() => {
            waiting = false;
            view.draw();
            tell(view, scene);
        });
    };
    const fit = () => {
        const ratio = window.devicePixelRatio || 1;
        view.resize(Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio));
        changed();
    };
    const controls = makeControls(view, scene, changed);
    listenToPointers(canvas, view, changed);
    listenToKeys(view, controls, changed);
    window.addEventListener("resize", fit);
    fit();
    return { view, scene, controls };
}

// For scripts, as that of our tests: resolves to the view, the scene and the controls.
window.tilepack = begin();
window.tilepack.catch(fail);
