"""The package for Python, by pytest: what it makes are the bits of the command, and no array outlives its memory."""
import gc
import json
import os
import pathlib

import numpy as np
import pytest
import touchstone

pytest_plugins = ["touchstone.pytest"]
SMALL = {"width": 64, "height": 36, "reflectors.count": 2, "cube.max_px": 16}


@pytest.fixture(scope="module")
def context():
	return touchstone.Context(threads=2)


@pytest.fixture(scope="module")
def scene(context):
	return context.open_scene("atrium:triangles=10000:texels=32", SMALL)


@pytest.fixture(scope="module")
def reference(context, scene):
	return context.run(scene, "reflections", "epr", SMALL)


def test_tables():
	assert touchstone.backends()[0] == "c"
	assert ("surfels", "ewa") in [(m.effect, m.name) for m in touchstone.methods()]
	assert touchstone.stages("reflections", "epr")[-1].name == "image"
	assert touchstone.buffers()["scene.vertex"].dtype.itemsize == 80
	assert all(row.dtype.itemsize == row.element_bytes for row in touchstone.buffers().values())


def test_arrays_are_views(context, scene):
	trace = context.run(scene, "reflections", "mvr", SMALL)
	image, again = trace["image.srgb"], trace["image.srgb"]
	assert image.shape == (36, 64, 3) and image.ctypes.data == again.ctypes.data
	total = int(image.sum())
	del trace
	gc.collect()
	assert int(image.sum()) == total
	with pytest.raises(ValueError):
		image[0, 0, 0] = 1


@pytest.mark.parametrize("which", ["TRACED", "PACKED"])
def test_folder_and_memory_are_the_same(context, reference, which):
	traced = os.environ[which]  # by the command, of the same run
	stored = context.open(traced)
	assert list(stored) == list(reference)
	assert all(np.array_equal(stored[name], reference[name]) for name in stored)
	assert all(stored.digest(name) == reference.digest(name) for name in stored)
	files = json.loads((pathlib.Path(traced) / "trace.json").read_text())["buffers"]
	assert {file["name"]: file["sha256"] for file in files} == {name: reference.digest(name) for name in reference}
	assert context.compare(reference, stored)


def test_candidate(context, reference, touchstone_judge):
	port = reference.candidate()
	keys = reference["eye.depth_triangle"].copy()
	port["eye.depth_triangle"] = keys
	assert port["eye.depth_triangle"].ctypes.data == keys.ctypes.data
	touchstone_judge("eye", reference, port)
	keys[3, 4] ^= np.uint64(1)
	verdicts = context.compare(reference, port)
	assert not verdicts and verdicts.first.where == "pixel (4, 3)" and verdicts.first.inputs.startswith("none")
	with pytest.raises(pytest.fail.Exception, match="given the candidate's inputs"):
		touchstone_judge("eye", reference, port)
	right = context.replayed("eye", reference, port)
	assert list(right) == ["eye.depth_triangle"] and np.array_equal(right["eye.depth_triangle"], reference["eye.depth_triangle"])
	before = port["eye.depth_triangle"]
	port["eye.depth_triangle"] = keys + np.uint64(0)
	assert np.array_equal(before, keys)
	port["eye.depth_triangle"] = keys
	with pytest.raises(touchstone.Error, match="dtype"):
		port["eye.depth_triangle"] = keys.astype(np.int64)
	with pytest.raises(touchstone.Error, match="cannot be changed"):
		reference["eye.depth_triangle"] = keys
	mask = np.ones((36, 64), np.uint8)
	mask[3, 4] = 0
	assert context.compare(reference, port, mask=mask)


def test_made_scene(context):
	records = touchstone.buffers()
	vertices = np.zeros(4, records["scene.vertex"].dtype)
	vertices["position"] = [(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)]
	vertices["colour"] = 1
	triangles = np.zeros(2, records["scene.triangle"].dtype)
	triangles["vertex"] = [(0, 1, 2), (0, 2, 3)]
	triangles["material"] = 0xffffffff
	made = context.make_scene(SMALL, vertices=vertices, triangles=triangles)
	trace = context.run(made, "reflections", "mvr", SMALL, buffers=["image.srgb"])
	assert list(trace) == ["image.srgb"] and len(np.unique(trace["image.srgb"].reshape(-1, 3), axis=0)) > 2
	texture = np.full((2, 2, 4), 255, np.uint8)
	context.make_scene(SMALL, images=[(texture, True)], options={"eye": (0, 1, 3), "target": (0, 0, 0)}, vertices=vertices,
	                   triangles=triangles)
	with pytest.raises(touchstone.Error, match="would be right"):
		context.make_scene(SMALL, vertices=np.zeros((4, 3), np.float32), triangles=triangles)
	with pytest.raises(TypeError, match="camra is no option"):
		context.make_scene(SMALL, vertices=vertices, triangles=triangles, options={"camra": "front"})
	triangles["vertex"][1, 2] = 4
	with pytest.raises(touchstone.Error, match="triangle 1: vertex 4 does not exist"):
		context.make_scene(SMALL, vertices=vertices, triangles=triangles)


