"""touchstone in Python: runs, comparisons and replays in memory, buffers as NumPy arrays without copies.

	import touchstone
	context = touchstone.Context()
	scene = context.open_scene("atrium", {"width": 480, "height": 270})
	reference = context.run(scene, "reflections", "epr", {"width": 480, "height": 270})

A stage of one's own in place of the method's: the later stages run on from it, to the image.

	mine = reference["points.record"].copy()
	mine["length"] *= 0.5
	trace = context.continue_from(reference, {"points.record": mine})
	touchstone.metrics(reference["image.srgb"], trace["image.srgb"]).psnr

A port's stage, judged given the port's own inputs:

	port = reference.candidate()
	port["eye.depth_triangle"] = my_keys
	verdicts = context.replay("eye", reference, port)
	assert verdicts, verdicts.first.line

A picture against ground truth by rays:

	truth = context.truth(scene, "reflections", "B", {"width": 480, "height": 270})
	touchstone.light_metrics(truth.radiance, reference["image.radiance"]).relative

Parameters are dictionaries from names, as of `touchstone list params`, to values. A path is a str, bytes or a
pathlib.Path. What fails raises touchstone.Error with the line that the command would print. The public headers,
include/touchstone/, say what each function does.

A process that was forked, as those of multiprocessing.Pool are, opens a Context of its own; it computes with one
thread if its parent had more."""
from __future__ import annotations

import collections.abc
import json
import os
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from ._library import (Error, Path, Row, callback, check, failure, ffi, filled, has_raised, in_order, lib, made,
                       options_for, params_for, path_for, pointer, rows_of, struct_of, text_for, text_of, tree_of,
                       view_of)
from ._pictures import (crumbs, decode_image, encode_exr, encode_png, estimate_metrics, flicker, light_metrics,
                        marks_for, metrics, read_image, read_image_bytes, write_exr, write_png)
from ._tables import (backends, buffers, builtins, devices, float_passes, float_text, methods, parameters, primitive_of,
                      primitives, probes, settings, sizes, stages, truths, version)

__all__ = ["Context", "Error", "Page", "Rendering", "Scene", "Trace", "Verdicts", "backends", "buffers", "builtins",
           "crumbs", "decode_image", "devices", "encode_exr", "encode_png", "estimate_metrics", "flicker",
           "float_passes", "float_text", "light_metrics", "methods", "metrics", "parameters", "primitives", "probes",
           "read_image", "read_image_bytes", "settings", "sizes", "stages", "truths", "version", "write_exr",
           "write_png"]

Params = Mapping[str, object]

_of_arrays = {"vertices": "scene.vertex", "triangles": "scene.triangle", "materials": "scene.material",
              "slots": "scene.slot", "lights": "scene.light", "objects": "scene.object", "surfels": "scene.surfel"}


def _places(options: Mapping[str, Any]) -> tuple[Any, dict]:
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
	if options.get("path") is not None:
		options["path"] = path_for(options["path"])
	return options_for("ts_scene_options", **options)


def _relaxed(options: Mapping[str, Any], mask: np.ndarray | None = None) -> tuple[Any, dict]:
	"""ts_compare_options; the mask is an array."""
	members = dict(options)
	if (marks := marks_for(mask, None, "mask")) is not None:
		members.update(mask=pointer("uint8_t", marks), mask_height=marks.shape[0], mask_width=marks.shape[1])
	wanted, kept = options_for("ts_compare_options", **members)
	return wanted, {"marks": marks, **kept}


