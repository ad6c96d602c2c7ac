"""What tests/cli/report.sh asks of a page. Usage: report.py CHECK ARGUMENT...;
each check ends with 0 where it holds."""
import base64
import json
import os
import re
import struct
import sys
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../image"))


def read(path):
	with open(path, encoding="utf-8") as file:
		return file.read()


def data_of(path):
	"""The page's data; and nothing in the page is loaded from elsewhere."""
	text = read(path)
	data, = re.findall(r'<script type="application/json" id="data">(.*?)</script>', text, re.S)
	assert "<" not in data, "markup in the data"
	rest = text.replace(data, "")
	assert len(re.findall(r"<script", rest)) == 2 and "http:" not in rest, "more scripts, or links"
	assert "https:" not in rest, "more scripts, or links"
	return json.loads(data)


def unfiltered(raw, width, height, n):
	"""Bytes of the rows of a PNG, from those that its filters left."""
	rows, last = [], bytearray(width * n)
	for y in range(height):
		how, line = raw[y * (width * n + 1)], bytearray(raw[y * (width * n + 1) + 1:(y + 1) * (width * n + 1)])
		for i in range(width * n):
			a, b, c = line[i - n] if i >= n else 0, last[i], last[i - n] if i >= n else 0
			near = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
			line[i] = line[i] + (0, a, b, (a + b) // 2, near)[how] & 255
		rows.append(bytes(line))
		last = line
	return b"".join(rows)


def pixels_of(png):
	"""(width, height, channels, bytes) of a PNG of 8 bits."""
	png, at, packed = base64.b64decode(png), 8, b""
	while at < len(png):
		size, kind = struct.unpack_from(">I4s", png, at)
		if kind == b"IHDR":
			width, height, depth, colour = struct.unpack_from(">IIBB", png, at + 8)
		if kind == b"IDAT":
			packed += png[at + 8:at + 8 + size]
		at += 12 + size
	n = {0: 1, 2: 3, 6: 4}[colour]
	assert depth == 8
	return width, height, n, unfiltered(zlib.decompress(packed), width, height, n)


def png_of(width, height, rows, depth):
	"""A PNG of three channels, by its rows, each behind its filter; not packed."""
	def chunk(kind, content):
		return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
	head = struct.pack(">IIBBBBB", width, height, depth, 2, 0, 0, 0)
	return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 0)) + chunk(b"IEND", b"")


def npy(folder, name):
	name, = [n for n in os.listdir(folder) if n.endswith(f"-{name}.npy")]
	with open(os.path.join(folder, name), "rb") as file:
		data = file.read()
	return data[10 + data[8] + 256 * data[9]:]


def pair_named(data, reference, image):
	names = [p["name"] for p in data["pictures"]]
	found, = [p for p in data["pairs"] if (names[p["reference"]], names[p["image"]]) == (reference, image)]
	return found


# ---- checks ----

def folder(path, where):
	"""A page of a rendered folder: its pictures and figures are those of the folder."""
	data, report = data_of(path), json.loads(read(where + "/report.json"))
	names = {p["name"] for p in data["pictures"] if p["judged"]}
	assert names == {"epr", "mvr", "truth-a"}, names
	for picture in data["pictures"]:
		with open(f"{where}/{picture['name']}.png", "rb") as file:
			assert pixels_of(base64.b64encode(file.read())) == pixels_of(picture["png"]), picture["name"]
	for row in report["metrics"]:
		if row["reference"] == "truth-a":
			pair = pair_named(data, "truth-a", row["image"])
			assert all(abs(pair[key] - row[key]) < 1e-6 for key in ("rmse", "psnr", "ssim")), (pair, row)
			assert 0 < pair["flip"] < 1
	assert len(data["pairs"]) == 2
	shown = data["folders"][0]
	assert shown["report"]["counters"] == report["counters"]
	assert shown["times"] == json.loads(read(where + "/times.json"))
	assert [p["trace"] for p in data["pictures"] if "trace" in p] == [f"{where}/trace-epr", f"{where}/trace-mvr"]


RAMP = [i * 6553 % 65536 for i in range(3 * 16 * 16)]


def series(path, where, name):
	"""The page has the plots and videos of a series, its values, and what each picture shows."""
	data = data_of(path)
	media = {m["name"]: m for m in data["media"]}
	assert set(media) == {n for n in os.listdir(where) if n.endswith((".svg", ".mp4"))} and name in media, list(media)
	for each in media.values():
		with open(f"{where}/{each['name']}", "rb") as file:
			assert base64.b64decode(each["content"]) == file.read() and each["shows"]
	values = [row["values"] for row in data["folders"][0]["times"]["renders"]]
	assert values == ([{"density.scale": "0.25"}, {"density.scale": "0.5"}]
	                  if name.startswith("rmse") else [{}, {}]), values
	assert all(p["shows"] for p in data["pictures"]) and len(data["pictures"]) > 4


