#!/usr/bin/python3
"""Port of touchstone's stages surfel_setup and surfel_depth to numpy, from METHODS section 16 (FIGURES.md 12
for the boxes) and CONTRACT.md rules 4 to 6 (one rounded f32 operation each, left to right), 11, 12, 14, 24, 34.

	port.py TRACE OUT     writes both stages' buffers, made from scene.surfel and eye.view of TRACE, as a candidate
	port.py --vectors IN OUT     writes disc.out.npy, and the primitives that the two stages use
"""
import json
import os
import sys
import numpy as np

f32 = np.float32
MIN, OBJECT, SCREEN, EXACT = range(4)	# field `filter` of the vectors
SIDE, ORTHOGRAPHIC, CROSSES = 1, 2, 4	# ts_disc.flags
DRAWN, AWAY, NEAR, BESIDE = range(4)	# fate
GROW, MORE = f32(1 + 2**-10), f32(1 / 16)
MOST = f32(2**20)


def flush(x):
	"""Rule 11: what is smaller than 2^-100, and -0, become +0."""
	return np.where(np.abs(x) < f32(2.0**-100), f32(0), x)


def dot(a, b):
	"""Rule 34, ts_dot."""
	return (a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1]) + a[..., 2] * b[..., 2]


def cross(a, b):
	"""Rule 34, ts_cross."""
	(ax, ay, az), (bx, by, bz) = np.moveaxis(a, -1, 0), np.moveaxis(b, -1, 0)
	return np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], -1)


def length(a):
	"""Rule 34, ts_length."""
	return np.sqrt(flush(dot(a, a)))


def normalize(a):
	"""Rule 34, ts_normalize: three divisions; zero stays zero."""
	n = length(a)
	return a / np.where(n == 0, f32(1), n)[..., None]


def exact_product(a, b):
	"""Dekker: the rounded product and what rounding lost."""
	def halves(x):
		t = x * f32(4097)
		h = t - (t - x)
		return h, x - h
	p = a * b
	(ah, al), (bh, bl) = halves(a), halves(b)
	return p, (((ah * bh - p) + ah * bl) + al * bh) + al * bl


def in_view(view, p):
	"""Section 1 with y downward: X, Y and the axial depth."""
	return np.stack([dot(view['right'], p), -dot(view['up'], p), -dot(view['back'], p)], -1)


def jacobian(orth, f, p, w):
	"""Pixels by a half-axis w: (f (w_x z - p_x w_z)) / z / z; orthographic f w_x."""
	z = p[:, 2:]
	return np.where(orth, f * w[:, :2], ((f * (w[:, :2] * z - p[:, :2] * w[:, 2:])) / z) / z)


def image_place(orth, f, half, p):
	"""The pixel that p falls into, and how far p is from its middle."""
	z = np.where(orth, f32(1), p[:, 2:])
	pixel = np.floor(half + (f * p[:, :2]) / z)
	a, lost_a = exact_product(np.broadcast_to(f, p[:, :2].shape), p[:, :2])
	b, lost_b = exact_product((pixel + f32(0.5)) - half, z)
	return pixel, ((a - b) + (lost_a - lost_b)) / z


def rays(J_u, J_v, s, t):
	"""A, B, G: rows of the inverse of J, and -(s A + t B), s = u_z/c_z, t = v_z/c_z; and det J."""
	det = J_u[:, 0] * J_v[:, 1] - J_v[:, 0] * J_u[:, 1]
	by = det[:, None]
	A = flush(np.stack([J_v[:, 1], -J_v[:, 0]], -1) / by)
	B = flush(np.stack([-J_u[:, 1], J_u[:, 0]], -1) / by)
	return A, B, flush(-(s[:, None] * A + t[:, None] * B)), det


def extents(J_u, J_v, s, t, r2):
	"""FIGURES 12 about the centre: A = 1 - r2 (s s + t t), and the roots of the ellipse of radius sqrt(r2)."""
	A = (f32(1) - r2 * (s * s + t * t))[:, None]
	r2, s, t = r2[:, None], s[:, None], t[:, None]
	B = -(J_u * s + J_v * t) * r2
	C = (J_u * J_u + J_v * J_v) * r2
	D = np.sqrt(np.maximum(B * B + A * C, f32(0)))
	far = f32(2**26)	# the ellipse comes to the eye's plane: all of the image
	return A[:, 0], np.where(A <= 0, -far, (B - D) / A), np.where(A <= 0, far, (B + D) / A)


