// The panel: what is drawn, and how; and the status line, which says what is seen.

const element = id => document.getElementById(id);

function makeControls(view, scene, changed) {
    const tilings = view.tilings;
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
        tiling(which) {
            const count = scene.tilings.length;
            tilings.which = (which + count) % count;
            element("tiling").selectedIndex = tilings.which;
            element("words").textContent = tilings.now.words;
            const fixed = !tilings.seeded;
            element("seed").disabled = element("new").disabled = fixed;
            element("seed").value = fixed ? "" : tilings.seed;
            changed();
        },
        seed(seed) {
            if (!tilings.seeded || !(seed >= 0 && seed < 2 ** 32)) return;
            tilings.seed = Math.floor(seed);
            element("seed").value = tilings.seed;
            changed();
        },
        another() {
            controls.seed(Math.floor(Math.random() * 1e6));
        },
        // Holds the tile whose repeats are shown, or lets it go.
        hold() {
            view.held = view.held === null && view.repeats ? view.looked.tile : null;
            changed();
        },
        step(id, by) {
            by > 0 ? element(id).stepUp() : element(id).stepDown();
            apply(id);
        },
        set(id, value) {
            element(id).value = value;
            apply(id);
        },
        flip(id, on = !view[id]) {
            element(id).checked = view[id] = on;
            if (id === "repeats") view.held = null;
            changed();
        },
        fold(folded = !element("controls").hidden) {
            element("controls").hidden = folded;
            element("fold").textContent = folded ? "+" : "–";
            element("fold").setAttribute("aria-expanded", String(!folded));
        },
        help() {
            element("help").showModal();
        },
    };
    if (!scene.packed) {
        buttons[0].textContent = "atlas";
        buttons[0].title = "Filtered in the atlas (1)";
    }
    buttons.forEach((button, at) => button.addEventListener("click", () => controls.view(at)));
    element("views").addEventListener("keydown", event => {
        const by = { ArrowLeft: 3, ArrowRight: 1 }[event.key];
        if (!by) return;
        event.stopPropagation();
        controls.view((view.view + by) % 4);
        buttons[view.view].focus();
    });
    element("tiling").replaceChildren(...scene.tilings.map(({ title }) => new Option(title)));
    element("tiling").addEventListener("change", () => controls.tiling(element("tiling").selectedIndex));
    element("seed").addEventListener("input", () => {
        if (element("seed").value !== "") controls.seed(Number(element("seed").value));
    });
    element("new").addEventListener("click", controls.another);
    for (const id of Object.keys(values)) {
        element(id).addEventListener("input", () => apply(id));
        apply(id);
    }
    for (const id of ["borders", "repeats", "hardware"]) {
        element(id).addEventListener("change", () => controls.flip(id, element(id).checked));
    }
    element("fold").addEventListener("click", () => controls.fold());
    element("help-button").addEventListener("click", controls.help);
    const atlas = scene.packed ? "Packed" : "Atlas";
    const reach = scene.gutter > 0 ? `gutters of ${scene.gutter} and a` : "the";
    element("claim").textContent = scene.exact === null
        ? `${atlas} and assembled differ at every level: what filters read across a border is not what ` +
          "the tiling has there."
        : `${atlas} and assembled agree bit for bit through LOD ${scene.exact}: ` +
          `${reach} common strip ${scene.gutter > 0 ? "of" : "is"} ${scene.strip} texels` +
          (scene.gutter > 0 ? "." : " wide.");
    controls.view(0);
    controls.tiling(0);
    return controls;
}

// What is said of a tile: where it is, its number and colors, its cell.
function tellTile(scene, { x, y, tile, sides, row, column }, held) {
    const names = scene.sides.map((name, at) => `${name} ${sides[at]}`).join(" ");
    const number = document.createElement("b");
    number.textContent = `tile ${tile}`;
    const where = held ? "held: " : `(${x}, ${y}) `;
    element("tile").replaceChildren(where, number, ` · ${names} · row ${row}, column ${column}`);
}

// How often the marked tile is in view, and how often each would be if all were equally frequent.
function tellCopies(view) {
    element("copies").hidden = !view.repeats;
    if (!view.repeats) return;
    const [copies, tiles] = view.count(view.marked), different = view.tilings.different;
    const number = document.createElement("b");
    number.textContent = copies === 1 ? "1 copy" : `${copies} copies`;
    const share = (tiles / different).toFixed(1);
    element("copies").replaceChildren(number, ` among ${tiles} in view · 1/${different} is ${share}`);
}

function tellLevel(view, scene) {
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
}

function tell(view, scene) {
    tellLevel(view, scene);
    tellCopies(view);
    const looked = view.looked;
    if (view.repeats && view.held !== null) tellTile(scene, view.tilings.about(view.held), true);
    else if (looked) tellTile(scene, looked, false);
    else element("tile").textContent = view.tilings.now.words;
}
