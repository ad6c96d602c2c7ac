"""The template of reference/METHODS.md. A stage has a heading of its own, "### `stage`", below it the generated block, and then
PARTS in this order: each begins a paragraph with its name in bold. The first is always there; an empty one is left out.
A departure is an item of DEPARTURE's form. Headings of other texts name no stage alone."""
import re

PARTS = ("Formula", "Edge cases", "Departures")

HEADING = re.compile(r"^(##|###) (.*)$", re.M)
STAGE = re.compile(r"^### `([\w.]+)`\n(.*?)(?=^##|\Z)", re.M | re.S)
PART = re.compile(r"^\*\*([^*\n]+)\.\*\*[ \n]", re.M)
BLOCK = "<!-- generated: stage {} -->\n"
END = "<!-- end -->\n"
DEPARTURE = re.compile(r"- \*Paper:\* (.+) \*Here:\* (.+) \*Switch:\* (.+)")


def anchor(heading):
	"""As GitHub and pandoc make it."""
	return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def link(heading):
	return f"[{heading.replace('`', '')}](#{anchor(heading)})"


def contents(text, wrapped):
	"""A list of links to the sections of a page; below a section a line of links to its stages and other headings."""
	out, within = "", []
	for level, heading in [*HEADING.findall(text), ("##", None)]:
		if level == "##" and within:
			out, within = out + wrapped(f"  - {', '.join(within)}", "    ") + "\n", []
		if level == "##" and heading:
			out += f"- {link(heading)}\n"
		elif heading:
			within.append(link(heading))
	return out


def items(part):
	"""The items of a list, each on one line."""
	return [" ".join(item.split()) for item in re.split(r"^(?=- )", part, flags=re.M) if item.strip()]


def parts(body):
	"""The text after the generated block by parts, [(name, text)]; text before the first part has no name."""
	cut = [("", body[:len(body) if not (first := PART.search(body)) else first.start()])]
	found = list(PART.finditer(body))
	ends = [match.start() for match in found[1:]] + [len(body)]
	return cut + [(match[1], body[match.end():end]) for match, end in zip(found, ends)]


def stages(text):
	"""(offset, name, body) of each stage's heading."""
	return [(match.start(), match[1], match[2]) for match in STAGE.finditer(text)]


def departures(text):
	"""(stage, paper, here, switch) of all departures."""
	found = []
	for _, name, body in stages(text):
		for item in items(dict(parts(body)).get("Departures", "")):
			match = DEPARTURE.fullmatch(item)
			found += [(name, *match.groups())] if match else []
	return found


def stage_faults(name, body):
	if not body.startswith(BLOCK.format(name)) or END not in body:
		yield f"{name}: its heading is not followed by its generated block"
		return
	before, *named = parts(body.partition(END)[2])
	names = [part for part, _ in named]
	if before[1].strip():
		yield f"{name}: there is text before its first part"
	if names != [part for part in PARTS if part in names] or PARTS[0] not in names:
		yield f"{name}: its parts are {', '.join(names) or 'none'}; expected {', '.join(PARTS)}, of which the first is needed"
	for part, text in named:
		if not text.strip():
			yield f"{name}: {part} is empty"
	for item in items(dict(named).get("Departures", "")):
		if not DEPARTURE.fullmatch(item):
			yield f"{name}: a departure is \"- *Paper:* ... *Here:* ... *Switch:* ...\", found {item[:40]}"


def faults(text, names):
	"""(offset, reason) where the page departs from its template; `names` are the stages that there are."""
	seen = set()
	for offset, name, body in stages(text):
		reasons = list(stage_faults(name, body)) if name in names else [f"there is no stage {name}"]
		for reason in reasons + ([f"{name} is described twice"] if name in seen else []):
			yield offset, reason
		seen.add(name)
	for name in sorted(set(names) - seen):
		yield 0, f"stage {name} is not described"
	headings = [anchor(heading) for _, heading in HEADING.findall(text)]
	for heading in sorted({heading for heading in headings if headings.count(heading) > 1}):
		yield 0, f"two headings have the anchor {heading}"
