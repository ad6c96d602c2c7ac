"""touchstone in Python: runs, comparisons and replays in memory, buffers as NumPy arrays without copies.

	import touchstone
	context = touchstone.Context()
	scene = context.open_scene("atrium", {"width": 480, "height": 270})
	reference = context.run(scene, "reflections", "epr", {"width": 480, "height": 270})
	port = reference.candidate()
	port["eye.depth_triangle"] = my_keys
	verdicts = context.replay("eye", reference, port)
	assert verdicts, verdicts.first.line

Parameters are dictionaries from names, as of `touchstone list params`, to values. What fails raises touchstone.Error with
the line that the command would print. The public headers, include/touchstone/, say what each function does."""
import ast
import collections.abc
import functools
import json
import types

import numpy as np

from ._library import ffi, lib


class Error(Exception):
	"""What could not be done, and why, in one line."""


def _check(status):
	if status == lib.TS_ERROR or status == lib.TS_SKIPPED:
		raise Error(_text(lib.ts_error_message()))
	return status == lib.TS_OK


def _text(pointer):
	return ffi.string(pointer).decode() if pointer != ffi.NULL else None


def _bytes(text):
	if text is None:
		return ffi.NULL
	if "\0" in str(text):
		raise Error(f"{text!r}: a text without the character 0 would be right")
	return ffi.new("char[]", str(text).encode())


def _struct(pointer):
	"""A struct of the library's as a namespace."""
	fields = {}
	for name, field in ffi.typeof(pointer).item.fields:
		value = getattr(pointer, name)
		fields[name] = _text(value) if field.type is ffi.typeof("const char *") else value
	return types.SimpleNamespace(**fields)


def _rows(at):
	"""All rows of a table that `at` walks."""
	rows = []
	while (row := at(len(rows))) != ffi.NULL:
		rows.append(_struct(row))
	return rows


def _options(kind, **members):
	"""(struct, what it points to) of a caller's options."""
	known = [name for name, _ in ffi.typeof(kind).fields]
	for name in members:
		if name not in known:
			raise TypeError(f"{name} is no option; there are {', '.join(known[1:])}")
	kept = {name: _bytes(value) if isinstance(value, str) else value for name, value in members.items() if value is not None}
	return ffi.new(kind + " *", {"bytes": ffi.sizeof(kind), **kept}), kept


def _made(kind, release, function, *arguments):
	"""What a function of the library makes, released when nobody has it any more."""
	handle = ffi.new(kind + " **")
	status = function(*[handle if argument is _made else argument for argument in arguments])
	_check(status)
	return ffi.gc(handle[0], release), status == lib.TS_OK


def _tree(tree):
	return json.loads(_text(ffi.gc(lib.ts_tree_json(tree), lib.free)))


def version():
	return _text(lib.ts_version())


@functools.lru_cache(None)
def backends():
	names = []
	while (name := lib.ts_backend_at(len(names))) != ffi.NULL:
		names.append(_text(name))
	return names


@functools.lru_cache(None)
def methods():
	return _rows(lib.ts_method_at)


def stages(effect, method):
	"""The stages of a method, in their order."""
	return _rows(lambda i: lib.ts_method_stage(_bytes(effect), _bytes(method), i))


@functools.lru_cache(None)
def parameters():
	return _rows(lib.ts_param_at)


@functools.lru_cache(None)
def buffers():
	"""All buffers by name; `dtype` is that of their elements."""
	fields = _rows(lib.ts_field_at)
	rows = {row.name: row for row in _rows(lib.ts_buffer_at)}
	for row in rows.values():
		members = [(f.name, _dtype(f.type), (f.count,)) if f.count > 1 else (f.name, _dtype(f.type))
		           for f in fields if f.record == row.element]
		row.dtype = np.dtype(members) if members else _dtype(row.element)
	return rows


@functools.lru_cache(None)
def primitives():
	"""All primitives that a port must compute with the same bits, by name. in_dtype and out_dtype are NumPy's, and their
	fields the columns; `shape` is that of the outputs."""
	rows = {row.name: row for row in _rows(lib.ts_vector_at)}
	for row in rows.values():
		row.in_dtype, row.out_dtype = (np.dtype(ast.literal_eval(text)) for text in (row.in_dtype, row.out_dtype))
		row.shape = tuple(row.shape[i] for i in range(row.n_dims))
		del row.inputs, row.outputs
	return rows


