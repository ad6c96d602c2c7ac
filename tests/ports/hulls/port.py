#!/usr/bin/python3
"""Stages corner and corner.lobes of screen-space approximate Gaussian hulls (METHODS, section 11), in numpy.

	port.py REF OUT    REF: a trace of indirect or area-light by hulls; OUT: a candidate (TRACES.md, section 6)"""
import ast
import json
import os
import sys
import numpy as np
import num
from num import F

INPUTS = ('eye.view', 'rsm.patch', 'polygon.patch', 'gbuffer.pixel', 'segment.box', 'lamp.light', 'lamp.shape')
PI = num.h('0x1.921fb6p+1')


def load(folder, trace, name):
	"""A buffer of a trace, or None where the run did not make it."""
	files = {b['name']: b['file'] for b in trace['buffers']}
	return np.load(os.path.join(folder, files[name])) if name in files else None


def stored(dtype, shape, **fields):
	"""Records of a buffer, every float through ts_put (rule 12)."""
	out = np.zeros(shape, dtype)
	for name, value in fields.items():
		out[name] = num.flush(value.reshape(out[name].shape))
	return out


def pixel_of(texel, size, side):
	"""METHODS 11, depth_grid: texel i shows pixel floor((2i + 1) W / 2G)."""
	return (2 * texel.astype(np.int64) + 1) * size // (2 * side)


def corner_pixels(box, view, side, rectangle):
	"""METHODS 11, corner: columns and rows (boxes, 4) of top left, top right, bottom left, bottom right."""
	high = np.minimum(box['high'] + rectangle, side - 1)
	x = np.stack([box['low'][:, 0], high[:, 0]] * 2, 1)
	y = np.stack([box['low'][:, 1], box['low'][:, 1], high[:, 1], high[:, 1]], 1)
	return pixel_of(x, int(view['width']), side), pixel_of(y, int(view['height']), side)


def on_ray(view, x, y, z):
	"""The point at axial depth z on the ray of the middle of pixel (x, y)."""
	a = ((x.astype(F) + F(0.5)) - F(view['width']) * F(0.5)) / view['focal']
	b = (F(view['height']) * F(0.5) - (y.astype(F) + F(0.5))) / view['focal']
	way = (view['right'] * a[..., None] + view['up'] * b[..., None]) - view['back']
	return view['eye'] + way * z[..., None]


def places(box, pixel, view, params):
	"""METHODS 11, corner: position and zn of each corner, by the paper's position correction where out of range."""
	x, y = corner_pixels(box, view, int(params['depth_grid.px']), params['hull.corners'] == 'rectangle')
	seen = pixel[y, x]
	near, far = box['nearest'][:, None], box['farthest'][:, None]
	moved = (seen['depth'] < near) | (seen['depth'] > far)
	middle = np.broadcast_to((near + far) * F(0.5), moved.shape)
	z = view['near'] / np.where(moved, F(1) - middle, F(1))
	p = np.where(moved[..., None], on_ray(view, x, y, z), seen['position'])
	return p, np.where(moved, middle, seen['depth'])


def corner(p, patches, ramp):
	"""METHODS 11, corner: sums of weights and of weighted directions over the triangles, in order."""
	total, direction = np.zeros(p.shape, F), np.zeros(p.shape + (3,), F)
	for patch in patches:
		w, d = num.gather(patch, p, ramp)
		total, direction = total + w, direction + d
	return total, direction


def points_of_light(p, lamps, shapes, total, direction):
	"""METHODS 11, corner: area-light adds lights whose radius is 0, as directions."""
	for lamp, shape in zip(lamps, shapes):
		l, arrives = num.light(lamp, p)
		w = lamp['intensity'] * (arrives * PI)[..., None]
		if shape['radius'] == 0:
			total, direction = total + w, direction + l[..., None, :] * w[..., :, None]
	return total, direction


def moments(b, params, lamps, dtype):
	"""Stage corner: corner.moment from the buffers b that it reads."""
	patches = b['polygon.patch'].reshape(-1) if lamps else b['rsm.patch']
	p, depth = places(b['segment.box'], b['gbuffer.pixel'], b['eye.view'][0], params)
	total, direction = corner(p, patches, params['corner.facing'] == 'ramp' and not lamps)
	if lamps:
		total, direction = points_of_light(p, b['lamp.light'], b['lamp.shape'], total, direction)
	return stored(dtype, depth.shape, position=p, depth=depth, sum=total, direction=direction)


def lobes(moment, params, dtype):
	"""Stage corner.lobes: corner.lobes from corner.moment."""
	direction = moment['direction'].reshape(moment.shape + (3, 3))
	mu, sharpness, phi = num.fit(moment['sum'], direction, params['hull.sharpness'] == 'vmf')
	return stored(dtype, moment.shape, **{'mu': mu, 'lambda': sharpness, 'phi': phi})


def write(out, effect, made):
	"""A candidate (TRACES.md, section 6), trace.json last."""
	os.makedirs(out, exist_ok=True)
	for name, data in made.items():
		np.save(os.path.join(out, name + '.npy'), data)
	head = {'format': 'touchstone-trace', 'version': 1, 'contract': 1, 'order': 'canonical', 'pipeline': 'hulls',
		'effect': effect, 'producer': {'name': 'hulls in numpy', 'version': '1'},
		'buffers': [{'name': name, 'file': name + '.npy'} for name in made]}
	with open(os.path.join(out, 'trace.json'), 'w') as file:
		json.dump(head, file, indent=1)


def port(reference, out):
	"""Both stages from the buffers of a trace, the second from what the first made."""
	with open(os.path.join(reference, 'trace.json')) as file:
		trace = json.load(file)
	b = {name: load(reference, trace, name) for name in INPUTS}
	dtypes = {x['name']: ast.literal_eval(x['dtype']) for x in trace['buffers']}
	moment = moments(b, trace['params'], trace['effect'] == 'area-light', dtypes['corner.moment'])
	made = {'corner.moment': moment, 'corner.lobes': lobes(moment, trace['params'], dtypes['corner.lobes'])}
	write(out, trace['effect'], made)


if __name__ == '__main__':
	with np.errstate(all='ignore'):
		port(sys.argv[1], sys.argv[2])
