"""Writes a glTF file whose nodes move, and says in double precision where: animated.py write FILE [DEFECT],
animated.py check TRACE FRAME [shorts], which compares scene.motion, scene.path and pose.vertex of a trace. The file
`still` has no animation, that of `shorts` has rotations of normalized integers."""
import base64
import json
import struct
import sys

import numpy as np

FRAMES = 38 # of 1.25 seconds, 30 a second
TURN_TIMES = [0.125, 0.5, 1.25]
SHORTS = [[0, 19660, 0, 26214], [0, -19660, 0, 26214], [-16384, 16384, -16384, -16383]] # about TURNS
TURNS = [[0, 0.6, 0, 0.8], [0, -1.8, 0, 2.4], [-0.5, 0.5, -0.5, -0.5]] # of any length, and not on the shorter arc
WAY_TIMES = [0, 0.4, 1]
WAY = [[0, 0, 0], [1, 2, 0], [2, -1, 1], [0, 3, 1], [0.5, 1, 0], [-1, 0, 2], [3, 0, 0], [0, 1.5, 0], [9, 9, 9]]
SIZE_TIMES = [0, 0.7]
SIZES = [[1, 2, 0.5], [-1, 1, 1]]
EYE_TIMES = [0, 1]
EYES = [[0, 1, 6], [2, 1.5, 6]]
PIVOT = [1, 0.5, 0]
BALL = [2, 0, 0.5]


def node_matrix(translation, rotation, scale):
	x, y, z, w = np.array(rotation, float) / np.linalg.norm(rotation)
	turn = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
	                 [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
	                 [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
	matrix = np.eye(4)
	matrix[:3, :3] = turn * np.array(scale, float)
	matrix[:3, 3] = translation
	return matrix


def key_of(times, t):
	k = max(np.searchsorted(times, t, side="right") - 1, 0)
	return (k, 0) if t <= times[0] or k + 1 == len(times) else (k, (t - times[k]) / (times[k + 1] - times[k]))


def slerp(t):
	k, s = key_of(TURN_TIMES, t)
	unit = [np.array(q, float) / np.linalg.norm(q) for q in TURNS]
	if s == 0:
		return unit[k]
	dot = unit[k] @ unit[k + 1]
	angle = np.arccos(min(abs(dot), 1))
	if angle < 1e-6:
		return unit[k]
	return (np.sin((1 - s) * angle) / np.sin(angle) * unit[k]
	        + np.sign(dot) * np.sin(s * angle) / np.sin(angle) * unit[k + 1])


def cubic(t):
	k, s = key_of(WAY_TIMES, t)
	into, value, out = [np.array(WAY[i::3], float) for i in range(3)]
	if s == 0:
		return value[k]
	apart = WAY_TIMES[k + 1] - WAY_TIMES[k]
	return ((2 * s**3 - 3 * s**2 + 1) * value[k] + apart * (s**3 - 2 * s**2 + s) * out[k] +
	        (3 * s**2 - 2 * s**3) * value[k + 1] + apart * (s**3 - s**2) * into[k + 1])


def places(frame):
	"""World matrices of the arm, of the ball below the pivot, which is its object's own, and the eye."""
	t = frame % FRAMES / 30
	pivot = node_matrix(PIVOT, slerp(t), [1, 1, 1])
	arm = pivot @ node_matrix(cubic(t), [0, 0, 0, 1], SIZES[key_of(SIZE_TIMES, t)[0]])
	k, s = key_of(EYE_TIMES, t)
	eye = np.array(EYES[k]) if s == 0 else (1 - s) * np.array(EYES[k]) + s * np.array(EYES[k + 1])
	return arm, pivot, eye


class file:
	def __init__(self):
		self.data, self.views, self.accessors = b"", [], []

	def put(self, rows, kind, form="f", component=5126):
		rows = np.array(rows)
		data = struct.pack(f"<{rows.size}{form}", *rows.ravel())
		self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)})
		self.data += data + bytes(-len(data) % 4)
		self.accessors.append({"bufferView": len(self.views) - 1, "componentType": component, "count": len(rows),
		                       "type": kind})
		return len(self.accessors) - 1


def tetrahedron(f, size):
	points = [[0, 0, 0], [size, 0, 0], [0, size, 0], [0, 0, size]]
	return {"attributes": {"POSITION": f.put(points, "VEC3"),
	                       "NORMAL": f.put([[0, 0, 1], [1, 0, 0], [0, 1, 0], [0.6, 0.8, 0]], "VEC3")},
	        "indices": f.put([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3], "SCALAR", "H", 5123)}


