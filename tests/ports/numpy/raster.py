"""Polygons in a face's view: clip, project, snap to 24.8 fixed point, cover conservatively. Whole arrays at a time:
row m of every array is polygon m, of n[m] corners; what lies behind them in the row is of no meaning."""
import numpy

from contract import f32, fix, flush, i64
from cube import to_view

MOST = 8  # corners: three, and one more for each of five planes
RANGE = 32767  # pixels that can be snapped


class Polygons:
	def __init__(self, corner, n):
		self.corner, self.n = corner, n


def polygons(corners):
	corner = numpy.zeros((len(corners[0]), MOST, 3), f32)
	for k, p in enumerate(corners):
		corner[:, k] = p
	return Polygons(corner, numpy.full(len(corner), len(corners)))


def plane_side(plane, p):
	x, y, z, d = (f32(v) for v in plane)
	return flush(((x * p[..., 0] + y * p[..., 1]) + z * p[..., 2]) + d)


def push(out, chosen, corner):
	chosen = chosen & (out.n < MOST)
	out.corner[chosen, out.n[chosen]] = corner[chosen]
	out.n[chosen] += 1


def cut(inner, d_inner, outer, d_outer):
	"""Rule 16: from the inside to the outside corner."""
	with numpy.errstate(all="ignore"):
		t = d_inner / (d_inner - d_outer)
		return inner + (outer - inner) * t[:, None]


def clip(polygon, plane):
	"""Sutherland and Hodgman against x X + y Y + z Z + d >= 0, the polygons that need it."""
	real = numpy.arange(MOST) < polygon.n[:, None]
	rows = numpy.flatnonzero(((plane_side(plane, polygon.corner) < 0) & real).any(1))
	if len(rows) == 0:
		return
	corner, n = polygon.corner[rows], polygon.n[rows]
	out = Polygons(numpy.zeros_like(corner), numpy.zeros_like(n))
	for k in range(MOST):
		p, q = corner[:, k], corner[numpy.arange(len(rows)), numpy.where(k + 1 < n, (k + 1) % MOST, 0)]
		dp, dq = plane_side(plane, p), plane_side(plane, q)
		push(out, (k < n) & (dp >= 0), p)
		push(out, (k < n) & (dp >= 0) & (dq < 0), cut(p, dp, q, dq))
		push(out, (k < n) & (dp < 0) & (dq >= 0), cut(q, dq, p, dp))
	polygon.corner[rows], polygon.n[rows] = out.corner, out.n


def project(polygon, size):
	"""x = n/2 + f X / z, y = n/2 - f Y / z, with f = n/2."""
	half = f32(size) * f32(0.5)
	with numpy.errstate(all="ignore"):
		x = (half * polygon.corner[..., 0]) / polygon.corner[..., 2]
		y = (half * polygon.corner[..., 1]) / polygon.corner[..., 2]
		return half + x, half - y


def meet(a, b):
	return numpy.concatenate([numpy.maximum(a[..., :2], b[..., :2]), numpy.minimum(a[..., 2:], b[..., 2:])], -1)


class Cover:
	"""Snapped convex polygons for the conservative test (rule 19): the pixel's square, of half size h / 256, meets each
	edge's inner side and the polygon's box."""

	def __init__(self, x, y, n, half_size):
		self.x, self.y, self.n, self.half_size = x, y, n, half_size
		real = numpy.arange(MOST) < n[:, None]
		lo = [numpy.where(real, v, 2 ** 30).min(1) - half_size for v in (x, y)]
		hi = [numpy.where(real, v, -2 ** 30).max(1) + half_size for v in (x, y)]
		self.box = numpy.stack([-((128 - v) // 256) for v in lo] + [(v - 128) // 256 for v in hi], 1)
		area = numpy.zeros(len(n), i64)
		for k in range(2, MOST):
			e = self.edge(slice(None), 0, k - 1, x[:, k], y[:, k])
			area += numpy.where(k < n, e, 0)
		self.turned = area < 0

	def edge(self, rows, a, b, x, y):
		ax, ay, bx, by = self.x[rows, a], self.y[rows, a], self.x[rows, b], self.y[rows, b]
		return (bx - ax) * (y - ay) - (by - ay) * (x - ax)

	def touches(self, rows, i, j):
		x, y, n = i * 256 + 128, j * 256 + 128, self.n[rows]
		inside = numpy.full(len(rows), True)
		for k in range(MOST):
			b = numpy.where(k + 1 < n, (k + 1) % MOST, 0)
			e = self.edge(rows, k, b, x, y)
			reach = abs(self.x[rows, b] - self.x[rows, k]) + abs(self.y[rows, b] - self.y[rows, k])
			inside &= (k >= n) | (numpy.where(self.turned[rows], -e, e) + self.half_size * reach >= 0)
		return inside


def cover(source, cube, face, half_size):
	"""Pieces as a face sees them: near plane, then -x +x -y +y at the end of the range that can be snapped."""
	polygon = polygons([to_view(face, source[k] - cube["centre"]) for k in "abc"])
	focal = f32(cube["n"]) * f32(0.5)
	ends = f32(RANGE) - focal
	clip(polygon, (0, 0, 1, -cube["near"]))
	for plane in ((focal, 0, ends, 0), (-focal, 0, ends, 0), (0, focal, ends, 0), (0, -focal, ends, 0)):
		clip(polygon, plane)
	x, y = project(polygon, cube["n"])
	return Cover(fix(x, 8, 23), fix(y, 8, 23), polygon.n, half_size)
