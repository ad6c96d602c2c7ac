#!/usr/bin/env python3
# scenes.py DIR: writes scenes whose first picture is hard to place, as .gltf files with a .bin each.
import json, math, os, struct, sys


class Mesh:
    def __init__(self):
        self.positions, self.indices = [], []

    def quad(self, corners):
        first = len(self.positions)
        self.positions += corners
        self.indices += [first, first + 1, first + 2, first, first + 2, first + 3]

    # Faces look outwards, or with `inside` inwards.
    def box(self, low, high, inside=False, without=()):
        for axis in range(3):
            for side in (0, 1):
                if (axis, side) in without:
                    continue
                u, v = (axis + 1) % 3, (axis + 2) % 3
                corners = []
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p = [0, 0, 0]
                    p[axis] = (low, high)[side][axis]
                    p[u] = (low, high)[a][u]
                    p[v] = (low, high)[b][v]
                    corners.append(p)
                self.quad(corners if (side == 1) != inside else corners[::-1])

    def ball(self, centre, radius, n=24):
        first = len(self.positions)
        for j in range(n + 1):
            for i in range(2 * n):
                t, p = math.pi * j / n, math.pi * i / n
                d = (math.sin(t) * math.cos(p), math.cos(t), math.sin(t) * math.sin(p))
                self.positions.append([c + radius * x for c, x in zip(centre, d)])
        for j in range(n):
            for i in range(2 * n):
                a, b = first + j * 2 * n + i, first + j * 2 * n + (i + 1) % (2 * n)
                self.indices += [a, b, b + 2 * n, a, b + 2 * n, a + 2 * n]


def write(folder, name, meshes):
    data, views, accessors, primitives, materials = b"", [], [], [], []
    for mesh, colour in meshes:
        positions = b"".join(struct.pack("<3f", *p) for p in mesh.positions)
        indices = struct.pack("<%dI" % len(mesh.indices), *mesh.indices)
        low = [min(struct.unpack("<f", struct.pack("<f", p[k]))[0] for p in mesh.positions) for k in range(3)]
        high = [max(struct.unpack("<f", struct.pack("<f", p[k]))[0] for p in mesh.positions) for k in range(3)]
        for part in (positions, indices):
            views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
            data += part
        accessors.append({"bufferView": len(views) - 2, "componentType": 5126, "count": len(mesh.positions),
                          "type": "VEC3", "min": low, "max": high})
        accessors.append({"bufferView": len(views) - 1, "componentType": 5125, "count": len(mesh.indices),
                          "type": "SCALAR"})
        primitives.append({"attributes": {"POSITION": len(accessors) - 2}, "indices": len(accessors) - 1,
                           "material": len(materials)})
        materials.append({"pbrMetallicRoughness": {"baseColorFactor": colour + [1], "metallicFactor": 0}})
    with open(os.path.join(folder, name + ".bin"), "wb") as file:
        file.write(data)
    gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": primitives}], "materials": materials, "accessors": accessors,
            "bufferViews": views, "buffers": [{"uri": name + ".bin", "byteLength": len(data)}]}
    with open(os.path.join(folder, name + ".gltf"), "w") as file:
        json.dump(gltf, file)


# A furnished room with one way out, its floor at y; lengths times s.
def room(x, y, z, s):
    shell, things = Mesh(), Mesh()
    at = lambda a, b, c: [x + a * s, y + b * s, z + c * s]
    shell.box(at(-4, 0, -3), at(4, 3, 3), inside=True)
    shell.box(at(-4.2, 0, -3.2), at(4.2, 3.2, 3.2), without=((1, 0),))
    things.box(at(-1, 0, -0.7), at(1, 0.8, 0.7), without=((1, 0),))
    things.box(at(-3.9, 0, -2.9), at(-3.2, 2, -1))
    things.box(at(2.8, 0, 1), at(3.8, 0.5, 2.6))
    things.ball(at(0.2, 1.1, 0), 0.3 * s)
    return [(shell, [0.7, 0.7, 0.65]), (things, [0.6, 0.35, 0.2])]


def main(folder):
    ground = Mesh()
    ground.quad([[-2000, -5.01, 6000], [8000, -5.01, 6000], [8000, -5.01, -4000], [-2000, -5.01, -4000]])
    write(folder, "far_room", room(3000, -5, 1200, 1) + [(ground, [0.3, 0.4, 0.3])])
    closed, model = Mesh(), Mesh()
    closed.box([-6, 0, -2], [-2, 3, 2])
    closed.box([-5.9, 0.1, -1.9], [-2.1, 2.9, 1.9], inside=True)
    model.ball([2, 1.5, 0], 1.5)
    model.box([1, -0.5, -1], [3, 0.2, 1])
    write(folder, "closed_box", [(closed, [0.5, 0.5, 0.6]), (model, [0.8, 0.3, 0.2])])
    write(folder, "millimetres", room(0, 0, 0, 1000))
    thing = Mesh()
    thing.ball([0, 1, 0], 1)
    thing.box([-0.3, -1, -0.3], [0.3, 0.1, 0.3])
    plain = Mesh()
    plain.quad([[-400, -1, 400], [400, -1, 400], [400, -1, -400], [-400, -1, -400]])
    write(folder, "model", [(thing, [0.8, 0.7, 0.3])])
    write(folder, "model_on_ground", [(thing, [0.8, 0.7, 0.3]), (plain, [0.4, 0.4, 0.4])])


main(sys.argv[1])