def document():
	f = file()
	floor = {"attributes": {"POSITION": f.put([[-8, -2, -8], [-8, -2, 8], [8, -2, 8], [8, -2, -8]], "VEC3")},
	         "indices": f.put([0, 1, 2, 0, 2, 3], "SCALAR", "H", 5123)}
	samplers = [{"input": f.put(TURN_TIMES, "SCALAR"), "output": f.put(TURNS, "VEC4"), "interpolation": "LINEAR"},
	            {"input": f.put(WAY_TIMES, "SCALAR"), "output": f.put(WAY, "VEC3"), "interpolation": "CUBICSPLINE"},
	            {"input": f.put(SIZE_TIMES, "SCALAR"), "output": f.put(SIZES, "VEC3"), "interpolation": "STEP"},
	            {"input": f.put(EYE_TIMES, "SCALAR"), "output": f.put(EYES, "VEC3")}]
	channels = [{"sampler": i, "target": {"node": node, "path": path}}
	            for i, (node, path) in enumerate([(1, "rotation"), (2, "translation"), (2, "scale"),
	                                              (4, "translation")])]
	root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 4]}],
	        "nodes": [{"mesh": 0}, {"translation": PIVOT, "children": [2, 3]}, {"name": "arm", "mesh": 1},
	                  {"name": "ball", "mesh": 2, "translation": BALL, "scale": [-1, 1, 1]},
	                  {"name": "eye", "camera": 0}],
	        "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}],
	        "meshes": [{"primitives": [floor]}, {"primitives": [tetrahedron(f, 1)]},
	                   {"primitives": [tetrahedron(f, 1.5)]}],
	        "animations": [{"name": "turn", "channels": channels, "samplers": samplers},
	                       {"name": "rest", "channels": channels[3:], "samplers": samplers}]}
	return root, f


def damage(root, f, defect):
	"""Each a file that must be refused."""
	a = root["animations"][0]
	def times(values):
		a["samplers"][0]["input"] = f.put(values, "SCALAR")
	defects = {
		"nan": lambda: times([0, float("nan"), 1]), "unsorted": lambda: times([0, 1, 0.5]),
		"negative": lambda: times([-1, 0, 1]), "few": lambda: times([0, 1]), "long": lambda: times([0, 1, 1e30]),
		"range": lambda: a["samplers"][0].update(input=999), "sampler": lambda: a["channels"][0].update(sampler=9),
		"type": lambda: a["samplers"][0].update(output=a["samplers"][1]["output"]),
		"twice": lambda: a["channels"].append(a["channels"][0]),
		"matrix": lambda: (root["nodes"][1].pop("translation"),
		                   root["nodes"][1].update(matrix=np.eye(4).ravel().tolist())),
		"cycle": lambda: root["nodes"][2].update(children=[1]),
		"huge": lambda: a["samplers"][3].update(output=f.put([[0, 0, 0], [1e38, 0, 0]], "VEC3")),
		"zero": lambda: a["samplers"][0].update(output=f.put([[0, 0, 0, 1], [0, 0, 0, 0], [0, 0, 0, 1]], "VEC4")),
	}
	defects[defect]()


def write(path, defect=None):
	root, f = document()
	if defect == "still":
		del root["animations"]
	elif defect == "shorts":
		root["animations"][0]["samplers"][0]["output"] = f.put(SHORTS, "VEC4", "h", 5122)
		f.accessors[-1]["normalized"] = True
	elif defect:
		damage(root, f, defect)
	root["accessors"], root["bufferViews"] = f.accessors, f.views
	root["buffers"] = [{"byteLength": len(f.data), "uri": "data:application/octet-stream;base64," +
	                    base64.b64encode(f.data).decode()}]
	with open(path, "w") as out:
		json.dump(root, out)


def near(found, right, what):
	worst = np.abs(np.asarray(found, float) - right).max()
	if not worst < 4e-6 * max(1, np.abs(right).max()):
		sys.exit(f"{what}: {worst} off\n{found}\n{right}")


def check_motion(motion):
	assert motion.shape[0] == FRAMES and (motion["moves"][:, 0] == 0).all() and (motion["moves"][:, 3:] == 0).all()
	for frame in range(FRAMES):
		for place, right in zip(motion[frame, 1:3], places(frame)):
			near(place["linear"].reshape(3, 3), right[:3, :3], f"linear of frame {frame}")
			near(place["origin"], right[:3, 3], f"origin of frame {frame}")
			side = np.linalg.det(right[:3, :3])
			assert place["moves"] == (2 if side < 0 else 1)
			normal = np.linalg.inv(right[:3, :3]).T
			near(place["normal"].reshape(3, 3) / np.linalg.norm(place["normal"]), normal / np.linalg.norm(normal),
			     f"normals of frame {frame}")


def check(trace, frame):
	load = lambda name: np.load(f"{trace}/{name}.npy")
	check_motion(load("00-scene.motion"))
	path, view = load("00-scene.path"), load("01-eye.view")[0]
	assert len(path) == FRAMES
	for i in range(FRAMES):
		near(path["eye"][i], places(i)[2], f"eye of frame {i}")
	near(view["eye"], places(frame)[2], "eye.view")
	vertex, posed = load("00-scene.vertex"), load("02-pose.vertex")
	for object, matrix in zip((1, 2), places(frame)):
		rows = vertex["object"] == object
		assert rows.sum() == 4
		own = vertex["position"][rows].astype(float)
		near(posed["position"][rows], own @ matrix[:3, :3].T + matrix[:3, 3], f"vertices of object {object}")
		normals = vertex["normal"][rows] @ np.linalg.inv(matrix[:3, :3])
		near(posed["normal"][rows], normals / np.linalg.norm(normals, axis=1)[:, None], f"normals of object {object}")
	static = vertex["object"] == 0
	assert (posed[static] == vertex[static]).all() and static.sum() == 4


if __name__ == "__main__":
	if sys.argv[1] == "write":
		write(*sys.argv[2:])
	else:
		TURNS = SHORTS if sys.argv[4:] == ["shorts"] else TURNS
		check(sys.argv[2], int(sys.argv[3]))
