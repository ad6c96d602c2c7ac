"""Stage `visibility` of METHODS, section 2: one bit a triangle and cube face; rules 35 and 36 of CONTRACT.md."""
import numpy as np

from contract import components, cross, dot, flush
from cube import views

DOUBLE_SIDED = 1


def run(trace, broken=0):
	vertex, triangle = trace['pose.vertex'], trace['scene.triangle']
	corners = vertex['position'][triangle['vertex']]
	owner = vertex['object'][triangle['vertex'][:, 0]]
	normal = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
	real = flush(dot(normal, normal)) > 0
	both = (trace['scene.material']['flags'][triangle['material']] & DOUBLE_SIDED > 0) | (broken == 2)
	faces = trace['cube_size.face']
	bits = np.zeros((len(triangle), (6 * len(faces) + 63) // 64), np.uint64)
	for view in views(faces):
		facing = both | (flush(dot(normal, view.centre - corners[:, 0])) > 0)
		inside = INSIDE[trace.params['visibility.test']](view.see(corners), view, broken)
		seen = real & facing & inside & (owner != faces['object'][view.bit // 6])
		bits[:, view.bit // 64] |= seen.astype(np.uint64) << np.uint64(view.bit % 64)
	return {'visibility.bits': bits}


def plane(corners, view, broken):
	"""Not all corners strictly beyond one plane."""
	x, y, z = components(corners)
	greater = np.greater_equal if broken == 1 else np.greater
	if broken == 8:
		x, y, z = x * view.focal, y * view.focal, z * view.focal
	sides = greater(x, z), greater(-x, z), greater(y, z), greater(-y, z), corners[..., 2] < view.near
	return ~np.logical_or.reduce([side.all(1) for side in sides])


def vertex(corners, view, broken):
	"""A corner in the frustum enlarged by a fifth."""
	x, y, z = components(corners)
	far = np.float32(1.2) * z
	return ((z > 0) & (np.abs(x) <= far) & (np.abs(y) <= far)).any(1)


INSIDE = {'plane': plane, 'vertex': vertex}
