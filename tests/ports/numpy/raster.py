"""Clipping and conservative coverage: rules 15 to 17 and 19 of CONTRACT.md, on arrays of convex polygons (n, m, 3).

A polygon of fewer than m corners repeats its first one: an edge without length adds no area and excludes no texel.
A polygon without area keeps its edges, which leave the texels about a segment.
"""
import numpy as np

from contract import components, fix, flush

RANGE = 32767
MOST = 8
REACH = 129


def project(p, middle, focal):
	"""Rule 15: view space to pixels."""
	with np.errstate(all='ignore'):
		return middle + focal * p[..., :2] * np.float32([1, -1]) / p[..., 2:]


def plane_side(p, plane):
	"""Rule 16."""
	x, y, z = components(p * plane[:3])
	return flush(((x + y) + z) + plane[3])


def clip(polygons, planes):
	"""Rule 16: the clipped polygons, and of which of them something is left."""
	left = np.ones(len(polygons), bool)
	for plane in planes:
		side = plane_side(polygons, plane)
		left &= (side >= 0).any(1)
		behind = (side < 0).any(1)
		if behind.any():
			part = clip_plane(polygons[behind], side[behind])
			part[..., 2] = np.maximum(part[..., 2], -planes[0][3])
			polygons = widened(polygons, part.shape[1])
			polygons[behind] = widened(part, polygons.shape[1])
	return polygons, left


def widened(polygons, width):
	more = max(width - polygons.shape[1], 0)
	return np.concatenate((polygons, np.repeat(polygons[:, :1], more, 1)), 1)


def clip_plane(polygons, side):
	"""Sutherland and Hodgman: each corner that is inside, and behind it the cut of its edge."""
	inside = side >= 0
	crosses = inside != np.roll(inside, -1, 1)
	slots = np.stack((polygons, cuts(polygons, side, crosses)), 2).reshape(len(side), -1, 3)
	empty = ~np.stack((inside, crosses), 2).reshape(len(side), -1)
	width = max(1, min(MOST, np.max(np.sum(~empty, 1))))
	taken = np.argsort(empty, 1, 'stable')[:, :width]
	taken = np.where(np.take_along_axis(empty, taken, 1), taken[:, :1], taken)
	return np.take_along_axis(slots, taken[..., None], 1)


def cuts(polygons, side, crosses):
	"""Rule 16: from the inside corner of each edge to the outside one."""
	here = np.concatenate((polygons, side[..., None]), 2)
	there = np.roll(here, -1, 1)
	inside = side[..., None] >= 0
	start, end = np.where(inside, here, there), np.where(inside, there, here)
	d_in, d_out = start[..., 3:], end[..., 3:]
	t = np.divide(d_in, d_in - d_out, out=np.zeros_like(d_in), where=crosses[..., None])
	return (start + (end - start) * t)[..., :3]


class Outlines:
	"""Polygons on the screen, and the texels that they touch (rule 19)."""

	def __init__(self, pixels, broken):
		corners = fix(pixels, 8, 23).astype(np.int64)
		reach = 128 if broken == 13 else REACH
		low, high = corners.min(1) - reach + 127, corners.max(1) + reach - 128
		self.low, self.high = (low & 0xffffffff if broken == 12 else low) >> 8, high >> 8
		(x, y), (dx, dy) = components(corners), components(np.roll(corners, -1, 1) - corners)
		area = (x * dy - y * dx).sum(1, keepdims=True)
		turn = np.sign(area) if broken == 6 else np.where(area < 0, -1, 1)
		a, b = -turn * dy, turn * dx
		self.edges = np.stack((a, b, reach * (abs(dx) + abs(dy)) - a * x - b * y)).transpose(2, 0, 1).copy()

	def meet(self, low, high, which, bounded):
		"""The boxes low to high, where bounded within the box of polygon `which`."""
		bounded = bounded[:, None]
		low = np.where(bounded, np.maximum(low, self.low[which]), low)
		return low, np.where(bounded, np.minimum(high, self.high[which]), high)

	def touches(self, which, column, row):
		"""Whether the edges of polygon `which` leave something of the texel; its box is not asked."""
		x, y = 256 * column + 128, 256 * row + 128
		touched = np.ones(len(which), bool)
		for a, b, c in self.edges:
			touched &= a[which] * x + b[which] * y + c[which] >= 0
		return touched


def spread(low, high):
	"""All texels of the boxes: which box, column, row."""
	width, height = components(np.maximum(high - low + 1, 0))
	count = width * height
	box = np.repeat(np.arange(len(count)), count)
	row, column = np.divmod(np.arange(len(box)) - np.repeat(np.cumsum(count) - count, count), width[box])
	return box, low[box, 0] + column, low[box, 1] + row