class Context:
	"""What computes. backend: one of backends(). say(line), progress(label, done, total) and cancelled(), which ends
	what runs where it returns true, are called meanwhile. What these raise ends what runs, which raises it, and so
	does Ctrl-C. They must not use the package."""

	def __init__(self, backend: str | None = None, device: int = 0, threads: int = 0, no_fast_paths: bool = False,
	             say: Callable[[str], object] | None = None, progress: Callable[[str, int, int], object] | None = None,
	             cancelled: Callable[[], object] | None = None) -> None:
		self._callbacks = {
			"say": say and callback("void(void *, const char *)", lambda _, line: say(text_of(line))),
			"progress": progress and callback("void(void *, const char *, uint64_t, uint64_t)",
			                                  lambda _, label, done, total: progress(text_of(label), done, total)),
			# Python hears signals whenever this is called.
			"cancelled": callback("int(void *)", lambda _: has_raised() or bool(cancelled and cancelled()), error=1),
		}
		options, kept = options_for("ts_context_options", backend=backend, device=device, threads=threads,
		                            no_fast_paths=no_fast_paths, **self._callbacks)
		self._handle, _ = made("ts_context", lib.ts_context_close, lib.ts_context_open, made, options)
		self._name = f"{backend or 'c'}, device {device}"

	def __repr__(self) -> str:
		return f"<touchstone.Context: {self._name}>"

	def open_scene(self, spec: Path, params: Params | None = None, **options: Any) -> Scene:
		"""A built-in scene or a file; options are members of ts_scene_options, such as camera="circle" or eye=(0, 1,
		2)."""
		wanted, kept = _places(options)
		handle, _ = made("ts_scene", lib.ts_scene_free, lib.ts_scene_open, self._handle, made, path_for(spec),
		                 params_for(params), wanted)
		return Scene(self, handle, os.fsdecode(spec))

	def open_scene_bytes(self, file: bytes, params: Params | None = None, name: str = "scene", **options: Any) -> Scene:
		"""A scene of the bytes of a .glb, .gltf or .ply file, by that name in messages; options as of open_scene."""
		wanted, kept = _places(options)
		data = ffi.from_buffer(file)
		handle, _ = made("ts_scene", lib.ts_scene_free, lib.ts_scene_open_bytes, self._handle, made, data, len(data),
		                 text_for(name), params_for(params), wanted)
		return Scene(self, handle, name)

	def make_scene(self, params: Params | None = None, name: str | None = None,
	               images: Iterable[tuple[np.ndarray, bool]] = (), options: Mapping[str, Any] | None = None,
	               **arrays: np.ndarray) -> Scene:
		"""A scene of arrays of records: vertices, triangles, materials, slots, lights, objects, surfels, each of the
		dtype of buffers()["scene.vertex"] and so on. images: pairs of an array of rows of RGBA bytes, and whether its
		colours are coded as sRGB. options: as of open_scene."""
		members: dict[str, Any] = {"name": name}
		kept = []
		for what, array in arrays.items():
			element = buffers()[_of_arrays.get(what, "scene." + what)]
			array = in_order(array, element.dtype, 1, what)
			kept.append(array)
			members[what] = pointer(element.element, array)
			members["n_" + what] = len(array)
		pictures = [(in_order(rgba, "u1", 3, "an image"), srgb) for rgba, srgb in images]
		if any(rgba.shape[2] != 4 for rgba, _ in pictures):
			raise Error("an image: 4 bytes a pixel would be right")
		members["images"] = ffi.new("ts_image_array[]", [(pointer("uint8_t", rgba), rgba.shape[1], rgba.shape[0], srgb)
		                                                  for rgba, srgb in pictures])
		members["n_images"] = len(pictures)
		given, texts = options_for("ts_scene_arrays", **members)
		wanted, places = _places(options or {})
		handle, _ = made("ts_scene", lib.ts_scene_free, lib.ts_scene_make, self._handle, made, given,
		                 params_for(params), wanted)
		return Scene(self, handle, name or "arrays")

	def run(self, scene: Scene, effect: str, method: str, params: Params | None = None,
	        buffers: str | Iterable[str] | None = None, margins: bool = False, arrival: bool = False) -> Trace:
		"""Runs a method and keeps its buffers, or those that `buffers` names."""
		if buffers is not None and not isinstance(buffers, str):
			buffers = ",".join(buffers)
		options, kept = options_for("ts_run_options", buffers=buffers, margins=margins, arrival=arrival)
		handle, _ = made("ts_trace", lib.ts_trace_close, lib.ts_trace_run, self._handle, made, scene._handle,
		                 params_for(params), text_for(effect), text_for(method), options)
		return Trace(self, handle, scene)

	def write(self, folder: Path, scene: Scene, effect: str, method: str, params: Params | None = None,
	          **options: Any) -> None:
		"""Runs a method and writes its trace to a new folder; options are members of ts_write_options: margins, arrival
		and compress."""
		wanted, _ = options_for("ts_write_options", **options)
		check(lib.ts_trace_write(self._handle, path_for(folder), scene._handle, params_for(params), text_for(effect),
		                         text_for(method), wanted))

	def digests(self, scene: Scene, effect: str, method: str, params: Params | None = None) -> dict[str, str]:
		"""Runs a method and keeps no buffer: the SHA-256 of each buffer's file, by name, in the order of the stages."""
		found = {}
		each = callback("void(void *, const char *, const char *)",
		                lambda _, buffer, hex: found.update({text_of(buffer): text_of(hex)}))
		check(lib.ts_run_digests(self._handle, scene._handle, params_for(params), text_for(effect), text_for(method),
		                         each, ffi.NULL))
		return found

	def truth(self, scene: Scene, effect: str, truth: str, params: Params | None = None) -> Row:
		"""A ground truth by rays, one of truths(): `radiance`, linear RGB, and `srgb`, the same as displayed, both rows
		of pixels; and `estimated`, whether some of the rays were left out."""
		image, _ = made("ts_truth_image", lib.ts_truth_image_free, lib.ts_truth_render, self._handle, made,
		                scene._handle, params_for(params), text_for(effect), text_for(truth))
		shape = (image.height, image.width, 3)
		return Row(radiance=view_of(image.radiance, shape, np.float32, image),
		           srgb=view_of(image.srgb, shape, np.uint8, image), estimated=image.estimated != 0)

	def render(self, scene: Scene, effect: str, methods: str | Iterable[str] | None = None,
	           truths: str | Iterable[str] | None = None, params: Params | None = None, stages: bool = False,
	           before: Rendering | None = None) -> Rendering:
		"""Runs methods, by default all, and makes truths, by default none, of one frame. stages: also pictures of
		stages. before: the rendering of the frame before."""
		named = [names if isinstance(names, str) else ",".join(names or []) or None for names in (methods, truths)]
		options, kept = options_for("ts_rendering_options", methods=named[0], truths=named[1], stages=stages,
		                            before=before and before._handle)
		handle, _ = made("ts_rendering", lib.ts_rendering_free, lib.ts_rendering_make, self._handle, made,
		                 scene._handle, params_for(params), text_for(effect), options)
		return Rendering(self, handle, scene, effect)

	def bench(self, table: Path, scenes: str | None = None, objects: str | None = None, runs: int = 0,
	          params: Params | None = None) -> dict:
		"""Measures a table, by its name or from a file, FILE.table: a list of rows for each of its parts, and
		"relations", what must hold."""
		options, kept = options_for("ts_bench_options", scenes=scenes, objects=objects, runs=runs)
		handle, _ = made("ts_tree", lib.ts_tree_free, lib.ts_bench_table, self._handle, made, path_for(table),
		                 params_for(params), options)
		return tree_of(handle)

	def open(self, folder: Path) -> Trace:
		"""Opens the trace in a folder."""
		return self._traced(lib.ts_trace_open, path_for(folder))

	def open_npy(self, path: Path) -> Trace:
		"""Opens one .npy file, BUFFER.npy, as a trace of one buffer."""
		return self._traced(lib.ts_trace_open_npy, path_for(path))

	def open_list(self, folder: Path, files: Mapping[str, Path], reference: Trace, arrival: bool = False) -> Trace:
		"""Opens a folder without trace.json as a candidate of the reference's method; files: those of the folder, by
		buffer. A file that is no .npy holds raw elements."""
		listed = b",".join(os.fsencode(name) + b"=" + os.fsencode(file) for name, file in files.items())
		return self._traced(lib.ts_trace_open_list, path_for(folder), path_for(listed), arrival, reference._handle)

	def _traced(self, function: Any, *arguments: Any) -> Trace:
		return Trace(self, made("ts_trace", lib.ts_trace_close, function, self._handle, made, *arguments)[0])

	def golden(self, folder: Path) -> Row:
		"""Runs again what a golden is of, and compares: a namespace, of which `same` is True or False."""
		judged = filled("ts_golden_judged")
		same = check(lib.ts_golden_check(self._handle, judged, path_for(folder)))
		return Row(same=same, **vars(struct_of(judged)))

	def vectors(self, primitive: str) -> tuple[np.ndarray, np.ndarray]:
		"""(inputs, outputs) of a primitive: the inputs that a port is to compute, and what is right."""
		row = primitive_of(primitive)
		inputs, outputs = np.empty(row.items, row.in_dtype), np.empty(row.shape, row.out_dtype)
		check(lib.ts_vector_words(self._handle, pointer("uint32_t", inputs), pointer("uint32_t", outputs),
		                          text_for(primitive)))
		return inputs, outputs

	def check_vectors(self, primitive: str, found: np.ndarray) -> Row:
		"""The verdict on what a port computed of a primitive's inputs: a namespace of the members of ts_vector_judged,
		and of `same`, which is True or False."""
		row = primitive_of(primitive)
		found = in_order(found, row.out_dtype, len(row.shape), primitive)
		if found.shape != row.shape:
			raise Error(f"{primitive}: shape {found.shape}; {row.shape} would be right")
		judged = filled("ts_vector_judged")
		same = check(lib.ts_vector_check(self._handle, judged, text_for(primitive), pointer("uint32_t", found)))
		return Row(same=same, **vars(struct_of(judged)))

	def page(self, ppd: float = 0, probes: int | None = None) -> Page:
		"""An empty page of HTML."""
		options, _ = options_for("ts_html_options", ppd=ppd, probes=probes, probes_said=probes is not None)
		return Page(self, made("ts_html", lib.ts_html_close, lib.ts_html_open, self._handle, made, options)[0])

	def compare(self, reference: Trace, candidate: Trace, mask: np.ndarray | None = None, **options: Any) -> Verdicts:
		"""Verdicts of a candidate; options are members of ts_compare_options, such as ulp=1 or forced=True. mask: an
		array of rows of pixels, which are judged where it is not 0."""
		wanted, kept = _relaxed(options, mask)
		return Verdicts(*made("ts_verdicts", lib.ts_verdicts_free, lib.ts_compare, self._handle, made,
		                      reference._handle, candidate._handle, wanted))

	def marks(self, buffer: str, reference: Trace, candidate: Trace, mask: np.ndarray | None = None,
	          **options: Any) -> np.ndarray:
		"""Which elements of a buffer differ, as an array of its shape. mask, options: as of compare."""
		wrong = np.zeros(reference.shape(buffer), np.uint8)
		wanted, kept = _relaxed(options, mask)
		check(lib.ts_compare_marks(self._handle, pointer("uint8_t", wrong), wrong.size, text_for(buffer),
		                           reference._handle, candidate._handle, wanted))
		return wrong != 0

	def replay(self, stage: str, reference: Trace, candidate: Trace | None = None, mask: np.ndarray | None = None,
	           **options: Any) -> Verdicts:
		"""Verdicts of one stage's outputs, given the candidate's own inputs. mask, options: as of compare."""
		wanted, kept = _relaxed(options, mask)
		return Verdicts(*made("ts_verdicts", lib.ts_verdicts_free, lib.ts_replay, self._handle, made, text_for(stage),
		                      reference._handle, candidate._handle if candidate is not None else ffi.NULL, wanted))

	def replayed(self, stage: str, reference: Trace, candidate: Trace | None = None) -> Trace:
		"""What the stage makes of the candidate's own inputs, as a trace."""
		return self._traced(lib.ts_trace_replay, text_for(stage), reference._handle,
		                    candidate._handle if candidate is not None else ffi.NULL)

	def continue_from(self, reference: Trace, buffers: Mapping[str, np.ndarray]) -> Trace:
		"""Runs a method on from one's own buffers: a candidate of these, of what the stages make that read them,
		directly or through others, and of the reference's other buffers. What the caller gives stays as given."""
		reference.match()
		for name in buffers:
			if name not in reference:
				raise Error(f"{name}: the reference has no such buffer")
		trace = reference.candidate()
		for name, array in {**reference, **buffers}.items():
			trace[name] = array
		changed = set(buffers)
		for stage in stages(reference.about.effect, reference.about.method):
			if changed.isdisjoint(stage.inputs) or not reference.takes(stage.name):
				continue
			for name, array in self.replayed(stage.name, reference, trace).items():
				if name not in buffers:
					trace[name] = array
					changed.add(name)
		return trace


