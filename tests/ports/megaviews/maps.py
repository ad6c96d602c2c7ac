"""Dual paraboloids and what of one a ball covers: METHODS section 13, "Maps", and `view_map`."""

import numpy as np
from num import f32, flush, length


def texel(d, n):
	"""Place in the map that shows d, and the texel: front then back, row by row; no direction is in the middle."""
	divisor = length(d) + np.abs(d[..., 0])
	u = flush(d[..., 1:] / np.where(divisor > 0, divisor, f32(1))[..., None])
	at = (u * f32(0.5) + f32(0.5)) * n.astype(f32)[..., None]
	column, row = (np.clip(np.floor(at[..., i]).astype(np.int64), 0, n - 1) for i in (0, 1))
	return at, ((d[..., 0] < 0) * n + row) * n + column


def cap(vs, d, radius, back):
	"""A ball at distance d as a circle of the disc of one half: b and c."""
	x = np.where(back, -vs[..., 0], vs[..., 0])
	e = np.sqrt(np.maximum(flush((d - radius) * (d + radius)), f32(0)))
	return x + e, x - e


def image(vs, b, c, u, w):
	return c + ((f32(2) * vs[..., 1] - b * u) * u + (f32(2) * vs[..., 2] - b * w) * w)


def cap_inside(vs, radius, back, n, level, column, row):
	"""Not below 0: all finest texels in a texel of a level are in the image of a ball, by their middles."""
	d = length(vs)
	b, c = cap(vs, d, radius, back)
	b = np.where(level > 0, np.maximum(b, f32(0)), b)
	place = lambda i: (i.astype(f32) + f32(0.5)) / n.astype(f32) * f32(2) - f32(1)
	ends = [[place((i << level) + k * ((1 << level) - 1)) for k in (0, 1)] for i in (column, row)]
	least = np.minimum.reduce([image(vs, b, c, u, w) for w in ends[1] for u in ends[0]])
	return np.where(d <= radius, f32(1), np.where(level > 0, least - f32(2.0 ** -20) * d, least))
