/* Tables of what render measured, what traces say of themselves, and how pictures are apart. */
const TITLES = {
	milliseconds: "Times of stages, ms",
	truth_seconds: "Time of truths",
	counters: "Work",
	bytes: "Memory of buffers, largest batch",
	metrics: "Metrics that render measured, also over reflective pixels",
	light: "Light, in radiance",
};
const QUIET = new Set(["pictures", "notes", "methods", "params", "differences", "buffers", "stages", "first"]);

function isTable(rows) {
	const isRow = (row) => row && typeof row === "object" && !Array.isArray(row);
	return Array.isArray(rows) && rows.length > 0 && rows.every(isRow);
}

function title(key) {
	return TITLES[key] || (key.charAt(0).toUpperCase() + key.slice(1)).replace(/_/g, " ");
}

function columnsOf(rows) {
	const keys = [...new Set(rows.flatMap((row) => Object.keys(row)))];
	const isNumber = (key) => rows.some((row) => typeof row[key] === "number");
	return keys.map((key) => ({key, head: key.includes(".") ? key : key.replace(/_/g, " "), right: isNumber(key)}));
}

/* What a row says by name, of methods or parameters, has columns of its own. */
function flattened(rows) {
	const own = ([key, value]) => (value === null || typeof value !== "object" || Array.isArray(value) ? [[key, value]] :
		Object.entries(value).map(([name, each]) => [key === "values" ? name : `${name}, ${TITLES[key] ? "ms" : key}`, each]));
	return rows.map((row) => Object.fromEntries(Object.entries(row)
		.filter(([key]) => key !== "combination" || !row.values).flatMap(own)));
}

function plainTable(key, rows) {
	const columns = columnsOf(rows);
	if (key === "bytes") for (const c of columns) if (c.right) c.cell = (n) => (typeof n === "number" ? bytes(n) : "–");
	return table(title(key), columns, rows);
}

/* With a bar below each figure; the longest is that of the column's slowest stage. */
function timesTable(rows) {
	const columns = columnsOf(rows);
	for (const c of columns.filter((column) => column.right)) {
		const most = Math.max(...rows.filter((row) => row.stage !== "all").map((row) => row[c.key] || 0));
		c.class = "right bar";
		c.cell = (ms, row) => {
			if (typeof ms !== "number") return "–";
			const bar = h("i", {"aria-hidden": "true"}), share = row.stage === "all" || !most ? 0 : ms / most;
			bar.style.width = `calc(${100 * share}% - ${1.25 * share}rem)`;
			return [ms.toFixed(2), bar];
		};
	}
	return table(TITLES.milliseconds, columns, rows);
}

function tablesOf(object) {
	const found = Object.entries(object || {}).filter(([key, rows]) => !QUIET.has(key) && isTable(rows));
	const isTimes = (key, rows) => key === "milliseconds" && rows[0].stage !== undefined;
	return found.map(([key, rows]) => (isTimes(key, rows) ? timesTable(rows) : plainTable(key, flattened(rows))));
}

function parameters(params) {
	return params ? folded("Parameters", pairs(Object.entries(params))) : null;
}

function singles(object) {
	return pairs(Object.entries(object).filter(([, value]) => value === null || typeof value !== "object"));
}

function folderPart({dir, report, times}) {
	const notes = (report.notes || []).map((text) => h("p", {class: "small"}, "note: " + text));
	return [h("h3", {class: "mono"}, dir), notes, h("div", {class: "tables"}, tablesOf(times), tablesOf(report)),
		folded("About this run", singles({...report, ...times})), parameters(report.params)];
}

function stagesOf(trace) {
	const names = (list) => (Array.isArray(list) ? list.join(", ") : "");
	const columns = [
		{key: "number", head: "", right: true},
		{key: "name", head: "stage"},
		{key: "kind", head: "kind"},
		{key: "doc", head: "what it does"},
		{key: "reads", head: "reads", class: "text small", cell: names},
		{key: "writes", head: "writes", class: "text small", cell: names},
	];
	return folded(`${trace.stages.length} stages`, table("Stages of " + trace.pipeline, columns, trace.stages));
}

