"""Pairs of a node of the scene and one of views (`traverse`): METHODS section 13, culling to subdivision."""

import numpy as np
from num import cross, dot, f32, flush, length

SPLIT_NODE, SPLIT_VIEW, RENDERED, CULLED, NEAR = range(5)


def is_culled(vs, d, radii, cone, phi):
	"""Figure 4, without an angle: psi = theta + phi, and fs must pass the radii. phi is its cosine and sine."""
	cosine = np.maximum(cone['cosine'] - f32(2.0 ** -22), f32(-1))
	sine = np.sqrt(flush(f32(1) - cosine * cosine))
	cos_psi = cosine * phi[0] - sine * phi[1]
	sin_psi = sine * phi[0] + cosine * phi[1]
	c = dot(vs, cone['axis'])
	s = length(cross(vs, cone['axis']))
	sin_d = s * cos_psi - c * sin_psi
	cos_d = c * cos_psi + s * sin_psi
	fs = np.where(cos_d < 0, d, sin_d)
	return (sin_psi > 0) & (sin_d > 0) & (fs > radii + f32(2.0 ** -20) * d)


def size(vs, d, at, r, n):
	"""Width in texels of a ball as it is at the distance `at`, seen along vs, whose length is d."""
	sine = flush(r / at)
	return n * sine / (np.abs(vs[..., 0]) / d + np.sqrt(np.maximum(f32(1) - sine * sine, f32(0))))


def fate(node, view, cone, phi, n, apart, last, to_last=0, cutoff=0):
	"""What becomes of a pair. Leaves have no children, or are of level `last`; with to_last none is equivalent."""
	vs = node['centre'] - view['centre']
	d = length(vs)
	rs, rv = node['radius'], view['radius']
	culled = is_culled(vs, d, rs + rv, cone, phi) | ((cutoff > 0) & (d - (rs + rv) > cutoff))
	equal = (d - rv > rs) & (rv <= rs) & (size(vs, d, d - rv, rs, n) < 1) & (to_last == 0)
	leaf, leaf_view = ((x['level'] >= last) | (x['children'] == 0) for x in (node, view))
	split_view = leaf | (~leaf_view & (rs * f32(0.5) < rv))
	last_fate = np.where(d < apart * rs, NEAR, RENDERED)
	choices = (culled, equal, leaf & leaf_view, split_view)
	return np.select(choices, (CULLED, RENDERED, last_fate, SPLIT_VIEW), SPLIT_NODE).astype(np.uint32)
