#!/usr/bin/python3
"""What glTF 2.0 requires of a loader, row by row: a small file each, and what becomes of it. Usage: table.py [--write]
[NAME...]: prints TAP, a line a chapter, with the rows that are other than they say; then whether reference/GLTF.md is
what the rows say. --write makes that document instead. NAME: these rows alone, and what is seen of each."""
import os
import re
import sys

import cases_buffers
import cases_extensions
import cases_files
import cases_meshes
import cases_motion
import cases_schema
import cases_start
import cases_textures
from judges import HELD, NO_CONSEQUENCE, NOTED, REFUSED, Loader

CHAPTERS = [module.CHAPTER for module in (cases_start, cases_buffers, cases_meshes, cases_textures, cases_motion,
                                          cases_files, cases_schema, cases_extensions)]
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../..")
PAGE, RULES = "reference/GLTF.md", "src/scene/gltf/rules.h"
HEAD = """# glTF 2.0, requirement by requirement

What glTF 2.0 and its extensions ask of a program that reads files, in our words, and what touchstone does. **held**:
the picture is right. **refused**: there is none, and a line says why. **noted**: there is a picture, and a note says
what of the file is not in it, or is read otherwise than it stands. **no consequence**: what the row is about is not
read, or can be read in one way only, and not a word is said. [METHODS](METHODS.md) says what is drawn.

Each row is a test: the case is a small file that `tests/scene/gltf/spec/` makes, opens and draws. This page is made of
those rows and of `src/scene/gltf/rules.h`, by `tests/scene/gltf/spec/table.py --write`.
"""


def read(path):
	with open(path, encoding="utf-8") as file:
		return file.read()


# ---- the document ----

def extensions():
	"""(name, what is said of it or None, whether it compresses) of those that the loader knows."""
	text = read(RULES)
	notes = dict(re.findall(r'constexpr const char \*(\w+) = "(.*)";', text))
	listed = re.search(r"known_extensions\[\] = \{\n(.*?)\n\};", text, re.S)[1]
	for name, note, compresses in re.findall(r'\{"(\w+)",\s*("[^"]*"|\w+)(,\s*true)?\}', listed):
		yield name, None if note == "nullptr" else notes.get(note, note.strip('"')), bool(compresses)


def extension_lines():
	yield "| extension | used by a file | required by it |"
	yield "| --- | --- | --- |"
	for name, note, compresses in extensions():
		used = "read" if note is None else f"noted: {note}{', else refused' if compresses else ''}"
		required = "refused" if compresses else "read" if note is None else "noted"
		yield f"| {name} | {used} | {required} |"
	yield "| any other | noted: it is not supported | refused |"


def count_lines():
	yield "| chapter | rows | " + " | ".join((HELD, REFUSED, NOTED, NO_CONSEQUENCE)) + " |"
	yield "| --- |" + 5 * " --- |"
	for title, rows in [*((chapter.title, chapter) for chapter in CHAPTERS), ("all", sum(CHAPTERS, []))]:
		counts = [sum(row.judge.outcome == outcome for row in rows)
		          for outcome in (HELD, REFUSED, NOTED, NO_CONSEQUENCE)]
		yield f"| {title} | {len(rows)} | {' | '.join(map(str, counts))} |"


def chapter_lines(chapter):
	yield "| section | requirement | level | outcome | case |"
	yield "| --- | --- | --- | --- | --- |"
	for row in chapter:
		outcome = f"{row.judge.outcome}: {row.remark}" if row.remark else row.judge.outcome
		yield f"| {row.section} | {row.requirement} | {row.level} | {outcome} | {row.name} |"


def page():
	parts = [HEAD, "## Extensions\n", *extension_lines(), "\n## Counts\n", *count_lines()]
	for chapter in CHAPTERS:
		parts += [f"\n## {chapter.title}\n", *chapter_lines(chapter)]
	return "\n".join(parts) + "\n"


# ---- the test ----

def faults(loader, chapter):
	for row in chapter:
		fault = row.judge.fault(loader, row.document)
		if fault:
			yield f"{row.name}: {row.judge.outcome} is expected: {fault}"


def verdict(number, name, found):
	print(f"{'not ok' if found else 'ok'} {number} - {name}")
	for line in found:
		print("#", " ".join(line.split()))
	return not found


def run():
	loader = Loader()
	names = [row.name for chapter in CHAPTERS for row in chapter]
	good = [verdict(number, f"glTF 2.0, {chapter.title}: {len(chapter)} rows", list(faults(loader, chapter)))
	        for number, chapter in enumerate(CHAPTERS, 1)]
	good.append(verdict(len(good) + 1, "each row has a name of its own",
	                    sorted({name for name in names if names.count(name) > 1})))
	stale = [] if os.path.exists(PAGE) and read(PAGE) == page() else ["tests/scene/gltf/spec/table.py --write makes it"]
	good.append(verdict(len(good) + 1, f"{PAGE} is what the rows say", stale))
	print(f"1..{len(good)}")
	return 0 if all(good) else 1


def show(names):
	loader = Loader()
	for row in sum(CHAPTERS, []):
		if row.name in names:
			print(f"{row.name}: {row.judge.fault(loader, row.document) or row.judge.outcome}")
			if row.document:
				seen = loader.look(row.document)
				print("\t" + (seen.error or f"middle {seen.picture[8][8]}; notes: {' | '.join(seen.notes)}"))


def main():
	os.chdir(ROOT)
	names = sys.argv[1:]
	if names == ["--write"]:
		with open(PAGE, "w", encoding="utf-8") as file:
			file.write(page())
	elif names:
		show(names)
	else:
		return run()
	return 0


if __name__ == "__main__":
	sys.exit(main())
