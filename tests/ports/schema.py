#!/usr/bin/python3
"""reference/trace.schema.json against trace.json of real traces, and against the minimal candidate of
reference/TRACES.md. The validator knows the keywords that this schema has and refuses others. Prints TAP.

	schema.py TRACE...     folders of traces that ran the whole pipeline; their digests and chains are checked too"""
import copy
import hashlib
import json
import os
import re
import sys

TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}
SILENT = {"$schema", "$defs", "title", "description", "then"}


def load(path):
	with open(path, encoding="utf-8") as file:
		return json.load(file)


def is_of(value, name):
	if name == "integer":
		return isinstance(value, int) and not isinstance(value, bool)
	if name == "number":
		return isinstance(value, (int, float)) and not isinstance(value, bool)
	return isinstance(value, TYPES[name])


def same(a, b):
	return type(a) is type(b) and a == b


class Schema:
	"""faults(value): where and why it is invalid; empty if it is valid."""

	def __init__(self, path):
		self.root = load(path)
		self.used = set()

	def faults(self, value):
		return list(self.check(self.root, value, "$"))

	def check(self, schema, value, at):
		for word, rule in schema.items():
			self.used.add(word)
			if word not in SILENT:
				yield from getattr(self, "check_" + word.strip("$"))(rule, value, at, schema)

	def check_ref(self, rule, value, at, _):
		yield from self.check(self.root["$defs"][rule.removeprefix("#/$defs/")], value, at)

	def check_type(self, rule, value, at, _):
		if not any(is_of(value, name) for name in ([rule] if isinstance(rule, str) else rule)):
			yield f"{at}: not {rule}"

	def check_const(self, rule, value, at, _):
		if not same(rule, value):
			yield f"{at}: not {rule!r}"

	def check_enum(self, rule, value, at, _):
		if not any(same(item, value) for item in rule):
			yield f"{at}: {value!r} is none of {rule}"

	def check_pattern(self, rule, value, at, _):
		if isinstance(value, str) and not re.search(rule, value):
			yield f"{at}: {value!r} is not like {rule}"

	def check_minimum(self, rule, value, at, _):
		if is_of(value, "integer") and value < rule:
			yield f"{at}: below {rule}"

	def check_maximum(self, rule, value, at, _):
		if is_of(value, "integer") and value > rule:
			yield f"{at}: above {rule}"

	def check_minItems(self, rule, value, at, _):
		if isinstance(value, list) and len(value) < rule:
			yield f"{at}: fewer than {rule}"

	def check_maxItems(self, rule, value, at, _):
		if isinstance(value, list) and len(value) > rule:
			yield f"{at}: more than {rule}"

	def check_items(self, rule, value, at, _):
		for i, item in enumerate(value if isinstance(value, list) else []):
			yield from self.check(rule, item, f"{at}[{i}]")

	def check_required(self, rule, value, at, _):
		for key in rule:
			if isinstance(value, dict) and key not in value:
				yield f"{at}: lacks {key}"

	def check_properties(self, rule, value, at, _):
		for key, inner in rule.items():
			if isinstance(value, dict) and key in value:
				yield from self.check(inner, value[key], f"{at}.{key}")

	def check_propertyNames(self, rule, value, at, _):
		for key in value if isinstance(value, dict) else []:
			yield from self.check(rule, key, f"{at}.{key}")

	def check_additionalProperties(self, rule, value, at, schema):
		for key in value if isinstance(value, dict) else []:
			if key in schema.get("properties", {}):
				continue
			if rule is False:
				yield f"{at}: has {key}"
			elif rule is not True:
				yield from self.check(rule, value[key], f"{at}.{key}")

	def check_allOf(self, rule, value, at, _):
		for part in rule:
			yield from self.check(part, value, at)

	def check_if(self, rule, value, at, schema):
		if not any(self.check(rule, value, at)):
			yield from self.check(schema["then"], value, at)


class Tap:
	def __init__(self):
		self.n = self.failed = 0

	def result(self, good, name, why=()):
		self.n += 1
		self.failed += not good
		print(f"{'ok' if good else 'not ok'} {self.n} - {name}")
		for line in list(why)[:5]:
			print(f"# {line}")


