/* Two pictures: side by side, under a divider, one after the other, or how they differ. */
const MODES = {side: "Side by side", slider: "Slider", flicker: "Flicker", heat: "Heat map"};
const MAPS = {flip: "FLIP", difference: "Difference", firsts: "First differing buffer"};
const ZOOMS = {fit: "Fit", 1: "100 %", 2: "200 %", 4: "400 %", 8: "800 %", 16: "1600 %"};

const view = {a: null, b: null, mode: "side", map: null, heat: null, zoom: "fit", split: 50, second: false, timer: 0};
view.x = view.y = null; /* the chosen pixel */
const parts = {};

function label(picture) {
	const twins = pictures.filter((other) => other.name === picture.name).length > 1;
	if (!twins || picture.from === picture.name) return picture.name;
	const dir = data.folders.length === 1 ? data.folders[0].dir + "/" : "";
	return `${picture.name} (${picture.from.startsWith(dir) ? picture.from.slice(dir.length) : picture.from})`;
}

function mapsOf() {
	const comparison = comparisonOf(view.a, view.b);
	const can = {flip: pairOf(view.a, view.b), difference: true, firsts: comparison?.layers?.length};
	return Object.keys(MAPS).filter((name) => can[name]);
}

function scaleFor(room) {
	if (view.zoom !== "fit") return Number(view.zoom);
	const fit = room / view.a.width;
	return fit >= 2 ? Math.floor(fit) : fit;
}

function sheetOf(canvases) {
	const sheet = h("div", {class: "sheet"}, canvases);
	sheet.addEventListener("click", (event) => choose(...pixelAt(sheet, event)));
	sheet.addEventListener("pointermove", (event) => read(...pixelAt(sheet, event)));
	sheet.addEventListener("pointerleave", () => read(view.x, view.y));
	return sheet;
}

function pixelAt(sheet, event) {
	const box = sheet.getBoundingClientRect();
	const at = (offset, size, n) => Math.min(n - 1, Math.max(0, Math.floor((offset / size) * n)));
	const x = at(event.clientX - box.left, box.width, view.a.width);
	return [x, at(event.clientY - box.top, box.height, view.a.height)];
}

function copied(canvas, words) {
	const twin = h("canvas", {width: canvas.width, height: canvas.height, role: "img", "aria-label": words});
	twin.getContext("2d").drawImage(canvas, 0, 0);
	return twin;
}

function pane(side, words, name, canvases) {
	const title = h("figcaption", null, h("b", {class: side}, words), h("span", {class: "dim"}, breakable(name)));
	return h("figure", {class: "pane"}, title, h("div", {class: "scroll"}, sheetOf(canvases)));
}

function panesOf() {
	const a = copied(view.a.canvas, "Reference: " + label(view.a));
	const b = copied(view.b.canvas, "Image: " + label(view.b));
	if (view.mode === "side") {
		return [pane("a-side", "reference", label(view.a), [a]), pane("b-side", "image", label(view.b), [b])];
	}
	if (view.mode === "heat") {
		const heat = copied(view.heat.canvas, "Heat map: " + MAPS[view.map]);
		return [pane("", MAPS[view.map], "of image to reference", [heat])];
	}
	if (view.mode === "slider") {
		const names = `${label(view.a)} left, ${label(view.b)} right`;
		return [pane("", "reference | image", names, [a, b, dividerOf()])];
	}
	b.hidden = !view.second;
	a.hidden = view.second;
	const [side, words, picture] = view.second ? ["b-side", "image", view.b] : ["a-side", "reference", view.a];
	return [pane(side, words, label(picture), [a, b])];
}

function dividerOf() {
	const divider = h("div", {class: "divider"});
	const move = (event) => {
		const box = divider.parentElement.getBoundingClientRect();
		split(Math.min(100, Math.max(0, (100 * (event.clientX - box.left)) / box.width)));
	};
	divider.addEventListener("pointerdown", (event) => divider.setPointerCapture(event.pointerId));
	divider.addEventListener("pointermove", (event) => divider.hasPointerCapture(event.pointerId) && move(event));
	divider.addEventListener("click", (event) => event.stopPropagation());
	return divider;
}

function split(percent) {
	view.split = percent;
	parts.range.value = percent;
	const sheet = parts.panes.querySelector(".sheet"), divider = parts.panes.querySelector(".divider");
	if (!divider) return;
	divider.style.left = percent + "%";
	sheet.querySelectorAll("canvas")[1].style.clipPath = `inset(0 0 0 ${percent}%)`;
}

