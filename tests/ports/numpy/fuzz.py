#!/usr/bin/python3
"""Random inputs of one stage, and the port's answer, as a candidate to replay: PORTING.md, section 6.

fuzz.py TRACE CANDIDATE STAGE SEED [--break N]     STAGE: visibility or splat;
TRACE: its parameters and types of records

What scenes hardly have: pieces without area, others that cross the range of snapping, or of which a face sees nothing;
corners within two units in the last place of a frustum's border. --break: as that of port.py.
"""
import argparse

import numpy as np

import splat
import visibility
from contract import flush
from cube import AXES, SIGNS
from traces import Trace, write_candidate

NONE = np.uint32(0xffffffff)


def spread(random, low, high, shape=()):
	"""Numbers with uniform logarithms."""
	return np.exp(random.uniform(np.log(low), np.log(high), shape))


def record(trace, name, n, /, **fields):
	made = np.zeros(n, trace[name].dtype)
	for field, value in fields.items():
		made[field] = flush(np.float32(value)) if made.dtype[field].base.kind == 'f' else value
	return made


def cubes(random, trace, n):
	"""Cubes of all sizes that the parameters allow, every other one at the origin."""
	params = {name: int(trace.params[name]) for name in ('cube.px', 'cube.max_px', 'height')}
	most = params['cube.px'] or max(16, min(params['cube.max_px'], params['height'] // 2))
	radius = np.float32(spread(random, .1, 10, n))
	side = random.randint(0, most + 1, n)
	side[:2] = most
	texels = 6 * side ** 2
	return record(
		trace, 'cube_size.face', n, centre=random.normal(0, 100, (n, 3)) * (np.arange(n) % 2)[:, None], radius=radius,
		near=radius / np.float32(1024), n=side, offset=np.cumsum(texels) - texels)


def world(views, face, cube):
	"""View space to world, exactly for a cube at the origin; views are (m, 3, 3), faces and cubes m."""
	offset = np.zeros_like(views, np.float32)
	for m, f in enumerate(face):
		offset[m][:, AXES[f]] = np.float32(views[m]) * SIGNS[f]
	return offset + cube['centre'][:, None]


def sizes(trace, n_cubes, n_triangles):
	"""What says how many there are of both, without being read."""
	info = trace['scene.info'].copy()
	info['n_reflectors'] = n_cubes
	return {'scene.info': info, 'scene.triangle': record(trace, 'scene.triangle', n_triangles)}


def pieces_anywhere(random, m, near):
	return random.normal(0, 1, (m, 1, 3)) * spread(random, .01, 100, (m, 1, 1)) + \
		random.normal(0, 1, (m, 3, 3)) * spread(random, 1e-4, 3e3, (m, 1, 1))


def pieces_in_range(random, m, near):
	"""Corners about the near plane, as far to the side as can be snapped or farther, or in the middle."""
	z = near[:, None] * spread(random, .5, 30, (m, 3))
	side = random.choice([-1, 1], (m, 3, 2)) * spread(random, .1, 3e4, (m, 3, 2))
	return np.concatenate((side * z[..., None], z[..., None]), 2)


def pieces_edge_on(random, m, near):
	"""Three rays in one plane through the eye, in numbers that leave their areas 0."""
	start, step = random.randint(-16, 17, (2, m, 1, 2))
	ray = (start + step * random.randint(-1, 2, (m, 3, 1))) / 16
	z = 2.0 ** random.randint(-2, 8, (m, 3, 1))
	return np.concatenate((ray * z, z), 2)


def pieces_thin(random, m, near):
	"""A corner on the opposite edge or, by rounding or less than the snapping sees, beside it."""
	p = pieces_anywhere(random, m, near)
	p[:, 2] = p[:, 0] + (p[:, 1] - p[:, 0]) * random.choice([0, .5, 1, random.random()], (m, 1))
	return p + random.choice([0, 1e-4], (m, 1, 1)) * random.normal(0, 1, p.shape)


KINDS = pieces_anywhere, pieces_in_range, pieces_edge_on, pieces_thin


def splat_inputs(random, trace, n_cubes=48, n=480, each=4):
	faces = cubes(random, trace, n_cubes)
	own, face, kind = np.arange(n) % n_cubes, random.randint(0, 6, n), random.randint(0, len(KINDS), n)
	near = faces['near'][own].astype(np.float64)
	corner = world(np.choose(kind[:, None, None], [make(random, n, near) for make in KINDS]), face, faces[own])
	words = np.zeros((n, (6 * n_cubes + 63) // 64), np.uint64)
	for b in range(6):
		bit = 6 * own + b
		words[np.arange(n), bit // 64] |= np.uint64(1) << np.uint64(bit % 64)
	axis = np.linalg.qr(random.normal(0, 1, (n, 3, 3)))[0]
	frame = record(trace, 'align.frame', n, c=corner.mean(1), s=1, u=axis[:, 0], v=axis[:, 1])
	piece = np.repeat(np.arange(n), each)
	weight = random.dirichlet([1, 1, 1], n * each)
	weight[::each] = weight[1::each]
	width = np.ptp(corner, 1).max(1)[piece] * spread(random, .1, 10, n * each)
	points = record(
		trace, 'points.record', n * each, centre=(corner[piece] * weight[..., None]).sum(1), length=width, piece=piece,
		flags=random.randint(0, 4, n * each) == 0)
	return sizes(trace, n_cubes, n) | {
		'cube_size.face': faces, 'align.frame': frame, 'points.record': points, 'visibility.bits': words,
		'split.piece': record(
			trace, 'split.piece', n, a=corner[:, 0], b=corner[:, 1], c=corner[:, 2], triangle=np.arange(n), path=1),
		'points.offset': np.arange(0, n * each + 1, each, np.uint32)}


def nudged(x, ulps):
	"""x, so many units in the last place farther from zero."""
	return (np.float32(x).view(np.int32) + np.int32(ulps)).view(np.float32)


def on_borders(random, trace, m, near):
	"""Triangles whose corners lie near one and the same border of a view, most of them beyond it."""
	z = np.float32(near[:, None] * spread(random, 1, 1e4, (m, 3)))
	slope = np.float32(1.2) if trace.params['visibility.test'] == 'vertex' else np.float32(1)
	beyond = np.where(random.random((m, 1)) < .8, random.randint(1, 3, (m, 3)), random.randint(-2, 3, (m, 3)))
	beyond[np.arange(m), random.randint(0, 3, m)] -= random.randint(0, 3, m)
	side = nudged(slope * z, beyond) * np.float32(random.choice([-1, 1], (m, 1)))
	views = np.stack((side, np.float32(random.uniform(-1.4, 1.4, (m, 3))) * z, z), -1)
	views[::2] = views[::2, :, [1, 0, 2]]
	close = slice(None, None, 5)
	views[close, :, 2] = nudged(np.repeat(near[close, None], 3, 1), -beyond[close])
	return views


def visibility_inputs(random, trace, n_cubes=24, n=3000):
	faces = cubes(random, trace, n_cubes)
	own = random.randint(0, n_cubes, n)
	corner = world(on_borders(random, trace, n, faces['near'][own]), random.randint(0, 6, n), faces[own])
	vertex = record(trace, 'pose.vertex', 3 * n, position=corner.reshape(-1, 3))
	vertex['object'] = np.maximum(random.randint(-4 * n_cubes, n_cubes + 1, 3 * n), 0)
	faces['object'] = np.arange(1, n_cubes + 1)
	objects = record(trace, 'scene.object', n_cubes + 1, n_vertices=1, reflector=np.arange(-1, n_cubes) & NONE)
	objects['first_vertex'] = np.arange(n_cubes + 1)
	material = record(trace, 'scene.material', 4, slot=NONE, flags=[0, 1, 2, 3])
	buffers = sizes(trace, n_cubes, n) | {
		'cube_size.face': faces, 'pose.vertex': vertex, 'scene.vertex': vertex, 'scene.object': objects,
		'scene.material': material}
	buffers['scene.triangle']['vertex'] = np.arange(3 * n).reshape(-1, 3)
	buffers['scene.triangle']['material'] = random.randint(0, 4, n)
	return buffers


STAGES = {'visibility': (visibility, visibility_inputs), 'splat': (splat, splat_inputs)}


def main():
	parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
	parser.add_argument('trace')
	parser.add_argument('candidate')
	parser.add_argument('stage', choices=STAGES)
	parser.add_argument('seed', type=int)
	parser.add_argument('--break', dest='broken', type=int, default=0, choices=range(14))
	given = parser.parse_args()
	trace = Trace(given.trace)
	stage, inputs = STAGES[given.stage]
	buffers = inputs(np.random.RandomState(given.seed), trace)
	trace.update(buffers)
	write_candidate(given.candidate, trace, 'canonical', buffers | stage.run(trace, given.broken))


if __name__ == '__main__':
	main()
