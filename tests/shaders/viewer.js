"use strict";
(async () => {
    const answers = {};
    const frame = () => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    const largest = data => data.reduce((most, value, at) => at % 4 < 3 && value > most ? value : most, 0);
    const apart = (a, b) => a.reduce((most, value, at) => Math.max(most, Math.abs(value - b[at])), 0);
    const text = id => document.getElementById(id).textContent;
    try {
        const { view, scene, controls } = await window.tilepack;
        const canvas = document.getElementById("canvas");
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
        for (const bias of [0, 0.5, 1, 1.5, 2]) answers["lod " + bias] = difference({ bias, gain: 256 });
        for (const bias of [2.5, 3, 4]) answers["lod " + bias] = difference({ bias });
        answers.far = difference({ bias: 1, gain: 256 }, -987654321.53, 123456789.29);
        answers.magnified = difference({ zoom: 7 * scene.side, gain: 256 });
        answers["4 : 1"] = difference({ probes: 4, gain: 256 });
        answers["16 : 1"] = difference({ probes: 16 });
        const picture = (which, settings = {}) => {
            Object.assign(view, { view: which, gain: 1, bias: 0, probes: 1, zoom: scene.side, hardware: false }, settings);
            return view.pixels();
        };
        answers["row-major"] = apart(picture(1), picture(2));
        answers.hardware = Math.max(
            apart(picture(0, { bias: 0.5 }), picture(0, { bias: 0.5, hardware: true })),
            apart(picture(0, { zoom: 3 * scene.side }), picture(0, { zoom: 3 * scene.side, hardware: true })));
        const plain = picture(0);
        if (apart(plain, picture(2)) !== 0) throw new Error("packed is not assembled");

        answers.tiles = [[0, 0], [-1, -1], [5, -7], [-123456789, 1000003], [1 << 29, -(1 << 29)]]
            .map(([x, y]) => view.tileAt(x, y));

        // Hands and keys. The picture must be another one after each.
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
        answers.resize = canvas.width === width && canvas.height === height && largest(view.pixels()) > 0;
        answers.failures = window.failures;
    } catch (error) {
        answers.failures = [...window.failures, String(error.stack)];
    }
    console.log("ANSWERS " + JSON.stringify(answers));
})();
