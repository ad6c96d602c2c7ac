#!/usr/bin/python3
"""Whether reports are as their schemas say, and whether these schemas can refuse: a report is invalid in which a
member is missing, has another type, or is beside what the schema has. Prints a line for each fault; exit 1 if there is any.

	schemas.py SCHEMA REPORT...     the last REPORT is also changed"""
import copy
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "ports"))
from schema import Schema, load  # noqa: E402


FREE = ("expected", "found")  # of vectors: arrays, or objects of them


def places(value, path=()):
	"""The paths of all members of objects."""
	items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
	for key, inner in items:
		if isinstance(value, dict):
			yield (*path, key)
		yield from places(inner, (*path, key))


def changed(report, path, act):
	report = copy.deepcopy(report)
	place = report
	for key in path[:-1]:
		place = place[key]
	act(place, path[-1])
	return report


def optional(root, path):
	"""Whether what stands there may be missing: the schema does not require it, or takes any name."""
	schema = root
	for key in path[:-1]:
		schema = root["$defs"][schema["$ref"].split("/")[-1]] if "$ref" in schema else schema
		if isinstance(key, int):
			schema = schema.get("items", {})
		else:
			more = schema.get("additionalProperties", {})
			schema = schema.get("properties", {}).get(key, more if isinstance(more, dict) else {})
	schema = root["$defs"][schema["$ref"].split("/")[-1]] if "$ref" in schema else schema
	return path[-1] not in schema.get("required", ())


def main(path, reports):
	schema = Schema(path)
	faults = [f"{name}: {fault}" for name in reports for fault in schema.faults(load(name))]
	report = load(reports[-1])
	for place in places(report):
		lacking = changed(report, place, lambda at, key: at.pop(key))
		other = changed(report, place, lambda at, key: at.update({key: {"of": [True]}}))
		beside = changed(report, place, lambda at, key: at.update({key + "?": at[key]}))
		for what, bad in ("lacks", lacking), ("has another", other), ("has another beside", beside):
			free = any(key in place for key in FREE) if what == "has another" else optional(schema.root, place)
			if not free and not schema.faults(bad):
				faults.append(f"{path}: passes a report that {what} {'.'.join(map(str, place))}")
	print("\n".join(faults[:10]))
	return 1 if faults else 0


sys.exit(main(sys.argv[1], sys.argv[2:]))
