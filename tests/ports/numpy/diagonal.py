#!/usr/bin/python3
"""The picture of triangle.gltf by the opposite of the top-left rule: PORTING.md, section 7.

The rest is as in rules 15, 17, 18 and 22 of CONTRACT.md.

diagonal.py TRACE CANDIDATE
"""
import sys

import numpy as np

from contract import EMPTY, components, dot, fix, key
from raster import project
from traces import Trace, write_candidate


def corners(trace, view):
	"""The triangle on the screen, turned to positive area, and its depths."""
	p = trace['pose.vertex']['position'][trace['scene.triangle']['vertex'][0]] - view['eye']
	p = np.stack((dot(p, view['right']), dot(p, view['up']), -dot(p, view['back'])), -1)
	middle = np.float32([view['width'] / 2, view['height'] / 2])
	snapped = fix(project(p, middle, view['focal']), 8, 23).astype(np.int64)
	(x, y), (x2, y2) = snapped[1:] - snapped[0]
	turn = [0, 1, 2] if x * y2 > y * x2 else [0, 2, 1]
	return snapped[turn], p[turn, 2]


def picture(trace):
	view = trace['eye.view'][0]
	snapped, z = corners(trace, view)
	row, column = 256 * np.indices((view['height'], view['width'])) + 128
	begin, end = np.roll(snapped, -1, 0), np.roll(snapped, -2, 0)
	(x, y), (dx, dy) = components(begin[:, None, None]), components((end - begin)[:, None, None])
	edge = dx * (row - y) - dy * (column - x)
	covered = ((edge > 0) | (edge == 0) & ((dy > 0) | (dy == 0) & (dx < 0))).all(0)
	share = edge[:, covered].astype(np.float32) / edge[:, 0, 0].sum().astype(np.float32) / z[:, None]
	texels = np.full(covered.shape, EMPTY)
	texels[covered] = key(1 / ((share[0] + share[1]) + share[2]), np.uint64(0))
	return texels


def main(folder, candidate):
	trace = Trace(folder)
	write_candidate(candidate, trace, 'canonical', {'eye.depth_triangle': picture(trace)})


if __name__ == '__main__':
	main(*sys.argv[1:])
