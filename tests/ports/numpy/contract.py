"""The numeric contract in numpy: binary32 throughout, one rounding an operation, sums from left to right.

numpy never fuses a product with a sum: each of its operators is one pass over an array. What has to be avoided is what
leaves binary32 (Python floats that are no float32, numpy.mean, integer arrays that become float64) and what adds in an
order of its own (numpy.dot, numpy.sum, einsum, linalg)."""
import numpy

f32, i32, i64, u32, u64 = numpy.float32, numpy.int32, numpy.int64, numpy.uint32, numpy.uint64


def bits(x):
	return x.view(u32)


def flush(x):
	"""Rule 11: |x| < 2^-100 and -0 become +0. Also what every float passes before it is stored (rule 12)."""
	x = numpy.asarray(x, f32)
	return numpy.where((bits(x) & u32(0x7fffffff)) < u32(0x0d800000), f32(0), x)


def dot(a, b):
	"""Rule 6. Vectors are the last axis."""
	return (a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1]) + a[..., 2] * b[..., 2]


def cross(a, b):
	x = a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1]
	y = a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2]
	z = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
	return numpy.stack([x, y, z], -1)


def length(a):
	return numpy.sqrt(flush(dot(a, a)))


def fix(x, fraction, n_bits):
	"""Rule 15: x * 2^fraction to the nearest integer, ties to even, saturating at +-(2^n_bits - 1). A binary64 holds
	x * 2^fraction exactly, and rint is round half to even."""
	limit = 2.0 ** n_bits - 1
	scaled = numpy.nan_to_num(x.astype(numpy.float64) * 2.0 ** fraction, nan=0.0, posinf=limit, neginf=-limit)
	return numpy.clip(numpy.rint(scaled), -limit, limit).astype(i64)


def floor(x):
	"""Rule 14: the pixel that holds x, saturating at the ends of int32; 0 for NaN."""
	down = numpy.floor(numpy.nan_to_num(x.astype(numpy.float64), nan=0.0))
	return numpy.clip(down, -2.0 ** 31, 2.0 ** 31 - 1).astype(i64)


def key(depth, index):
	"""Rule 24: the bits of a depth >= +0 above, an index below; the least wins."""
	return (bits(depth).astype(u64) << u64(32)) | index.astype(u64)