def sha256(data):
	return hashlib.sha256(data).hexdigest()


def chain(digests, names):
	return sha256("".join(f"{digests[name]}  {name}\n" for name in names).encode())


def check_digests(tap, folder, about):
	"""Files, chains of the stages, and that of the scene, as section 5 says."""
	digests = {buffer["name"]: buffer["sha256"] for buffer in about["buffers"]}
	wrong = []
	for buffer in about["buffers"]:
		if buffer["file"] is not None:
			with open(os.path.join(folder, buffer["file"]), "rb") as file:
				wrong += [buffer["file"]] * (sha256(file.read()) != buffer["sha256"])
	wrong += [stage["name"] for stage in about["stages"] if chain(digests, stage["reads"]) != stage["inputs_sha256"]]
	scene = [name for name in digests if name.startswith("scene.")]
	wrong += ["scene"] * (chain(digests, scene) != about["scene"]["sha256"])
	tap.result(not wrong, f"digests of {folder}", wrong)


def damaged(value, path, new):
	"""A copy in which the item at `path` is another, or gone."""
	value = copy.deepcopy(value)
	place = value
	for key in path[:-1]:
		place = place[key]
	if new is None:
		del place[path[-1]]
	else:
		place[path[-1]] = new
	return value


def minimal():
	with open("reference/TRACES.md", encoding="utf-8") as file:
		return json.loads(re.search(r"^```json\n(.*?)^```", file.read(), re.M | re.S).group(1))


def main():
	tap, schema, small = Tap(), Schema("reference/trace.schema.json"), minimal()
	for folder in sys.argv[1:]:
		about = load(os.path.join(folder, "trace.json"))
		faults = schema.faults(about)
		tap.result(not faults, f"schema of {folder}", faults)
		check_digests(tap, folder, about)
		for key in sorted(set(about) - {"producer"}):
			tap.result(schema.faults(damaged(about, [key], None)), f"refused: ours without {key}")
		for key in about["buffers"][0]:
			tap.result(schema.faults(damaged(about, ["buffers", 0, key], None)), f"refused: a buffer without {key}")
		tap.result(schema.faults(damaged(about, ["colour"], "red")), "refused: ours with another key")
		tap.result(schema.faults(damaged(about, ["stages", 0, "kind"], "sort")), "refused: another kind of stage")
	tap.result(not schema.faults(small), "schema of the minimal candidate", schema.faults(small))
	for key in schema.root["required"]:
		tap.result(schema.faults(damaged(small, [key], None)), f"refused: a candidate without {key}")
	tap.result(not schema.faults(damaged(small, ["producer"], None)), "a candidate without producer")
	names = damaged(small, ["version"], 2)
	for name in ("bits.npy.zst", "../scene/00-scene.texel.npy"):
		faults = schema.faults(damaged(names, ["buffers", 0, "file"], name))
		tap.result(not faults, f"version 2 with a file {name}", faults)
	for name in ("../scenes/a.npy", "../scene/.a.npy", "../scene/a/b.npy", "../../scene/a.npy", "../scene/",
	             "/scene/a.npy"):
		tap.result(schema.faults(damaged(names, ["buffers", 0, "file"], name)),
		           f"refused: version 2 with a file {name}")
	for path, new in ((["version"], 3), (["buffers", 0, "file"], "../scene/a.npy"), (["contract"], True),
	                  (["order"], "any"), (["pipeline"], "nil"), (["buffers", 0, "file"], "../bits.npy"),
	                  (["buffers", 0, "file"], 7),
	                  (["buffers", 0, "name"], "bits"), (["buffers", 0, "crop"], [0, 0, 8]),
	                  (["params"], {"width": 240})):
		tap.result(schema.faults(damaged(small, path, new)), f"refused: a candidate with {path[-1]} {new!r}")
	print(f"1..{tap.n}")
	return 1 if tap.failed else 0


if __name__ == "__main__":
	sys.exit(main())
