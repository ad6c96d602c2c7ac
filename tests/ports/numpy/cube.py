"""The six views of a reflector's cube: rule 36 of CONTRACT.md, section 1 of METHODS."""
from typing import NamedTuple

import numpy as np

from raster import RANGE, project

# Right, up and front of +X -X +Y -Y +Z -Z: the coordinate of each, and its sign.
AXES = (2, 1, 0), (2, 1, 0), (0, 2, 1), (0, 2, 1), (0, 1, 2), (0, 1, 2)
SIGNS = np.float32([(-1, 1, 1), (1, 1, -1), (1, -1, 1), (1, 1, -1), (1, 1, 1), (-1, 1, -1)])


class View(NamedTuple):
	bit: int
	centre: np.ndarray
	near: np.float32
	n: int
	offset: int

	@property
	def focal(self):
		return np.float32(self.n / 2)

	def has(self, bits):
		"""Which triangles have the bit of this view."""
		return bits[:, self.bit // 64] >> np.uint64(self.bit % 64) & np.uint64(1) > 0

	def see(self, points):
		"""World to view space: X, Y, z."""
		face = self.bit % 6
		return (points - self.centre)[..., AXES[face]] * SIGNS[face]

	def project(self, p):
		return project(p, self.focal, self.focal)

	def near_plane(self):
		return np.float32([0, 0, 1, -self.near])

	def planes(self, broken):
		"""Rule 16: near, and left, right, bottom, top at the ends of what can be snapped."""
		f, reach = self.focal, RANGE - self.focal
		if broken == 7:
			f, reach = 1, reach / f
		sides = (f, 0, reach, 0), (-f, 0, reach, 0), (0, f, reach, 0), (0, -f, reach, 0)
		return np.float32([self.near_plane(), *sides])


def views(faces):
	"""The views of all cubes that have texels."""
	for reflector, face in enumerate(faces):
		n = int(face['n'])
		for f in range(6) if n else ():
			yield View(6 * reflector + f, face['centre'], face['near'], n, int(face['offset']) + f * n * n)