def ramp(path):
	"""A PNG of 16 bits a channel."""
	rows = b"".join(b"\0" + struct.pack(">48H", *RAMP[48 * y:48 * (y + 1)]) for y in range(16))
	with open(path, "wb") as file:
		file.write(png_of(16, 16, rows, 16))


def codes(path):
	"""All pictures of the page are the ramp in the nearest codes of 8 bits."""
	pictures = data_of(path)["pictures"]
	assert len(pictures) == 2
	for picture in pictures:
		assert pixels_of(picture["png"]) == (16, 16, 3, bytes((code + 128) // 257 for code in RAMP))


def flip(path, *pairs):
	"""FLIP is that of numpy, for pairs REFERENCE:IMAGE."""
	import flip as second
	import numpy
	data = data_of(path)
	def array(index):
		width, height, n, rows = pixels_of(data["pictures"][index]["png"])
		return numpy.frombuffer(rows, numpy.uint8).reshape(height, width, n)
	for names in pairs:
		pair = pair_named(data, *names.split(":"))
		errors = second.evaluate(array(pair["reference"]), array(pair["image"]), data["ppd"])
		width, height, _, grey = pixels_of(pair["errors"])
		assert abs(errors.mean() - pair["flip"]) < 1e-7, (errors.mean(), pair["flip"])
		assert numpy.abs(255 * errors - numpy.frombuffer(grey, numpy.uint8).reshape(height, width)).max() < 0.5001
		assert errors.max() > 0.1


def spoil(folder_name, *places):
	"""Changes bits: BUFFER:BYTES OF A PIXEL:X,Y of a trace 96 pixels wide."""
	for place in places:
		buffer, size, xy = place.split(":")
		x, y = map(int, xy.split(","))
		name, = [n for n in os.listdir(folder_name) if n.endswith(f"-{buffer}.npy")]
		with open(os.path.join(folder_name, name), "r+b") as file:
			data = file.read()
			at = 10 + data[8] + 256 * data[9] + int(size) * (96 * y + x)
			file.seek(at)
			file.write(bytes([data[at] ^ (64 if buffer == "image.srgb" else 1)]))


def comparison(path, reference, candidate, line, probes, firsts):
	"""The comparison of two traces: its line, the first buffer of each differing pixel, the probes, the pictures."""
	data = data_of(path)
	found, = data["comparisons"]
	assert found["said"]["verdict"] == "different"
	assert found["said"]["first_divergence"] == line, (found["said"]["first_divergence"], line)
	for place, index in ((reference, found["reference"]), (candidate, found["image"])):
		width, height, n, rows = pixels_of(data["pictures"][index]["png"])
		assert (width, n) == (96, 3) and rows == npy(place, "image.srgb")
	_, _, n, marks = pixels_of(found["firsts"])
	names = [layer["buffer"] for layer in found["layers"]]
	shown = {f"{i % 96},{i // 96}": names[mark - 1] for i, mark in enumerate(marks) if mark}
	assert n == 1 and shown == json.loads(firsts), shown
	for layer in found["layers"]:
		assert layer["pixels"] == list(shown.values()).count(layer["buffer"]), layer
	held = {f"{p['x']},{p['y']}" for p in found["probes"]}
	assert len(held) == len(found["probes"]) == int(probes) and held <= set(shown), held
	for probe in found["probes"]:
		assert probe["reference"]["pixel"] == probe["candidate"]["pixel"] == [probe["x"], probe["y"]]
	said = [d for b in found["said"]["differences"] for d in b["first"]]
	assert all(f"pixel ({d['x']}, {d['y']})" in d["where"] for d in said), said


def names(path, text):
	"""The text, which a file holds, is in the data as it is."""
	def walk(value):
		if isinstance(value, dict):
			return any(map(walk, value.values()))
		return any(map(walk, value)) if isinstance(value, list) else value == text
	assert walk(data_of(path)), text


def noise(path, side):
	"""A PNG of side x side pixels that no packing makes smaller."""
	side = int(side)
	row = bytes(1) + os.urandom(3 * side)
	with open(path, "wb") as file:
		file.write(png_of(side, side, row * side, 8))


if __name__ == "__main__":
	{f.__name__: f for f in (folder, ramp, codes, flip, spoil, comparison, names, noise,
	                         series)}[sys.argv[1]](*sys.argv[2:])