def test_answers_and_errors(context, scene, reference):
	assert reference.probe_pixel(3, 4)["pixel"] == [3, 4]
	assert reference.counter("shading operations") > 0
	assert "eye.depth" not in reference
	with pytest.raises(KeyError):
		reference["eye.depth"]
	with pytest.raises(touchstone.Error, match="magic"):
		context.run(scene, "reflections", "magic", SMALL)
	with pytest.raises(touchstone.Error, match="width"):
		context.open_scene("atrium", {"width": -1})


def test_callbacks():
	heard = []
	context = touchstone.Context(progress=lambda *told: heard.append(told), cancelled=lambda: len(heard) > 0)
	scene = context.open_scene("atrium:triangles=10000:texels=32", SMALL)
	with pytest.raises(touchstone.Error, match="cancelled"):
		context.run(scene, "reflections", "mvr", SMALL)
	assert heard


def test_verdicts(context, reference, tmp_path):
	port = reference.candidate()
	vertices = reference["pose.vertex"].copy()
	vertices["normal"][[3, 8, 20], 1] += np.float32(1)
	port["pose.vertex"] = vertices
	verdicts = context.compare(reference, port, first=2)
	row = next(i for i, row in enumerate(verdicts) if row.buffer == "pose.vertex")
	assert [d.element for d in verdicts.differences(row)] == [3, 8]
	assert [d.spot for d in verdicts.differences(row)] == ["normal[1]", "normal[1]"]
	assert verdicts.fields(row) == {"normal": 3} and verdicts.fields(row + 1) == {}
	assert verdicts.tree()["first_divergence"] == verdicts.first.line
	marks = context.marks("pose.vertex", reference, port)
	assert list(np.flatnonzero(marks)) == [3, 8, 20]
	page = context.page(probes=1)
	page.add(reference)
	page.add(port)
	page.add_verdicts(verdicts, reference, port)
	page.add_picture("mine", reference["image.srgb"])
	page.write(tmp_path / "page.html")
	assert "normal[1]" in (tmp_path / "page.html").read_text()


def test_explained(reference):
	told = reference.explain("image", buffer="image.radiance", element=5)
	lines = [line for launch in told["launches"] for line in launch["lines"]]
	assert lines[told["stores"] - 1]["to"] == "image.radiance:5"
	with pytest.raises(touchstone.Error, match="the nearest is splat"):
		reference.explain("splat", item=0, kernel="splatt")


def test_folders(context, scene, reference, tmp_path):
	context.write(tmp_path / "made", scene, "reflections", "epr", SMALL, compress=True)
	assert context.compare(reference, context.open(tmp_path / "made"))
	port = reference.candidate()
	port["image.srgb"] = reference["image.srgb"]
	port.save(tmp_path / "port", "my port")
	assert list(context.open(tmp_path / "port")) == ["image.srgb"]
	cropped = context.open(os.environ["CROPPED"])
	cropped.save(tmp_path / "again")
	assert context.compare(cropped, context.open(tmp_path / "again"))
	golden = pathlib.Path("reference/small-mvr").absolute()
	judged = context.golden(golden)
	assert judged.same and judged.method == "mvr" and judged.text == ""
	with pytest.raises(touchstone.Error, match="No such file"):
		context.golden(tmp_path / "none")


def test_vectors(context):
	rows = touchstone.primitives()
	assert all(row.in_dtype.itemsize == 4 * row.in_words for row in rows.values())
	for name in ("cross", "light"):  # an array, and a record
		inputs, right = context.vectors(name)
		assert inputs.shape == (4096,) and right.shape == rows[name].shape and right.dtype == rows[name].out_dtype
		judged = context.check_vectors(name, right)
		assert judged.same and judged.n_wrong == 0 and judged.fault is None
	inputs, found = context.vectors("cross")
	found[7, 1] = np.nan
	judged = context.check_vectors("cross", found)
	assert not judged.same and (judged.n_wrong, judged.first, judged.first_element, judged.first_nan) == (1, 7, 1, 1)
	inputs, found = context.vectors("div")
	with np.errstate(all="ignore"):
		found[:] = inputs["a"] * (np.float32(1) / inputs["b"])
	judged = context.check_vectors("div", found)
	assert judged.fault == "reciprocal division" and judged.first_fault is not None and judged.n_explained > 100
	with pytest.raises(touchstone.Error, match="4096, 3"):
		context.check_vectors("cross", np.zeros((3, 4096), np.float32))
	with pytest.raises(touchstone.Error, match="would be right"):
		context.check_vectors("cross", found)
	with pytest.raises(touchstone.Error, match="no primitive"):
		context.vectors("magic")