class Scene:
	"""Triangles, materials, lights, cameras, reflectors and surfels."""

	def __init__(self, context: Context, handle: Any, name: str) -> None:
		self._context, self._handle, self._name = context, handle, name

	def __repr__(self) -> str:
		return f"<touchstone.Scene: {self._name!r}>"

	def info(self) -> dict:
		"""What was loaded, and what in the file was not understood, as `info --json` has it."""
		with tempfile.TemporaryFile() as file:
			check(lib.ts_scene_print(self._handle, file, 1))
			file.seek(0)
			return json.load(file)


class Rendering:
	"""One frame by methods and truths. rendering["epr.rmse.B"] is a figure."""

	def __init__(self, context: Context, handle: Any, scene: Scene, effect: str) -> None:
		self._context, self._handle, self._scene, self._effect = context, handle, scene, effect

	def __repr__(self) -> str:
		return f"<touchstone.Rendering: {self._effect}: {', '.join(self.pictures)}>"

	@property
	def pictures(self) -> dict[str, Row]:
		"""By name, "epr", "truth-b", of stages "epr-points": `srgb`, rows of pixels as displayed; `radiance`, linear
		RGB, or None of false colours; and `estimated`, whether rays of a truth were left out."""
		return {p.name: p for p in rows_of(lambda i: lib.ts_rendering_picture_at(self._handle, i), self._picture)}

	def picture(self, name: str) -> Row:
		"""One of these by its name, or the difference of two, "difference-epr-truth-b": displayed levels apart, times a
		factor of the effect, and radiance, the first less the second."""
		picture = ffi.new("const ts_rendering_picture **")
		check(lib.ts_rendering_picture_named(self._context._handle, picture, self._handle, text_for(name)))
		return self._picture(picture[0])

	def _picture(self, p: Any) -> Row:
		shape = (p.height, p.width, 3)
		light = view_of(p.radiance, shape, np.float32, self) if p.radiance != ffi.NULL else None
		return Row(name=text_of(p.name), srgb=view_of(p.srgb, shape, np.uint8, self), radiance=light,
		           estimated=p.estimated != 0)

	@property
	def figures(self) -> dict[str, Row]:
		"""What was measured, by name: `value`, `unit`, `error`, the standard error of an estimate, and `timed`, whether
		two runs differ."""
		figures, row = {}, filled("ts_rendering_figure")
		while lib.ts_rendering_figure_at(row, self._handle, len(figures)) == lib.TS_OK:
			figure = struct_of(row)
			figures[figure.name] = figure
		return {name: figure for name, figure in figures.items() if figure.value == figure.value}

	def __contains__(self, name: object) -> bool:
		return name in self.figures

	def __getitem__(self, name: str) -> float:
		value = ffi.new("double *")
		check(lib.ts_rendering_figure_named(value, self._handle, text_for(name)))
		return value[0]