def _primitive(name):
	if name not in primitives():
		raise Error(f'there is no primitive "{name}"; primitives() has all')
	return primitives()[name]


def _dtype(scalar):
	return np.dtype(f"{scalar[0]}{int(scalar[1:]) // 8}")


_of_arrays = {"vertices": "scene.vertex", "triangles": "scene.triangle", "materials": "scene.material", "slots": "scene.slot",
              "lights": "scene.light", "objects": "scene.object", "surfels": "scene.surfel"}


def _array(array, dtype, n_dims, what):
	"""The array in C order. Another dtype, or another number of dimensions, is refused."""
	array = np.asarray(array)
	if array.dtype != dtype or array.ndim != n_dims:
		raise Error(f"{what}: {array.ndim} dimensions of {array.dtype}; {n_dims} of {dtype} would be right")
	return np.ascontiguousarray(array)


def _words(array):
	return ffi.cast("uint32_t *", array.ctypes.data)


def _places(options):
	"""ts_scene_options; places are sequences of numbers."""
	options = dict(options)
	for name in ("eye", "target", "lamp"):
		if options.get(name) is not None:
			if len(options[name]) != 3:
				raise Error(f"{name}: three numbers would be right")
			options[name] = ffi.new("float[3]", [float(x) for x in options[name]])
	if options.get("mirrors") is not None:
		options["n_mirrors"] = len(options["mirrors"])
		options["mirrors"] = ffi.new("float[][4]", [[float(x) for x in ball] for ball in options["mirrors"]])
	return _options("ts_scene_options", **options)


def _params(values):
	params, _ = _made("ts_params", lib.ts_params_free, lib.ts_params_make, _made)
	for name, value in (values or {}).items():
		_check(lib.ts_params_set(params, _bytes(name), _bytes(value)))
	return params


