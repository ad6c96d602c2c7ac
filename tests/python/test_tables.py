"""What the package for Python says of the library: the rows are those of the headers' tables."""
import pytest
import touchstone


def test_methods_and_their_stages():
	assert touchstone.backends()[0] == "c"
	assert ("surfels", "ewa") in [(m.effect, m.name) for m in touchstone.methods()]
	stages = {stage.name: stage for stage in touchstone.stages("reflections", "epr")}
	assert list(stages)[-1] == "image" and "image.srgb" in stages["image"].outputs
	assert "points.record" in stages["splat"].inputs and stages["splat"].number < stages["image"].number
	assert {"splat", "hull"} < {stage.name for stage in touchstone.stages()}
	assert touchstone.stages("reflections", "magic") == []


def test_buffers():
	buffers = touchstone.buffers()
	assert buffers["scene.vertex"].dtype.itemsize == 80
	assert all(row.dtype.itemsize == row.element_bytes for row in buffers.values())
	assert buffers["image.srgb"].is_image and not buffers["scene.vertex"].is_image
	assert "width" in [size.name for size in touchstone.sizes()]


def test_scenes_truths_and_probes():
	assert "atrium" in [scene.name for scene in touchstone.builtins()]
	assert "reflections" in next(truth for truth in touchstone.truths() if truth.name == "B").effects
	assert any(probe.option.startswith("--triangle") for probe in touchstone.probes())


def test_devices():
	device, = touchstone.devices("c")
	assert device.name and device.rounded
	with pytest.raises(touchstone.Error, match="magic"):
		touchstone.devices("magic")


def test_settings_are_those_of_a_run():
	plain, mine = touchstone.settings(), touchstone.settings({"width": 480, "eye.fov": 60.1})
	assert list(plain) == [row.name for row in touchstone.parameters()]
	assert {name for name in plain if plain[name] != mine[name]} == {"width", "eye.fov"}
	assert (mine["width"], mine["eye.fov"]) == (480, 60.1) and touchstone.settings(mine) == mine


def test_floats():
	assert touchstone.float_text(1) == "1 = 0x1p+0 (3f800000)"
	assert touchstone.float_passes(1, 1) and not touchstone.float_passes(1, 1.25)
	assert touchstone.float_passes(1, 1.25, abs=0.25)
