/* Search in all pages without a server: the names and headings of terms.js, rows of name, kind and address, which is loaded when
 * the field is first used. "/" goes to the field, arrows to the answers, Enter to the first or chosen one; Escape ends. */
"use strict";
const root = document.currentScript.dataset.root, MOST = 20;
const form = document.querySelector(".search"), field = form.querySelector("input"), list = form.querySelector("ul");
let terms = null;

function load() {
	terms = terms || new Promise((done) => {
		const script = document.createElement("script");
		script.src = root + "terms.js";
		script.onload = () => done(TERMS);
		document.head.append(script);
	});
	return terms;
}

/* 0 is the name itself; then names that begin so, have a word that begins so, or have it within a word. */
function distance(name, words) {
	let sum = 0;
	for (const word of words) {
		const at = name.indexOf(word);
		if (at < 0) return Infinity;
		sum += name === word ? 0 : at === 0 ? 1 : /\w/.test(name[at - 1]) ? 3 : 2;
	}
	return sum;
}

function found(all, words) {
	const rows = all.map((term) => ({term, far: distance(term[0].toLowerCase(), words)})).filter((row) => row.far < Infinity);
	rows.sort((a, b) => a.far - b.far || a.term[0].length - b.term[0].length);
	return rows.slice(0, MOST).map((row) => row.term);
}

function answer([name, kind, address]) {
	const item = document.createElement("li"), link = document.createElement("a"), what = document.createElement("span");
	link.href = root + address;
	what.textContent = kind;
	link.append(name, " ", what);
	item.append(link);
	return item;
}

async function show() {
	const typed = field.value, words = typed.toLowerCase().split(/\s+/).filter((word) => word);
	const items = words.length > 0 ? found(await load(), words).map(answer) : [];
	if (typed !== field.value) return;
	list.replaceChildren(...items);
	list.hidden = words.length === 0;
	if (items.length === 0) list.textContent = "Nothing has this in its name.";
}

function step(event, by) {
	const stops = [field, ...list.querySelectorAll("a")];
	const to = stops[stops.indexOf(document.activeElement) + by];
	if (to) to.focus();
	event.preventDefault();
}

form.hidden = false;
field.addEventListener("input", show);
form.addEventListener("submit", async (event) => {
	event.preventDefault();
	await show();
	list.querySelector("a")?.click();
});
form.addEventListener("keydown", (event) => {
	if (event.key === "ArrowDown") step(event, 1);
	if (event.key === "ArrowUp") step(event, -1);
	if (event.key !== "Escape") return;
	field.value = "";
	field.focus();
	show();
});
form.addEventListener("focusout", (event) => (list.hidden = !form.contains(event.relatedTarget)));
field.addEventListener("focus", show);
document.addEventListener("keydown", (event) => {
	if (event.key !== "/" || event.target === field) return;
	field.focus();
	event.preventDefault();
});
