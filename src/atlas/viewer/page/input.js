// Mouse, touch, wheel and keyboard to what the camera does.

function devicePixels(event) {
    const ratio = window.devicePixelRatio || 1;
    return [event.clientX * ratio, event.clientY * ratio];
}

// One pointer moves, two zoom as well.
function listenToPointers(canvas, view, controls, changed) {
    const down = new Map();
    // How far a click has strayed.
    let strayed = 0;
    const middle = () => {
        const all = [...down.values()];
        const sum = all.reduce(([x, y], [px, py]) => [x + px, y + py], [0, 0]);
        return sum.map(at => at / all.length);
    };
    const spread = () => {
        const [a, b] = [...down.values()];
        return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
    };
    const look = event => {
        view.pointer = devicePixels(event);
    };
    canvas.addEventListener("pointerdown", event => {
        canvas.focus({ preventScroll: true });
        // A pointer made up by a script cannot be captured.
        try { canvas.setPointerCapture(event.pointerId); } catch { /* then it stays inside */ }
        strayed = 0;
        down.set(event.pointerId, devicePixels(event));
        canvas.classList.add("held");
        look(event);
        changed();
    });
    canvas.addEventListener("pointermove", event => {
        if (down.has(event.pointerId)) {
            const [x, y] = middle(), wide = spread();
            down.set(event.pointerId, devicePixels(event));
            const [nowX, nowY] = middle(), nowWide = spread();
            view.pan(nowX - x, nowY - y);
            strayed += Math.abs(nowX - x) + Math.abs(nowY - y);
            if (wide > 0 && nowWide > 0) view.zoomAt(nowWide / wide, nowX, nowY);
        }
        look(event);
        changed();
    });
    const up = event => {
        down.delete(event.pointerId);
        if (down.size === 0) canvas.classList.remove("held");
    };
    canvas.addEventListener("pointerup", event => {
        if (event.pointerType === "mouse" && event.button === 0 && strayed < 4) controls.hold();
        up(event);
    });
    canvas.addEventListener("pointercancel", up);
    canvas.addEventListener("pointerleave", event => {
        if (down.size === 0 && event.pointerType === "mouse") view.pointer = null;
        changed();
    });
    canvas.addEventListener("wheel", event => {
        event.preventDefault();
        // Lines and pages are told as such by some mice; a pinch comes as a wheel with Ctrl.
        const unit = [1, 16, 400][event.deltaMode] || 1;
        const speed = event.ctrlKey ? 0.01 : 0.0015;
        view.zoomAt(Math.exp(-event.deltaY * unit * speed), ...devicePixels(event));
        look(event);
        changed();
    }, { passive: false });
}

// What keys do; `controls` has the same names as the elements of the panel.
function listenToKeys(view, controls, changed) {
    const pan = (dx, dy) => event => {
        const far = event.shiftKey ? 640 : 64;
        view.pan(dx * far, dy * far);
    };
    const zoom = factor => () => view.zoomAt(factor, view.canvas.width / 2, view.canvas.height / 2);
    const keys = {
        ArrowLeft: pan(1, 0), ArrowRight: pan(-1, 0), ArrowUp: pan(0, 1), ArrowDown: pan(0, -1),
        "+": zoom(Math.SQRT2), "=": zoom(Math.SQRT2), "-": zoom(Math.SQRT1_2), "_": zoom(Math.SQRT1_2),
        "0": () => {
            view.moveTo(0, 0);
            view.zoomTo(view.scene.side);
        },
        "1": () => controls.view(0), "2": () => controls.view(1),
        "3": () => controls.view(2), "4": () => controls.view(3),
        "[": () => controls.step("bias", -1), "]": () => controls.step("bias", 1),
        ",": () => controls.step("probes", -1), ".": () => controls.step("probes", 1),
        g: () => controls.step("gain", 1), G: () => controls.step("gain", -1),
        t: () => controls.tiling(view.tilings.which + 1), T: () => controls.tiling(view.tilings.which - 1),
        n: () => controls.another(), c: () => controls.hold(),
        b: () => controls.flip("borders"), r: () => controls.flip("repeats"), h: () => controls.flip("hardware"),
        m: () => controls.fold(), "?": () => controls.help(),
    };
    window.addEventListener("keydown", event => {
        // Sliders have keys of their own, and lists and numbers take all.
        const target = event.target instanceof Element ? event.target : document.body;
        const own = target.matches("select, input[type=number]") ||
            target.matches("input") && event.key.startsWith("Arrow");
        const act = keys[event.key];
        if (!act || own || event.ctrlKey || event.metaKey || event.altKey) return;
        if (document.getElementById("help").open) return;
        event.preventDefault();
        act(event);
        changed();
    });
}
