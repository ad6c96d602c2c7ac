"""The shared library, by the declarations that the public headers were printed to, and how its functions are called."""
from __future__ import annotations

import json
import os
import pathlib
import threading
import types
from collections.abc import Callable, Mapping
from typing import Any, Union

import cffi
import numpy as np

_here = pathlib.Path(__file__).parent

Path = Union[str, bytes, os.PathLike]
Row = types.SimpleNamespace  # the members of a struct of the headers, by their names


class Error(Exception):
	"""What could not be done, and why, in one line. kind: "argument", "file", "format", "memory", "device", "library"
	or "cancelled", the kinds of ts_kind."""
	__module__ = "touchstone"

	def __init__(self, message: str, kind: str = "argument") -> None:
		super().__init__(message)
		self.kind = kind


def _open() -> Any:
	"""TOUCHSTONE_LIBRARY, else the one of a wheel or of a build, else what the loader finds, else what stands where
	this package was installed with it."""
	soname = (_here / "soname").read_text().strip()
	own = [str(path) for path in (_here / soname, _here.parents[1] / "libtouchstone.so") if path.exists()]
	named = os.environ.get("TOUCHSTONE_LIBRARY")
	tried = [named] if named else own or [soname, str(_here.parents[2] / soname)]
	for path in tried:
		try:
			return ffi.dlopen(path)
		except OSError as error:
			why = str(error).partition(".  Additionally")[0]  # where else cffi looked
	raise ImportError(f"touchstone: {why}; TOUCHSTONE_LIBRARY can name the library")


ffi: Any = cffi.FFI()
ffi.cdef((_here / "declarations.h").read_text() + "void free(void *memory);\n")
lib = _open()


def failure() -> Error:
	"""The last one of the library."""
	kinds = ffi.typeof("ts_kind").elements
	return Error(text_of(lib.ts_error_message()), kinds[lib.ts_error_kind()].removeprefix("TS_KIND_").lower())


_here_raised = threading.local()  # raised: by a function that the library called on this thread


def has_raised() -> bool:
	return getattr(_here_raised, "raised", None) is not None


def callback(kind: str, function: Callable[..., Any], error: Any = None) -> Any:
	"""A function for the library to call. What it raises, KeyboardInterrupt too, `check` raises; error: its value
	then."""
	def keep(_: type, raised: BaseException, __: Any) -> None:
		if not has_raised():
			_here_raised.raised = raised
	return ffi.callback(kind, function, error=error, onerror=keep)


def check(status: int) -> bool:
	raised, _here_raised.raised = getattr(_here_raised, "raised", None), None
	if raised is not None:
		raise raised
	if status in (lib.TS_ERROR, lib.TS_SKIPPED):
		raise failure()
	return status == lib.TS_OK


def text_of(pointer: Any) -> Any:
	"""A str; None for NULL."""
	return ffi.string(pointer).decode(errors="backslashreplace") if pointer != ffi.NULL else None


def text_for(text: object) -> Any:
	if text is None:
		return ffi.NULL
	return _chars(str(text).encode(errors="surrogateescape"), text)  # a name from os.listdir may have these


def path_for(path: Path) -> Any:
	return _chars(os.fsencode(path), path)


def _chars(data: bytes, said: object) -> Any:
	if b"\0" in data:
		raise Error(f"{said!r}: a text without the character 0 would be right")
	return ffi.new("char[]", data)


def struct_of(given: Any) -> Row:
	"""A struct of the library's, or what a pointer leads to."""
	kind, members = ffi.typeof(given), {}
	for name, field in (kind.item if kind.kind == "pointer" else kind).fields:
		value = getattr(given, name)
		is_text = field.type.kind in ("pointer", "array") and field.type.item.cname == "char"
		members[name] = text_of(value) if is_text else value
	return Row(**members)


def rows_of(at: Callable[[int], Any], row: Callable[[Any], Any] = struct_of) -> list:
	"""All rows of a table that `at` walks."""
	found: list = []
	while (one := at(len(found))) != ffi.NULL:
		found.append(row(one))
	return found


def filled(kind: str) -> Any:
	"""A struct for the library to fill in."""
	return ffi.new(kind + " *", {"bytes": ffi.sizeof(kind)})


def options_for(kind: str, **members: Any) -> tuple[Any, dict]:
	"""(struct, what it points to) of a caller's options."""
	known = [name for name, _ in ffi.typeof(kind).fields]
	for name in members:
		if name not in known:
			raise TypeError(f"{name} is no option; there are {', '.join(known[1:])}")
	kept = {name: text_for(value) if isinstance(value, str) else value
	        for name, value in members.items() if value is not None}
	return ffi.new(kind + " *", {"bytes": ffi.sizeof(kind), **kept}), kept


def made(kind: str, release: Any, function: Any, *arguments: Any) -> tuple[Any, bool]:
	"""(handle, whether all is the same): what a function of the library makes, in the place of the argument `made`. It
	is released when nobody has the handle any more."""
	handle = ffi.new(kind + " **")
	status = function(*[handle if argument is made else argument for argument in arguments])
	return ffi.gc(handle[0], release), check(status)


def tree_of(handle: Any) -> dict:
	return json.loads(text_of(ffi.gc(lib.ts_tree_json(handle), lib.free)))


def params_for(values: Mapping[str, object] | None) -> Any:
	params, _ = made("ts_params", lib.ts_params_free, lib.ts_params_make, made)
	for name, value in (values or {}).items():
		check(lib.ts_params_set(params, text_for(name), text_for(value)))
	return params


def in_order(array: Any, dtype: Any, n_dims: int, what: str) -> np.ndarray:
	"""The array in C order. Another dtype, or another number of dimensions, is refused."""
	array = np.asarray(array)
	if array.dtype != dtype or array.ndim != n_dims:
		raise Error(f"{what}: {array.ndim} dimensions of {array.dtype}; {n_dims} of {np.dtype(dtype)} would be right")
	return np.ascontiguousarray(array)


def pointer(kind: str, array: np.ndarray | None) -> Any:
	"""To the elements, which the caller keeps; NULL for None."""
	return ffi.cast(kind + " *", array.ctypes.data) if array is not None else ffi.NULL


class _View:
	"""Memory that stays while an array of it does."""

	def __init__(self, kept: Any, address: int, shape: tuple, dtype: np.dtype, writable: bool):
		self.kept = kept
		self.__array_interface__ = {"version": 3, "data": (address, not writable), "shape": shape, "typestr": dtype.str,
		                            "descr": dtype.descr}


def view_of(data: Any, shape: tuple, dtype: Any, kept: Any, writable: bool = False) -> np.ndarray:
	"""An array of the library's memory, which `kept` owns."""
	address = int(ffi.cast("uintptr_t", data))
	return np.asarray(_View(kept, address, shape, np.dtype(dtype), writable))
