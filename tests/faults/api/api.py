"""A run and its comparison through the package for Python, for tests/faults/commands.txt: api.py IN. Only their
allocations count. Any exception of Python is a good end, after which the same works when memory is back."""
import ctypes
import sys

import touchstone

PARAMETERS = {"width": 16, "height": 16, "reflectors.count": 1, "cube.max_px": 16}
library = ctypes.CDLL(None)
begin, end = (getattr(library, name, None) for name in ("ts_fault_begin", "ts_fault_end"))
context = touchstone.Context(threads=1)
scene = context.open_scene(sys.argv[1] + "/triangle.gltf", PARAMETERS)


def first_line():
	reference = context.run(scene, "reflections", "epr", PARAMETERS)
	port = reference.candidate()
	port["image.srgb"] = ~reference["image.srgb"]
	return context.compare(reference, port, stages="image", ignore="image.radiance").first.line


failed = None
if begin is not None:
	begin()
try:
	line = first_line()
except Exception as error:
	failed = error
if end is not None:
	end()
if failed is not None:
	print("touchstone: memory:", repr(failed).replace("\n", " "), file=sys.stderr)
	line = first_line()
with open("sum", "w", encoding="utf-8") as out:
	out.write(line)
sys.exit(0 if failed is None else 2)
