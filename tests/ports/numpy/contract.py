"""The arithmetic of CONTRACT.md on arrays of binary32; numpy rounds each operation and fuses none (rules 4 to 6)."""
import numpy as np

EMPTY = np.uint64(2 ** 64 - 1)


def flush(x):
	"""Rule 11."""
	return np.where(np.abs(x) < np.float32(2.0 ** -100), np.float32(0), x)


def put(x):
	"""Rule 12."""
	return flush(np.nan_to_num(x))


def widen(x):
	"""To binary64, in which the steps of `fix` and `floor_i32` are exact; NaN to 0."""
	return np.where(np.isnan(x), np.float32(0), x).astype(np.float64)


def fix(x, frac, bits):
	"""Rule 13."""
	most = np.ldexp(1.0, bits) - 1
	return np.clip(np.rint(np.ldexp(widen(x), frac)), -most, most).astype(np.int32)


def floor_i32(x):
	"""Rule 14."""
	return np.clip(np.floor(widen(x)), -2 ** 31, 2 ** 31 - 1).astype(np.int32)


def components(v):
	return np.moveaxis(v, -1, 0)


def dot(a, b):
	"""Rule 34."""
	x, y, z = components(a * b)
	return (x + y) + z


def cross(a, b):
	"""Rule 34."""
	(ax, ay, az), (bx, by, bz) = components(a), components(b)
	return np.stack((ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx), -1)


def fused(a, b, c):
	"""a·b + c rounded once, as a compiler that contracts gives it: the product is exact in binary64, and the sum is
	rounded there to odd, after which rounding to binary32 is that of the exact sum (Boldo and Melquiond, 2008)."""
	product, c = a.astype(np.float64) * b, c.astype(np.float64)
	total = product + c
	part = total - product
	error = (product - (total - part)) + (c - part)
	between = (error != 0) & (total.view(np.uint64) % np.uint64(2) == 0)
	return np.where(between, np.nextafter(total, np.copysign(np.inf, error)), total).astype(np.float32)


def length(v):
	"""Rule 34."""
	return np.sqrt(flush(dot(v, v)))


def contracted_length(v):
	"""As a compiler that contracts computes it."""
	x, y, z = components(v)
	return np.sqrt(flush(fused(z, z, fused(y, y, x * x))))


def key(depth, index):
	"""Rule 24."""
	return put(depth).view(np.uint32).astype(np.uint64) << np.uint64(32) | index.astype(np.uint64)
