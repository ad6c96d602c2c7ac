"""Stage splat: every point as a square into every face whose bit its triangle has; the least distance wins a texel.

in: resize.face, split.triangle, align.frame, visibility.bits, points.record   out: splat.depth_index"""
import numpy

import raster
from contract import f32, floor, i64, key, length, u32, u64
from cube import face_bits, to_view

TINY = 1
EMPTY = u64(0xffffffffffffffff)
HALF_SIZE = 129  # of a texel, in 1/256: no texel of the unsnapped triangle is missed


def squares(points, frames, eye, face):
	"""Corners of the squares in the face's view, as polygons."""
	half = points["length"] * f32(0.5)
	du, dv = frames["u"] * half[:, None], frames["v"] * half[:, None]
	centre = points["centre"]
	corner = [(centre - du) - dv, (centre + du) - dv, (centre + du) + dv, (centre - du) + dv]
	return raster.polygons([to_view(face, p - eye) for p in corner])


def square_boxes(points, frames, cube, face, shift):
	"""Texels from the floor of the least to the floor of the greatest coordinate, within the face."""
	polygons = squares(points, frames, cube["centre"], face)
	raster.clip(polygons, (0, 0, 1, -cube["near"]))
	x, y = raster.project(polygons, cube["n"])
	real = numpy.arange(raster.MOST) < polygons.n[:, None]
	lo = [floor(numpy.where(real, p + shift, f32(numpy.inf)).min(1)) for p in (x, y)]
	hi = [floor(numpy.where(real, p + shift, f32(-numpy.inf)).max(1)) for p in (x, y)]
	last = i64(cube["n"]) - 1
	boxes = raster.meet(numpy.stack(lo + hi, 1), numpy.array([0, 0, last, last]))
	boxes[polygons.n == 0] = (0, 0, -1, -1)
	return boxes


def texels_of(boxes):
	"""Every texel of every box: which box, column, row."""
	wide = numpy.maximum(boxes[:, 2] - boxes[:, 0] + 1, 0)
	high = numpy.maximum(boxes[:, 3] - boxes[:, 1] + 1, 0)
	count = wide * high
	which = numpy.repeat(numpy.arange(len(boxes)), count)
	local = numpy.arange(len(which)) - numpy.repeat(numpy.cumsum(count) - count, count)
	return which, boxes[which, 0] + local % wide[which], boxes[which, 1] + local // wide[which]


def into_face(texels, trace, cube, face, pieces, ids, broken):
	"""The points `ids`, of pieces which are seen, into one face's n * n texels."""
	points = trace["points.record"][ids]
	source = trace["split.triangle"][pieces]
	cover = raster.cover(source, cube, face, HALF_SIZE)
	place = numpy.searchsorted(pieces, points["piece"])
	seen = cover.n[place] != 0
	points, ids, place = points[seen], ids[seen], place[seen]
	shift = f32(0.5) if broken == 3 else f32(0)
	boxes = square_boxes(points, trace["align.frame"][points["piece"]], cube, face, shift)
	clip = trace.params.get("clip", "on") == "on"
	cut = numpy.full(len(points), True) if clip else (points["flags"] & u32(TINY)) != 0
	boxes[cut] = raster.meet(boxes[cut], cover.box[place[cut]])
	which, i, j = texels_of(boxes)
	if clip and broken != 4:
		inside = cover.touches(place[which], i, j)
		which, i, j = which[inside], i[inside], j[inside]
	offset = points["centre"] - cube["centre"]
	distance = to_view(face, offset)[:, 2].copy() if broken == 5 else length(offset)
	numpy.minimum.at(texels, j * i64(cube["n"]) + i, key(distance, ids)[which])


def run(trace, broken=0):
	if trace.params.get("planedepth", "off") != "off":
		raise SystemExit("this port has no planedepth")
	cubes, words = trace["resize.face"], trace["visibility.bits"]
	n_texels = sum(6 * int(n) * int(n) for n in cubes["n"])
	texels = numpy.full(n_texels, EMPTY, u64)
	piece = trace["points.record"]["piece"]
	for r, cube in enumerate(cubes):
		seen = face_bits(words, r)[trace["split.triangle"]["triangle"]]
		for face in range(6):
			ids = numpy.flatnonzero(seen[piece, face])
			pieces = numpy.unique(piece[ids])
			if len(ids) == 0 or cube["n"] == 0:
				continue
			first = int(cube["offset"]) + face * int(cube["n"]) ** 2
			into_face(texels[first:first + int(cube["n"]) ** 2], trace, cube, face, pieces, ids, broken)
	return {"splat.depth_index": texels}
