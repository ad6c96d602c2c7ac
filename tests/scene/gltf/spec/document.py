"""A small glTF document, its pictures, and edits of it. Its file is the same bytes each time."""
import base64
import collections
import copy
import json
import math
import struct
import zlib

KINDS = {"i8": (5120, "b"), "u8": (5121, "B"), "i16": (5122, "h"), "u16": (5123, "H"), "u32": (5125, "I"),
         "f32": (5126, "f")}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
GONE = ...  # as a value: the member is taken out
RED, GREEN, BLUE, WHITE, BLACK = (255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255), (0, 0, 0)
LIGHTS, UNLIT = "KHR_lights_punctual", "KHR_materials_unlit"

# What becomes a new accessor or a new buffer view where a document takes it.
Data = collections.namedtuple("Data", "kind type values members")
View = collections.namedtuple("View", "data members")


def data(kind, type, values, **members):
	"""An accessor of these numbers; members: more of it; target is its view's."""
	return Data(kind, type, list(values), members)


def view(data, **members):
	return View(data, members)


def pack(kind, values):
	return struct.pack(f"<{len(values)}{KINDS[kind][1]}", *values)


def flattened(rows):
	return [number for row in rows for number in row]


# ---- pictures ----

def chunk(kind, data):
	return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width, height, samples, colour=2, depth=8, between=b""):
	length = len(samples) // height
	rows = b"".join(b"\0" + bytes(samples[i * length:(i + 1) * length]) for i in range(height))
	head = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, 0)
	whole = chunk(b"IHDR", head) + between + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
	return b"\x89PNG\r\n\x1a\n" + whole


def flat(*colour):
	"""A PNG of one pixel."""
	return png(1, 1, colour, {1: 0, 2: 4, 3: 2, 4: 6}[len(colour)])


def quarters(between=b""):
	"""A PNG of 4 x 4 pixels: red and green above blue and white."""
	upper, lower = flattened((RED, RED, GREEN, GREEN)), flattened((BLUE, BLUE, WHITE, WHITE))
	return png(4, 4, 2 * upper + 2 * lower, between=between)


def checks(size):
	"""A PNG of black and white pixels by turns."""
	return png(size, size, [255 * ((x ^ y) & 1) for y in range(size) for x in range(size) for _ in range(3)])


GAMMA_1 = chunk(b"gAMA", struct.pack(">I", 100000))
PROFILE = chunk(b"iCCP", b"x\0\0" + zlib.compress(bytes(128)))
FRAMES_AND_SHAPE = chunk(b"pHYs", struct.pack(">IIB", 1, 5, 0)) + chunk(b"acTL", struct.pack(">II", 2, 0))


def segment(marker, data):
	return struct.pack(">BBH", 0xFF, marker, len(data) + 2) + data


JPEG_PROFILE = segment(0xE2, b"ICC_PROFILE\0\1\1" + struct.pack(">I", 128) + b"none" + bytes(120))


def jpeg(between=b""):
	"""Eight by eight grey pixels."""
	table = bytes([1] + 16 * [0])
	head = segment(0xDB, b"\0" + 64 * b"\1") + segment(0xC0, bytes([8, 0, 8, 0, 8, 1, 1, 17, 0]))
	tables = segment(0xC4, b"\0" + table) + segment(0xC4, b"\x10" + table)
	return b"\xff\xd8" + between + head + tables + segment(0xDA, bytes([1, 1, 0, 0, 63, 0])) + b"\x3f\xff\xd9"


def data_uri(kind, data):
	return f"data:{kind};base64,{base64.b64encode(data).decode()}"


def percent_coded(content):
	return "data:application/octet-stream," + "".join(f"%{octet:02x}" for octet in content)


# ---- documents ----