class Trace(collections.abc.Mapping):
	"""The buffers of a run, of a folder or of a candidate, by name.
	Arrays are views: of a run and of a folder read only."""

	def __init__(self, context: Context, handle: Any, scene: Scene | None = None, writable: bool = False) -> None:
		self._context, self._handle, self._scene, self._writable = context, handle, scene, writable
		self._given: dict[str, np.ndarray] = {}

	def __repr__(self) -> str:
		about = self.about
		return f"<touchstone.Trace {about.folder!r}: {about.method} of {about.effect}, {len(self)} buffers>"

	def __getitem__(self, name: str) -> np.ndarray:
		buffer = self._found(name, lib.ts_trace_buffer)
		return view_of(buffer.data, self.shape(name), buffers()[name].dtype, kept=(self, self._given.get(name)))

	def shape(self, name: str) -> tuple[int, ...]:
		"""That of a buffer, which is not read from its file."""
		buffer = self._found(name, lib.ts_trace_look)
		return tuple(buffer.shape[0:buffer.n_dims])

	def _found(self, name: str, function: Any) -> Any:
		if name not in self:
			raise KeyError(name)
		buffer = function(self._handle, text_for(name))
		if buffer == ffi.NULL:
			raise failure()
		return buffer

	def __setitem__(self, name: str, array: np.ndarray) -> None:
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
		check(lib.ts_trace_put(self._handle, text_for(name), array.ndim, shape, pointer("void", array), array.nbytes))
		self._given[name] = array

	def __contains__(self, name: object) -> bool:
		return lib.ts_trace_has(self._handle, text_for(name)) != 0

	def __iter__(self) -> Iterator[str]:
		return (name for name in buffers() if name in self)

	def __len__(self) -> int:
		return sum(1 for _ in self)

	@property
	def about(self) -> Row:
		"""The run: folder, effect, method, producer, arrival and has_params."""
		about = lib.ts_trace_about(self._handle)
		return Row(**{**vars(struct_of(about)), "folder": os.fsdecode(ffi.string(about.folder))})

	def takes(self, stage: str) -> bool:
		"""Whether the run had this stage: some parameters leave stages out."""
		return lib.ts_trace_takes(self._handle, text_for(stage)) != 0

	def match(self, candidate: Trace | None = None) -> None:
		"""Fails unless this can be replayed, and the candidate is of the same method and parameters."""
		check(lib.ts_trace_match(self._handle, candidate._handle if candidate is not None else ffi.NULL))

	def candidate(self, arrival: bool = False) -> Trace:
		"""An empty candidate of the same method and parameters."""
		handle, _ = made("ts_trace", lib.ts_trace_close, lib.ts_trace_candidate, self._context._handle, made,
		                 self._handle, arrival)
		return Trace(self._context, handle, writable=True)

	def save(self, folder: Path, producer: str | None = None) -> None:
		"""Writes the buffers and a trace.json to a new folder; producer: who made them."""
		check(lib.ts_trace_save(self._context._handle, self._handle, path_for(folder), text_for(producer)))

	def digest(self, name: str) -> str:
		"""The SHA-256 of the buffer's file."""
		digits = ffi.new("char[65]")
		check(lib.ts_trace_digest(self._handle, text_for(name), digits))
		return text_of(digits)

	def counter(self, name: str) -> int:
		return lib.ts_trace_counter(self._handle, text_for(name))

	def probe_pixel(self, x: int, y: int, view: str | None = None) -> dict:
		"""Why a pixel of the eye, or a texel of a view, is what it is."""
		return self._ask(lib.ts_probe_pixel, x, y, text_for(view))

	def probe_triangle(self, triangle: int) -> dict:
		return self._ask(lib.ts_probe_triangle, triangle)

	def probe_point(self, point: int) -> dict:
		return self._ask(lib.ts_probe_point, point)

	def probe_point_key(self, piece: int, x: int, y: int) -> dict:
		return self._ask(lib.ts_probe_point_key, [piece, x, y])

	def explain(self, stage: str, inputs: Trace | None = None, other: Trace | None = None, **question: Any) -> dict:
		"""What one item of a stage computes, line by line, as `explain --json` has it; the question is members of
		ts_explain_options, such as buffer="splat.depth_index", element=12; outline=1 asks for an outline."""
		if "item" in question:
			question["item_said"] = 1
		options, kept = options_for("ts_explain_options", stage=stage, **question)
		tree, _ = made("ts_tree", lib.ts_tree_free, lib.ts_explain_item, self._context._handle, made, options,
		               self._handle, *[side._handle if side is not None else ffi.NULL for side in (inputs, other)])
		return tree_of(tree)

	def _ask(self, function: Any, *question: Any) -> dict:
		return tree_of(made("ts_tree", lib.ts_tree_free, function, self._context._handle, made, self._handle,
		                    *question)[0])


