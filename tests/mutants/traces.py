"""Traces as the author of a port would read and write them, with nothing of ours. Says by itself where two buffers
first differ, so that the words of `touchstone compare` can be checked and not only believed."""
import ast
import json
import os
import re
import shutil
import struct
import subprocess

SIZES = {"f4": 4, "u4": 4, "i4": 4, "u8": 8, "u1": 1}
FACES = ("+X", "-X", "+Y", "-Y", "+Z", "-Z")
NONE = 0xffffffff
EMPTY = 0xffffffffffffffff
RECORDS = subprocess.check_output(["scripts/assembled", "include/touchstone/records.def"], text=True)
SUMS = set(re.findall(r'^SUM\((\w+),', RECORDS, re.M))
NOUNS = dict(re.findall(r'^DIM\((\w+), "([^"]+)"', RECORDS, re.M))


def is_image(shape):
	return shape[0] in ("height", "eye_rows", "sample_rows") and shape[1:2] == ["width"]


class Field:
	def __init__(self, name, descr, count, offset):
		self.name, self.type, self.count, self.offset = name, descr[1:], count, offset
		self.size = SIZES[self.type]


class Buffer:
	"""One .npy file: `data` is a bytearray of `n` elements of `bytes` bytes."""

	def __init__(self, path):
		with open(path, "rb") as file:
			content = file.read()
		size, = struct.unpack_from("<H", content, 8)
		header = ast.literal_eval(content[10:10 + size].decode("ascii"))
		self.descr, self.shape, self.data = header["descr"], header["shape"], bytearray(content[10 + size:])
		rows = [("", self.descr, (1,))] if isinstance(self.descr, str) else self.descr
		self.fields, self.bytes = [], 0
		for name, descr, *shape in rows:
			self.fields.append(Field(name, descr, shape[0][0] if shape else 1, self.bytes))
			self.bytes += self.fields[-1].size * self.fields[-1].count
		self.n = len(self.data) // self.bytes

	def write(self, path):
		header = f"{{'descr': {self.descr!r}, 'fortran_order': False, 'shape': {self.shape!r}, }}".encode("ascii")
		header += b" " * (-(10 + len(header) + 1) % 64) + b"\n"
		with open(path, "wb") as file:
			file.write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + self.data)

	def element(self, i):
		return bytes(self.data[i * self.bytes:(i + 1) * self.bytes])

	def put(self, i, element):
		self.data[i * self.bytes:(i + 1) * self.bytes] = element

	def set_elements(self, elements):
		"""Also another number of rows."""
		self.data = bytearray(b"".join(elements))
		row = self.bytes
		for size in self.shape[1:]:
			row *= size
		self.shape = (len(self.data) // row,) + tuple(self.shape[1:])
		self.n = len(self.data) // self.bytes

	def elements(self):
		return [self.element(i) for i in range(self.n)]

	def words(self):
		"""Elements of a buffer of scalars, as a list of integers or floats."""
		kind = {"f4": "f", "u4": "I", "u8": "Q", "u1": "B"}[self.fields[0].type]
		return list(struct.unpack(f"<{self.n}{kind}", self.data))

	def set_words(self, words):
		kind = {"f4": "f", "u4": "I", "u8": "Q", "u1": "B"}[self.fields[0].type]
		self.data = bytearray(struct.pack(f"<{len(words)}{kind}", *words))

	def get(self, i, name):
		"""A field of a record: a tuple."""
		field = next(f for f in self.fields if f.name == name)
		kind = {"f4": "f", "u4": "I", "i4": "i", "u8": "Q"}[field.type]
		return struct.unpack_from(f"<{field.count}{kind}", self.data, i * self.bytes + field.offset)


class Trace:
	"""A trace's folder; buffers are read when asked for."""

	def __init__(self, folder):
		self.folder = folder
		with open(folder + "/trace.json", encoding="utf-8") as file:
			self.json = json.load(file)
		self.about = {b["name"]: b for b in self.json["buffers"] if b["file"]}
		self.stages = {name: stage["name"] for stage in self.json["stages"] for name in stage["writes"]}
		self.numbers = {stage["name"]: stage["number"] for stage in self.json["stages"]}
		self.read = {}

	def path(self, name):
		return f"{self.folder}/{self.about[name]['file']}"

	def __getitem__(self, name):
		if name not in self.read:
			self.read[name] = Buffer(self.path(name))
		return self.read[name]

	def order(self):
		"""Names of the buffers that stages make, in the order of the pipeline."""
		made = [name for name in self.about if name in self.stages]
		return sorted(made, key=lambda name: self.numbers[self.stages[name]])

	def copy(self, folder, arrival=False):
		"""A candidate beside it: links to the files, but not to the scene's, which a port reads from ours."""
		shutil.rmtree(folder, ignore_errors=True)
		os.makedirs(folder)
		about = dict(self.json, order="arrival" if arrival else "canonical")
		about["buffers"] = [dict(b) for b in self.json["buffers"]]
		for buffer in about["buffers"]:
			if buffer["file"] and buffer["name"] in self.stages:
				os.link(self.path(buffer["name"]), f"{folder}/{buffer['file']}")
			else:
				buffer["file"] = None
		with open(folder + "/trace.json", "w", encoding="utf-8") as file:
			json.dump(about, file, indent=1)
		return Trace(folder)

	def put(self, name, buffer):
		"""Replaces a linked file by its own."""
		os.unlink(self.path(name))
		buffer.write(self.path(name))
		self.read[name] = buffer

	def where(self, name, element):
		"""How a report names an element."""
		shape, buffer = self.about[name]["sizes"].split(), self[name]
		inside = 1
		for size in buffer.shape[2 if is_image(shape) else 1:]:
			inside *= size
		row = element // inside
		if is_image(shape) and shape[2:] == ["lamps"]:
			return self.place(shape, row) + f", light {element % inside}"
		return self.place(shape, row) + (f" [{element % inside}]" if inside > 1 else "")

	def pixel(self, element, sampled):
		"""Buffers of the eye hold a picture of each sample of the pixels, one below the other."""
		width, height = (int(self.json["params"][name]) for name in ("width", "height"))
		several = sampled and str(self.json["params"].get("eye.samples")) == "4"
		sample = f", sample {element // width // height}" if several else ""
		return f"pixel ({element % width}, {element // width % height})" + sample

	def place(self, shape, row):
		if is_image(shape):
			return self.pixel(row, shape[0] != "height")
		if shape[0] in ("height*width+1", "eye_rows*width+1"):
			return self.pixel(row, shape[0][0] == "e")
		if shape[0] == "mirror_pixels":
			return self.pixel(*self["mirror_pixel.record"].get(row, "index"), True)
		if shape[0] == "points":
			return f"key ({self.key(self['points.key'].words()[row])})"
		if shape[0] in ("texels", "texels+1"):
			return self.texel(row)
		last = shape[0].removesuffix("+1").split("*")[-1]
		return f"{NOUNS.get(last, 'element')} {row}"

	@staticmethod
	def key(key):
		return f"piece {key >> 32}, x {(key & 0xffff) - 32768}, y {(key >> 16 & 0xffff) - 32768}"

	def texel(self, texel):
		if "cube_size.face" not in self.about:
			return self.view_texel(texel)
		cubes = self["cube_size.face"]
		for r in range(cubes.n):
			n, = cubes.get(r, "n")
			first, = cubes.get(r, "offset")
			if first <= texel < first + 6 * n * n:
				inside = texel - first
				owner = "sample" if cubes.get(r, "object")[0] == NONE else "reflector"
				return f"{owner} {r}, face {FACES[inside // (n * n)]}, texel ({inside % n}, {inside // n % n})"
		return f"element {texel}"

	def view_texel(self, texel):
		views = self["offscreen.view"]
		for v in range(views.n):
			(width,), (height,), (first,) = (views.get(v, name) for name in ("width", "height", "offset"))
			if first <= texel < first + width * height:
				return f"view {v}, texel ({(texel - first) % width}, {(texel - first) // width})"
		return f"element {texel}"


def counts(sums):
	return [sums[0]] + [after - before for before, after in zip(sums, sums[1:])]


class Difference:
	"""Where two buffers of the same order first differ, and in how many elements; of prefix sums, in how many counts;
	of pairs, the first that is missing, and how many are."""

	def __init__(self, reference, candidate, name):
		ref, cand = reference[name], candidate[name]
		if name == "traverse.rendered":
			self.of_pairs(ref.words(), cand.words())
			return
		both = min(ref.n, cand.n)
		sums = name.replace(".", "_") in SUMS
		unlike = []
		if ref.data != cand.data:
			ours, theirs = (counts(b.words()) if sums else b.elements() for b in (ref, cand))
			unlike = [i for i in range(both) if ours[i] != theirs[i]]
		self.n = len(unlike) + ref.n + cand.n - 2 * both
		self.first = unlike[0] if unlike else None
		if self.first == 0 and sums:
			self.where, self.field = "element 0, where the sums begin", None
		elif self.first is not None and sums:
			thing, sum_before = reference.where(name, self.first - 1), self.first - 1
			self.where, self.field = f"count of {thing} (element {self.first} less element {sum_before})", None
		elif self.first is not None:
			self.where, self.field = reference.where(name, self.first), self.first_field(ref, cand)
		elif self.n:
			self.where = f"{ref.n} elements, candidate {cand.n}"
			self.field = None

	def of_pairs(self, ours, theirs):
		missing = sorted(set(ours) - set(theirs))
		self.n, self.first, self.field = len(missing), None, None
		if missing:
			self.where = f"pair (node {missing[0] >> 32}, node of views {missing[0] & 0xffffffff}): missing"

	def first_field(self, ref, cand):
		a, b = ref.element(self.first), cand.element(self.first)
		for field in ref.fields:
			for k in range(field.count):
				at = slice(field.offset + k * field.size, field.offset + (k + 1) * field.size)
				if a[at] != b[at]:
					return field.name + (f"[{k}]" if field.count > 1 else "")
		return None


LINE = re.compile(r"stage (?P<number>\d\d) (?P<stage>[\w.]+), buffer (?P<buffer>[\w.]+), (?P<what>.*?)"
                  r"(?: — first of (?P<n>\d+)(?: missing, \d+ beside)?)?; (?P<inputs>(?:equal as far .*)?inputs .*)$")


def read_line(line):
	"""The parts of the one line that a failing comparison ends with, or None."""
	match = LINE.match(line or "")
	return match.groupdict() if match else None
