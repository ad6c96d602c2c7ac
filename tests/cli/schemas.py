#!/usr/bin/python3
"""Whether reports are as their schemas say, and whether these schemas can refuse: a report is invalid in which a
member is missing, has another type, or is beside what the schema has. Prints a line for each fault;
exit 1 if there is any.

	schemas.py SCHEMA REPORT...     the last REPORT is also changed, with one item of each shape in its lists"""
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


def shape(value):
	"""A text that equals that of another value with the same members of the same types."""
	if isinstance(value, dict):
		return f"{{{', '.join(f'{key}: {shape(inner)}' for key, inner in value.items())}}}"
	return f"[{', '.join(map(shape, value))}]" if isinstance(value, list) else type(value).__name__


def short(value):
	"""A value whose lists have one item of each shape."""
	if isinstance(value, dict):
		return {key: short(inner) for key, inner in value.items()}
	return list({shape(inner): inner for inner in map(short, value)}.values()) if isinstance(value, list) else value


def refused(schema, report, place, act):
	"""Whether the report is invalid when `act` has changed the object that has that place. It is whole again then."""
	holder = report
	for key in place[:-1]:
		holder = holder[key]
	before = dict(holder)
	act(holder, place[-1])
	fault = next(schema.check(schema.root, report, "$"), None)
	holder.clear()
	holder.update(before)
	return fault


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
	report = short(load(reports[-1]))
	faults += [f"{reports[-1]}, short: {fault}" for fault in schema.faults(report)]
	damages = {
		"lacks": lambda at, key: at.pop(key),
		"has another": lambda at, key: at.update({key: {"of": [True]}}),
		"has another beside": lambda at, key: at.update({key + "?": at[key]}),
	}
	for place in list(places(report)):
		for what, act in damages.items():
			free = any(key in place for key in FREE) if what == "has another" else optional(schema.root, place)
			if not free and not refused(schema, report, place, act):
				faults.append(f"{path}: passes a report that {what} {'.'.join(map(str, place))}")
	print("\n".join(faults[:10]))
	return 1 if faults else 0


sys.exit(main(sys.argv[1], sys.argv[2:]))
