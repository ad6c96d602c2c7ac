/* Why a pixel is what it is: the probe's tree, of both sides where they were compared. */
function leaf(value) {
	if (value === null || typeof value !== "object") return true;
	if (Array.isArray(value)) return value.every((item) => item === null || typeof item !== "object");
	return "value" in value && "bits" in value && Object.keys(value).length === 2;
}

function words(value) {
	if (Array.isArray(value)) return value.length ? value.map(shownExactly).join(", ") : "none";
	return shownExactly(value);
}

function shownExactly(value) {
	return value === true ? "yes" : value === false ? "no" : String(value);
}

function leafValue(value) {
	if (value === undefined) return h("span", {class: "dim"}, "–");
	if (value !== null && typeof value === "object" && !Array.isArray(value)) {
		return h("span", {class: "value"}, words(value.value), " ", h("span", {class: "bits"}, words(value.bits)));
	}
	return h("span", {class: "value"}, words(value));
}

function keysOf(a, b) {
	return [...new Set([...Object.keys(a || {}), ...Object.keys(b || {})])];
}

function same(a, b) {
	return JSON.stringify(a) === JSON.stringify(b);
}

function part(of, key) {
	return of === undefined || of === null ? undefined : of[key];
}

/* two: there are both sides, a and b; of which one may lack the key. */
function branch(key, a, b, two, depth) {
	const changed = two && !same(a, b), one = a !== undefined ? a : b;
	if (leaf(one) && (a === undefined || b === undefined || leaf(b))) {
		const both = [h("div", {class: "a-side"}, leafValue(a)), h("div", {class: "b-side"}, leafValue(b))];
		const values = h("div", null, changed ? both : leafValue(one));
		return h("div", {class: "leaf" + (changed ? " changed" : "")}, h("span", {class: "key"}, key), values);
	}
	const list = Array.isArray(one), inner = keysOf(a, b), open = changed || (depth < 1 && inner.length <= 12);
	const count = list ? h("span", {class: "dim"}, ` (${inner.length})`) : null;
	const summary = h("summary", null, key, count, changed ? [" ", chip("different")] : null);
	const children = inner.map((k) => branch(list ? "#" + k : k, part(a, k), part(b, k), two, depth + 1));
	return h("details", {open, class: changed ? "has-change" : null}, summary, children);
}

function tree(a, b) {
	const two = b !== undefined;
	return h("div", {class: "tree"}, keysOf(a, b).map((k) => branch(k, a[k], two ? b[k] : undefined, two, 0)));
}

function treeOfBoth(probe) {
	const [lacking, told] = [true, false].map((lacks) =>
		["reference", "candidate"].filter((side) => (probe[side].none !== undefined) === lacks));
	if (lacking.length) {
		return [lacking.map((side) => note(`${side}: no probe: ${probe[side].none}`)),
			told.map((side) => [h("p", {class: "small"}, `Of the ${side}:`), tree(probe[side])])];
	}
	const shown = tree(probe.reference, probe.candidate);
	const only = h("input", {type: "checkbox", change: () => shown.classList.toggle("only-changed", only.checked)});
	const key = [h("b", {class: "a-side"}, "reference"), " above ", h("b", {class: "b-side"}, "candidate")];
	const words = same(probe.reference, probe.candidate)
		? "Both sides have the same probe: the difference is in a buffer that the probe does not read."
		: ["Where they differ: ", key, ". ", h("label", null, only, " Only that")];
	return [h("p", {class: "small"}, words), shown];
}

function commandsFor(x, y) {
	const traces = [...new Set([view.a.trace, view.b.trace].filter((trace) => trace))];
	return traces.map((trace) => command(`touchstone probe ${quoted(trace)} --pixel ${x},${y}`));
}

const NO_TRACE = "No trace of these pictures is known: render with --trace, and the page shows how to probe a pixel.";

function probePart(x, y) {
	const comparison = comparisonOf(view.a, view.b), probes = comparison?.probes || [];
	const found = probes.find((probe) => probe.x === x && probe.y === y);
	const commands = commandsFor(x + view.a.left, y + view.a.top);
	if (found) return [treeOfBoth(found), commands];
	if (!commands.length) return note(NO_TRACE);
	const all = (comparison?.layers || []).reduce((sum, layer) => sum + layer.pixels, 0);
	const held = `The page holds ${grouped(probes.length)} probes of ${grouped(all)} differing pixels, not this one's.`;
	const words = h("p", {class: "small"}, "This tells why the pixel is what it is:");
	return [probes.length ? note(held) : null, words, commands];
}

/* To the next pixel, or the one before, whose probe is held. */
function step(by) {
	const probes = comparisonOf(view.a, view.b).probes;
	const at = probes.findIndex((probe) => probe.x === view.x && probe.y === view.y);
	const next = probes[(at + by + (at < 0 && by < 0 ? 1 : 0) + probes.length) % probes.length];
	choose(next.x, next.y);
}

function pixelPanel() {
	const {a, b, x, y} = view;
	const walk = comparisonOf(a, b)?.probes?.length
		? h("div", {class: "walk"}, button("Previous", () => step(-1)), button("Next differing pixel", () => step(1)))
		: null;
	if (x === null) return [h("h3", null, "A pixel"), walk, note("Click a picture, or move with the arrow keys.")];
	const second = a === b ? null : crop(b.canvas, x, y, "image", "b-side");
	const crops = h("div", {class: "crops"}, crop(a.canvas, x, y, "reference", "a-side"), second);
	return [h("h3", null, `Pixel (${x + a.left}, ${y + a.top})`), walk, crops, probePart(x, y)];
}
