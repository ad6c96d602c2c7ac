"""Stage `scatter` of METHODS, section 10: stored points into depth maps; rules 11, 14 and 15 of CONTRACT.md."""
import numpy as np

from contract import components, dot, floor_i32, flush
from raster import project

EMPTY = np.uint32(2 ** 32 - 1)


def run(trace, broken=0):
	views, points = trace['offscreen.view'], trace['points.record']
	bits = trace['visibility.bits'][trace['split.piece']['triangle'][points['piece']]]
	texels = np.full(int((views['width'].astype(np.int64) * views['height']).sum()), EMPTY)
	for v, view in enumerate(views):
		seen = bits[:, v // 64] >> np.uint64(v % 64) & np.uint64(1) > 0
		place, z = see(points['centre'][seen], view)
		column, row = components(floor_i32(place + np.float32(.5 if broken == 3 else 0)).astype(np.int64))
		inside = (z >= view['near']) & (column >= 0) & (row >= 0) & (column < view['width']) & (row < view['height'])
		texel = int(view['offset']) + row * int(view['width']) + column
		np.minimum.at(texels, texel[inside], flush(z)[inside].view(np.uint32))
	return {'depth_map.depth': texels}


def see(points, view):
	"""World to pixels and axial depth; orthographic ones are divided by 1."""
	p = points - view['eye']
	p = np.stack((dot(p, view['right']), dot(p, view['up']), -dot(p, view['back'])), -1)
	over = np.where(view['orthographic'] != 0, np.float32(1), p[..., 2])
	middle = np.float32([view['width'] / 2, view['height'] / 2])
	return project(np.stack((p[..., 0], p[..., 1], over), -1), middle, view['focal']), p[..., 2]
