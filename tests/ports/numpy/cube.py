"""Cube faces as views from the inside: right, up and back of +X -X +Y -Y +Z -Z (OpenGL's table). Focal length n/2."""
import numpy

from contract import dot, f32

ROWS = numpy.array([
	[[0, 0, -1], [0, 1, 0], [-1, 0, 0]],
	[[0, 0, 1], [0, 1, 0], [1, 0, 0]],
	[[1, 0, 0], [0, 0, -1], [0, -1, 0]],
	[[1, 0, 0], [0, 0, 1], [0, 1, 0]],
	[[1, 0, 0], [0, 1, 0], [0, 0, -1]],
	[[-1, 0, 0], [0, 1, 0], [0, 0, 1]],
], f32)


def to_view(face, offset):
	"""Offsets from the cube's centre to (X, Y, axial depth) of a face."""
	right, up, back = ROWS[face]
	return numpy.stack([dot(right, offset), dot(up, offset), -dot(back, offset)], -1)


def face_bits(words, cube):
	"""The six bits of a cube in rows of 64-bit words: bit 6 cube + face."""
	found = numpy.zeros((len(words), 6), bool)
	for face in range(6):
		bit = 6 * cube + face
		found[:, face] = (words[:, bit >> 6] >> numpy.uint64(bit & 63)) & numpy.uint64(1) != 0
	return found