class Verdicts(collections.abc.Sequence):
	"""How each buffer was judged. True if nothing differs; else `first` is the first divergence."""

	def __init__(self, handle: Any, same: bool) -> None:
		self._handle, self._same = handle, same
		self._rows = rows_of(lambda i: lib.ts_verdicts_at(handle, i))
		first = lib.ts_verdicts_first(handle)
		self.first: Any = struct_of(first) if first != ffi.NULL else None  # a Row

	def __repr__(self) -> str:
		return f"<touchstone.Verdicts on {len(self)} buffers: {self.first.line if self.first else 'no difference'}>"

	def __bool__(self) -> bool:
		return self._same

	def __getitem__(self, i: Any) -> Any:
		return self._rows[i]

	def __len__(self) -> int:
		return len(self._rows)

	def differences(self, i: int) -> list[Row]:
		"""Those of row i, as many as the option `first` asked for."""
		return rows_of(lambda k: lib.ts_verdicts_difference(self._handle, i, k))

	def fields(self, i: int) -> dict[str, int]:
		"""How many elements of row i differ in which field of their records."""
		return {row.field: row.n_different for row in rows_of(lambda k: lib.ts_verdicts_field(self._handle, i, k))}

	def tree(self) -> dict:
		"""All that differs, as `compare --json` has it."""
		return tree_of(ffi.gc(lib.ts_verdicts_tree(self._handle), lib.ts_tree_free))