function tracePart(trace) {
	const about = {method: trace.pipeline, effect: trace.effect, paper: trace.paper, scene: trace.scene?.name,
		"scene, SHA-256": trace.scene?.sha256, order: trace.order, contract: trace.contract};
	const of = (name) => Object.entries(trace[name] || {}).map(([key, value]) => [`${name}, ${key}`, value]);
	const said = Object.entries(about).filter(([, value]) => value !== undefined);
	return [h("h3", {class: "mono"}, trace.dir), pairs([...said, ...of("producer"), ...of("arithmetic")]),
		isTable(trace.stages) ? stagesOf(trace) : null,
		trace.counters ? folded("Work", pairs(Object.entries(trace.counters))) : null,
		parameters(trace.params)];
}

const METRICS = "FLIP: mean of the error that an observer sees who flips between the two, 0 to 1 (Andersson et al. " +
	`2020), at ${shown(data.ppd)} pixels per degree. RMSE in grey levels of 255, PSNR in dB, SSIM over luma; all of ` +
	"the pictures as they are shown.";

function metricsSection() {
	if (!data.pairs.length) return null;
	const name = (index) => label(pictures[index]);
	const go = (pair) => () => {
		pick(pictures[pair.reference], pictures[pair.image]);
		document.getElementById("pictures").scrollIntoView();
	};
	const digits = (n, count) => (n === null ? "∞" : n.toFixed(count));
	const figure = (key, head, count) => ({key, head, right: true, cell: (n) => digits(n, count)});
	const words = (pair) => `Show ${name(pair.image)} against ${name(pair.reference)}`;
	const columns = [
		{key: "image", head: "image", cell: name},
		{key: "reference", head: "against", cell: name},
		figure("flip", "FLIP", 4),
		figure("rmse", "RMSE", 3),
		figure("psnr", "PSNR, dB", 2),
		figure("ssim", "SSIM", 5),
		{key: "errors", head: "", cell: (_, pair) => button("Show", go(pair), {"aria-label": words(pair)})},
	];
	return section("metrics", "Metrics", table("", columns, data.pairs), note(METRICS));
}

function gallery() {
	const rest = pictures.filter((picture) => !picture.judged);
	if (!rest.length) return null;
	const figure = (picture) => {
		const {width, height, shows} = picture, src = "data:image/png;base64," + picture.png;
		const doc = shows ? h("div", {class: "dim"}, shows) : null;
		const words = h("figcaption", null, h("b", null, breakable(label(picture))), doc);
		return h("figure", null, h("img", {src, alt: shows || picture.name, loading: "lazy", width, height}), words);
	};
	return section("stage-pictures", "Pictures of stages", h("div", {class: "gallery"}, rest.map(figure)));
}

/* Plots and videos of a sweep or a sequence. */
function mediaSection() {
	if (!data.media.length) return null;
	const figure = ({name, type, content, shows}) => {
		const src = `data:${type};base64,${content}`, video = type.startsWith("video/");
		const words = h("figcaption", null, h("b", null, breakable(name)), shows ? h("div", {class: "dim"}, shows) : null);
		return h("figure", null, video ? h("video", {src, controls: true, loop: true, muted: true}) :
			h("img", {src, alt: shows || name}), words);
	};
	return section("plots", "Plots and videos", h("div", {class: "gallery media"}, data.media.map(figure)));
}

function figuresSection() {
	return data.folders.length ? section("figures", "Stages and times", data.folders.map(attempt(folderPart))) : null;
}

function tracesSection() {
	return data.traces.length ? section("traces", "Traces", data.traces.map(attempt(tracePart))) : null;
}
