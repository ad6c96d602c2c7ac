"""Files of pictures, and how far pictures are apart. Pictures are arrays of rows of pixels, from the top."""
from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from ._library import Error, Path, Row, check, ffi, in_order, lib, path_for, pointer, struct_of, text_for, view_of


def read_image(path: Path) -> np.ndarray:
	"""A PNG, JPEG or EXR as float32, with the channels of the file; 8-bit values are divided by 255."""
	n_channels = ffi.new("uint32_t *")
	pixels, size = _read("float", lambda *out: lib.ts_image_read(*out, n_channels, path_for(path)))
	return view_of(pixels, (*size, n_channels[0]), np.float32, pixels, writable=True)


def read_image_bytes(file: bytes, name: str = "image") -> np.ndarray:
	"""As read_image, of the bytes of a file. name: what a message calls the picture."""
	n_channels, data = ffi.new("uint32_t *"), ffi.from_buffer(file)
	pixels, size = _read("float",
	                     lambda *out: lib.ts_image_read_bytes(*out, n_channels, data, len(data), text_for(name)))
	return view_of(pixels, (*size, n_channels[0]), np.float32, pixels, writable=True)


def decode_image(file: bytes, max_texels: int = 1 << 28, name: str = "image") -> np.ndarray:
	"""The bytes of a PNG or JPEG file as 8-bit RGBA. name: what a message calls the picture."""
	data = ffi.from_buffer(file)
	pixels, size = _read("uint8_t", lambda *out: lib.ts_image_decode(*out, data, len(data), max_texels, text_for(name)))
	return view_of(pixels, (*size, 4), np.uint8, pixels, writable=True)


def _read(kind: str, function: Callable[..., int]) -> tuple[Any, tuple[int, int]]:
	"""(pixels, (height, width)) of a picture that the library allocates."""
	pixels, width, height = ffi.new(kind + " **"), ffi.new("uint32_t *"), ffi.new("uint32_t *")
	check(function(pixels, width, height))
	return ffi.gc(pixels[0], lib.free), (height[0], width[0])


def write_png(path: Path, pixels: np.ndarray, texts: Mapping[str, str] | None = None) -> None:
	"""Writes uint8 of 1, 3 or 4 channels, and texts by name. The file appears only when complete."""
	_save(lib.ts_image_write_png, np.uint8, pixels, texts, path_for(path))


def write_exr(path: Path, pixels: np.ndarray, texts: Mapping[str, str] | None = None) -> None:
	"""Writes float32 of 1, 3 or 4 channels, and texts by name. The file appears only when complete."""
	_save(lib.ts_image_write_exr, np.float32, pixels, texts, path_for(path))


def encode_png(pixels: np.ndarray, texts: Mapping[str, str] | None = None) -> bytes:
	"""The file that write_png writes."""
	return _encode(lib.ts_image_encode_png, np.uint8, pixels, texts)


def encode_exr(pixels: np.ndarray, texts: Mapping[str, str] | None = None) -> bytes:
	"""The file that write_exr writes."""
	return _encode(lib.ts_image_encode_exr, np.float32, pixels, texts)


def _encode(function: Any, dtype: Any, pixels: np.ndarray, texts: Mapping[str, str] | None) -> bytes:
	file, n_bytes = ffi.new("void **"), ffi.new("size_t *")
	_save(function, dtype, pixels, texts, file, n_bytes, name="pixels")
	return bytes(ffi.buffer(ffi.gc(file[0], lib.free), n_bytes[0]))


def _save(function: Any, dtype: Any, pixels: np.ndarray, texts: Mapping[str, str] | None, *to: Any,
          name: str | None = None) -> None:
	pixels = np.asarray(pixels)
	pixels = in_order(pixels[..., np.newaxis] if pixels.ndim == 2 else pixels, dtype, 3, "pixels")
	height, width, n_channels = pixels.shape
	if n_channels not in (1, 3, 4) or pixels.size == 0:
		raise Error(f"pixels: shape {pixels.shape}; pixels of 1, 3 or 4 channels would be right")
	kept = [(text_for(name), text_for(text)) for name, text in (texts or {}).items()]
	kind = "float" if dtype is np.float32 else "uint8_t"
	check(function(*to, pointer(kind, pixels), width, height, n_channels,
	               ffi.new("ts_image_text[]", [*kept, (ffi.NULL, ffi.NULL)]), *([text_for(name)] if name else [])))