class Context:
	"""What computes. backend: one of backends(). say(line), progress(label, done, total) and cancelled(), which ends what
	runs where it returns true, are called meanwhile."""

	def __init__(self, backend=None, device=0, threads=0, no_fast_paths=False, say=None, progress=None, cancelled=None):
		self._callbacks = {
			"say": say and ffi.callback("void(void *, const char *)", lambda _, line: say(_text(line))),
			"progress": progress and ffi.callback("void(void *, const char *, uint64_t, uint64_t)",
			                                      lambda _, label, done, total: progress(_text(label), done, total)),
			"cancelled": cancelled and ffi.callback("int(void *)", lambda _: bool(cancelled())),
		}
		options, kept = _options("ts_context_options", backend=backend, device=device, threads=threads,
		                         no_fast_paths=int(no_fast_paths), **self._callbacks)
		self._handle, _ = _made("ts_context", lib.ts_context_close, lib.ts_context_open, _made, options)

	def open_scene(self, spec, params=None, **options):
		"""A built-in scene or a file; options are members of ts_scene_options, such as camera="circle" or eye=(0, 1, 2)."""
		wanted, kept = _places(options)
		handle, _ = _made("ts_scene", lib.ts_scene_free, lib.ts_scene_open, self._handle, _made, _bytes(spec),
		                  _params(params), wanted)
		return Scene(self, handle)

	def make_scene(self, params=None, name=None, images=(), options=None, **arrays):
		"""A scene of arrays of records: vertices, triangles, materials, slots, lights, objects, surfels, each of the
		dtype of buffers()["scene.vertex"] and so on. images: pairs of an array of rows of RGBA bytes, and whether its
		colours are coded as sRGB. options: as of open_scene."""
		members, kept = {"name": name}, []
		for what, array in arrays.items():
			element = buffers()[_of_arrays.get(what, "scene." + what)]
			array = _array(array, element.dtype, 1, what)
			kept.append(array)
			members[what] = ffi.cast(element.element + " *", array.ctypes.data)
			members["n_" + what] = len(array)
		pictures = [(_array(rgba, np.dtype("u1"), 3, "an image"), srgb) for rgba, srgb in images]
		if any(rgba.shape[2] != 4 for rgba, _ in pictures):
			raise Error("an image: 4 bytes a pixel would be right")
		members["images"] = ffi.new("ts_image_array[]", [(ffi.cast("uint8_t *", rgba.ctypes.data), rgba.shape[1], rgba.shape[0],
		                                                  int(srgb)) for rgba, srgb in pictures])
		members["n_images"] = len(pictures)
		given, texts = _options("ts_scene_arrays", **members)
		wanted, places = _places(options or {})
		handle, _ = _made("ts_scene", lib.ts_scene_free, lib.ts_scene_make, self._handle, _made, given, _params(params), wanted)
		return Scene(self, handle)

	def run(self, scene, effect, method, params=None, buffers=None, margins=False, arrival=False):
		"""Runs a method and keeps its buffers, or those that `buffers` names."""
		options, kept = _options("ts_run_options", buffers=buffers if buffers is None or isinstance(buffers, str) else ",".join(buffers), margins=int(margins),
		                         arrival=int(arrival))
		handle, _ = _made("ts_trace", lib.ts_trace_close, lib.ts_trace_run, self._handle, _made, scene._handle,
		                  _params(params), _bytes(effect), _bytes(method), options)
		return Trace(self, handle, scene)

	def write(self, folder, scene, effect, method, params=None, **options):
		"""Runs a method and writes its trace to a new folder; options are members of ts_write_options: margins, arrival and
		compress."""
		wanted, _ = _options("ts_write_options", **{name: int(value) for name, value in options.items()})
		_check(lib.ts_trace_write(self._handle, _bytes(folder), scene._handle, _params(params), _bytes(effect), _bytes(method), wanted))

	def open(self, folder):
		"""Opens the trace in a folder."""
		handle, _ = _made("ts_trace", lib.ts_trace_close, lib.ts_trace_open, self._handle, _made, _bytes(folder))
		return Trace(self, handle)

	def golden(self, folder):
		"""Runs again what a golden is of, and compares: a namespace, of which `same` is True or False."""
		judged = ffi.new("ts_golden_judged *", {"bytes": ffi.sizeof("ts_golden_judged")})
		same = _check(lib.ts_golden_check(self._handle, judged, _bytes(folder)))
		names = ("effect", "method", "scene", "stage", "buffer", "text")
		return types.SimpleNamespace(same=same, **{name: _text(getattr(judged, name)) for name in names})

	def vectors(self, primitive):
		"""(inputs, outputs) of a primitive: the inputs that a port is to compute, and what is right."""
		row = _primitive(primitive)
		inputs, outputs = np.empty(row.items, row.in_dtype), np.empty(row.shape, row.out_dtype)
		_check(lib.ts_vector_words(self._handle, _words(inputs), _words(outputs), _bytes(primitive)))
		return inputs, outputs

	def check_vectors(self, primitive, found):
		"""The verdict on what a port computed of a primitive's inputs: a namespace of the members of ts_vector_judged, and
		of `same`, which is True or False."""
		row = _primitive(primitive)
		found = _array(found, row.out_dtype, len(row.shape), primitive)
		if found.shape != row.shape:
			raise Error(f"{primitive}: shape {found.shape}; {row.shape} would be right")
		judged = ffi.new("ts_vector_judged *", {"bytes": ffi.sizeof("ts_vector_judged")})
		same = _check(lib.ts_vector_check(self._handle, judged, _bytes(primitive), _words(found)))
		return types.SimpleNamespace(same=same, **vars(_struct(judged)))

	def page(self, ppd=0, probes=None):
		"""An empty page of HTML."""
		options, _ = _options("ts_html_options", ppd=ppd, probes=probes, probes_said=int(probes is not None))
		return Page(self, _made("ts_html", lib.ts_html_close, lib.ts_html_open, self._handle, _made, options)[0])

	def compare(self, reference, candidate, mask=None, **options):
		"""Verdicts of a candidate; options are members of ts_compare_options, such as ulp=1 or forced=True. mask: an
		array of rows of pixels, which are judged where it is not 0."""
		if mask is not None:
			mask = _array(np.asarray(mask) != 0, np.dtype(bool), 2, "mask").view(np.uint8)
			options.update(mask=ffi.cast("uint8_t *", mask.ctypes.data), mask_height=mask.shape[0], mask_width=mask.shape[1])
		wanted, kept = _options("ts_compare_options", **{n: int(v) if isinstance(v, bool) else v for n, v in options.items()})
		return Verdicts(*_made("ts_verdicts", lib.ts_verdicts_free, lib.ts_compare, self._handle, _made, reference._handle,
		                       candidate._handle, wanted))

	def marks(self, buffer, reference, candidate, **options):
		"""Which elements of a buffer differ, as an array of its shape."""
		wrong = np.zeros(reference[buffer].shape, np.uint8)
		wanted, kept = _options("ts_compare_options", **options)
		_check(lib.ts_compare_marks(self._handle, ffi.cast("uint8_t *", wrong.ctypes.data), wrong.size, _bytes(buffer),
		                            reference._handle, candidate._handle, wanted))
		return wrong != 0

	def replay(self, stage, reference, candidate=None):
		"""Verdicts of one stage's outputs, given the candidate's own inputs."""
		return Verdicts(*_made("ts_verdicts", lib.ts_verdicts_free, lib.ts_replay, self._handle, _made, _bytes(stage),
		                       reference._handle, candidate._handle if candidate is not None else ffi.NULL, ffi.NULL))

	def replayed(self, stage, reference, candidate=None):
		"""What the stage makes of the candidate's own inputs, as a trace."""
		handle, _ = _made("ts_trace", lib.ts_trace_close, lib.ts_trace_replay, self._handle, _made, _bytes(stage),
		                  reference._handle, candidate._handle if candidate is not None else ffi.NULL)
		return Trace(self, handle)


