"""Defects planted in copies of traces, each with the buffer and element that the comparison must name. A function a
mutant: it gets the reference, the candidate, which it changes, and the bench, which has other traces; it returns what
must be found."""
import random
import struct
from traces import EMPTY, NONE, Difference

MUTANTS = []


class Planted:
	"""What must be reported: `where` is how the element is named; `refused`: a part of the message instead."""

	def __init__(self, buffer=None, where="", field=None, n=None, refused=None):
		self.buffer, self.where, self.field, self.n, self.refused = buffer, where, field, n, refused


def mutant(name, of="base", **how):
	"""of: a run of the bench; how: arguments of Trace.copy."""
	def add(plant):
		MUTANTS.append((name, of, how, plant))
		return plant
	return add


def first(reference, candidate, buffer):
	difference = Difference(reference, candidate, buffer)
	return Planted(buffer, difference.where, difference.field or None, difference.n)


# Buffers that hold indices of points in their lower 32 bits, and what is no index; and those with a field of that.
INDICES = {"splat.depth_index": EMPTY, "lookup.point": NONE, "lookup.second_point": NONE, "lookup.third_point": NONE}
QUEUES = ("lookup.second_parent", "lookup.third_parent")


def remap(candidate, place):
	"""Every index of a point becomes place[index]."""
	for name in [name for name in INDICES if name in candidate.about]:
		buffer, none = candidate[name], INDICES[name]
		buffer.set_words([w if w == none else w & ~NONE | place[w & NONE] for w in buffer.words()])
		candidate.put(name, buffer)
	for name in [name for name in QUEUES if name in candidate.about]:
		buffer = candidate[name]
		for i in range(buffer.n):
			put_field(buffer, i, "point", 0, place[buffer.get(i, "point")[0]])
		candidate.put(name, buffer)


def put_field(buffer, element, field, component, bits):
	at = element * buffer.bytes + next(f.offset for f in buffer.fields if f.name == field) + 4 * component
	struct.pack_into("<I", buffer.data, at, bits)


def reorder(candidate, order, remapped=True):
	"""Point i becomes the one that was order[i]; order may leave points out and name them twice."""
	n = candidate["points.key"].n
	for name in ("points.key", "points.record"):
		buffer = candidate[name]
		elements = buffer.elements()
		buffer.set_elements([elements[i] for i in order])
		candidate.put(name, buffer)
	if remapped:
		place = [0] * n
		for at, i in enumerate(order):
			place[i] = at
		remap(candidate, place)


def shuffled(n, seed):
	order = list(range(n))
	random.Random(seed).shuffle(order)
	return order


def texels_where(trace, tied):
	"""Texels that hold a point and are marked as tied, or not."""
	marks = trace["splat.tie"].words()
	return [i for i, key in enumerate(trace["splat.depth_index"].words()) if key != EMPTY and marks[i] == tied]


def put_words(candidate, buffer, words):
	"""Replaces a buffer of scalars, as long as before."""
	data = candidate[buffer]
	data.set_words(words)
	candidate.put(buffer, data)


def edit(candidate, buffer, index, change):
	"""Replaces one word of a buffer of scalars."""
	words = candidate[buffer].words()
	words[index] = change(words[index])
	put_words(candidate, buffer, words)


@mutant("point dropped", arrival=True)
def _(ref, cand, _bench):
	n = ref["points.key"].n
	dropped = n // 3
	reorder(cand, [i for i in range(n) if i != dropped])
	return Planted("points.key", ref.where("points.key", dropped), None, 1)


