#!/usr/bin/python3
"""The values of reference/PORTING.md, sections 2 and 9 to 11, that can be worked out by hand, in traces of the
triangles and surfels of scenes/. numpy is not needed. Prints TAP.

	micro.py ONE MIRROR TWICE EDGE SIDE BEHIND BOX SEEN SPLATS     folders of the nine traces"""
import json
import math
import os
import re
import struct
import sys

EMPTY = 0xffffffffffffffff


class Trace:
	"""Buffers as lists: of numbers, or of dicts of numbers or tuples."""

	def __init__(self, folder):
		self.folder = folder
		with open(os.path.join(folder, "trace.json"), encoding="utf-8") as file:
			self.buffers = {buffer["name"]: buffer for buffer in json.load(file)["buffers"]}

	def __getitem__(self, name):
		with open(os.path.join(self.folder, self.buffers[name]["file"]), "rb") as file:
			data = file.read()
		data = data[10 + struct.unpack_from("<H", data, 8)[0]:]
		codes = {"<f4": "f", "<i4": "i", "<u4": "I", "<u8": "Q", "|u1": "B"}
		dtype = self.buffers[name]["dtype"]
		fields = re.findall(r"\('(\w+)', '(...)'(?:, \((\d+),\))?\)", dtype)
		if not fields:
			return [v[0] for v in struct.iter_unpack("<" + codes[dtype.strip("'")], data)]
		layout = struct.Struct("<" + "".join(count + codes[code] for _, code, count in fields))
		return [self.record(fields, values) for values in layout.iter_unpack(data)]

	@staticmethod
	def record(fields, values):
		out, at = {}, 0
		for name, _, count in fields:
			n = int(count or 1)
			out[name] = values[at:at + n] if count else values[at]
			at += n
		return out


def bits(x):
	return struct.unpack("<I", struct.pack("<f", x))[0]


def number(key):
	return struct.unpack("<f", struct.pack("<I", key >> 32))[0]


class Tap:
	n = failed = 0

	def equal(self, name, found, right):
		self.n += 1
		good = found == right
		self.failed += not good
		print(f"{'ok' if good else 'not ok'} {self.n} - {name}")
		if not good:
			print(f"# found {found}\n# right {right}")

	def near(self, name, found, right):
		self.equal(name, abs(found - right) <= 2e-6 * abs(right) and right, right)


def check_one(tap, trace):
	view = trace["eye.view"][0]
	tap.equal("triangle: f = H/2", view["focal"], 8.0)
	corners = [trace["pose.vertex"][v]["position"] for v in trace["scene.triangle"][0]["vertex"]]
	screen = [(8 + 8 * x / -z, 8 - 8 * y / -z) for x, y, z in corners]
	tap.equal("triangle: corners on the screen", screen, [(4, 12), (12, 12), (4, 4)])
	covered = [(j, i) for j in range(16) for i in range(16) if 4 <= i < j < 12]
	right = [bits(4.0) << 32 if (j, i) in covered else EMPTY for j in range(16) for i in range(16)]
	tap.equal("triangle: 28 pixels", len(covered), 28)
	tap.equal("triangle: eye.depth_triangle", trace["eye.depth_triangle"], right)


def faces_of(trace):
	texels = trace["splat.depth_index"]
	return [[texels[256 * f + 16 * j:256 * f + 16 * j + 16] for j in range(16)] for f in range(6)]


# Which point holds texels 5 to 10 of rows 5 to 10 of face +X; -1: none.
HOLDS = [
	[-1, -1, -1, -1, 6, 6],
	[-1, -1, -1, -1, 5, 6],
	[-1, -1, 3, 3, 10, 11],
	[-1, -1, 3, 3, 10, 14],
	[0, 1, 8, 8, 13, 15],
	[0, 0, 7, 12, 15, 15],
]


