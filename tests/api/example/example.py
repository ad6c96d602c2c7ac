"""As example.c, in Python: a wrong bit in a port's stage, found alone and given the port's own inputs."""
import numpy as np
import touchstone

parameters = {"width": 96, "height": 54}
records = touchstone.buffers()
vertices = np.zeros(4, records["scene.vertex"].dtype)
vertices["position"] = [(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)]
vertices["normal"] = (0, 1, 0)
vertices["colour"] = 1
triangles = np.zeros(2, records["scene.triangle"].dtype)
triangles["vertex"] = [(0, 1, 2), (0, 2, 3)]
triangles["material"] = 0xffffffff

context = touchstone.Context()
scene = context.make_scene(parameters, vertices=vertices, triangles=triangles)
reference = context.run(scene, "reflections", "epr", parameters)

keys = reference["eye.depth_triangle"].copy()
keys[27, 48] ^= np.uint64(1 << 32)
port = reference.candidate()
port["eye.depth_triangle"] = keys
print(context.compare(reference, port).first.line)
print(context.replay("eye", reference, port).first.line)
