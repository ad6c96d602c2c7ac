#!/usr/bin/python3
"""Two stages of MegaViews (effect indirect, method megaviews), METHODS section 13: `traverse` and `view_map`.

usage: port.py TRACE OUT

Reads octree.* and view_octree.* of TRACE; writes traverse.rendered and view_map.depth_node, and trace.json, to OUT."""

import json
import os
import sys

import numpy as np
import maps
import pairs
from num import f32, length

EMPTY = np.uint64(0xffffffffffffffff)
NONE = 0xffffffff


class Trace:
	"""What a folder that `render --trace` wrote holds: its buffers by name, and its parameters as text."""

	def __init__(self, folder):
		with open(os.path.join(folder, 'trace.json')) as file:
			self.json = json.load(file)
		buffers = self.json['buffers']
		self.files = {b['name']: os.path.join(folder, b['file']) for b in buffers if b['file']}
		self.params = self.json['params']
		self.changed = {}

	def __getitem__(self, name):
		return self.changed[name] if name in self.changed else np.load(self.files[name])


def children(nodes, ids):
	"""For each id its children, which stand one after the other: which of the ids, and the child."""
	counts = np.array([bin(mask).count('1') for mask in nodes['children'][ids].tolist()], np.int64)
	which = np.repeat(np.arange(len(ids)), counts)
	rank = np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)
	return which, nodes['child'][ids][which].astype(np.int64) + rank


def traverse(trace):
	"""Pairs that are rendered, sorted. A decision knows nothing but its pair, so any order of work will do."""
	scene, views, cones = (trace[name] for name in ('octree.node', 'view_octree.node', 'view_octree.cone'))
	half = trace.json['plan']['views.field'] == 0 and trace.params['traverse.cull'] == 'on'
	phi = (f32(0), f32(1)) if half else (f32(-1), f32(0))
	n, apart = f32(trace.params['view_map.px']), f32(trace.params['view_map.apart'])
	last = int(trace.params['octree.levels'])
	v = np.flatnonzero(views['parent'] == NONE)
	s = np.zeros_like(v)
	if trace.params['traverse.hierarchies'] == 'views':
		s, v = (x.ravel() for x in np.meshgrid(np.flatnonzero(scene['children'] == 0), v))
	rendered = []
	while len(s):
		fate = pairs.fate(scene[s], views[v], cones[v], phi, n, apart, last)
		rendered.append(((s << 32) | v)[fate == pairs.RENDERED])
		s0, v0 = s[fate == pairs.SPLIT_NODE], v[fate == pairs.SPLIT_NODE]
		s1, v1 = s[fate == pairs.SPLIT_VIEW], v[fate == pairs.SPLIT_VIEW]
		of_s, child_s = children(scene, s0)
		of_v, child_v = children(views, v1)
		s, v = np.concatenate([child_s, s1[of_v]]), np.concatenate([v0[of_s], child_v])
	return np.sort(np.concatenate(rendered)).astype(np.uint64)


def first_texel(n, level):
	"""Levels of the pyramid stand one behind the other; a level is two maps of n >> level texels a side."""
	return sum(2 * (n >> l) ** 2 for l in range(level))


def fill(texels, n, levels, key, vs, radius):
	"""Fills all texels of one map that a ball covers, the coarsest first; none within one that is filled."""
	done = np.zeros((2, 1, 1), bool)
	for level in reversed(range(levels)):
		side = n >> level
		back, row, column = np.mgrid[0:2, 0:side, 0:side]
		done = done.repeat(side // done.shape[1], 1).repeat(side // done.shape[2], 2)
		ways = np.broadcast_to(vs, back.shape + (3,))
		inside = maps.cap_inside(ways, radius, back == 1, np.int64(n), level, column, row) >= 0
		at = first_texel(n, level) + np.flatnonzero(inside & ~done)
		texels[at] = np.minimum(texels[at], key)
		done |= inside


def view_map(trace, rendered):
	"""Bits of the distance and the node of each pair into the map of its node of views, by minimum."""
	scene, views = trace['octree.node'], trace['view_octree.node']
	n, mode = int(trace.params['view_map.px']), trace.params['view_map.multipixel']
	point = trace.params['view_map.texel'] == 'point'
	if mode == 'auto':
		mode = 'mips' if n > 16 else 'off' if point else 'texels'
	levels = n.bit_length() if mode == 'mips' else 1
	texels = np.full((len(views), first_texel(n, levels)), EMPTY)
	s, v = (rendered >> np.uint64(32)).astype(np.int64), (rendered & np.uint64(NONE)).astype(np.int64)
	vs = scene['centre'][s] - views['centre'][v]
	d = length(vs)
	key = (d.view(np.uint32).astype(np.uint64) << np.uint64(32)) | s.astype(np.uint64)
	if point:
		np.minimum.at(texels, (v, maps.texel(vs, np.int64(n))[1]), key)
	if mode != 'off':
		radius = f32(trace.params['view_map.fill']) * scene['radius'][s]
		wide = (d <= radius) | (pairs.size(vs, d, d, radius, f32(n)) > 1)
		for i in np.flatnonzero(wide | (not point)):
			fill(texels[v[i]], n, levels, key[i], vs[i], radius[i])
	return texels


def write(trace, out, buffers):
	"""A candidate: the buffers, then trace.json (TRACES.md, section 6)."""
	os.makedirs(out, exist_ok=True)
	for name, array in buffers.items():
		np.save(os.path.join(out, name + '.npy'), array)
	head = {'format': 'touchstone-trace', 'version': 1, 'contract': 1, 'order': 'canonical'}
	head.update({key: trace.json[key] for key in ('effect', 'pipeline')})
	head['producer'] = {'name': 'port.py', 'version': '1'}
	head['buffers'] = [{'name': name, 'file': name + '.npy'} for name in buffers]
	with open(os.path.join(out, 'trace.json'), 'w') as file:
		json.dump(head, file)


def main(source, out):
	trace = Trace(source)
	rendered = traverse(trace)
	write(trace, out, {'traverse.rendered': rendered, 'view_map.depth_node': view_map(trace, rendered)})


if __name__ == '__main__':
	np.seterr(divide='ignore', invalid='ignore', over='ignore')
	main(*sys.argv[1:])
