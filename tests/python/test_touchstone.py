"""The package for Python, by pytest: what it makes are the bits of the command, and no array outlives its memory."""
import gc
import json
import multiprocessing
import os
import pathlib
import re
import shutil
import signal
import threading
import time

import numpy as np
import pytest
import touchstone
from conftest import SMALL


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
	assert list(right) == ["eye.depth_triangle"]
	assert np.array_equal(right["eye.depth_triangle"], reference["eye.depth_triangle"])
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
	context.make_scene(SMALL, images=[(texture, True)], options={"eye": (0, 1, 3), "target": (0, 0, 0)},
	                   vertices=vertices, triangles=triangles)
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


def test_a_scene_of_bytes_is_that_of_its_file(context):
	room = pathlib.Path("scenes/room.gltf")
	same = context.open_scene_bytes(room.read_bytes(), SMALL, name="room", camera="circle")
	traces = [context.run(scene, "reflections", "mvr", SMALL)
	          for scene in (same, context.open_scene(room, SMALL, camera="circle"))]
	assert traces[0].digest("image.srgb") == traces[1].digest("image.srgb")
	with pytest.raises(touchstone.Error, match="mine: its first bytes"):
		context.open_scene_bytes(b"no scene", name="mine")


def kind_of(call):
	with pytest.raises(touchstone.Error) as raised:
		call()
	return raised.value.kind


def test_errors_have_kinds(context, scene, tmp_path):
	assert kind_of(lambda: context.run(scene, "reflections", "magic", SMALL)) == "argument"
	assert kind_of(lambda: context.open(tmp_path / "none")) == "file"
	assert kind_of(lambda: touchstone.decode_image(b"no picture")) == "format"
	ended = touchstone.Context(cancelled=lambda: True)
	assert kind_of(lambda: ended.run(scene, "reflections", "mvr", SMALL)) == "cancelled"


def test_callbacks():
	heard = []
	context = touchstone.Context(progress=lambda *told: heard.append(told), cancelled=lambda: len(heard) > 0)
	scene = context.open_scene("atrium:triangles=10000:texels=32", SMALL)
	with pytest.raises(touchstone.Error, match="cancelled"):
		context.run(scene, "reflections", "mvr", SMALL)
	assert heard


@pytest.mark.parametrize("which", ["progress", "cancelled"])
def test_what_a_callback_raises_comes_out(scene, which, capfd):
	raising = []

	def call(*_):
		if raising:
			raise RuntimeError("mine")

	context = touchstone.Context(**{which: call})
	raising.append(True)
	with pytest.raises(RuntimeError, match="mine"):
		context.run(scene, "reflections", "mvr", SMALL)
	raising.clear()
	assert context.run(scene, "reflections", "mvr", SMALL)
	assert capfd.readouterr().err == ""


def test_an_interrupt_is_heard(context, scene):
	long = {"width": 512, "height": 512, "rsm.px": 32}
	large = context.open_scene("atrium:triangles=10000:texels=32", long)
	sent = []
	timer = threading.Timer(0.5, lambda: (sent.append(time.process_time()), os.kill(os.getpid(), signal.SIGINT)))
	timer.start()
	with pytest.raises(KeyboardInterrupt):
		context.run(large, "indirect", "direct", long)
	timer.join()
	assert time.process_time() - sent[0] < os.cpu_count()  # a second, but for what other processes take
	assert context.run(scene, "reflections", "mvr", SMALL)


def digest_in_child(inherited):
	with pytest.raises(touchstone.Error, match="a context of its own"):
		inherited_context.run(inherited_scene, "reflections", "mvr", SMALL)
	own = touchstone.Context(threads=2)
	scene = own.open_scene("atrium:triangles=10000:texels=32", SMALL)
	return own.run(scene, "reflections", "mvr", SMALL).digest("image.srgb")


def test_forked_processes_open_their_own(context, scene):
	global inherited_context, inherited_scene
	inherited_context, inherited_scene = context, scene
	here = context.run(scene, "reflections", "mvr", SMALL).digest("image.srgb")
	with multiprocessing.get_context("fork").Pool(2) as pool:
		assert pool.map_async(digest_in_child, range(2)).get(60) == [here] * 2


def test_names_need_not_be_utf_8(context, reference, tmp_path):
	(tmp_path / os.fsdecode(b"\xff")).mkdir()
	(name,) = os.listdir(tmp_path)
	folder = tmp_path / name
	shutil.copy("scenes/room.gltf", folder / (name + ".gltf"))
	context.open_scene(str(folder / (name + ".gltf")), SMALL)
	context.open_scene_bytes(pathlib.Path("scenes/room.gltf").read_bytes(), SMALL, name=name)
	touchstone.write_png(folder / "a.png", np.zeros((1, 1, 3), np.uint8), {"name": name})
	assert touchstone.read_image(str(folder / "a.png")).shape == (1, 1, 3)
	reference.save(str(folder / "saved"), producer=name)
	assert context.open(str(folder / "saved")).about.folder == str(folder / "saved")
	with pytest.raises(touchstone.Error, match="xff"):
		context.open_scene(str(folder / "none.gltf"))


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