def check_mirror(tap, trace, name, copies):
	face = trace["cube_size.face"][0]
	cube = [face[field] for field in ("centre", "radius", "near", "n")]
	tap.equal(f"{name}: cube", cube, [(0, 0, 0), 1.0, 2 ** -10, 16])
	tap.equal(f"{name}: visibility.bits", trace["visibility.bits"], [1] * copies + [0] * 8)
	tap.equal(f"{name}: split.density", trace["split.density"], [2.0] * copies)
	frame = trace["align.frame"][0]
	tap.equal(f"{name}: lattice", frame["q"], (128, 611, -596, -113, 852, -113))
	for axis, right in (("u", (0, math.sqrt(0.5), -math.sqrt(0.5))), ("v", (0, -math.sqrt(0.5), -math.sqrt(0.5)))):
		tap.equal(f"{name}: {axis}", [abs(a - b) < 1e-6 for a, b in zip(frame[axis], right)], [True] * 3)
	tap.equal(f"{name}: points.offset", trace["points.offset"], [16 * k for k in range(copies + 1)])
	samples = [(j, i) for j, most in ((-1, 3), (0, 2), (1, 1), (2, 0)) for i in range(-most, most + 1)]
	keys = [k << 32 | (j + 32768) << 16 | (i + 32768) for k in range(copies) for j, i in samples]
	tap.equal(f"{name}: points.key", trace["points.key"], keys)
	points = trace["points.record"]
	tap.equal(f"{name}: splat lengths", {point["length"] for point in points}, {0.5})
	faces = faces_of(trace)
	holds = [[-1 if key == EMPTY else key & 0xffffffff for key in row[5:11]] for row in faces[0][5:11]]
	tap.equal(f"{name}: which point holds which texel", holds, HOLDS)
	tap.equal(f"{name}: 24 texels", sum(key != EMPTY for face in faces for row in face for key in row), 24)
	tap.near(f"{name}: distance of point 3", number(faces[0][8][8]), math.hypot(4, 0.5 - math.sqrt(2) / 3))
	ties = sum(trace["splat.tie"])
	tap.equal(f"{name}: ties", ties, 24 if copies == 2 else 0)


def held_in(trace):
	faces = faces_of(trace)
	return [(f, j, i) for f in range(6) for j in range(16) for i in range(16) if faces[f][j][i] != EMPTY]


def check_edge(tap, trace):
	tap.equal("triangle_edge: visibility.bits, +X and +Z", trace["visibility.bits"][0], 0x11)
	held = held_in(trace)
	tap.equal("triangle_edge: texels of +X", [(j, i) for f, j, i in held if f == 0], [(7, 0), (8, 0)])
	tap.equal("triangle_edge: faces", sorted({f for f, _, _ in held}), [0, 4])


def check_side(tap, trace):
	tap.equal("triangle_side: visibility.bits, +X", trace["visibility.bits"][0], 1)
	right = [(0, j, i) for j in range(3, 13) for i in range(3, 13) if 14 <= i + j <= 16]
	tap.equal("triangle_side: 28 texels", len(right), 28)
	tap.equal("triangle_side: those about the diagonal", held_in(trace), right)


def check_behind(tap, trace):
	tap.equal("triangle_behind: visibility.bits, all faces", trace["visibility.bits"][0], 0x3f)
	tap.equal("triangle_behind: nothing in +X", [f for f, _, _ in held_in(trace) if f == 0], [])
	tap.equal("triangle_behind: no tiny points", {point["flags"] for point in trace["points.record"]}, {0})


