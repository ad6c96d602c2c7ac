"""The arithmetic of CONTRACT.md in numpy's binary32 (rules 4, 5, 6, 11 and 34): one rounding an operation."""

import numpy as np

f32 = np.float32


def flush(x):
	"""Rule 11: |x| < 2^-100 and -0 become +0."""
	return np.where(np.abs(x) < f32(2.0 ** -100), f32(0), x)


def dot(a, b):
	return (a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1]) + a[..., 2] * b[..., 2]


def length(a):
	return np.sqrt(flush(dot(a, a)))


def cross(a, b):
	x, y, z = (a[..., i] for i in range(3))
	u, v, w = (b[..., i] for i in range(3))
	return np.stack([y * w - z * v, z * u - x * w, x * v - y * u], -1)
