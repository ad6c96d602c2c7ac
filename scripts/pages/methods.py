"""The template of METHODS: reference/METHODS.md, which has what all methods share, and a page of reference/methods for
the stages of each family. A stage has a heading of its own, "### `stage`", below it the generated block, and then
PARTS in this order: each begins a paragraph with its name in bold. The first is always there; an empty one is left out.
A departure is an item of DEPARTURE's form. Sections, "## 11. Title", are numbered through all pages. Measurements
belong in reference/FIGURES.md: a page of a family has no other headings below its sections."""
import re

COMMON = "METHODS.md"
FAMILIES = tuple(f"methods/{name}.md" for name in ("points", "shadows", "hulls", "views", "surfels"))
PAGES = (COMMON, *FAMILIES)

PARTS = ("Formula", "Edge cases", "Departures")

HEADING = re.compile(r"^(##|###) (.*)$", re.M)
STAGE = re.compile(r"^### `([\w.]+)`\n(.*?)(?=^##|\Z)", re.M | re.S)
NUMBER = re.compile(r"(\d+)\. ")
STAGE_HEADING = re.compile(r"`[\w.]+`")
PART = re.compile(r"^\*\*([^*\n]+)\.\*\*[ \n]", re.M)
BLOCK = "<!-- generated: stage {} -->\n"
END = "<!-- end -->\n"
DEPARTURE = re.compile(r"- \*Paper:\* (.+) \*Here:\* (.+) \*Switch:\* (.+)")


def anchor(heading):
	"""As GitHub and pandoc make it."""
	return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def link(heading, page=""):
	return f"[{heading.replace('`', '')}]({page}#{anchor(heading)})"


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


def sections(texts, wrapped):
	"""A list of links to the sections of all pages, as seen from the common one, in the order of their numbers."""
	found = []
	for page, text in texts.items():
		there = "" if page == COMMON else page
		for level, heading in HEADING.findall(text):
			if level == "##":
				found.append((heading, there, []))
			elif found:
				found[-1][2].append(link(heading, there))
	out = ""
	for heading, there, within in sorted(found, key=lambda section: number(section[0])):
		out += wrapped(f"- {link(heading, there)}", "  ") + "\n"
		out += wrapped(f"  - {', '.join(within)}", "    ") + "\n" if within else ""
	return out


def number(heading):
	"""That of a section; 0: it has none."""
	found = NUMBER.match(heading)
	return int(found[1]) if found else 0


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


def departures(texts):
	"""(link to the stage, how many departures it has, the switches that go back to the paper) of all stages with
	any."""
	for page, text in texts.items():
		for _, name, body in stages(text):
			found = [DEPARTURE.fullmatch(item) for item in items(dict(parts(body)).get("Departures", ""))]
			switches = [match[3] for match in found if match and match[3] != "none"]
			if found:
				yield f"[`{name}`]({'' if page == COMMON else page}#{anchor(name)})", len(found), "; ".join(switches)


def stage_faults(name, body):
	if not body.startswith(BLOCK.format(name)) or END not in body:
		yield f"{name}: its heading is not followed by its generated block"
		return
	before, *named = parts(body.partition(END)[2])
	names = [part for part, _ in named]
	if before[1].strip():
		yield f"{name}: there is text before its first part"
	if names != [part for part in PARTS if part in names] or PARTS[0] not in names:
		yield (f"{name}: its parts are {', '.join(names) or 'none'}; "
		       f"expected {', '.join(PARTS)}, of which the first is needed")
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
	headings = [anchor(heading) for _, heading in HEADING.findall(text)]
	for heading in sorted({heading for heading in headings if headings.count(heading) > 1}):
		yield 0, f"two headings have the anchor {heading}"


def family_faults(text, names):
	"""The same of a page of a family, whose headings below sections are stages."""
	yield from faults(text, names)
	for match in HEADING.finditer(text):
		if match[1] == "###" and not STAGE_HEADING.fullmatch(match[2]):
			yield match.start(), f"\"{match[2]}\" names no stage: measurements belong in FIGURES"
		if match[1] == "##" and not number(match[2]):
			yield match.start(), f"section \"{match[2]}\" has no number"


def unique_faults(texts, names):
	"""Reasons why the pages together depart from the template: stages and sections that are missing or stand twice."""
	found = [name for text in texts.values() for _, name, _ in stages(text)]
	for name in sorted(set(names) - set(found)):
		yield f"stage {name} is not described"
	on_pages = [name for text in texts.values() for name in {name for _, name, _ in stages(text)}]
	for name in sorted({name for name in on_pages if on_pages.count(name) > 1}):
		yield f"{name} is described on two pages"
	numbers = sorted(number(heading) for text in texts.values() for level, heading in HEADING.findall(text)
	                 if level == "##" and number(heading))
	if numbers != list(range(1, len(numbers) + 1)):
		yield f"the sections of all pages are not numbered 1, 2, 3 ...: {numbers}"
