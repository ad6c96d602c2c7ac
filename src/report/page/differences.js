/* What `compare` says: the first divergence, each stage, and the first differences of each buffer. */
function value(text) {
	const found = /^(\S+) = (\S+) \((\w+)\)$/.exec(text);
	return found ? [h("div", null, found[1]), h("div", {class: "mono dim"}, found[2] + " " + found[3])] : text;
}

const HOW = {missing: "missing in the candidate", beside: "not of the reference", twice: "twice"};

function firstsOf(unlike, go) {
	const any = (has) => unlike.first.some(has);
	const side = (key, cell) => ({key, head: key, cell});
	const move = (x, d) => (x === undefined ? null : button("Show pixel", () => go(d.x, d.y)));
	const columns = [
		{key: "where", head: "where"},
		any((d) => d.field) && {key: "field", head: "field"},
		side("reference", (text, d) => (d.how === "unequal" ? value(text) : HOW[d.how])),
		side("candidate", (text) => (text === undefined ? "" : value(text))),
		any((d) => d.ulps) && {key: "ulps", head: "ulps", right: true, cell: (n) => (n > 0 ? "+" : "") + shown(n)},
		go && any((d) => d.x !== undefined) && {key: "x", head: "", cell: move},
	];
	return table(`First differences of ${unlike.buffer}`, columns.filter((c) => c), unlike.first);
}

/* The first pixels of a buffer, on both sides, into the box when the pictures are read. */
async function putCrops(unlike, a, b, box) {
	const places = new Map(unlike.first.filter((d) => d.x !== undefined).map((d) => [`${d.x},${d.y}`, d]));
	await Promise.all([load(a), load(b)]);
	for (const {x, y} of [...places.values()].slice(0, 3)) {
		box.append(h("div", {class: "place"}, h("span", null, `pixel (${x + a.left}, ${y + a.top})`),
			crop(a.canvas, x, y, "reference", "a-side"), crop(b.canvas, x, y, "candidate", "b-side")));
	}
}

/* told: a line that was said already. */
function bufferPart(unlike, a, b, told) {
	const box = h("div", {class: "crops"}), both = a && b;
	const go = async (x, y) => {
		await pick(a, b);
		await choose(x, y);
		document.getElementById("pictures").scrollIntoView();
	};
	if (both) putCrops(unlike, a, b, box);
	const fields = Object.entries(unlike.fields || {}).map(([name, n]) => `${name} ${grouped(n)}`).join(", ");
	return h("div", {class: "buffer"}, h("h3", null, unlike.buffer),
		unlike.line === told ? null : h("p", {class: "mono line"}, unlike.line),
		fields ? note("elements that differ, by field: " + fields) : null, firstsOf(unlike, both ? go : null), box);
}

function stagesPart(stages) {
	const item = (s) => h("li", {class: s.verdict, title: s.why || null},
		`${String(s.number).padStart(2, "0")} ${s.stage}: ${s.verdict}`);
	return h("ol", {class: "stages", "aria-label": "Verdicts of the stages"}, stages.map(item));
}

function imagesPart(said) {
	const words = `${grouped(said.values)} values, ${grouped(said.different)} different in ` +
		`${grouped(said.pixels_different)} of ${grouped(said.pixels)} pixels; largest difference ` +
		`${shown(said.largest)}, root mean square ${shown(said.root_mean_square)}`;
	return [h("p", null, words), (said.first || []).map((first) => h("p", {class: "small mono"}, first.line))];
}

/* said: compare's JSON, of traces or of images. */
function comparisonPart({said, reference, image}) {
	const a = pictures[reference], b = pictures[image], unlike = said.differences || [];
	const parts = unlike.map((one) => bufferPart(one, a, b, said.first_divergence)), more = parts.splice(4);
	return [
		h("p", null, h("span", {class: "a-side mono"}, said.reference), " against ",
			h("span", {class: "b-side mono"}, said.candidate), " ", chip(said.verdict)),
		said.relaxations ? h("p", {class: "small"}, "relaxed: ", h("code", null, said.relaxations)) : null,
		said.first_divergence ? [h("h3", null, "First divergence"), command(said.first_divergence)] : null,
		said.stages ? stagesPart(said.stages) : null,
		said.values !== undefined ? imagesPart(said) : null,
		parts,
		more.length ? folded(`${more.length} more buffers that differ`, more) : null,
		said.buffers ? folded("All buffers", plainTable("buffers", said.buffers)) : null,
	];
}

/* Comparisons of this page, and those that a folder of `compare -o` holds. */
function allComparisons() {
	const kept = data.folders.map((folder) => ({said: folder.report})).filter(({said}) => said.verdict !== undefined);
	return [...data.comparisons, ...kept];
}

function differencesSection() {
	const all = allComparisons();
	return all.length ? section("differences", "First differences", all.map(attempt(comparisonPart))) : null;
}
