#!/usr/bin/python3
"""The orders of stages in reference/PORTING.md: rows of tables whose heads are HEAD name stages, buffers that they
read, and all buffers that they write. Prints TAP.

	orders.py STAGES     what `list stages --json` prints"""
import json
import re
import sys

HEAD = "| stage | from the reference | makes | what goes wrong |"


def rows():
	with open("reference/PORTING.md", encoding="utf-8") as file:
		for table in re.findall(re.escape(HEAD) + r"\n\|[-| ]+\|\n((?:\|.*\n)+)", file.read()):
			for row in table.splitlines():
				yield [set(re.findall(r"`([^`]+)`", cell)) for cell in re.split(r"(?<!\\)\|", row)[1:4]]


def main():
	with open(sys.argv[1], encoding="utf-8") as file:
		known = {stage["name"]: stage for stage in json.load(file)["stages"]}
	n = failed = 0
	for stages, reads, makes in rows():
		n += 1
		given = {word for stage in stages for word in known[stage]["reads"].split()}
		made = {word for stage in stages for word in known[stage]["writes"].split()}
		right = reads <= given and makes == made
		failed += not right
		print(f"{'ok' if right else 'not ok'} {n} - {' '.join(stages)}")
		if not right:
			print(f"# not read: {reads - given}; written: {made ^ makes}")
	print(f"1..{n}")
	return 1 if failed or n < 20 else 0


sys.exit(main())