class Page:
	"""A page of HTML, as `touchstone report` writes it."""

	def __init__(self, context: Context, handle: Any) -> None:
		self._context, self._handle = context, handle
		self._parts = 0

	def __repr__(self) -> str:
		return f"<touchstone.Page: {self._parts} parts>"

	def _add(self, status: int) -> None:
		check(status)
		self._parts += 1

	def add(self, trace: Trace) -> None:
		"""Adds a trace: its picture, and what it says of itself."""
		self._add(lib.ts_html_add_trace(self._handle, trace._handle))

	def add_folder(self, folder: Path) -> None:
		"""Adds what render or compare wrote to a folder."""
		self._add(lib.ts_html_add_folder(self._handle, path_for(folder)))

	def add_picture(self, name: str, rgb: np.ndarray, source: Path = "") -> None:
		"""Adds rows of pixels of 8-bit sRGB."""
		rgb = in_order(rgb, "u1", 3, name)
		if rgb.shape[2] != 3:
			raise Error(f"{name}: 3 bytes a pixel would be right")
		self._add(lib.ts_html_add_picture(self._handle, text_for(name), path_for(source), pointer("uint8_t", rgb),
		                                  rgb.shape[1], rgb.shape[0]))

	def add_pair(self, result: Mapping[str, object]) -> None:
		"""Adds a comparison of the last two pictures that were added, and its result."""
		self._add(lib.ts_html_add_pair(self._handle, text_for(json.dumps(result))))

	def add_verdicts(self, verdicts: Verdicts, reference: Trace, candidate: Trace, mask: np.ndarray | None = None,
	                 **options: Any) -> None:
		"""Adds how a candidate was judged, both sides being added already; mask, options: as of that comparison."""
		wanted, kept = _relaxed(options, mask)
		self._add(lib.ts_html_add_verdicts(self._handle, verdicts._handle, reference._handle, candidate._handle, wanted,
		                                   ffi.NULL))

	def write(self, path: Path) -> None:
		check(lib.ts_html_write(self._handle, path_for(path)))
