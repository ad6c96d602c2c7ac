"""Pictures of the package for Python: files give back what was written, and metrics have their closed forms."""
import math
import os
import shutil
import subprocess
import sys

import numpy as np
import pytest
import touchstone

GREY = np.full((12, 16, 3), 100, np.uint8)
LIGHT = np.ones((12, 16, 3), np.float32)


def shifted(pixels, by):
	"""The pixels, of which one, (4, 3), is another."""
	other = pixels.copy()
	other[3, 4] += np.array(by, pixels.dtype)
	return other


@pytest.mark.parametrize("channels", [1, 3, 4])
def test_files_give_back_what_was_written(tmp_path, channels):
	rng = np.random.default_rng(channels)
	codes, light = rng.integers(0, 256, (5, 7, channels), np.uint8), rng.random((5, 7, channels), np.float32)
	touchstone.write_png(tmp_path / "a.png", codes, {"Source": "a test"})
	touchstone.write_exr(tmp_path / "a.exr", light)
	assert np.array_equal(touchstone.read_image(tmp_path / "a.png"), codes / np.float32(255))
	assert np.array_equal(touchstone.read_image(tmp_path / "a.exr"), light)
	assert b"a test" in (tmp_path / "a.png").read_bytes()
	assert touchstone.encode_png(codes, {"Source": "a test"}) == (tmp_path / "a.png").read_bytes()
	assert touchstone.encode_exr(light) == (tmp_path / "a.exr").read_bytes()
	assert np.array_equal(touchstone.read_image_bytes(touchstone.encode_exr(light)), light)
	decoded = touchstone.decode_image((tmp_path / "a.png").read_bytes())
	assert np.array_equal(decoded[..., :3], np.broadcast_to(codes[..., :3], (5, 7, 3)))
	assert np.array_equal(decoded[..., 3], codes[..., 3] if channels == 4 else np.full((5, 7), 255))


def test_without_the_module_of_images_the_kind_is_library(tmp_path):
	touchstone.write_exr(tmp_path / "a.exr", LIGHT)
	alone = shutil.copy(os.environ["TOUCHSTONE_LIBRARY"], tmp_path)
	read = ("import sys, touchstone\ntry: touchstone.read_image(sys.argv[1])\n"
	        "except touchstone.Error as error: print(error.kind)")
	said = subprocess.run([sys.executable, "-c", read, tmp_path / "a.exr"],
	                      env={**os.environ, "TOUCHSTONE_LIBRARY": alone}, capture_output=True, text=True, check=True)
	assert said.stdout == "library\n"


def test_rows_of_numbers_are_one_channel(tmp_path):
	touchstone.write_exr(tmp_path / "a.exr", LIGHT[..., 0])
	assert touchstone.read_image(tmp_path / "a.exr").shape == (12, 16, 1)


def test_metrics_have_their_closed_forms():
	same, apart = touchstone.metrics(GREY, GREY), touchstone.metrics(GREY, GREY + np.uint8(3))
	assert same.psnr == math.inf and same.ssim == 1 and same.pixels == 12 * 16
	assert apart.rmse == 3 and apart.psnr == pytest.approx(20 * math.log10(255 / 3))
	mask = np.ones((12, 16), bool)
	mask[3, 4] = False
	assert touchstone.metrics(GREY, shifted(GREY, 9)).rmse > 0
	assert touchstone.metrics(GREY, shifted(GREY, 9), mask).rmse == 0
	assert touchstone.flicker(GREY, GREY, GREY, GREY + np.uint8(2)) == 2
	whole = touchstone.estimate_metrics(GREY, GREY, GREY, GREY + np.uint8(3), np.ones((12, 16)))
	assert whole.rmse == 3 and math.isnan(whole.ssim)
	light = touchstone.light_metrics(LIGHT, LIGHT * np.float32(1.25))
	assert light.relative == pytest.approx(0.25) and light.median == 0.25 and light.beyond == 1 and light.unlit == 0
	assert list(zip(*np.nonzero(touchstone.crumbs(LIGHT, shifted(LIGHT, 1))))) == [(3, 4)]


def test_pictures_that_do_not_fit_are_refused(tmp_path):
	for call, line in ((lambda: touchstone.metrics(GREY, GREY[1:]),
	                    r"image: shape \(11, 16, 3\); \(12, 16, 3\) would be right"),
	                   (lambda: touchstone.metrics(GREY, LIGHT),
	                    "image: 3 dimensions of float32; 3 of uint8 would be right"),
	                   (lambda: touchstone.metrics(GREY, GREY, np.ones((2, 2))), r"mask: shape \(2, 2\)"),
	                   (lambda: touchstone.write_png(tmp_path / "a.png", LIGHT), "of uint8 would be right"),
	                   (lambda: touchstone.write_png(tmp_path / "a.png", GREY[..., :2]), "1, 3 or 4 channels"),
	                   (lambda: touchstone.write_png(tmp_path / "a.png", GREY[:0]), r"shape \(0, 16, 3\)"),
	                   (lambda: touchstone.read_image(tmp_path / "none.png"), "none.png"),
	                   (lambda: touchstone.decode_image(b"no picture", name="mine"), "mine")):
		with pytest.raises(touchstone.Error, match=line):
			call()
	assert not list(tmp_path.iterdir())