class Scene:
	def __init__(self, context, handle):
		self._context, self._handle = context, handle


class Trace(collections.abc.Mapping):
	"""The buffers of a run, of a folder or of a candidate, by name. Arrays are views: of a run and of a folder read only."""

	def __init__(self, context, handle, scene=None, writable=False):
		self._context, self._handle, self._scene, self._writable = context, handle, scene, writable
		self._given = {}

	def __getitem__(self, name):
		if name not in self:
			raise KeyError(name)
		view = lib.ts_trace_buffer(self._handle, _bytes(name))
		if view == ffi.NULL:
			raise Error(_text(lib.ts_error_message()))
		dtype, shape = buffers()[name].dtype, tuple(view.shape[i] for i in range(view.n_dims))
		return np.asarray(_View((self, self._given.get(name)), int(ffi.cast("uintptr_t", view.data)), shape, dtype))

	def __setitem__(self, name, array):
		"""Gives a candidate a buffer; an array that is contiguous, of the buffer's dtype, is not copied."""
		if not self._writable:
			raise Error(f"{name}: a trace cannot be changed; candidate() makes one that can")
		if name not in buffers():
			raise Error(f'there is no buffer "{name}"')
		array = np.asarray(array)
		if array.dtype != buffers()[name].dtype:
			raise Error(f"{name}: dtype {array.dtype}; {buffers()[name].dtype} would be right")
		array = np.ascontiguousarray(array)
		shape = ffi.new("uint64_t[]", array.shape)
		_check(lib.ts_trace_put(self._handle, _bytes(name), array.ndim, shape, ffi.cast("void *", array.ctypes.data),
		                        array.nbytes))
		self._given[name] = array

	def __contains__(self, name):
		return lib.ts_trace_has(self._handle, _bytes(name)) != 0

	def __iter__(self):
		return (name for name in buffers() if name in self)

	def __len__(self):
		return sum(1 for _ in self)

	def candidate(self, arrival=False):
		"""An empty candidate of the same method and parameters."""
		handle, _ = _made("ts_trace", lib.ts_trace_close, lib.ts_trace_candidate, self._context._handle, _made, self._handle,
		                  int(arrival))
		return Trace(self._context, handle, writable=True)

	def save(self, folder, producer=None):
		"""Writes the buffers and a trace.json to a new folder; producer: who made them."""
		_check(lib.ts_trace_save(self._context._handle, self._handle, _bytes(folder), _bytes(producer)))

	def digest(self, name):
		"""The SHA-256 of the buffer's file."""
		digits = ffi.new("char[65]")
		_check(lib.ts_trace_digest(self._handle, _bytes(name), digits))
		return _text(digits)

	def counter(self, name):
		return lib.ts_trace_counter(self._handle, _bytes(name))

	def probe_pixel(self, x, y, view=None):
		"""Why a pixel of the eye, or a texel of a view, is what it is."""
		return self._ask(lib.ts_probe_pixel, x, y, _bytes(view))

	def probe_triangle(self, triangle):
		return self._ask(lib.ts_probe_triangle, triangle)

	def probe_point(self, point):
		return self._ask(lib.ts_probe_point, point)

	def explain(self, stage, inputs=None, other=None, **question):
		"""What one item of a stage computes, line by line, as `explain --json` has it; the question is members of
		ts_explain_options, such as buffer="splat.depth_index", element=12."""
		if "item" in question:
			question["item_said"] = 1
		options, kept = _options("ts_explain_options", stage=stage, **question)
		tree, _ = _made("ts_tree", lib.ts_tree_free, lib.ts_explain_item, self._context._handle, _made, options, self._handle,
		                *[side._handle if side is not None else ffi.NULL for side in (inputs, other)])
		return _tree(tree)

	def _ask(self, function, *question):
		return _tree(_made("ts_tree", lib.ts_tree_free, function, self._context._handle, _made, self._handle, *question)[0])