def crossing_extents(orth, f, near, c, u, v, p):
	"""Extents of X and Y over the depths from near to the farthest point's, from that point's image."""
	e = np.sqrt(flush(u[:, :2] * u[:, :2] + v[:, :2] * v[:, :2])) * GROW

	def shown(x, z):
		return np.where(orth, f * x, (f * x) / z)
	z, at = p[:, 2:], shown(p[:, :2], p[:, 2:])
	low, high = c[:, :2] - e, c[:, :2] + e
	return np.minimum(shown(low, near), shown(low, z)) - at, np.maximum(shown(high, near), shown(high, z)) - at


def gaussian(J_u, J_v, det, rule):
	"""Exact EWA: the inverse of V = object2 J J^T + screen2 I, and the weight of the centre."""
	o2, s2 = rule['object2'], rule['screen2']
	xx = o2 * (J_u[:, 0] * J_u[:, 0] + J_v[:, 0] * J_v[:, 0]) + s2
	xy = o2 * (J_u[:, 0] * J_u[:, 1] + J_v[:, 0] * J_v[:, 1])
	yy = o2 * (J_u[:, 1] * J_u[:, 1] + J_v[:, 1] * J_v[:, 1]) + s2
	d = xx * yy - xy * xy
	there = flush(d) > 0
	conic = np.where(there[:, None], np.stack([yy / d, -xy / d, xx / d], -1), f32(0))
	peak = (o2 * np.abs(det)) / np.sqrt(d)
	return flush(conic), np.where(there, flush(np.where(peak > 1, f32(1), peak)), f32(0))


def boxes(filters, side, reach, ellipse, half_botsch, wide, blur):
	"""Least and greatest offset from the centre, before what is added for rounding."""
	side, exact, reach = side[:, None], (filters == EXACT)[:, None], reach[:, None]
	low, high = np.minimum(ellipse[0], -reach), np.maximum(ellipse[1], reach)
	botsch = half_botsch[:, None]
	low = np.where(botsch < 0, low, np.minimum(-botsch, -reach))
	high = np.where(botsch < 0, high, np.maximum(botsch, reach))
	low, high = np.where(side, -reach, low), np.where(side, reach, high)
	low = np.where(exact, np.minimum(low, wide[0] - blur), low)
	return low, np.where(exact, np.maximum(high, wide[1] + blur), high)


def discs(view, rule, surfel):
	"""Stage surfel_setup: every surfel in the view: fields of ts_disc, and its fate."""
	centre, u, v = surfel['centre'], surfel['u'], surfel['v']
	orth, f, near = (rule['orthographic'] != 0)[:, None], view['focal'][:, None], view['near'][:, None]
	filters, size = rule['filter'], np.stack([view['width'], view['height']], -1)
	half = size.astype(f32) * f32(0.5)
	normal = normalize(cross(u, v))
	cosine = dot(normal, np.where(orth, view['back'], normalize(view['eye'] - centre)))
	c, u3, v3 = in_view(view, centre - view['eye']), in_view(view, u), in_view(view, v)
	longest = np.maximum(length(u), length(v))

	# Before the near plane, or across it: then about the farthest point.
	deep = np.sqrt(flush(u3[:, 2] * u3[:, 2] + v3[:, 2] * v3[:, 2]))
	a0, b0 = (w[:, 2] / np.where(deep == 0, f32(1), deep) for w in (u3, v3))
	p = c + (u3 * a0[:, None] + v3 * b0[:, None])
	p[:, 2] = c[:, 2] + deep
	before = c[:, 2] < near[:, 0]
	crosses = before & (p[:, 2] >= near[:, 0]) & (filters < SCREEN)
	p = np.where(crosses[:, None], p, c)

	s, t = (np.where(orth[:, 0], f32(0), w[:, 2] / p[:, 2]) for w in (u3, v3))
	J_u, J_v = jacobian(orth, f, p, u3), jacobian(orth, f, p, v3)
	A, B, G, det = rays(J_u, J_v, u3[:, 2] / p[:, 2], v3[:, 2] / p[:, 2])
	side = (cosine < f32(1e-6)) | (flush(det) == 0)
	pixel, fraction = image_place(orth, f, half, p)
	conic, peak = gaussian(J_u, J_v, det, rule)

	reach1, *ellipse = extents(J_u, J_v, s, t, np.ones_like(near[:, 0]))
	reach2, *wide = extents(J_u, J_v, s, t, f32(4) * rule['object2'])
	across = crossing_extents(orth, f, near, c, u3, v3, p)
	ellipse = [np.where(crosses[:, None], x, e) for x, e in zip(across, ellipse)]
	square = (longest * f[:, 0]) / np.where(orth[:, 0], f32(1), p[:, 2])
	square = np.where((rule['botsch'] != 0) & ~crosses, square, f32(-1))
	low, high = boxes(filters, side, rule['reach'], ellipse, square, wide, f32(2) * np.sqrt(rule['screen2'])[:, None])
	low = np.maximum(pixel + np.ceil(fraction + (low * GROW - MORE)), f32(0))
	high = np.minimum(pixel + np.floor(fraction + (high * GROW + MORE)), size.astype(f32) - f32(1))

	fate = np.where((np.abs(pixel) > MOST).any(1) | (low > high).any(1), BESIDE, DRAWN)
	to_eye = (filters == EXACT) & ((reach1 <= 0) | (reach2 <= 0))
	fate = np.where((before & ~crosses) | to_eye, NEAR, fate)
	fate = np.where(flush(cosine) <= 0, AWAY, fate)
	zero = f32(0)
	extra = np.stack([a0, b0, np.zeros_like(a0)], -1)
	fields = {
		'pixel': pixel, 'fraction': flush(fraction), 'depth': flush(p[:, 2]), 'normal': flush(normal),
		'a': np.where(side[:, None], zero, A), 'b': np.where(side[:, None], zero, B),
		'g': np.where(side[:, None], zero, G), 'low': low, 'high': high,
		'flags': side * SIDE + orth[:, 0] * ORTHOGRAPHIC + crosses * CROSSES,
		'conic': np.where((filters == EXACT)[:, None], conic, np.where(crosses[:, None], flush(extra), zero)),
		'peak': np.where(filters == EXACT, peak, zero), 'pad': 0 * p[:, 0]}
	return fields, fate


