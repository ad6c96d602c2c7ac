"""The papers' claims of `bench list` with their verdicts in reference/verdicts.json, in short for
reference/VERDICTS.md, a row each, and at length for reference/FIGURES.md. A verdict is the text that scripts/verdicts
wrote: counts of rows, and behind "times: " the same of times; behind "differs in n of m rows: " the relations that
fail, the scenes, the class of the cause, and the cause."""
import collections
import json
import re

# As src/study/bench.h explains them.
CLASSES = ("a GPU's cost", "asked elsewhere", "not in general", "ours")
LONGEST = 160

HOLDS = re.compile(r"holds in (\d+) rows?")
DIFFERS = re.compile(r"differs in (\d+) of (\d+) rows?: (.*)")
NOT_JUDGED = re.compile(r"(?:^|; )(\d+) rows? of times not judged.*")
FAULT = re.compile(rf"(.*?)(?: in ([^ ]+(?:, [^ ]+)*))?: ({'|'.join(CLASSES)}): (.*?)(?:; see (.*))?")

Fault = collections.namedtuple("Fault", "relation scenes group cause see")


def asked(claims, path):
	"""The claims, each with its verdict, and by which version and scenes these were found."""
	with open(path, encoding="utf-8") as file:
		stored = json.load(file)
	found = {(row["paper"], row["place"]): "; ".join(filter(None, (row["counts"], row["times"])))
	         for row in stored["verdicts"]}
	for claim in claims:
		verdict = found.get((claim["paper"], claim["place"]), "not asked yet")
		claim["verdict"] = verdict if claim["bench"] else f"cannot be asked: {claim['cannot']}"
	return claims, f"{stored['version']}, commit {stored['commit']}, scenes {', '.join(stored['scenes'])}"


def parted(verdict):
	"""The parts of a verdict: on counts, errors and pictures, and on times;
	and how many rows of times were not judged."""
	left = NOT_JUDGED.search(verdict)
	counts, _, times = (f"; {NOT_JUDGED.sub('', verdict)}").partition("; times: ")
	return counts[2:], times, int(left[1]) if left else 0


def faults(part):
	"""The relations that fail, of one part; None stands for a text that has no class."""
	differs = DIFFERS.fullmatch(part)
	found = [FAULT.fullmatch(text) for text in re.split(r"; (?!see )", differs[3])] if differs else []
	return [match and Fault(*match.groups()) for match in found]


def rows(part, left=0):
	"""How many rows hold, of how many."""
	holds, differs = HOLDS.match(part), DIFFERS.match(part)
	out = [f"{int(differs[2]) - int(differs[1])} of {differs[2]}"
	       if differs else f"{holds[1]} of {holds[1]}"] if holds or differs else []
	return ", ".join(out + ([f"{left} not judged"] if left else []))


def joined(words):
	"""Each once, in their order."""
	return "; ".join(dict.fromkeys(words))


def row(claim):
	"""(paper, where, what, table, verdict, rows, times, kind, reason): causes without the figures behind a colon."""
	verdict = claim["verdict"]
	start = [claim["paper"], claim["place"], claim["shows"], claim["bench"] or ""]
	if not claim["bench"]:
		verdict, _, reason = verdict.partition(": ")
		return [*start, verdict, "", "", "", reason]
	counts, times, left = parted(verdict)
	found = [fault for fault in faults(counts) + faults(times) if fault]
	answers = [("differs" if DIFFERS.match(part) else "holds") if k == 0 else
	           ("times differ" if DIFFERS.match(part) else "times hold")
	           for k, part in enumerate((counts, times)) if rows(part)]
	if answers == ["holds", "times hold"] or answers == ["differs", "times differ"]:
		answers = answers[:1]
	return [*start, ", ".join(answers) or verdict, rows(counts), rows(times, left),
	        joined(fault.group for fault in found), joined(fault.cause.partition(": ")[0] for fault in found)]


def listed(claims):
	"""Why claims differ, at length: an item for each claim and cause."""
	out = {}
	for claim in claims:
		for part, kind in zip(parted(claim["verdict"]), ("", ", times")) if claim["bench"] else ():
			for fault in filter(None, faults(part)):
				key = f"- **{claim['paper']}, {claim['place']}{kind}**, {fault.group}: {fault.cause}.", fault.see
				out.setdefault(key, []).append(f"{fault.relation}{f' in {fault.scenes}' if fault.scenes else ''}")
	for (start, see), relations in out.items():
		yield f"{start} Rows: {'; '.join(relations)}.{f' Setting: {see}.' if see else ''}"


def long_cells(text):
	"""(offset, length) of the cells of a page's tables that are too long."""
	for line in re.finditer(r"^\|(.*)\|$", text, re.M):
		for cell in re.split(r"(?<!\\)\|", line[1]):
			if len(cell.strip()) > LONGEST:
				yield line.start(), len(cell.strip())
