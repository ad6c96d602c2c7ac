"""The shared library, by the declarations that the public headers were printed to."""
import os
import pathlib

import cffi

_here = pathlib.Path(__file__).parent


def _open():
	"""TOUCHSTONE_LIBRARY, else what the loader finds, else what stands where this package was installed with it."""
	soname = (_here / "soname").read_text().strip()
	named = os.environ.get("TOUCHSTONE_LIBRARY")
	tried = [named] if named else [soname, str(_here.parents[2] / soname)]
	for path in tried:
		try:
			return ffi.dlopen(path)
		except OSError as error:
			why = error
	raise ImportError(f"touchstone: {why}; TOUCHSTONE_LIBRARY can name the library")


ffi = cffi.FFI()
ffi.cdef((_here / "declarations.h").read_text() + "void free(void *memory);\n")
lib = _open()
