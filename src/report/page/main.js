/* The page. */
function sources() {
	const dirs = [...data.folders.map((f) => f.dir), ...data.traces.map((t) => t.dir)];
	const names = dirs.length ? dirs : data.pictures.map((p) => p.name);
	return h("p", {class: "dim"}, names.map((name, i) => [i ? ", " : "", h("span", {class: "mono"}, name)]));
}

function subject() {
	const traced = data.traces.map(({effect, scene}) => ({effect, scene: scene?.name}));
	const runs = [...data.folders.map(({report}) => report), ...traced];
	const words = runs.filter((run) => run.effect).map(({effect, scene}) => (scene ? `${effect} of ${scene}` : effect));
	const sizes = pictures.filter((p) => p.judged).map((p) => `${p.width} × ${p.height} pixels`);
	return [...new Set([...words, ...sizes])].join(" · ");
}

function verdict({said}) {
	const n = said.differences?.length;
	const counted = n && said.judged !== undefined;
	const count = counted ? h("span", {class: "dim"}, ` ${n} of ${said.judged} buffers judged differ `) : null;
	return h("p", null, chip(said.verdict), count, n ? h("a", {href: "#differences"}, "First divergence") : null);
}

/* What is looked at first: a comparison, else the first pair, else the first two pictures. */
function firstPair() {
	const shownBoth = data.comparisons.find((c) => c.image !== undefined) || data.pairs[0];
	if (shownBoth) return [pictures[shownBoth.reference], pictures[shownBoth.image]];
	const one = pictures.find((picture) => picture.judged);
	const fits = (other) => other.judged && other !== one && other.width === one.width && other.height === one.height;
	return one ? [one, pictures.find(fits) || one] : null;
}

/* The pixel of the first difference, if there is one. */
function chooseFirst() {
	const comparison = comparisonOf(view.a, view.b), unlike = comparison?.said.differences || [];
	const first = unlike.flatMap((one) => one.first).find((d) => d.x !== undefined) || comparison?.probes?.[0];
	if (first) choose(first.x, first.y);
}

function main() {
	const pair = firstPair();
	const parts = [mediaSection(), metricsSection(), differencesSection(), figuresSection(), gallery(), tracesSection()];
	const sections = [pair ? viewer() : null, ...parts].filter((part) => part);
	const link = (part) => h("li", null, h("a", {href: "#" + part.id}, part.querySelector("h2").textContent));
	const title = h("h1", null, "touchstone report"), about = subject();
	document.title = "touchstone report: " + (about || "nothing");
	document.body.append(h("header", null, title, h("p", null, about), sources(), allComparisons().map(verdict)),
		h("nav", {"aria-label": "Parts of this page"}, h("ul", null, sections.map(link))), h("main", null, sections),
		h("footer", null, `Written by touchstone ${data.version}. All of it is in this file.`));
	if (pair) pick(...pair).then(chooseFirst);
}

main();