function fit() {
	for (const scroll of parts.panes.querySelectorAll(".scroll")) {
		const scale = scaleFor(scroll.clientWidth), sheet = scroll.firstChild;
		sheet.style.width = view.a.width * scale + "px";
		sheet.style.height = view.a.height * scale + "px";
		for (const canvas of sheet.querySelectorAll("canvas")) canvas.classList.toggle("large", scale >= 2);
	}
	mark();
}

/* The chosen pixel, in each pane. */
function mark() {
	for (const sheet of parts.panes.querySelectorAll(".sheet")) {
		sheet.querySelector(".mark")?.remove();
		if (view.x === null) continue;
		const box = h("div", {class: "mark"});
		const share = (n, of) => (100 * n) / of + "%";
		box.style.left = share(view.x, view.a.width);
		box.style.top = share(view.y, view.a.height);
		box.style.width = share(1, view.a.width);
		box.style.height = share(1, view.a.height);
		sheet.append(box);
	}
}

function follow(scrolls) {
	for (const one of scrolls) {
		one.addEventListener("scroll", () => {
			for (const other of scrolls) {
				if (other === one) continue;
				other.scrollLeft = one.scrollLeft;
				other.scrollTop = one.scrollTop;
			}
		}, {passive: true});
	}
}

async function show() {
	const {a, b, mode} = view;
	await Promise.all([load(a), load(b)]);
	const can = mapsOf();
	if (!can.includes(view.map)) view.map = can[0];
	const heat = mode === "heat" ? await maps[view.map](a, b) : null;
	if (view.a !== a || view.b !== b || view.mode !== mode) return; /* another choice came while pictures were read */
	view.heat = heat;
	fill(parts.panes, panesOf());
	fill(parts.legend, heat ? heat.legend : []);
	fill(parts.map, can.map((name) => h("option", {value: name, selected: name === view.map}, MAPS[name])));
	parts.mapField.hidden = mode !== "heat";
	parts.range.parentElement.hidden = mode !== "slider";
	parts.flicker.hidden = mode !== "flicker";
	if (mode !== "flicker") play(false);
	fit();
	if (mode === "slider") split(view.split);
	follow([...parts.panes.querySelectorAll(".scroll")]);
	figures();
	read(view.x, view.y);
}

function figures() {
	const pair = pairOf(view.a, view.b);
	const dd = (value, unit) => h("dd", null, value, " ", h("small", null, unit));
	const one = (name, value, unit) => h("div", null, h("dt", null, name), dd(value, unit));
	fill(parts.figures, pair ? [
		one("FLIP", pair.flip.toFixed(4), "0 to 1"),
		one("RMSE", pair.rmse.toFixed(3), "grey levels"),
		one("PSNR", pair.psnr === null ? "∞" : pair.psnr.toFixed(2), "dB"),
		one("SSIM", pair.ssim.toFixed(5), ""),
	] : [note(view.a === view.b ? "One picture." : "Not measured; the heat map shows how they differ.")]);
}

function colour(picture, at) {
	const rgb = [...picture.pixels.slice(at, at + 3)];
	return [swatch(rgb), rgb.join(" ")];
}

const HINT = "Click a pixel to see why it is what it is. Keys: arrows move, with Shift by 10; Space flickers.";

/* What stands below the pictures of the pixel at (x, y). */
function read(x, y) {
	if (!view.a.pixels || !view.b.pixels) return;
	if (x === null) {
		fill(parts.readout, [h("span", {class: "dim"}, HINT)]);
		return;
	}
	const i = y * view.a.width + x;
	const items = [
		`pixel (${x + view.a.left}, ${y + view.a.top})`,
		[h("b", {class: "a-side"}, "reference "), colour(view.a, 4 * i)],
		[h("b", {class: "b-side"}, "image "), colour(view.b, 4 * i)],
		`${apart(view.a, view.b, 4 * i)} grey levels apart`,
	];
	if (view.heat && view.map !== "difference") items.push(`${MAPS[view.map]}: ${view.heat.value(i)}`);
	fill(parts.readout, items.map((item) => h("span", null, item)));
}

async function choose(x, y) {
	view.x = Math.min(view.a.width - 1, Math.max(0, x));
	view.y = Math.min(view.a.height - 1, Math.max(0, y));
	await Promise.all([load(view.a), load(view.b)]);
	mark();
	read(view.x, view.y);
	fill(parts.pixel, pixelPanel());
}