def _pictures(dtype: Any, mask: np.ndarray | None,
              **pictures: np.ndarray) -> tuple[list[np.ndarray], np.ndarray | None, tuple[int, int]]:
	"""(the pictures in C order, the mask as bytes, (width, height)); all of them must be of one size."""
	arrays = [in_order(picture, dtype, 3, name) for name, picture in pictures.items()]
	height, width = arrays[0].shape[:2]
	shape = (height, width, 3)
	for name, array in zip(pictures, arrays):
		if array.shape != shape:
			raise Error(f"{name}: shape {array.shape}; {shape} would be right")
	return arrays, marks_for(mask, (height, width), "mask"), (width, height)


def marks_for(marks: np.ndarray | None, shape: tuple[int, int] | None, what: str) -> np.ndarray | None:
	"""Bytes that are not 0 where the marks are not."""
	if marks is None:
		return None
	marks = in_order(np.asarray(marks) != 0, bool, 2, what).view(np.uint8)
	if shape not in (None, marks.shape):
		raise Error(f"{what}: shape {marks.shape}; {shape} would be right")
	return marks


def metrics(reference: np.ndarray, image: np.ndarray, mask: np.ndarray | None = None) -> Row:
	"""How far two pictures of 8-bit RGB are apart: rmse, psnr, ssim and the other members of ts_metrics. Pixels are
	judged where the mask, rows of pixels, is not 0; so in the other metrics."""
	pictures, judged, size = _pictures(np.uint8, mask, reference=reference, image=image)
	return struct_of(lib.ts_metrics_compare(*(pointer("uint8_t", picture) for picture in (*pictures, judged)), *size))


def estimate_metrics(reference: np.ndarray, image: np.ndarray, all_reference: np.ndarray, all_image: np.ndarray,
                     chosen: np.ndarray, mask: np.ndarray | None = None) -> Row:
	"""How far the better pictures `all_` are apart, which are known only where `chosen` is not 0."""
	pictures, judged, size = _pictures(np.uint8, mask, reference=reference, image=image, all_reference=all_reference,
	                                   all_image=all_image)
	drawn = marks_for(chosen, size[::-1], "chosen")
	part = ffi.new("ts_metrics_part *", [pointer("uint8_t", array) for array in (*pictures, drawn)])
	return struct_of(lib.ts_metrics_estimate(part, pointer("uint8_t", judged), *size))


def flicker(reference_before: np.ndarray, reference: np.ndarray, image_before: np.ndarray, image: np.ndarray,
            mask: np.ndarray | None = None) -> float:
	"""How much more a picture of 8-bit RGB changes from one frame to the next than its reference does,
	in grey levels."""
	pictures, judged, size = _pictures(np.uint8, mask, reference_before=reference_before, reference=reference,
	                                   image_before=image_before, image=image)
	return lib.ts_metrics_flicker(*(pointer("uint8_t", picture) for picture in (*pictures, judged)), *size)


def light_metrics(reference: np.ndarray, image: np.ndarray, mask: np.ndarray | None = None) -> Row:
	"""How far two pictures of light, float32 of linear RGB, are apart: relative, median, beyond and the other members
	of ts_light_metrics."""
	pictures, judged, size = _pictures(np.float32, mask, reference=reference, image=image)
	light = [pointer("float", picture) for picture in pictures]
	return struct_of(lib.ts_metrics_light(*light, pointer("uint8_t", judged), *size))


def crumbs(reference: np.ndarray, image: np.ndarray) -> np.ndarray:
	"""Where light is more than 0.1 above or below all that the reference has around a pixel: bool,
	by rows of pixels."""
	pictures, _, size = _pictures(np.float32, None, reference=reference, image=image)
	marks = np.empty(size[::-1], np.uint8)
	lib.ts_metrics_crumbs(pointer("uint8_t", marks), *(pointer("float", picture) for picture in pictures), *size)
	return marks.view(bool)