def test_outlined(reference):
	whole, outline = [reference.explain("image", item=7, outline=outline)["launches"][0]["lines"] for outline in (0, 1)]
	titles = [line["text"] for line in outline if line["how"] == "title"]
	assert len(titles) > 3 and set(titles) == {line["text"] for line in whole if line["how"] == "title"}
	for line in outline:
		same = whole[line.pop("number") - 1]
		assert line.pop("times") >= 1 and line == same


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
	golden = pathlib.Path("reference/goldens/small-mvr").absolute()
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


def test_a_method_runs_on_from_ones_own_buffers(context, scene, reference):
	same = context.continue_from(reference, {"pose.vertex": reference["pose.vertex"].copy()})
	assert list(same) == list(reference) and all(np.array_equal(same[name], reference[name]) for name in same)
	made = [name for name in same if same[name].ctypes.data != reference[name].ctypes.data]
	assert "image.srgb" in made and "splat.depth_index" in made and "scene.vertex" not in made
	mine = reference["points.record"].copy()
	mine["length"] *= np.float32(0.25)
	trace = context.continue_from(reference, {"points.record": mine})
	changed = {name for name in trace if not np.array_equal(trace[name], reference[name])}
	assert {"points.record", "splat.depth_index", "image.srgb"} <= changed and "points.key" not in changed
	assert np.array_equal(trace["points.record"], mine)
	by_hand = reference.candidate()
	by_hand["points.record"] = mine
	for stage in ("splat", "lookup"):
		for name, array in context.replayed(stage, reference, by_hand).items():
			by_hand[name] = array
	assert all(np.array_equal(trace[name], by_hand[name]) for name in by_hand)
	still = context.continue_from(reference, {"points.record": mine,
	                                          "splat.depth_index": reference["splat.depth_index"]})
	assert np.array_equal(still["splat.depth_index"], reference["splat.depth_index"])


def test_what_a_method_cannot_run_on_from(context, scene, reference):
	mine = reference["points.record"]
	for buffers, line in (({"points.recrd": mine}, "points.recrd: the reference has no such buffer"),
	                      ({"points.record": mine["length"]}, "points.record: dtype float32; "),
	                      ({"points.record": mine[:0]}, r"stage splat: points.offset: element 9966: .* would be right"),
	                      ({"points.record": mine.reshape(1, -1)}, "points.record: its shape is none of points")):
		with pytest.raises(touchstone.Error, match=line) as raised:
			context.continue_from(reference, buffers)
		assert "\n" not in str(raised.value)
	part = context.run(scene, "reflections", "epr", SMALL, buffers=["points.record", "image.srgb"])
	with pytest.raises(touchstone.Error, match="no file of cube_size.face, .*points.offset"):
		context.continue_from(part, {"points.record": mine})


def test_what_the_documents_show(tmp_path, monkeypatch):
	text = pathlib.Path(touchstone.__file__).read_text().split('"""')[1]  # of __doc__ Python 3.13 strips the indent
	shown = re.findall(r"^\t(.*)", text, re.M)
	recipe = pathlib.Path("reference/RECIPES.md").read_text().split("## Try a stage in NumPy\n")[1].split("\n## ")[0]
	monkeypatch.chdir(tmp_path)
	for lines in (shown, ["import touchstone", *re.findall("^ {4}(.*)", recipe, re.M)]):
		code = "\n".join(lines).replace('"atrium"',
		                                '"atrium:triangles=10000:texels=32"').replace('"epr")', f'"epr", {SMALL})')
		code = re.sub('"width": 480, "height": 270', str(SMALL)[1:-1], code)
		code = code.replace("my_keys", 'reference["eye.depth_triangle"]')
		ran = {}
		exec(code, ran)
		assert not np.array_equal(ran["trace"]["image.srgb"], ran["reference"]["image.srgb"])
	assert (tmp_path / "mine.png").exists()


def test_rendering(context, scene, reference):
	rendering = context.render(scene, "reflections", ["epr", "mvr"], "B", SMALL, stages=True)
	pictures, figures = rendering.pictures, rendering.figures
	assert {"epr", "mvr", "truth-b", "epr-points"} <= set(pictures) and "truth-b" in repr(rendering)
	assert np.array_equal(pictures["epr"].radiance, reference["image.radiance"])
	assert pictures["epr-points"].radiance is None and not pictures["truth-b"].estimated
	shown = touchstone.metrics(pictures["truth-b"].srgb, pictures["epr"].srgb)
	assert rendering["epr.rmse.B"] == figures["epr.rmse.B"].value == shown.rmse
	assert figures["epr.ms.splat"].unit == "ms" and figures["epr.ms.splat"].timed and not figures["epr.rmse.B"].timed
	assert rendering["epr.count.points"] == len(reference["points.record"])
	assert rendering["epr.bytes.points.record"] == reference["points.record"].nbytes
	difference = rendering.picture("difference-epr-mvr")
	assert np.array_equal(difference.radiance, pictures["epr"].radiance - pictures["mvr"].radiance)
	kept = pictures["epr"].srgb
	after = context.render(scene, "reflections", ["epr", "mvr"], "B", {**SMALL, "frame": 1}, before=rendering)
	del rendering, pictures
	assert after["epr.flicker.B"] > 0 and kept.max() > 0
	with pytest.raises(touchstone.Error, match="no truth"):
		context.render(scene, "reflections", "epr", "Z", SMALL)
	with pytest.raises(touchstone.Error, match="no variant, and no truth"):
		after["epr.rmse.Z"]
	with pytest.raises(touchstone.Error, match="no such picture"):
		after.picture("epr-points")


