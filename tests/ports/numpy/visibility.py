"""Stage visibility: one bit a triangle and cube face.

in: pose.vertex, scene.triangle, scene.material, scene.object, resize.face   out: visibility.bits"""
import numpy

from contract import cross, dot, f32, flush, u32, u64
from cube import to_view

DOUBLE_SIDED = 1


def outside_plane(a, b, c, near, broken):
	"""All three corners beyond one and the same of five planes, which belong to the inside."""
	beyond = numpy.greater_equal if broken == 1 else numpy.greater
	out = numpy.zeros(len(a), bool)
	for axis in (0, 1):
		for sign in (f32(1), f32(-1)):
			out |= numpy.logical_and.reduce([beyond(sign * p[:, axis], p[:, 2]) for p in (a, b, c)])
	return out | ((a[:, 2] < near) & (b[:, 2] < near) & (c[:, 2] < near))


def inside_enlarged(p):
	reach = f32(1.2) * p[:, 2]
	return (p[:, 2] > 0) & (abs(p[:, 0]) <= reach) & (abs(p[:, 1]) <= reach)


def run(trace, broken=0):
	vertices, triangles = trace["pose.vertex"], trace["scene.triangle"]
	cubes = trace["resize.face"]
	position = vertices["position"][triangles["vertex"]]
	corner = [position[:, k] for k in range(3)]
	normal = cross(corner[1] - corner[0], corner[2] - corner[0])
	whole = flush(dot(normal, normal)) > 0
	both_sides = (trace["scene.material"]["flags"][triangles["material"]] & u32(DOUBLE_SIDED)) != 0
	own = trace["scene.object"]["reflector"][vertices["object"][triangles["vertex"][:, 0]]]
	words = numpy.zeros((len(triangles), (6 * len(cubes) + 63) // 64), u64)
	for r, cube in enumerate(cubes):
		if cube["n"] == 0:
			continue
		facing = flush(dot(normal, cube["centre"] - corner[0])) > 0
		asked = whole & (both_sides | facing | (broken == 2)) & (own != r)
		for face in range(6):
			a, b, c = (to_view(face, v - cube["centre"]) for v in corner)
			if trace.params.get("visibility", "plane") == "vertex":
				seen = inside_enlarged(a) | inside_enlarged(b) | inside_enlarged(c)
			else:
				seen = ~outside_plane(a, b, c, cube["near"], broken)
			bit = 6 * r + face
			words[:, bit >> 6] |= (asked & seen).astype(u64) << u64(bit & 63)
	return {"visibility.bits": words}