class _View:
	"""Memory that stays while an array of it does."""

	def __init__(self, kept, address, shape, dtype):
		self.kept = kept
		self.__array_interface__ = {"version": 3, "data": (address, True), "shape": shape, "typestr": dtype.str,
		                            "descr": dtype.descr}


class Verdicts(collections.abc.Sequence):
	"""How each buffer was judged. True if nothing differs; else `first` is the first divergence."""

	def __init__(self, handle, same):
		self._handle, self._same = handle, same
		self._rows = _rows(lambda i: lib.ts_verdicts_at(handle, i))
		first = lib.ts_verdicts_first(handle)
		self.first = _struct(first) if first != ffi.NULL else None

	def __bool__(self):
		return self._same

	def __getitem__(self, i):
		return self._rows[i]

	def __len__(self):
		return len(self._rows)

	def differences(self, i):
		"""Those of row i, as many as the option `first` asked for."""
		return _rows(lambda k: lib.ts_verdicts_difference(self._handle, i, k))

	def fields(self, i):
		"""How many elements of row i differ in which field of their records."""
		return {row.field: row.n_different for row in _rows(lambda k: lib.ts_verdicts_field(self._handle, i, k))}

	def tree(self):
		"""All that differs, as `compare --json` has it."""
		return _tree(ffi.gc(lib.ts_verdicts_tree(self._handle), lib.ts_tree_free))


class Page:
	"""A page of HTML, as `touchstone report` writes it."""

	def __init__(self, context, handle):
		self._context, self._handle = context, handle

	def add(self, trace):
		"""Adds a trace: its picture, and what it says of itself."""
		_check(lib.ts_html_add_trace(self._handle, trace._handle))

	def add_folder(self, folder):
		"""Adds what render or compare wrote to a folder."""
		_check(lib.ts_html_add_folder(self._handle, _bytes(folder)))

	def add_picture(self, name, rgb, source=""):
		"""Adds rows of pixels of 8-bit sRGB."""
		rgb = _array(rgb, np.dtype("u1"), 3, name)
		if rgb.shape[2] != 3:
			raise Error(f"{name}: 3 bytes a pixel would be right")
		_check(lib.ts_html_add_picture(self._handle, _bytes(name), _bytes(source), ffi.cast("uint8_t *", rgb.ctypes.data),
		                               rgb.shape[1], rgb.shape[0]))

	def add_verdicts(self, verdicts, reference, candidate, **options):
		"""Adds how a candidate was judged, both sides being added already; options as of that comparison."""
		wanted, kept = _options("ts_compare_options", **options)
		_check(lib.ts_html_add_verdicts(self._handle, verdicts._handle, reference._handle, candidate._handle, wanted, ffi.NULL))

	def write(self, path):
		_check(lib.ts_html_write(self._handle, _bytes(path)))