@mutant("point dropped, in order")
def _(ref, cand, _bench):
	n = ref["points.key"].n
	reorder(cand, [i for i in range(n) if i != n // 3])
	return Planted("points.key", ref.where("points.key", n // 3), None, n - n // 3)


@mutant("count of a piece")
def _(ref, cand, _bench):
	"""All sums behind it are wrong, and one count."""
	sums = cand["points.offset"].words()
	piece = len(sums) // 2
	put_words(cand, "points.offset", sums[:piece + 1] + [total + 2 for total in sums[piece + 1:]])
	return Planted("points.offset", f"count of piece {piece} (element {piece + 1} less element {piece})", None, 1)


@mutant("sums that include their own counts")
def _(ref, cand, _bench):
	sums = cand["points.offset"].words()
	put_words(cand, "points.offset", sums[1:] + sums[-1:])
	planted = first(ref, cand, "points.offset")
	return Planted("points.offset", "element 0, where the sums begin", None, planted.n)


@mutant("point twice", arrival=True)
def _(ref, cand, _bench):
	n = ref["points.key"].n
	reorder(cand, shuffled(n, 1) + [n // 2])
	return Planted("points.key", ref.where("points.key", n // 2), None, 1)


@mutant("point twice, in order")
def _(ref, cand, _bench):
	n = ref["points.key"].n
	reorder(cand, list(range(n // 2 + 1)) + list(range(n // 2, n)))
	return Planted("points.key", ref.where("points.key", n // 2 + 1), None, n - n // 2)


@mutant("records swapped, references not", arrival=True)
def _(ref, cand, _bench):
	"""Both are the only ones of their depth in some texel."""
	keys = ref["splat.depth_index"].words()
	texels = texels_where(ref, 0)
	a, b = keys[texels[len(texels) // 3]] & NONE, keys[texels[len(texels) // 2]] & NONE
	order = list(range(ref["points.key"].n))
	order[a], order[b] = b, a
	reorder(cand, order, remapped=False)
	texels = [i for i, key in enumerate(keys) if key != EMPTY and key & NONE in (a, b)]
	return Planted("splat.depth_index", ref.texel(texels[0]), None, len(texels))


@mutant("records swapped, in order")
def _(ref, cand, _bench):
	n = ref["points.key"].n
	order = list(range(n))
	order[n // 4], order[n // 4 + 1] = n // 4 + 1, n // 4
	reorder(cand, order)
	return Planted("points.key", ref.where("points.key", n // 4), None, 2)


@mutant("shuffled and called canonical")
def _(ref, cand, _bench):
	reorder(cand, shuffled(ref["points.key"].n, 1))
	return first(ref, cand, "points.key")


@mutant("record under another's key", arrival=True)
def _(ref, cand, _bench):
	"""Keys and records were appended by two counters."""
	n = ref["points.key"].n
	records = cand["points.record"]
	a, b = records.element(n // 5), records.element(n // 5 + 1)
	records.put(n // 5, b)
	records.put(n // 5 + 1, a)
	cand.put("points.record", records)
	planted = first(ref, cand, "points.record")
	reorder(cand, shuffled(n, 2))
	return planted


@mutant("depths of the frame before")
def _(ref, cand, bench):
	cand.put("eye.depth_triangle", bench["before"]["eye.depth_triangle"])
	return first(ref, cand, "eye.depth_triangle")


@mutant("cubes of the frame before")
def _(ref, cand, bench):
	cand.put("splat.depth_index", bench["before"]["splat.depth_index"])
	return first(ref, cand, "splat.depth_index")


@mutant("24 bits of depth kept")
def _(ref, cand, _bench):
	cubes = cand["splat.depth_index"]
	cubes.set_words([w if w == EMPTY else w & 0xffffff00ffffffff for w in cubes.words()])
	cand.put("splat.depth_index", cubes)
	return first(ref, cand, "splat.depth_index")


def put_float(candidate, name, element, field, component, bits):
	buffer = candidate[name]
	put_field(buffer, element, field, component, bits)
	candidate.put(name, buffer)


@mutant("-0 for 0")
def _(ref, cand, _bench):
	frames = ref["align.frame"]
	piece, k = next((i, k) for i in range(frames.n // 2, frames.n) for k in range(3) if frames.get(i, "u")[k] == 0)
	put_float(cand, "align.frame", piece, "u", k, 0x80000000)
	return Planted("align.frame", f"piece {piece}", f"u[{k}]", 1)


@mutant("-0 for 0 in a point", arrival=True)
def _(ref, cand, _bench):
	"""In any order, the key must lead to it."""
	points = ref["points.record"]
	point, k = next((i, k) for i in range(points.n // 3, points.n) for k in range(3) if points.get(i, "centre")[k] == 0)
	put_float(cand, "points.record", point, "centre", k, 0x80000000)
	reorder(cand, shuffled(points.n, 3))
	return Planted("points.record", ref.where("points.record", point), f"centre[{k}]", 1)


@mutant("one NaN")
def _(ref, cand, _bench):
	at = ref["shade.radiance"].n // 2
	edit(cand, "shade.radiance", at, lambda _: float("nan"))
	return Planted("shade.radiance", ref.where("shade.radiance", at), None, 1)


@mutant("one ulp")
def _(ref, cand, _bench):
	frames = ref["align.frame"]
	bits, = struct.unpack("<I", struct.pack("<f", frames.get(7, "c")[1]))
	put_float(cand, "align.frame", 7, "c", 1, bits + 1)
	return Planted("align.frame", "piece 7", "c[1]", 1)


@mutant("image transposed")
def _(ref, cand, _bench):
	image = cand["image.radiance"]
	height, width, _ = image.shape
	pixels = [image.data[i * 12:i * 12 + 12] for i in range(height * width)]
	image.data = bytearray(b"".join(pixels[y * width + x] for x in range(width) for y in range(height)))
	cand.put("image.radiance", image)
	return first(ref, cand, "image.radiance")


@mutant("image transposed, and its shape")
def _(ref, cand, _bench):
	image = cand["image.radiance"]
	height, width, _ = image.shape
	image.shape = (width, height, 3)
	cand.put("image.radiance", image)
	return Planted(refused=f"radiance.npy: shape {width} x {height} x 3; the reference's is {height} x {width} x 3")


@mutant("cube face transposed")
def _(ref, cand, _bench):
	n, = ref["cube_size.face"].get(1, "n")
	at, = ref["cube_size.face"].get(1, "offset")
	at += 4 * n * n
	cubes = cand["splat.depth_index"]
	words = cubes.words()
	words[at:at + n * n] = [words[at + x * n + y] for y in range(n) for x in range(n)]
	cubes.set_words(words)
	cand.put("splat.depth_index", cubes)
	planted = first(ref, cand, "splat.depth_index")
	assert planted.where.startswith("reflector 1, face +Z,"), planted.where
	return planted


@mutant("cube faces swapped")
def _(ref, cand, _bench):
	n, = ref["cube_size.face"].get(2, "n")
	at, = ref["cube_size.face"].get(2, "offset")
	at += 2 * n * n
	cubes = cand["splat.depth_index"]
	words = cubes.words()
	words[at:at + 2 * n * n] = words[at + n * n:at + 2 * n * n] + words[at:at + n * n]
	cubes.set_words(words)
	cand.put("splat.depth_index", cubes)
	planted = first(ref, cand, "splat.depth_index")
	assert planted.where.startswith("reflector 2, face +Y,"), planted.where
	return planted


@mutant("srgb applied twice")
def _(ref, cand, _bench):
	def encode(byte):
		x = byte / 255
		return round(255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055))
	image = cand["image.srgb"]
	image.set_words([encode(byte) for byte in image.words()])
	cand.put("image.srgb", image)
	return first(ref, cand, "image.srgb")


@mutant("last reflective pixel missing")
def _(ref, cand, _bench):
	pixels = cand["mirror_pixel.record"]
	pixels.set_elements(pixels.elements()[:-1])
	cand.put("mirror_pixel.record", pixels)
	return Planted("mirror_pixel.record", f"{ref['mirror_pixel.record'].n} elements, candidate {pixels.n}", None, None)


@mutant("look-up of the next point")
def _(ref, cand, _bench):
	found = ref["lookup.point"].words()
	at = next(i for i in range(len(found) // 2, len(found)) if found[i] != NONE)
	edit(cand, "lookup.point", at, lambda point: point + 1)
	return Planted("lookup.point", ref.where("lookup.point", at), None, 1)


@mutant("another point, where none ties", arrival=True)
def _(ref, cand, _bench):
	texel = texels_where(ref, 0)[100]
	edit(cand, "splat.depth_index", texel, lambda key: key ^ 1)
	return Planted("splat.depth_index", ref.texel(texel), None, 1)


@mutant("point that does not tie", of="twice", arrival=True)
def _(ref, cand, _bench):
	"""Where two points of equal distance may win, a third must not."""
	texel = texels_where(ref, 1)[50]
	pieces, points = ref["split.piece"], ref["points.record"]
	def place(point):
		piece, = points.get(point, "piece")
		return [pieces.get(piece, corner) for corner in "abc"]
	here = place(ref["splat.depth_index"].words()[texel] & NONE)
	other = next(i for i in range(points.n) if place(i) != here)
	edit(cand, "splat.depth_index", texel, lambda key: key & ~NONE | other)
	return Planted("splat.depth_index", ref.texel(texel), None, 1)


@mutant("tied texel of another depth", of="twice", arrival=True)
def _(ref, cand, _bench):
	texel = texels_where(ref, 1)[60]
	edit(cand, "splat.depth_index", texel, lambda key: key + (1 << 32))
	return Planted("splat.depth_index", ref.texel(texel), None, 1)


@mutant("file cut short")
def _(ref, cand, _bench):
	faces = cand["cube_size.face"]
	faces.data = faces.data[:-8]
	cand.put("cube_size.face", faces)
	return Planted(refused="cube_size.face.npy: ")


@mutant("pieces swapped", of="soft")
def _(ref, cand, _bench):
	pieces = cand["split.piece"]
	a, b = pieces.element(pieces.n // 2), pieces.element(pieces.n // 2 + 1)
	pieces.put(pieces.n // 2, b)
	pieces.put(pieces.n // 2 + 1, a)
	cand.put("split.piece", pieces)
	planted = first(ref, cand, "split.piece")
	assert planted.n == 2, planted.n
	return planted


@mutant("piece dropped", of="soft")
def _(ref, cand, _bench):
	pieces = cand["split.piece"]
	pieces.set_elements(pieces.elements()[:-1])
	cand.put("split.piece", pieces)
	return Planted("split.piece", f"{ref['split.piece'].n} elements, candidate {pieces.n}", None, None)


@mutant("-0 for the density of the unseen", of="soft")
def _(ref, cand, _bench):
	at = ref["split.triangle_density"].words().index(0)
	edit(cand, "split.triangle_density", at, lambda _: -0.0)
	return Planted("split.triangle_density", ref.where("split.triangle_density", at), None, 1)


@mutant("NaN in a depth map", of="soft")
def _(ref, cand, _bench):
	at = ref["depth_map.depth"].n // 2
	edit(cand, "depth_map.depth", at, lambda _: 0x7fc00000)
	return Planted("depth_map.depth", ref.texel(at), None, 1)


@mutant("depth map from below", of="soft")
def _(ref, cand, _bench):
	n, = ref["offscreen.view"].get(3, "width")
	at, = ref["offscreen.view"].get(3, "offset")
	depths = ref["depth_map.depth"].words()
	rows = [depths[at + y * n:at + (y + 1) * n] for y in range(n)]
	depths[at:at + n * n] = sum(reversed(rows), [])
	put_words(cand, "depth_map.depth", depths)
	planted = first(ref, cand, "depth_map.depth")
	assert planted.where.startswith("view 3,"), planted.where
	return planted


@mutant("batches of depth maps swapped", of="soft")
def _(ref, cand, _bench):
	at, = ref["offscreen.view"].get(2, "offset")
	depths = ref["depth_map.depth"].words()
	put_words(cand, "depth_map.depth", depths[at:2 * at] + depths[:at] + depths[2 * at:])
	planted = first(ref, cand, "depth_map.depth")
	assert planted.where.startswith("view 0,"), planted.where
	return planted


@mutant("cubes of light samples swapped", of="splats")
def _(ref, cand, _bench):
	at, = ref["cube_size.face"].get(1, "offset")
	depths = ref["depth_map.depth"].words()
	put_words(cand, "depth_map.depth", depths[at:] + depths[:at])
	planted = first(ref, cand, "depth_map.depth")
	assert planted.where.startswith("sample 0,"), planted.where
	return planted


@mutant("lit transposed", of="soft")
def _(ref, cand, _bench):
	height, width, _ = ref["shadow_test.lit"].shape
	lit = ref["shadow_test.lit"].words()
	put_words(cand, "shadow_test.lit", [lit[y * width + x] for x in range(width) for y in range(height)])
	return first(ref, cand, "shadow_test.lit")


@mutant("samples in shadow for the lit", of="soft")
def _(ref, cand, _bench):
	samples, = ref["lamp.shape"].get(0, "samples")
	put_words(cand, "shadow_test.lit", [samples - lit for lit in ref["shadow_test.lit"].words()])
	return first(ref, cand, "shadow_test.lit")


@mutant("boxes swapped", of="hulls")
def _(ref, cand, _bench):
	boxes = cand["segment.box"]
	at = boxes.n // 2
	a, b = boxes.element(at), boxes.element(at + 1)
	boxes.put(at, b)
	boxes.put(at + 1, a)
	cand.put("segment.box", boxes)
	planted = first(ref, cand, "segment.box")
	assert planted.n == 2, planted.n
	return planted


@mutant("box dropped", of="hulls")
def _(ref, cand, _bench):
	boxes = cand["segment.box"]
	boxes.set_elements(boxes.elements()[:-1])
	cand.put("segment.box", boxes)
	return Planted("segment.box", f"{ref['segment.box'].n} elements, candidate {boxes.n}", None, None)


@mutant("corners swapped", of="hulls")
def _(ref, cand, _bench):
	"""Top right and bottom left of one box whose corners see other light."""
	moments = cand["corner.moment"]
	at = next(i for i in range(moments.n // 8 * 4, moments.n, 4) if moments.element(i + 1) != moments.element(i + 2))
	a, b = moments.element(at + 1), moments.element(at + 2)
	moments.put(at + 1, b)
	moments.put(at + 2, a)
	cand.put("corner.moment", moments)
	return Planted("corner.moment", ref.where("corner.moment", at + 1), None, 2)


@mutant("NaN in a lobe", of="hulls")
def _(ref, cand, _bench):
	at = ref["corner.lobes"].n // 3
	put_float(cand, "corner.lobes", at, "lambda", 1, 0x7fc00000)
	return Planted("corner.lobes", ref.where("corner.lobes", at), "lambda[1]", 1)


@mutant("box for none", of="hulls")
def _(ref, cand, _bench):
	"""The sky's pixels have box 0, not none."""
	put_words(cand, "hull.box", [0 if box == NONE else box for box in ref["hull.box"].words()])
	return first(ref, cand, "hull.box")


@mutant("irradiance transposed", of="hulls")
def _(ref, cand, _bench):
	irradiance = cand["indirect.irradiance"]
	height, width, _ = irradiance.shape
	pixels = [irradiance.data[i * 12:i * 12 + 12] for i in range(height * width)]
	irradiance.data = bytearray(b"".join(pixels[y * width + x] for x in range(width) for y in range(height)))
	cand.put("indirect.irradiance", irradiance)
	return first(ref, cand, "indirect.irradiance")


@mutant("-0 for no irradiance", of="hulls")
def _(ref, cand, _bench):
	at = ref["indirect.irradiance"].words().index(0)
	edit(cand, "indirect.irradiance", at, lambda _: -0.0)
	return Planted("indirect.irradiance", ref.where("indirect.irradiance", at), None, 1)


@mutant("fragment of a surfel not counted", of="surfels")
def _(ref, cand, _bench):
	sums = ref["surfel_blend.sum"].words()
	at = next(i for i in range(7, len(sums), 8) if sums[i] > 3)
	edit(cand, "surfel_blend.sum", at, lambda n: n - 1)
	return Planted("surfel_blend.sum", ref.where("surfel_blend.sum", at), None, 1)


@mutant("another surfel of the same depth", of="surfels")
def _(ref, cand, _bench):
	keys = ref["surfel_depth.surfel"].words()
	at = next(i for i, key in enumerate(keys) if key != EMPTY)
	edit(cand, "surfel_depth.surfel", at, lambda key: key ^ 1)
	return Planted("surfel_depth.surfel", ref.where("surfel_depth.surfel", at), None, 1)


@mutant("box of a surfel by a pixel less", of="surfels")
def _(ref, cand, _bench):
	discs = cand["surfel_setup.disc"]
	at = next(i for i in range(discs.n) if discs.get(i, "high")[1] > discs.get(i, "low")[1])
	put_field(discs, at, "high", 1, discs.get(at, "high")[1] - 1)
	cand.put("surfel_setup.disc", discs)
	return Planted("surfel_setup.disc", ref.where("surfel_setup.disc", at), "high[1]", 1)


@mutant("-0 for 0 in a normal of a surfel", of="surfels")
def _(ref, cand, _bench):
	pixels = cand["gbuffer.pixel"]
	at = next(i for i in range(pixels.n) if pixels.get(i, "depth")[0] < 1 and 0 in pixels.get(i, "normal"))
	component = pixels.get(at, "normal").index(0)
	put_field(pixels, at, "normal", component, 0x80000000)
	cand.put("gbuffer.pixel", pixels)
	return Planted("gbuffer.pixel", ref.where("gbuffer.pixel", at), f"normal[{component}]", 1)
