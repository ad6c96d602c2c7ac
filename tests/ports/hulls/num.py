"""Primitives of CONTRACT.md in numpy: rules 4 to 14, 34 (vectors), 9 (atan2, exp), 41 and 42 (lobes, Omega)."""
import numpy as np

F = np.float32
TWO_100 = F(2.0 ** -100)


def h(text):
	"""The binary32 of a hexadecimal literal (rule 7)."""
	return F(float.fromhex(text))


PI2, PI4 = h('0x1.921fb6p+2'), h('0x1.921fb6p+3')


def flush(x):
	"""Rule 11."""
	return np.where(np.abs(x) < TWO_100, F(0), x)


def least(a, b):
	"""Rule 14: ts_min."""
	return np.where(b < a, b, a)


def most(a, b):
	"""Rule 14: ts_max."""
	return np.where(a < b, b, a)


def dot(a, b):
	"""Rule 34."""
	return (a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1]) + a[..., 2] * b[..., 2]


def cross(a, b):
	"""Rule 34: each component a difference of two rounded products."""
	ax, ay, az, bx, by, bz = *np.moveaxis(a, -1, 0), *np.moveaxis(b, -1, 0)
	return np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], -1)


def length(a):
	"""Rule 34."""
	return np.sqrt(flush(dot(a, a)))


def divided(a, n):
	"""a / n, a length of 0 divides by 1 (rule 34)."""
	return a / np.where(n == 0, F(1), n)[..., None]


def normalize(a):
	"""Rule 34."""
	return divided(a, length(a))


def horner(x, coefficients):
	"""Horner's rule, the highest first (rule 6)."""
	p = F(coefficients[0])
	for c in coefficients[1:]:
		p = p * x + c
	return p


ATAN = [h(t) for t in ('0x1.7ec1c4p-9', '-0x1.0c23fep-6', '0x1.61f756p-5', '-0x1.3553f4p-4', '0x1.b4dfdcp-4',
	'-0x1.230ab0p-3', '0x1.9978eep-3', '-0x1.5554dcp-2')]


def atan2(y, x):
	"""Rule 9: ts_atan2."""
	ay, ax = np.abs(y), np.abs(x)
	greater, lesser = np.where(ay > ax, ay, ax), np.where(ay > ax, ax, ay)
	a = flush(lesser / np.where(greater == 0, F(1), greater))
	z = a * a
	r = horner(z, ATAN) * (a * z) + a
	r = np.where(ay > ax, h('0x1.921fb6p+0') - r, r)
	r = np.where(x < 0, h('0x1.921fb6p+1') - r, r)
	return np.where(y < 0, -r, r)


EXP = [h(t) for t in ('0x1.9a9442p-13', '0x1.6d5156p-10', '0x1.1115b6p-7', '0x1.5554e4p-5', '0x1.555552p-3', '0x1p-1')]


def exp(x):
	"""Rule 9: ts_exp."""
	low, high = h('-0x1.5d589ep+6'), h('0x1.62e42ep+6')
	top = np.where(x < high, x, high)
	m = np.where(top > low, top, low)
	g = m * h('0x1.715476p+0') + h('0x1.8p+23')
	n = g.view(np.uint32) - np.uint32(0x4b400000)
	w = g - h('0x1.8p+23')
	r = (m - w * h('0x1.63p-1')) - w * h('-0x1.bd0106p-13')
	p = (horner(r, EXP) * (r * r) + r) + F(1)
	bits = p.view(np.uint32) + (n << np.uint32(23))
	return np.where(top >= low, bits.view(F), F(0))


def solid_angle(p, a, b, c):
	"""Rule 42: ts_k_solid_angle, and the unit vectors to the corners."""
	to = [a - p, b - p, c - p]
	lengths = [length(t) for t in to]
	u = [divided(t, n) for t, n in zip(to, lengths)]
	volume = np.abs(dot(u[0], cross(b - a, c - a)))
	over = lengths[1] * lengths[2]
	y = np.where(over == 0, F(0), volume / np.where(over == 0, F(1), over))
	x = ((F(1) + dot(u[0], u[1])) + dot(u[1], u[2])) + dot(u[2], u[0])
	return F(2) * atan2(y, x), u