function swap() {
	view.second = !view.second;
	parts.swap.setAttribute("aria-pressed", view.second);
	parts.swap.textContent = view.second ? "Show reference" : "Show image";
	if (view.mode === "flicker") show();
}

function play(on) {
	clearInterval(view.timer);
	view.timer = on ? setInterval(swap, 500) : 0;
	parts.play.setAttribute("aria-pressed", on);
	parts.play.textContent = on ? "Pause" : "Play, twice a second";
}

function keys(event) {
	const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
	const far = event.shiftKey ? 10 : 1;
	if (event.key === " ") {
		if (view.mode !== "flicker") setMode("flicker");
		swap();
	} else if (step) {
		if (view.x === null) choose(view.a.width >> 1, view.a.height >> 1);
		else choose(view.x + far * step[0], view.y + far * step[1]);
	} else {
		return;
	}
	event.preventDefault();
}

function setMode(mode) {
	view.mode = mode;
	parts.modes.querySelector(`input[value="${mode}"]`).checked = true;
	return show();
}

function select(words, options, value, change) {
	const made = h("select", {change: () => change(made.value)},
		options.map(([key, text, disabled]) => h("option", {value: key, disabled, selected: key === value}, text)));
	return h("label", null, words, made);
}

/* Of the pictures that are judged; those of another size than the reference cannot be the image. */
function pickers() {
	const all = pictures.filter((p) => p.judged);
	const fits = (p) => p.width === view.a.width && p.height === view.a.height;
	const pickA = (index) => pick(pictures[index], fits(pictures[index]) ? view.b : pictures[index]);
	fill(parts.pickers, [
		select("Reference", all.map((p) => [p.index, label(p)]), view.a.index, pickA),
		select("Image", all.map((p) => [p.index, label(p), !fits(p)]), view.b.index,
			(index) => pick(view.a, pictures[index]))]);
}

function pick(a, b) {
	if (view.a && (a.width !== view.a.width || a.height !== view.a.height)) view.x = view.y = null;
	if (b.width !== a.width || b.height !== a.height) b = a;
	Object.assign(view, {a, b});
	pickers();
	fill(parts.pixel, pixelPanel());
	return show().then(() => (view.x === null ? null : choose(view.x, view.y)));
}

function viewer() {
	const radio = ([value, words]) => h("label", null,
		h("input", {type: "radio", name: "mode", value, checked: value === view.mode, change: () => setMode(value)}),
		h("span", null, words));
	parts.modes = h("fieldset", {class: "choice", "aria-label": "How to compare"}, Object.entries(MODES).map(radio));
	parts.pickers = h("div", {class: "controls"});
	parts.map = h("select", {change: () => ((view.map = parts.map.value), show())});
	parts.mapField = h("label", {hidden: true}, "Heat map of", parts.map);
	parts.range = h("input", {type: "range", min: 0, max: 100, step: 1, value: 50,
		"aria-label": "Divider: reference to the left, image to the right",
		input: () => split(Number(parts.range.value))});
	parts.swap = button("Show image", swap, {"aria-pressed": "false"});
	parts.play = button("Play, twice a second", () => play(!view.timer), {"aria-pressed": "false"});
	parts.flicker = h("div", {class: "controls", hidden: true}, parts.swap, parts.play);
	parts.panes = h("div", {class: "panes", tabIndex: 0, role: "application",
		"aria-label": "Pictures: arrow keys move the chosen pixel, Space flickers", keydown: keys});
	parts.legend = h("div", {class: "legend"});
	parts.readout = h("div", {class: "readout", role: "status"});
	parts.figures = h("dl", {class: "figures"});
	parts.pixel = h("div", {class: "pixel", tabIndex: 0, role: "region", "aria-label": "The chosen pixel",
		"aria-live": "polite"});
	const zoom = select("Zoom", Object.entries(ZOOMS), view.zoom, (value) => ((view.zoom = value), fit()));
	const field = h("div", {class: "field"}, "Compare", parts.modes);
	const controls = h("div", {class: "controls"}, field, zoom, parts.mapField);
	new ResizeObserver(() => view.a && parts.panes.firstChild && fit()).observe(parts.panes);
	const range = h("div", {hidden: true}, parts.range);
	const left = h("div", null, controls, parts.flicker, parts.panes, range, parts.legend, parts.readout);
	const both = h("div", {class: "viewer"}, left, parts.pixel);
	return section("pictures", "Pictures", parts.pickers, parts.figures, both);
}
