/* The pixels of pictures and of maps of differences. */
const empty = {loading: null, canvas: null, pixels: null};
const pictures = data.pictures.map((picture, index) => ({...picture, index, ...empty}));

async function decoded(png, width, height) {
	const image = new Image();
	image.src = "data:image/png;base64," + png;
	await image.decode();
	const canvas = h("canvas", {width, height});
	const context = canvas.getContext("2d", {willReadFrequently: true});
	context.drawImage(image, 0, 0);
	return {canvas, pixels: context.getImageData(0, 0, width, height).data};
}

/* Once. */
function load(picture) {
	const {png, width, height} = picture;
	picture.loading ??= decoded(png, width, height).then((made) => Object.assign(picture, made));
	return picture.loading;
}

function pairOf(a, b) {
	return data.pairs.find((pair) => pair.reference === a.index && pair.image === b.index);
}

function comparisonOf(a, b) {
	return data.comparisons.find((c) => c.reference === a.index && c.image === b.index);
}

/* How two colours differ: the greatest of three channels, in grey levels. */
function apart(a, b, at) {
	const p = a.pixels, q = b.pixels;
	return Math.max(Math.abs(p[at] - q[at]), Math.abs(p[at + 1] - q[at + 1]), Math.abs(p[at + 2] - q[at + 2]));
}

function painted(width, height, colourOf) {
	const canvas = h("canvas", {width, height});
	const context = canvas.getContext("2d");
	const image = context.createImageData(width, height);
	for (let i = 0; i < width * height; i++) {
		const [r, g, b] = colourOf(i);
		image.data.set([r, g, b, 255], 4 * i);
	}
	context.putImageData(image, 0, 0);
	return canvas;
}

/* A map of {canvas, value(i): words of pixel i, legend}. */
const maps = {
	async flip(a, b) {
		const {pixels} = await decoded(pairOf(a, b).errors, a.width, a.height);
		const canvas = painted(a.width, a.height, (i) => data.ramp[pixels[4 * i]]);
		const legend = ramp(["0", "0.25", "0.5", "0.75", "1"],
			"FLIP error, at " + data.ppd + " pixels per degree: 0 is not seen, 1 is the most that there is");
		return {canvas, legend, value: (i) => (pixels[4 * i] / 255).toFixed(2)};
	},
	async difference(a, b) {
		let most = 1;
		for (let i = 0; i < a.pixels.length; i += 4) most = Math.max(most, apart(a, b, i));
		const canvas = painted(a.width, a.height, (i) => data.ramp[Math.round((255 * apart(a, b, 4 * i)) / most)]);
		const ticks = (most < 4 ? [0, 1] : [0, 0.25, 0.5, 0.75, 1]).map((share) => shown(share * most));
		return {canvas, legend: ramp(ticks, "greatest difference of a channel, in grey levels of 255"),
			value: (i) => String(apart(a, b, 4 * i))};
	},
	async firsts(a, b) {
		const {layers, firsts} = comparisonOf(a, b);
		const {pixels} = await decoded(firsts, a.width, a.height);
		const luma = (at) => 0.3 * a.pixels[at] + 0.6 * a.pixels[at + 1] + 0.1 * a.pixels[at + 2];
		const faint = (at) => Array(3).fill(20 + 0.25 * luma(at));
		const canvas = painted(a.width, a.height, (i) => (pixels[4 * i] ? data.names[pixels[4 * i]] : faint(4 * i)));
		const words = (layer) => `${layer.buffer}: ${grouped(layer.pixels)} pixels`;
		const item = (layer, n) => (layer.pixels ? h("li", null, swatch(data.names[n + 1]), words(layer)) : null);
		const named = layers.map(item);
		const legend = [h("ul", null, named),
			h("div", null, "the first buffer, in the order of the pipeline, whose bits differ at a pixel")];
		return {canvas, legend, value: (i) => (pixels[4 * i] ? layers[pixels[4 * i] - 1].buffer : "none")};
	},
};

function swatch([r, g, b]) {
	const box = h("span", {class: "swatch", "aria-hidden": "true"});
	box.style.background = `rgb(${r},${g},${b})`;
	return box;
}

function ramp(ticks, words) {
	const bar = painted(256, 1, (i) => data.ramp[i]);
	bar.setAttribute("aria-hidden", "true");
	return [bar, h("div", {class: "ticks"}, ticks.map((tick) => h("span", null, tick))), h("div", null, words)];
}

/* Pixels around (x, y), a square each, with the one in the middle marked. */
const CROP = 11;
const CELL = 12;
function crop(canvas, x, y, words, side) {
	const made = h("canvas", {width: CROP * CELL, height: CROP * CELL, role: "img",
		"aria-label": `${words}: pixels around (${x}, ${y}), magnified`});
	const context = made.getContext("2d"), reach = (CROP - 1) / 2;
	context.imageSmoothingEnabled = false;
	context.drawImage(canvas, x - reach, y - reach, CROP, CROP, 0, 0, CROP * CELL, CROP * CELL);
	context.strokeStyle = "#000";
	context.strokeRect(reach * CELL - 1.5, reach * CELL - 1.5, CELL + 3, CELL + 3);
	context.strokeStyle = "#fff";
	context.strokeRect(reach * CELL - 0.5, reach * CELL - 0.5, CELL + 1, CELL + 1);
	return h("figure", {class: "crop"}, made, h("figcaption", {class: side}, words));
}
