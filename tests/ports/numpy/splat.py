"""Stage `splat` of METHODS, section 2: points into cube faces; rules 15 to 19, 24 and 25 of CONTRACT.md."""
import numpy as np

from contract import EMPTY, contracted_length, floor_i32, key, length
from cube import views
from raster import Outlines, clip, spread

TINY = 1


def run(trace, broken=0):
	faces, points, pieces = trace['cube_size.face'], trace['points.record'], trace['split.piece']
	clipped = trace.params['splat.clip'] == 'on' and broken != 4
	bounded = clipped | (points['flags'] & TINY > 0)
	square = squares(points, trace['align.frame'][points['piece']])
	slack = np.abs([pieces[corner] for corner in 'abc']).max((0, 2)) * np.float32(2 ** -19)
	widest = np.float32(127 / 256 if trace.params['splat.box'] == 'centre' else 0)
	texels = np.full(6 * (faces['n'].astype(np.int64) ** 2).sum(), EMPTY)
	for view in views(faces):
		seen = view.has(trace['visibility.bits'])[pieces['triangle']]
		outlines, outline = outline_pieces(pieces, seen, view, broken)
		index, keys = farthest_first(points, outline[points['piece']] >= 0, view, broken)
		reach = slack[points['piece'][index]], widest
		low, high, left = boxes(square[index], view, reach, np.float32(.5 if broken == 3 else 0))
		index, keys = index[left], keys[left]
		which = outline[points['piece'][index]]
		splat, column, row = spread(*outlines.meet(low, high, which, bounded[index]))
		if clipped:
			touched = outlines.touches(which[splat], column, row)
			splat, column, row = splat[touched], column[touched], row[touched]
		texels[view.offset + row * view.n + column] = keys[splat]
	return {'splat.depth_index': texels}


def squares(points, frame):
	"""Step 1: corners in the plane of the piece."""
	half = (points['length'] * np.float32(.5))[:, None]
	u, v, c = frame['u'] * half, frame['v'] * half, points['centre']
	return np.stack(((c - u) - v, (c + u) - v, (c + u) + v, (c - u) + v), 1)


def outline_pieces(pieces, seen, view, broken):
	"""Step 3: the outlines of the pieces seen, and which of them each piece has, -1 where nothing is left."""
	seen = np.flatnonzero(seen)
	corners = np.stack([pieces[corner][seen] for corner in 'abc'], 1)
	polygons, left = clip(view.see(corners), view.planes(broken))
	left |= broken == 9
	outline = np.full(len(pieces), -1)
	outline[seen[left]] = np.arange(left.sum())
	return Outlines(view.project(polygons[left]), broken), outline


def farthest_first(points, shown, view, broken):
	"""Step 4: the points shown and their keys, descending, so that the least is written last (rule 25)."""
	index = np.flatnonzero(shown)
	centre = points['centre'][index]
	distance = contracted_length if broken == 10 else length
	keys = key(view.see(centre)[:, 2] if broken == 5 else distance(centre - view.centre), index)
	order = np.arange(len(keys)) if broken == 11 else np.argsort(keys)[::-1]
	return index[order], keys[order]


def boxes(square, view, reach, shift):
	"""Steps 1 and 2: first and last texels of the squares, and of which of them something is left."""
	(slack, widest), (corners, left) = reach, clip(view.see(square), [view.near_plane()])
	corners = corners[left]
	with np.errstate(divide='ignore'):
		inset = np.maximum(widest - (view.focal * slack[left]) / corners[..., 2].min(1), np.float32(0))[:, None]
	pixels = view.project(corners) + shift
	low, high = floor_i32(pixels.min(1) + inset), floor_i32(pixels.max(1) - inset)
	return np.maximum(low, 0), np.minimum(high, view.n - 1), left
