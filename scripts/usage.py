"""The words that a script is called with, by the usage in its own text:
`Usage: scripts/NAME [--option] [--of VALUE] WORD [WORD...]`, with what may be left out in brackets, and words in
capitals."""
import re
import sys

USAGE = re.compile(r"Usage:\s+scripts/(\S+?)((?:\s+(?:\[[^]]*\]|[A-Z][A-Z-]*)(?:\.\.\.)?)+)")
OPTION = re.compile(r"(--[a-z]+)(?: ([A-Z][A-Z,.]*))?")


def refuse(text):
	"""Prints the usage, and ends."""
	name, pattern = USAGE.search(text).groups()
	print(f"{name.split('/')[-1]}: usage: scripts/{name} {' '.join(pattern.split())}", file=sys.stderr)
	sys.exit(2)


def given(text):
	"""The options that are given, each with its value, else True; and the other words."""
	pattern = " ".join(USAGE.search(text)[2].split())
	known, options, words = dict(OPTION.findall(pattern)), {}, []
	rest = iter(sys.argv[1:])
	for word in rest:
		if not word.startswith("-"):
			words.append(word)
		elif word not in known:
			refuse(text)
		else:
			options[word] = next(rest, None) if known[word] else True
	for part in re.findall(r"\[([^]]*)\]", pattern):
		if sum(one.split()[0] in options if one[0] == "-" else bool(words) for one in part.split(" | ")) > 1:
			refuse(text)
	words_of = lambda pattern: len(re.findall(r"[A-Z][A-Z-]*", pattern))
	least, most = words_of(re.sub(r"\[[^]]*\]", "", pattern)), words_of(OPTION.sub("", pattern))
	if None in options.values() or len(words) < least or (len(words) > most and "..." not in OPTION.sub("", pattern)):
		refuse(text)
	return options, words