SERIES = [F((-1) ** j / np.prod(np.arange(1.0, j + 2))) for j in range(7, -1, -1)]


def sg_integral(sharpness):
	"""Rule 41: A, ts_k_sg_integral."""
	x = F(2) * sharpness
	safe = np.where(x < F(0.5), F(1), x)
	return np.where(x < F(0.5), PI4 * horner(x, SERIES), PI4 * ((F(1) - exp(-x)) / safe))


LANGEVIN = [F(-1 / 4725), F(2 / 945), F(-1 / 45), F(1 / 3)]


def langevin(k):
	"""coth k - 1/k, a series below one half."""
	e = exp(F(-2) * k)
	closed = (F(1) + e) / (F(1) - e) - F(1) / k
	return np.where(k < F(0.5), k * horner(k * k, LANGEVIN), closed)


def sg_sharpness(r, vmf):
	"""ts_k_sg_sharpness (METHODS 11, corner.lobes); vmf, found by trial: three steps of Newton for langevin(k) = r."""
	r = least(r, F(1) - F(1e-5))
	k = (r * (F(3) - r * r)) / (F(1) - r * r)
	for _ in range(3):
		mean = langevin(k)
		k = k - (mean - r) / ((F(1) - mean * mean) - F(2) * mean / k)
	k = np.where(r > F(0.9), F(1) / (F(1) - r), np.where(r > 0, k, F(0)))
	return np.where(vmf, k, r / (F(1) - r))


def fit(m, direction, vmf):
	"""METHODS 11, corner.lobes: ts_k_fit, the lobe (mu, lambda, phi) of weights whose sum is m."""
	mean = direction / np.where(m == 0, F(1), m)[..., None]
	r = length(mean)
	sharpness = sg_sharpness(r, vmf)
	mu = m / sg_integral(sharpness)
	phi = np.where((r < F(1e-6))[..., None], F(0), divided(mean, r))
	none = m == 0
	return (np.where(none, F(0), mu), np.where(none, F(1), sharpness), np.where(none[..., None], F(0), phi))


def gather(patch, p, ramp):
	"""METHODS 11, corner: ts_k_gather, weights (..., 3) and directions (..., 3 channels, 3) of triangles of light."""
	a, b, c = patch['a'], patch['b'], patch['c']
	side = length(b - a)
	height = dot(patch['normal'], p - a)
	safe = np.where(side == 0, F(1), side)
	slope = least((height - safe * F(1 / 16)) / (safe * F(0.25)), F(1))
	facing = np.where(ramp, slope, np.where(height > 0, F(1), F(0)))
	omega, u = solid_angle(p, a, b, c)
	w = patch['exitance'] * (omega * facing)[..., None]
	w = np.where((facing > 0)[..., None], w, F(0))
	return w, ((u[0] + u[1]) + u[2])[..., None, :] * (w / F(3))[..., :, None]


def light(it, p):
	"""METHODS 4, Lights: ts_k_light, the way to the light and what arrives of its intensity."""
	far = it['position'] - p
	d2 = flush(dot(far, far))
	l = np.where((it['kind'] == 0)[..., None], F(0) - it['direction'], divided(far, np.sqrt(d2)))
	range2 = it['range'] * it['range']
	ratio = flush(d2 / np.where(range2 == 0, F(1), range2))
	window = least(most(F(1) - ratio * ratio, F(0)), F(1))
	arrives = np.where(d2 == 0, F(0), F(1) / np.where(d2 == 0, F(1), d2))
	arrives = np.where(it['range'] > 0, arrives * window, arrives)
	ramp = least(most(dot(it['direction'], F(0) - l) * it['spot_scale'] + it['spot_offset'], F(0)), F(1))
	arrives = np.where(it['kind'] == 2, arrives * (ramp * ramp), arrives)
	return l, np.where(it['kind'] == 0, F(1), arrives)
