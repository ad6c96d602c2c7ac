"""What the library has: backends, methods, stages, parameters, buffers, primitives, scenes, truths and probes."""
from __future__ import annotations

import ast
import functools
from collections.abc import Mapping

import numpy as np

from ._library import (Error, Row, check, ffi, filled, lib, options_for, params_for, rows_of, struct_of, text_for,
                       text_of)


def version() -> str:
	return text_of(lib.ts_version())


@functools.lru_cache(None)
def backends() -> list[str]:
	return rows_of(lib.ts_backend_at, text_of)


def devices(backend: str) -> list[Row]:
	"""The devices of a backend; none where it has no driver."""
	found: list[Row] = []
	while True:
		device = filled("ts_device_info")
		status = lib.ts_device_at(device, text_for(backend), len(found))
		if status == lib.TS_SKIPPED:
			return found
		check(status)
		found.append(struct_of(device))


@functools.lru_cache(None)
def methods() -> list[Row]:
	return rows_of(lib.ts_method_at)


def stages(effect: str | None = None, method: str | None = None) -> list[Row]:
	"""The stages of a method, in their order, each with its `number`; or all stages. `inputs` and `outputs` are the
	buffers that a stage reads and makes."""
	if method is None:
		found = rows_of(lib.ts_stage_at)
	else:
		found = rows_of(lambda i: lib.ts_method_stage(text_for(effect), text_for(method), i))
	for i, row in enumerate(found):
		name = text_for(row.name)
		row.inputs = rows_of(functools.partial(lib.ts_stage_input, name), text_of)
		row.outputs = rows_of(functools.partial(lib.ts_stage_output, name), text_of)
		if method is not None:
			row.number = lib.ts_method_stage_number(text_for(effect), text_for(method), i)
	return found


@functools.lru_cache(None)
def parameters() -> list[Row]:
	return rows_of(lib.ts_param_at)


def settings(params: Mapping[str, object] | None = None) -> dict[str, int | float | str]:
	"""All parameters by name, as a run has them: those given, and the others at their defaults."""
	values, text, kinds = params_for(params), ffi.new("char[64]"), {"u32": int, "f32": float, "enum": str}
	found = {}
	for row in parameters():
		check(lib.ts_params_get(values, text_for(row.name), text, len(text)))
		found[row.name] = kinds[row.kind](text_of(text))
	return found


@functools.lru_cache(None)
def sizes() -> list[Row]:
	"""The sizes that shapes of buffers are of."""
	return rows_of(lib.ts_size_at)


@functools.lru_cache(None)
def buffers() -> dict[str, Row]:
	"""All buffers by name. `dtype` is that of their elements;
	`is_image`: whether rows and columns are those of pixels."""
	fields = rows_of(lib.ts_field_at)
	found = {row.name: row for row in rows_of(lib.ts_buffer_at)}
	for row in found.values():
		members = [(f.name, _dtype(f.type), (f.count,)) if f.count > 1 else (f.name, _dtype(f.type))
		           for f in fields if f.record == row.element]
		row.dtype = np.dtype(members) if members else _dtype(row.element)
		row.is_image = lib.ts_buffer_is_image(text_for(row.name)) != 0
	return found


def _dtype(scalar: str) -> np.dtype:
	return np.dtype(f"{scalar[0]}{int(scalar[1:]) // 8}")


@functools.lru_cache(None)
def primitives() -> dict[str, Row]:
	"""All primitives that a port must compute with the same bits, by name. in_dtype and out_dtype are NumPy's, and
	their fields the columns; `shape` is that of the outputs."""
	found = {row.name: row for row in rows_of(lib.ts_vector_at)}
	for row in found.values():
		row.in_dtype, row.out_dtype = (np.dtype(ast.literal_eval(text)) for text in (row.in_dtype, row.out_dtype))
		row.shape = tuple(row.shape[i] for i in range(row.n_dims))
		del row.inputs, row.outputs
	return found


def primitive_of(name: str) -> Row:
	if name not in primitives():
		raise Error(f'there is no primitive "{name}"; primitives() has all')
	return primitives()[name]


@functools.lru_cache(None)
def builtins() -> list[Row]:
	"""The built-in scenes."""
	return rows_of(lib.ts_builtin_at)


@functools.lru_cache(None)
def truths() -> list[Row]:
	"""The ground truths, for Context.truth."""
	return rows_of(lib.ts_truth_at)


@functools.lru_cache(None)
def probes() -> list[Row]:
	"""What a probe answers, on what, and for which methods."""
	return rows_of(lib.ts_probe_at)


def float_passes(reference: float, candidate: float, **tolerance: float) -> bool:
	"""Whether two floats are equal, or near enough by ulp=, abs= and rel=, members of ts_compare_options."""
	wanted, _ = options_for("ts_compare_options", **tolerance)
	return lib.ts_float_passes(wanted, reference, candidate) != 0


def float_text(value: float) -> str:
	"""A float as a divergence shows it: "1 = 0x1p+0 (3f800000)"."""
	text = ffi.new("char[]", lib.TS_FLOAT_TEXT)
	lib.ts_float_text(text, value)
	return text_of(text)
