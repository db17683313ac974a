"use strict";
(async () => {
    const answers = {};
    const frame = () => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    const later = time => new Promise(resolve => setTimeout(resolve, time));
    const largest = data => data.reduce((most, value, at) => at % 4 < 3 && value > most ? value : most, 0);
    const apart = (a, b) => a.reduce((most, value, at) => Math.max(most, Math.abs(value - b[at])), 0);
    const text = id => document.getElementById(id).textContent;
    // Hands and keys. The picture must be another one after each.
    const canvas = document.getElementById("canvas");
    const hands = async ({ view, time }, size, answers) => {
        const tilings = view.tilings;
        let before = view.pixels();
        const moved = () => {
            const now = view.pixels();
            const changed = apart(now, before) > 0;
            before = now;
            return changed;
        };
        const pointer = (kind, x, y, id = 1, type = "mouse") =>
            canvas.dispatchEvent(new PointerEvent(kind, {
                clientX: x, clientY: y, pointerId: id, pointerType: type, bubbles: true, cancelable: true,
            }));
        const key = (key, more = {}) =>
            document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...more }));
        const { x, y, zoom } = view;
        pointer("pointerdown", 50, 60);
        pointer("pointermove", 66, 100);
        pointer("pointerup", 66, 100);
        answers.drag = moved() && Math.abs(view.x - (x - 16 / zoom)) < 1e-9 && Math.abs(view.y - (y + 40 / zoom)) < 1e-9;
        // What is under the pointer stays there.
        const held = view.positionAt(30, 40);
        canvas.dispatchEvent(new WheelEvent("wheel", { deltaY: -240, clientX: 30, clientY: 40, bubbles: true, cancelable: true }));
        answers.wheel = moved() && view.zoom > zoom && apart(view.positionAt(30, 40), held) < 1e-9;
        const wheeled = view.zoom;
        pointer("pointerdown", 60, 60, 2, "touch");
        pointer("pointerdown", 100, 60, 3, "touch");
        pointer("pointermove", 140, 60, 3, "touch");
        pointer("pointerup", 140, 60, 3, "touch");
        pointer("pointerup", 60, 60, 2, "touch");
        answers.pinch = moved() && Math.abs(view.zoom / wheeled - 2) < 1e-9;
        const west = view.x;
        key("ArrowRight");
        answers.arrow = moved() && view.x > west;
        const small = view.zoom;
        key("+");
        answers.plus = moved() && view.zoom > small;
        key("2");
        answers["view key"] = moved() && view.view === 1;
        key("1");
        before = view.pixels();
        for (let times = 0; times < 16; times++) key("]");
        answers["bias key"] = moved() && view.bias === 4 && text("bias-value") === "+4.00";
        key("b");
        answers["borders key"] = moved() && view.borders;
        key("?");
        answers.help = document.getElementById("help").open;
        document.getElementById("help").close();
        // Another tiling, another seed, and back.
        if (tilings.which !== 0) throw new Error("not the first tiling");
        key("t");
        answers["tiling key"] = moved() && tilings.which === 1;
        key("T");
        const seed = tilings.seed;
        key("n");
        answers["new key"] = moved() && tilings.which === 0 && tilings.seed !== seed;

        // The copies of the tile under the pointer; a click holds the tile, wherever the pointer goes.
        key("r");
        answers["repeats key"] = moved() && view.repeats;
        const click = (x, y) => {
            pointer("pointerdown", x, y);
            pointer("pointerup", x, y);
        };
        click(70, 80);
        const tile = view.tileAt(...view.positionAt(70, 80).map(Math.floor)).tile;
        let other = 90;
        pointer("pointermove", other, 80);
        while (view.looked.tile === tile) pointer("pointermove", ++other, 80);
        await frame();
        answers.held = view.marked === tile && text("tile").startsWith(`held: tile ${tile} ·`) &&
            /^\d+ cop(y|ies) among \d+ in view · 1\/81 is [\d.]+$/.test(text("copies"));
        click(other, 80);
        answers["let go"] = view.marked !== tile && view.marked === view.looked.tile;
        key("r");
        before = view.pixels();

        // A graphics card with a clock, which answers when it is asked again.
        let asked = 0, told = 0;
        const card = new time.constructor({
            QUERY_RESULT: 1, QUERY_RESULT_AVAILABLE: 2,
            getExtension: () => ({ TIME_ELAPSED_EXT: 3, GPU_DISJOINT_EXT: 4 }),
            createQuery: () => ({}), beginQuery() {}, endQuery() {}, deleteQuery() {},
            getParameter: () => false, isContextLost: () => false,
            getQueryParameter: (query, what) => what === 2 ? asked++ > 0 : 2.5e6,
        });
        card.of("a card");
        for (const _ of [1, 2]) card.measure(() => {}, () => told++);
        for (let tries = 0; tries < 100 && told === 0; tries++) await later(20);
        answers.clock = asked === 3 && told === 1 && card.words === "2.50 ms GPU";

        // A link says where to go.
        location.hash = "#tiling=halton&x=12&y=-7&zoom=24&view=assembled&borders=0";
        await later(0);
        await frame();
        answers.link = moved() && view.x === 12 && view.y === -7 && view.zoom === 24 && view.view === 2 &&
            tilings.which === 1 && !view.borders && document.getElementById("tiling").selectedIndex === 1;
        key("m");
        answers.fold = document.getElementById("controls").hidden;

        // The status line names the tile under the pointer.
        pointer("pointermove", 20, 30);
        await frame();
        const [px, py] = view.positionAt(20, 30).map(Math.floor);
        const under = view.tileAt(px, py);
        answers.hover = text("tile").startsWith(`(${px}, ${py}) tile ${under.tile} ·`) &&
            text("tile").endsWith(`row ${under.row}, column ${under.column}`);
        window.dispatchEvent(new Event("resize"));
        await frame();
        answers.resize = canvas.width === size[0] && canvas.height === size[1] && largest(view.pixels()) > 0;
    };
    try {
        const { view, scene, controls, time } = await window.tilepack;
        await frame();
        const [width, height] = [canvas.width, canvas.height];
        view.resize(192, 192);

        // Difference of packed and assembled, many times enlarged. Pixels lie between texels, so that
        // filters have something to do.
        const difference = (settings, x = -3.2468, y = 5.5391) => {
            Object.assign(view, { view: 3, gain: 1, bias: 0, probes: 1, zoom: scene.side }, settings);
            view.moveTo(x, y);
            return largest(view.pixels());
        };
        const picture = (which, settings = {}) => {
            Object.assign(view, { view: which, gain: 1, bias: 0, probes: 1, zoom: scene.side, hardware: false }, settings);
            return view.pixels();
        };
        view.moveTo(-3.2468, 5.5391);
        answers["row-major"] = apart(picture(1), picture(2));
        answers.hardware = Math.max(
            apart(picture(0, { bias: 0.5 }), picture(0, { bias: 0.5, hardware: true })),
            apart(picture(0, { zoom: 3 * scene.side }), picture(0, { zoom: 3 * scene.side, hardware: true })));
        if (apart(picture(0), picture(2)) !== 0) throw new Error("packed is not assembled");
        if (thorough) {
            for (const bias of [0, 0.5, 1, 1.5, 2]) answers["lod " + bias] = difference({ bias, gain: 256 });
            for (const bias of [2.5, 3, 4]) answers["lod " + bias] = difference({ bias });
            answers.far = difference({ bias: 1, gain: 256 }, -987654321.53, 123456789.29);
            answers.magnified = difference({ zoom: 7 * scene.side, gain: 256 });
            answers["4 : 1"] = difference({ probes: 4, gain: 256 });
            answers["16 : 1"] = difference({ probes: 16 });
        }

        // Every tiling, with its own seed and, if it has one, others: chosen as a hand does it.
        const places = [
            [0, 0], [-1, -1], [5, -7], [-123456789, 1000003], [1 << 29, -(1 << 29)],
            [-(2 ** 30), 2 ** 30 - 2], [2 ** 30 - 2, -(2 ** 30)],
        ];
        let last = new Uint8Array(4);
        const told = () => {
            const { name } = view.tilings.now, seed = view.tilings.seed;
            const differences = [0, 1.5].map(bias => difference({ bias, gain: 256 }));
            const now = picture(0);
            const another = now.length !== last.length || apart(now, last) > 0;
            last = now;
            return { name, seed, differences, another, tiles: places.map(([x, y]) => view.tileAt(x, y)), views: repeats() };
        };
        // The copies of a tile in a window that tiles fill: counted, and those that are not dimmed.
        const repeats = () => [[3, -4, 1], [-987654, 2 ** 29, 70]].map(([x, y, px]) => {
            picture(0, { zoom: 16, pointer: [px, 100] });
            view.moveTo(x, y);
            const plain = view.pixels();
            view.repeats = true;
            const bright = view.pixels(), tile = view.marked, extent = view.extent;
            const middle = at => {
                const pixel = (Math.floor(at / 12) * 16 + 8) * 192 + at % 12 * 16 + 8;
                return [0, 1, 2].every(c => bright[4 * pixel + c] === plain[4 * pixel + c]);
            };
            const shown = Array.from({ length: 144 }, (_, at) => middle(at)).filter(same => same).length;
            const found = { extent, tile, count: view.count(tile), shown };
            Object.assign(view, { repeats: false, pointer: null });
            return found;
        });
        const send = (id, kind) => document.getElementById(id).dispatchEvent(new Event(kind, { bubbles: true }));
        answers.tilings = [];
        scene.tilings.forEach((tiling, at) => {
            document.getElementById("tiling").selectedIndex = at;
            send("tiling", "change");
            answers.tilings.push(told());
            if (tiling.keys.length === 0) return;
            document.getElementById("seed").value = 4294967295;
            send("seed", "input");
            answers.tilings.push(told());
            if (at > 0) return;
            document.getElementById("new").click();
            answers.tilings.push(told());
        });
        for (let frames = 0; frames < 4; frames++) {
            view.pan(1, 0);
            controls.view(0);
            await frame();
        }
        for (let tries = 0; tries < 100 && text("time") === ""; tries++) await later(20);
        answers.time = /^\d+(\.\d+)? ms (GPU|CPU)$/.test(text("time"));
        picture(0);

        if (thorough) {
            controls.tiling(0);
            await hands({ view, time }, [width, height], answers);
        }
        answers.failures = window.failures;
    } catch (error) {
        answers.failures = [...window.failures, String(error.stack)];
    }
    console.log("ANSWERS " + JSON.stringify(answers));
})();
