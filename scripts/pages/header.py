"""A C header as a page of Markdown: its comments as text, a section for each declaration."""
import re

LICENCE = re.compile(r"\A/\* SPDX-.*\n")
GUARDS = re.compile(r"^#ifdef __cplusplus\n.*?^#endif\n", re.M | re.S)
LITERALS = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'')
COMMENT = re.compile(r"/\*(.*?)\*/\n?", re.S)
# What is public without a comment of its own; helpers of candidate.h and the macros that expand records.def are not.
PLAIN = re.compile(r"typedef|TS_API")


def paragraphs(text):
	"""The parts of a header that blank lines separate, outside braces and comments."""
	part, depth = [], 0
	for line in text.splitlines():
		if not line and depth == 0:
			yield "\n".join(part)
			part = []
			continue
		part.append(line)
		bare = LITERALS.sub("", re.sub(r"/\*.*?\*/", "", line))
		depth += bare.count("{") - bare.count("}")
	yield "\n".join(part)


def declarations(part):
	"""Pairs of a comment and the code below it; comments inside the code stay in it."""
	comment, code = "", []
	for piece in re.split(r"^(/\*.*?\*/)(?:\n|$)", part, flags=re.M | re.S):
		if piece.startswith("/*"):
			comment = piece
		elif piece.strip():
			yield comment, piece.rstrip("\n")
			comment = ""


def shown(comment, code):
	"""The code of a section: without the bodies of functions; None for what is not public."""
	if not comment and not PLAIN.match(code):
		return None
	if "clang-format" in comment or code.startswith("static const") or "\\\n" in code:
		return None
	return re.sub(r"\n\{\n.*?^\}$", ";", code, flags=re.M | re.S)


def names(code):
	"""What the code declares."""
	bare = re.sub(r"/\*.*?\*/", "", code, flags=re.S)
	found = re.findall(r"^#define (\w+)", bare, re.M)
	found += re.findall(r"^(?:TS_API|static inline) [^;(]*?(\w+)\(", bare, re.M)
	found += re.findall(r"^typedef [^{;]*?(\w+);", bare, re.M) + re.findall(r"^\} ?(\w+);", bare, re.M)
	found += re.findall(r"^typedef enum \{[^}]*\} (\w+);", bare, re.M)
	return list(dict.fromkeys(found or re.findall(r"\bTS_\w+", bare)))


def escaped(line):
	"""Text as Markdown; symbols are code."""
	parts = re.split(r"(`[^`]+`|\b(?:ts|TS)_\w+)", line)
	for i, part in enumerate(parts):
		parts[i] = re.sub(r"([\\`*_{}\[\]<>#|~$&])", r"\\\1", part) if i % 2 == 0 else f"`{part.strip('`')}`"
	return "".join(parts)


def prose(comment):
	"""The text of a comment; lines indented by two or more are code or tables, and keep their shape."""
	lines = [re.sub(r"^ \* ?", "", line) for line in comment[2:-2].strip().splitlines()]
	out, fenced, listed = [], False, False
	for line in lines:
		indented = line.startswith("  ")
		if listed and indented and not re.match(r"  +\w+ {2,}", line):
			out.append(escaped(line))
			continue
		if indented != fenced:
			out += ["```"] if fenced else ["", "```"]
			fenced = indented
		listed = line.startswith("- ") or (listed and bool(line) and not fenced)
		out.append(line if fenced else escaped(line))
	return "\n".join(out + ["```"] * fenced)


def sections(text):
	"""(names, comment, code) of all that a header declares."""
	for part in paragraphs(text):
		for comment, code in declarations(part):
			code = shown(comment, code)
			if code and names(code):
				yield names(code), comment, code


def page(path, text):
	"""The Markdown of a header, and the anchor of each of its symbols."""
	text = GUARDS.sub("", LICENCE.sub("", text))
	opening = COMMENT.match(text)
	out = [f"# {path.rsplit('/', 1)[1]}\n", f"`#include <touchstone/{path.rsplit('/', 1)[1]}>`\n",
	       prose(opening[0].rstrip())]
	anchors = {}
	body = re.sub(r"^#(?:ifndef|include|endif|undef|if|else).*\n|^#define TOUCHSTONE_.*\n", "", text[opening.end():],
	              flags=re.M)
	for found, comment, code in sections(body):
		title = ", ".join(found[:3]) + ", ..." * (len(found) > 3)
		out.append(f"\n## {escaped(title)}\n")
		out.append(prose(comment) if comment else "")
		out.append(f"\n```c\n{code}\n```\n")
		enumerators = re.findall(r"\bTS_[A-Z_0-9]+\b",
		                         re.sub(r"/\*.*?\*/", "", code, flags=re.S)) if "enum {" in code else []
		anchors.update({name: re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-") for name in found + enumerators})
	return "\n".join(out), anchors
