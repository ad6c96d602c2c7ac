"use strict";
/* All that files said is in `data`, and gets into the page as text, never as HTML. */
const data = JSON.parse(document.getElementById("data").textContent);

/* An element; attributes that are functions are listeners, those that are null or false are left out. */
function h(tag, attributes, ...children) {
	const element = document.createElement(tag);
	for (const [key, value] of Object.entries(attributes || {})) {
		if (value === null || value === undefined || value === false) continue;
		if (typeof value === "function") element.addEventListener(key, value);
		else if (key === "class") element.className = value;
		else if (key in element && key !== "list") element[key] = value;
		else element.setAttribute(key, value);
	}
	return fill(element, children);
}

/* In the place of all that was in it. */
function fill(element, children) {
	element.replaceChildren(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
	return element;
}

function button(words, click, more) {
	return h("button", {type: "button", click, ...more}, words);
}

function note(...words) {
	return h("p", {class: "small dim"}, ...words);
}

/* Makes a part of what a file holds, which may be anything. */
function attempt(make) {
	return (of) => {
		try {
			return make(of);
		} catch (error) {
			return note("This part cannot be shown: ", error.message);
		}
	};
}

/* With places where a line may end: behind marks, as words of parameters and folders have them. */
function breakable(words) {
	return words.split(/(?<=[,/(=])/).flatMap((part) => [part, h("wbr")]);
}

function folded(words, ...children) {
	return h("details", null, h("summary", null, words), ...children);
}

function section(id, title, ...children) {
	return h("section", {id, "aria-labelledby": id + "-title"}, h("h2", {id: id + "-title"}, title), ...children);
}

function grouped(n) {
	return String(n).replace(/\B(?=(\d{3})+$)/g, ",");
}

/* A number as people read it: whole ones grouped, others with four digits. */
function shown(value) {
	if (value === null || value === undefined) return "–";
	if (typeof value !== "number") return typeof value === "object" ? JSON.stringify(value) : String(value);
	if (Number.isInteger(value)) return value < 0 ? "-" + grouped(-value) : grouped(value);
	const size = Math.abs(value);
	return size >= 1e7 || size < 1e-4 ? value.toExponential(3) : String(Number(value.toPrecision(4)));
}

function bytes(n) {
	const units = ["B", "kB", "MB", "GB"];
	let unit = 0;
	for (; n >= 1000 && unit < 3; unit++) n /= 1000;
	return (unit ? n.toFixed(2) : n) + " " + units[unit];
}

function chip(verdict) {
	return h("span", {class: "chip " + (verdict === "same" || verdict === "different" ? verdict : "")}, verdict);
}

/* As a shell takes it. */
function quoted(word) {
	return /^[\w./:=,+-]+$/.test(word) ? word : "'" + word.replace(/'/g, "'\\''") + "'";
}

async function copy(text, button) {
	let done = true;
	try {
		await navigator.clipboard.writeText(text);
	} catch {
		const area = h("textarea", {value: text, readOnly: true});
		document.body.append(area);
		area.select();
		done = document.execCommand("copy");
		area.remove();
	}
	button.textContent = done ? "Copied" : "Select it";
	setTimeout(() => (button.textContent = "Copy"), 1500);
}

/* A text that can be copied. */
function command(text) {
	const made = button("Copy", () => copy(text, made), {"aria-label": "Copy: " + text});
	const words = text.split(" ").flatMap((word) => [h("span", null, word), " "]);
	return h("div", {class: "command"}, h("code", null, words), made);
}

function pairs(entries) {
	return h("dl", {class: "pairs"}, entries.map(([key, value]) => [h("dt", null, key), h("dd", null, shown(value))]));
}

/* columns: {key, head, right, cell}; cell makes the content of a row's cell, by default its value. */
function table(caption, columns, rows) {
	const head = columns.map((c) => h("th", {scope: "col", class: c.right ? "right" : null}, c.head));
	const body = rows.map((row) => h("tr", null, columns.map((c) => {
		const content = c.cell ? c.cell(row[c.key], row) : shown(row[c.key]);
		const long = typeof row[c.key] === "string" && row[c.key].length > 24;
		return h("td", {class: c.class || (c.right ? "right" : long ? "text" : null)}, content);
	})));
	return h("div", {class: "table", tabIndex: 0, role: "region", "aria-label": caption || "Table"},
		h("table", null, caption ? h("caption", null, caption) : null, h("thead", null, h("tr", null, head)),
			h("tbody", null, body)));
}