DISC = np.dtype([
	('pixel', '<i4', (2,)), ('fraction', '<f4', (2,)), ('a', '<f4', (2,)), ('b', '<f4', (2,)), ('g', '<f4', (2,)),
	('depth', '<f4'), ('flags', '<u4'), ('low', '<i4', (2,)), ('high', '<i4', (2,)), ('conic', '<f4', (3,)),
	('peak', '<f4'), ('normal', '<f4', (3,)), ('pad', '<u4')])


def records(fields, fate, dtype):
	"""Fields as records; of what is not drawn `high` is (-1, -1) and all else 0."""
	out = np.zeros(len(fate), dtype)
	drawn = fate == DRAWN
	out['high'] = -1
	for name in DISC.names:
		out[name][drawn] = np.asarray(fields[name])[drawn].astype(out[name].dtype)
	if 'fate' in out.dtype.names:
		out['fate'] = fate
	return out


def epsilon(given, surfel):
	"""The lower median of the longer half-axes, if surfel_depth.epsilon is 0."""
	if given != 0:
		return given
	longer = np.sort(np.maximum(length(surfel['u']), length(surfel['v'])))
	return longer[(len(longer) - 1) // 2]


def fragments(disc, near, x, y):
	"""r3D^2 <= 1 and the axial depth of a surfel at pixels x, y."""
	def at(w):
		return w[0] * dx + w[1] * dy
	dx, dy = ((n - disc['pixel'][k]).astype(f32) - disc['fraction'][k] for k, n in enumerate((x, y)))
	g, flags = at(disc['g']), int(disc['flags'])
	w = f32(1) + g
	by = f32(1) if flags & ORTHOGRAPHIC else f32(1) / w
	a, b = at(disc['a']) * by, at(disc['b']) * by
	if flags & CROSSES:
		a, b = a + disc['conic'][0], b + disc['conic'][1]
	z = disc['depth'] * (f32(1) - g) if flags & ORTHOGRAPHIC else disc['depth'] * by
	return (not flags & SIDE) & (w > 0) & (a * a + b * b <= 1) & (z >= near), z


def depths(view, eps, disc):
	"""Stage surfel_depth: the least bits of z + epsilon/|q| << 32 | surfel of every pixel."""
	width, height = int(view['width']), int(view['height'])
	x, y = np.meshgrid(np.arange(width), np.arange(height))
	qx = ((x.astype(f32) + f32(0.5)) - f32(width) * f32(0.5)) / view['focal']
	qy = ((y.astype(f32) + f32(0.5)) - f32(height) * f32(0.5)) / view['focal']
	behind = eps / np.sqrt((f32(1) + qx * qx) + qy * qy)	# not the order of ts_length
	keys = np.full((height, width), 2**64 - 1, np.uint64)
	for k in np.nonzero((disc['high'] >= disc['low']).all(1))[0]:
		d = disc[k]
		box = slice(d['low'][1], d['high'][1] + 1), slice(d['low'][0], d['high'][0] + 1)
		inside, z = fragments(d, view['near'], x[box], y[box])
		key = (flush(z + behind[box]).view(np.uint32).astype(np.uint64) << np.uint64(32)) | np.uint64(k)
		keys[box] = np.where(inside, np.minimum(keys[box], key), keys[box])
	return keys


def rule_of(params, method, n):
	"""The rules of ts_k_disc, from the parameters, once a surfel."""
	sigma_k, radius = f32(params['ewa.sigma_k']), f32(params['ewa.screen_radius'])
	sigma_h = f32(params['ewa.sigma_h']) or radius * sigma_k
	filters = {'min': MIN, 'object': OBJECT, 'screen': SCREEN}[params['ewa.filter']]
	values = {
		'orthographic': np.uint32(0), 'filter': np.uint32(EXACT if method == 'ewa' else filters),
		'botsch': np.uint32(params['surfel_setup.bounds'] == 'botsch'), 'object2': sigma_k * sigma_k,
		'screen2': sigma_h * sigma_h, 'reach': max(radius, f32(params['surfel_setup.min_px']) * f32(0.5))}
	return {name: np.full(n, value) for name, value in values.items()}


def run(trace, out):
	"""Both stages from a trace's scene.surfel and eye.view, into a candidate."""
	with open(os.path.join(trace, 'trace.json')) as file:
		head = json.load(file)
	files = {b['name']: os.path.join(trace, b['file']) for b in head['buffers'] if b['file']}
	surfel, view = np.load(files['scene.surfel']), np.load(files['eye.view'])
	each = {name: np.repeat(view[name], len(surfel), 0) for name in view.dtype.names}
	fields, fate = discs(each, rule_of(head['params'], head['pipeline'], len(surfel)), surfel)
	disc = records(fields, fate, DISC)
	eps = f32(epsilon(f32(head['params']['surfel_depth.epsilon']), surfel))
	buffers = {'surfel_setup.disc': disc, 'surfel_setup.epsilon': np.array([eps], f32),
		'surfel_depth.surfel': depths(view[0], eps, disc)}
	write(head, buffers, out)


def write(head, buffers, out):
	"""A candidate of these buffers; head is that of the reference."""
	os.makedirs(out, exist_ok=True)
	for name, data in buffers.items():
		np.save(os.path.join(out, name + '.npy'), data)
	head = {
		'format': 'touchstone-trace', 'version': 1, 'contract': 1, 'order': 'canonical', 'effect': head['effect'],
		'pipeline': head['pipeline'], 'params': head['params'], 'producer': {'name': 'numpy surfels', 'version': '1'},
		'buffers': [{'name': name, 'file': name + '.npy'} for name in buffers]}
	with open(os.path.join(out, 'trace.json'), 'w') as file:
		json.dump(head, file, indent=1)


def run_vectors(vectors, out):
	"""The primitives and the composite `disc` of `touchstone vectors`."""
	os.makedirs(out, exist_ok=True)

	def load(name):
		return np.load(os.path.join(vectors, name + '.in.npy'))
	one = {'add': lambda a, b: a + b, 'mul': lambda a, b: a * b, 'div': lambda a, b: a / b, 'dot': dot, 'cross': cross,
		'sqrt': np.sqrt, 'put': flush, 'length': length, 'normalize': normalize}
	for name, function in one.items():
		data = load(name)
		np.save(os.path.join(out, name + '.out.npy'), function(*(data[n] for n in data.dtype.names)))
	data = load('disc')
	view, surfel = ({n.split('.')[1]: data[n] for n in data.dtype.names if n.startswith(kind)}
		for kind in ('view.', 'surfel.'))
	fields, fate = discs(view, data, surfel)
	np.save(os.path.join(out, 'disc.out.npy'), records(fields, fate, np.dtype(DISC.descr + [('fate', '<u4')])))


if __name__ == '__main__':
	np.seterr(all='ignore')
	if sys.argv[1] == '--vectors':
		run_vectors(sys.argv[2], sys.argv[3])
	else:
		run(sys.argv[1], sys.argv[2])