class Document:
	"""`json` is the document; `bytes` are of two buffers: geometry, and what keyframes and skins have. `beside` are
	files of its folder, by name."""

	def __init__(self):
		self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": []}
		self.bytes = [b"", b""]
		self.beside = {}
		self.suffix = ".gltf"
		self.whole = None  # the file, where it is not the JSON
		self.reworded = None  # changes the text of the JSON

	def add(self, key, item):
		self.json.setdefault(key, []).append(item)
		return len(self.json[key]) - 1

	def view(self, data, buffer=0, **members):
		self.bytes[buffer] += bytes(-len(self.bytes[buffer]) % 4)
		place = {"buffer": buffer, "byteOffset": len(self.bytes[buffer]), "byteLength": len(data)}
		self.bytes[buffer] += data
		return self.add("bufferViews", {**place, **members})

	def accessor(self, of, buffer=0):
		members = dict(of.members)
		found = {"target": members.pop("target")} if "target" in members else {}
		taken = members.pop("view", None)
		count = members.pop("count", len(of.values) // WIDTHS.get(of.type, 1))
		index = self.view(pack(of.kind, of.values), buffer, **found) if taken is None else self.taken(taken)
		return self.add("accessors", {"bufferView": index, "componentType": KINDS[of.kind][0], "count": count,
		                              "type": of.type, **members})

	def taken(self, value):
		"""The value as it stands in the document: an index for what becomes an accessor or a view."""
		if isinstance(value, Data):
			return self.accessor(value)
		if isinstance(value, View):
			return self.view(value.data, **value.members)
		if isinstance(value, dict):
			return {key: self.taken(item) for key, item in value.items()}
		return [self.taken(item) for item in value] if isinstance(value, list) else value

	def node(self, root=True, **members):
		index = self.add("nodes", members)
		if root:
			self.json["scenes"][0]["nodes"].append(index)
		return index

	def light(self, node=None, light=None):
		self.uses(LIGHTS)
		lights = self.json.setdefault("extensions", {}).setdefault(LIGHTS, {"lights": []})["lights"]
		lights.append({"type": "directional", "intensity": math.pi, **(light or {})})
		placed = {"translation": [0, 0, 2], **(node or {})}
		return self.node(**placed, extensions={LIGHTS: {"light": len(lights) - 1}})

	def texture(self, image, mime="image/png"):
		image = self.add("images", {"bufferView": self.view(image), "mimeType": mime})
		return self.add("textures", {"source": image})

	def uses(self, *names):
		listed = self.json.setdefault("extensionsUsed", [])
		listed += [name for name in names if name not in listed]
		return self

	def requires(self, *names):
		self.uses(*names)
		self.json.setdefault("extensionsRequired", []).extend(names)
		return self

	@property
	def primitive(self):
		return self.json["meshes"][0]["primitives"][0]

	def text(self, glb=False):
		whole = copy.deepcopy(self.json)
		if "buffers" not in whole:
			for i, data in enumerate(self.bytes):
				if data:
					uri = {} if glb and i == 0 else {"uri": data_uri("application/octet-stream", data)}
					whole.setdefault("buffers", []).append({"byteLength": len(data), **uri})
		text = json.dumps(whole, ensure_ascii=False).encode()
		return self.reworded(text) if self.reworded else text

	def file(self):
		return self.text() if self.whole is None else self.whole


def edit(document, *changes):
	"""The document, changed. Each change: a path with /, where an index may be that of a new item, and a value."""
	for path, value in changes:
		at = document.json
		*steps, last = [int(step) if step.isdigit() else step for step in path.split("/")]
		for step in steps:
			if isinstance(at, list) and step == len(at):
				at.append({})
			at = at.setdefault(step, {}) if isinstance(at, dict) else at[step]
		if value is GONE:
			del at[last]
		elif isinstance(at, list) and last == len(at):
			at.append(document.taken(value))
		else:
			at[last] = document.taken(value)
	return document


def reworded(document, *replacements):
	"""The document, in whose text each word of a pair is replaced by the other."""
	def change(text):
		for word, other in replacements:
			text = text.replace(word.encode(), other.encode())
		return text
	document.reworded = change
	return document


def recoded(document, coded):
	"""The document as coded(text) writes its text."""
	document.reworded = lambda text: coded(text.decode())
	return document


# ---- containers ----

def block(kind, data, padding=b"\0", multiple=4):
	data += padding * (-len(data) % multiple)
	return struct.pack("<I4s", len(data), kind) + data


def glb(document, order="JB", version=2, longer=0, binary=None, binary_more=b"", text_more=b"", behind=b"",
        magic=b"glTF", suffix=".glb"):
	"""The document as a .glb. order: its chunks: J the JSON, B the data, X one of an unknown kind. binary: instead of
	the data. longer: what its header says more than there is."""
	text = document.text(True)
	text += b" " * (-len(text) % 4) + text_more
	binary = document.bytes[0] if binary is None else binary
	chunks = {"J": block(b"JSON", text, b" "), "B": block(b"BIN\0", binary + binary_more), "X": block(b"XTRA", b"more")}
	body = b"".join(chunks[name] for name in order)
	document.whole = magic + struct.pack("<II", version, 12 + len(body) + longer) + body + behind
	document.suffix = suffix
	return document


def glb_of_odd_length(document):
	"""A .glb whose JSON has a length of one more than a multiple of 4."""
	text = document.text(True)
	text += b" " * (1 - len(text) % 4)
	body = block(b"JSON", text, multiple=1) + block(b"BIN\0", document.bytes[0])
	document.whole = b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body
	document.suffix = ".glb"
	return document