def test_bench(context, tmp_path):
	table = tmp_path / "my.table"
	table.write_text("table mine\neffect reflections\nscenes atrium\nvariant epr = epr seen\nvariant mvr = mvr seen\n"
	                 "part one \"One\"\n\trmse \"RMSE\" 3 = epr.rmse.mvr\n\twide \"wide\" whole = image.width\n")
	figures = context.bench(table, scenes="atrium:triangles=10000:texels=32", params=SMALL)
	assert figures["one"][0]["rmse"] > 0 and figures["one"][0]["wide"] == SMALL["width"]
	table.write_text("table mine\neffect mirrors\n")
	with pytest.raises(touchstone.Error, match="my.table:2:8: no effect"):
		context.bench(table)


def test_truth(context, scene, reference):
	truth = context.truth(scene, "reflections", "B", SMALL)
	light = touchstone.light_metrics(truth.radiance, reference["image.radiance"])
	shown = touchstone.metrics(truth.srgb, reference["image.srgb"])
	assert 0 < light.relative < 1 and 20 < shown.psnr < 60 and not truth.estimated
	pixel = truth.radiance[0, 0].copy()
	kept = truth.radiance
	del truth
	gc.collect()
	assert np.array_equal(kept[0, 0], pixel)
	with pytest.raises(touchstone.Error, match="magic"):
		context.truth(scene, "reflections", "magic", SMALL)


def test_digests_of_a_run_that_keeps_nothing(context, scene, reference):
	assert context.digests(scene, "reflections", "epr", SMALL) == {name: reference.digest(name) for name in reference}


def test_what_traces_and_scenes_say(context, scene, reference):
	about = reference.about
	assert (about.effect, about.method, about.arrival) == ("reflections", "epr", 0) and about.has_params
	assert reference.takes("splat") and not reference.takes("hull")
	assert reference.shape("image.srgb") == (36, 64, 3)
	assert scene.info()["triangles"] == len(reference["scene.triangle"])
	with pytest.raises(touchstone.Error, match="mvr"):
		reference.match(context.run(scene, "reflections", "mvr", SMALL))
	point = reference.probe_point(5)
	assert reference.probe_point_key(*map(int, point["key"].split(","))) == point


def test_reprs_are_short(context, scene, reference):
	port = reference.candidate()
	port["image.srgb"] = np.zeros_like(reference["image.srgb"])
	page = context.page()
	page.add(reference)
	verdicts = context.compare(reference, port)
	for one, wanted in ((context, "c, device 0"), (scene, "'atrium:triangles=10000:texels=32'"),
	                    (port, "epr of reflections, 1 buffers"), (page, "1 parts")):
		assert wanted in repr(one) and len(repr(one)) < 100
	assert verdicts.first.line in repr(verdicts) and "no difference" in repr(context.compare(reference, reference))


@pytest.mark.parametrize("name", [b"\xe9t\xe9", os.fsdecode(b"\xe9t\xe9"), pathlib.Path("plain")])
def test_any_path(context, scene, reference, tmp_path, name):
	at = os.path.join(os.fsencode(tmp_path) if isinstance(name, bytes) else tmp_path, name)
	inside = lambda file: os.path.join(at, os.fsencode(file) if isinstance(name, bytes) else file)
	context.write(at, scene, "reflections", "mvr", SMALL)
	trace = context.open(at)
	assert os.fsencode(trace.about.folder) == os.fsencode(at)
	file = next(one for one in os.listdir(os.fsdecode(at)) if one.endswith("image.srgb.npy"))
	assert np.array_equal(context.open_npy(inside(file))["image.srgb"], trace["image.srgb"])
	listed = context.open_list(at, {"image.srgb": file}, trace)
	assert list(listed) == ["image.srgb"] and context.compare(trace, listed, stages="image", ignore="image.radiance")
	trace.save(inside("saved"))
	touchstone.write_png(inside("image.png"), trace["image.srgb"])
	assert touchstone.read_image(inside("image.png")).shape == (36, 64, 3)
	page = context.page()
	page.add(trace)
	page.write(inside("page.html"))
	assert {"saved", "image.png", "page.html"} < set(os.listdir(os.fsdecode(at)))
	with pytest.raises(touchstone.Error, match="scene.gltf") as raised:
		context.open_scene(inside("scene.gltf"))
	str(raised.value).encode()