def check_box(tap, trace):
	zn = 1 - math.sqrt(8 + 2 ** -8) / 4096
	covered = [4 <= i // 2 < j // 2 < 12 for j in range(32) for i in range(32)]
	tap.equal("box: 112 texels", sum(covered), 112)
	right = [bits(trace["segment.box"][0]["nearest"]) if inside else bits(1.0) for inside in covered]
	tap.equal("box: depth_grid.depth", [bits(depth) for depth in trace["depth_grid.depth"]], right)
	tap.equal("box: its depth", bits(trace["segment.box"][0]["nearest"]), bits(zn))
	labels = trace["segment.label"]
	tap.equal("box: segment.label", {label for label, inside in zip(labels, covered) if inside}, {22 * 32 + 8})
	box = [trace["segment.box"][0][field] for field in ("low", "high")]
	tap.equal("box: segment.box", (len(trace["segment.box"]), box), (1, [(8, 10), (21, 23)]))
	found = [corner["position"] for corner in trace["corner.moment"]]
	right = [(x, y, -4.0) for y in (1.25, -1.75) for x in (-1.75, 1.25)]
	tap.equal("box: corner.moment, the corner in the sky", [round(x, 4) for x in found[1]], list(right[1]))
	tap.equal("box: corner.moment, the others", [found[k] for k in (0, 2, 3)], [right[k] for k in (0, 2, 3)])


def check_seen(tap, trace):
	root = trace["octree.root"][0]
	tap.near("seen: side of the root", root["side"], 5 * (1 + 2 ** -10) + 4 * 2 ** -20)
	middle = [round(low + root["side"] / 2, 6) for low in root["lower"]]
	tap.equal("seen: middle of the root", middle, [1.5, 0, 0])
	tap.equal("seen: octree.level", trace["octree.level"], [0, 1, 9, 21])
	offset, listed = trace["octree.offset"], trace["octree.triangle"]
	of_leaf = {9 + k: listed[offset[k]:offset[k + 1]] for k in range(12)}
	tap.equal("seen: leaves of the triangle", [leaf for leaf, of in of_leaf.items() if of == [0]], [11, 14, 17, 20])
	tap.equal("seen: nodes of views", len(trace["view_octree.node"]), 3)
	pairs = [divmod(pair, 1 << 32) for pair in trace["traverse.rendered"]]
	tap.equal("seen: traverse.rendered", pairs, [(leaf, 2) for leaf in (11, 14, 17, 20)])


def check_splats(tap, trace):
	discs = trace["surfel_setup.disc"]
	tap.equal("splats: pixels", [disc["pixel"] for disc in discs], [(6, 8), (8, 8), (10, 8)])
	tap.equal("splats: fractions", {disc["fraction"] for disc in discs}, {(-0.5, -0.5)})
	found = [[round(x, 6) for x in disc["a"] + disc["b"]] for disc in discs]
	tap.equal("splats: A and B", found, [[1, 0, 0, -1], [0, -0.5, -2, 0], [0.6, -0.8, -1.6, -1.2]])
	found = [disc["low"] + disc["high"] for disc in discs]
	tap.equal("splats: boxes", found, [(5, 7, 6, 8), (7, 6, 8, 9), (9, 7, 10, 8)])
	tap.equal("splats: epsilon", trace["surfel_setup.epsilon"], [0.5])
	keys = {divmod(at, 16): key for at, key in enumerate(trace["surfel_depth.surfel"]) if key != EMPTY}
	right = {(7, 5): 0, (7, 6): 0, (8, 5): 0, (8, 6): 0, (7, 10): 2, (8, 9): 2}
	tap.equal("splats: who is nearest", {at: key & 0xffffffff for at, key in keys.items()}, right)
	for (j, i), key in keys.items():
		tap.near(f"splats: depth ({i}, {j})", number(key), 4 + 0.5 / math.hypot(1, (i - 7.5) / 8, (j - 7.5) / 8))


def main():
	tap = Tap()
	names = ("triangle", "triangle_mirror", "triangle_twice", "triangle_edge", "triangle_side", "triangle_behind")
	traces = [Trace(folder) for folder in sys.argv[1:7]]
	check_one(tap, traces[0])
	check_mirror(tap, traces[1], names[1], 1)
	check_mirror(tap, traces[2], names[2], 2)
	check_edge(tap, traces[3])
	check_side(tap, traces[4])
	check_behind(tap, traces[5])
	check_box(tap, Trace(sys.argv[7]))
	check_seen(tap, Trace(sys.argv[8]))
	check_splats(tap, Trace(sys.argv[9]))
	for name, trace in zip(names, traces):
		with open(f"scenes/{name}.gltf", encoding="utf-8") as file:
			corners = json.load(file)["meshes"][0]["extras"]["corners"]
		position = [vertex["position"] for vertex in trace["pose.vertex"]]
		found = [position[v] for t in trace["scene.triangle"][:len(corners) // 3] for v in t["vertex"]]
		tap.equal(f"{name}: the corners in its extras", [list(p) for p in found], corners)
	print(f"1..{tap.n}")
	return 1 if tap.failed else 0


sys.exit(main())
