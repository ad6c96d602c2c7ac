"""The scenes that the rows change a little: a square before a camera, lit, textured, skinned, moved; and points."""
import json
import math

from document import (GONE, KINDS, UNLIT, Document, data, data_uri, edit, flat, flattened, pack, quarters, view)

SKY = (0.2, 0.3, 0.5)
LIT = {"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 1}}
# Nothing of it is reflected: what it emits is seen alone.
DARK = {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 1, "roughnessFactor": 1}
IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
CORNERS = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]
HALF = math.sqrt(0.5)
EIGHTH = [0, 0.3826834, 0, 0.9238795]  # of a turn about y
TURNED = {"rotation": [0, 1, 0, 0]}
BASE_TEXTURE = "materials/0/pbrMetallicRoughness/baseColorTexture"
ATTRIBUTES = "meshes/0/primitives/0/attributes"
LIGHT = "extensions/KHR_lights_punctual/lights/0"
INSTANCES = "EXT_mesh_gpu_instancing"
INSTANCES_OF = "nodes/1/extensions/EXT_mesh_gpu_instancing/attributes"


# ---- pixels that are right ----

def at(**colours):
	"""By the name of a quarter or the middle: colours of the picture's pixels."""
	places = {"upper_left": (4, 4), "upper_right": (11, 4), "lower_left": (4, 11), "lower_right": (11, 11),
	          "middle": (8, 8)}
	return {places[name]: colour for name, colour in colours.items()}


def all_of(red, green=None, blue=None):
	"""One colour, everywhere."""
	colour = (red, red if green is None else green, red if blue is None else blue)
	return {(8, 8): colour, (3, 5): colour}


FOUR = at(upper_left=(1, 0, 0), upper_right=(0, 1, 0), lower_left=(0, 0, 1), lower_right=(1, 1, 1))


# ---- the square ----

def camera(document, z=2.0):
	lens = {"yfov": 2 * math.atan(1 / z), "znear": 0.1}
	index = document.add("cameras", {"type": "perspective", "perspective": lens})
	document.node(name="cam", camera=index, translation=[0, 0, z])


def square():
	"""Attributes of a square of side 2."""
	return {"POSITION": data("f32", "VEC3", CORNERS, min=[-1, -1, 0], max=[1, 1, 0], target=34962),
	        "NORMAL": data("f32", "VEC3", [0, 0, 1] * 4, target=34962),
	        "TEXCOORD_0": data("f32", "VEC2", [0, 1, 1, 1, 1, 0, 0, 0], target=34962)}


def textured(**more):
	"""A material without light, of the first texture."""
	return {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "extensions": {UNLIT: {}}, **more}


def base(material=GONE, light=True, attributes=None, node=None, image=None, mime="image/png", **primitive):
	"""A square that fills the picture, without light, of the texture quarters(). material: another, or None. image:
	another. Of attributes and of the primitive's members None leaves one out. Node 0 is the camera, node 1 the square,
	node 2 a light."""
	document = Document()
	camera(document)
	material = textured() if material is GONE else material
	vertices = {**square(), **(attributes or {})}
	parts = {"attributes": {name: item for name, item in vertices.items() if item is not None},
	         "indices": data("u16", "SCALAR", [0, 1, 2, 0, 2, 3], target=34963), **primitive}
	parts = {name: document.taken(item) for name, item in parts.items() if item is not None}
	if material is not None:
		parts["material"] = document.add("materials", material)
		document.uses(*material.get("extensions", {}))
		for slot in material.values():
			document.uses(*(slot.get("extensions", {}) if isinstance(slot, dict) else {}))
	document.node(name="square", mesh=document.add("meshes", {"primitives": [parts]}), **(node or {}))
	if image is not None or '"index": ' in json.dumps(material):
		document.texture(quarters() if image is None else image, mime)
	if light:
		document.light()
	return document


def lit(factors=None, attributes=None, node=None, light=True, **material):
	return base({"pbrMetallicRoughness": {"metallicFactor": 0, **(factors or {})}, **material}, light, attributes, node)


def solid(colour=(1, 0, 0), alpha=1, attributes=None, node=None, **material):
	"""Of one colour, without light."""
	factors = {"pbrMetallicRoughness": {"baseColorFactor": [*colour, alpha]}, "extensions": {UNLIT: {}}}
	return base({**factors, **material}, True, attributes, node)


def shown(image, mime="image/png"):
	"""The square with this image."""
	document = base(image=image, mime=mime)
	return edit(document, ("images/0/mimeType", GONE)) if mime is None else document


def tilted(document):
	"""The same with light from the right and above."""
	return edit(document, ("nodes/2/rotation", [-0.2, 0.2, 0, 0.96]))


def child_of(parent, roots, **more):
	"""The square below node 3."""
	return edit(base(**more), ("nodes/3", {"children": [1], **parent}), ("scenes/0/nodes", roots))


def shifted(x, y=0, z=0):
	return base(node={"translation": [x, y, z]})


# ---- attributes ----

def colours(values, kind="f32", type="VEC4", **more):
	return {"COLOR_0": data(kind, type, values, **more)}


def coordinates(left, right, top, bottom):
	return {"TEXCOORD_0": data("f32", "VEC2", [left, bottom, right, bottom, right, top, left, top])}


def tangents(w, x=1.0):
	return {"TANGENT": data("f32", "VEC4", [x, 0, 0, w] * 4, target=34962)}


def normals(x, y, z):
	return {"NORMAL": data("f32", "VEC3", [x, y, z] * 4)}


def zeros(attribute, kind, type, width, normalized=False):
	"""The square, of which an attribute is of zeros, of so many bytes an item, at multiples of 4."""
	stride = width + -width % 4
	place = view(bytes(4 * stride), byteStride=stride)
	return base(attributes={attribute: data(kind, type, [], view=place, count=4,
	                                        **({"normalized": True} if normalized else {}))})


def second_set(document):
	"""The document, whose texture coordinates are its second set; the first one is of zeros."""
	sets = document.primitive["attributes"]
	return edit(document, (f"{ATTRIBUTES}/TEXCOORD_1", sets["TEXCOORD_0"]),
	            (f"{ATTRIBUTES}/TEXCOORD_0", data("f32", "VEC2", [0] * 8)))


def sampled(left, right, top, bottom, **sampler):
	"""The square with these texture coordinates, and a sampler."""
	document = base(attributes=coordinates(left, right, top, bottom))
	return edit(document, ("samplers", [sampler]), ("textures/0/sampler", 0)) if sampler else document


def normal_map(x, y, z=255, attributes=None, alpha=(), **info):
	"""The square, lit from the right and above, with a normal map of one pixel."""
	return tilted(base({**LIT, "normalTexture": {"index": 0, **info}}, attributes=attributes,
	                   image=flat(x, y, z, *alpha)))


def transformed(**transform):
	"""The square, whose texture has a KHR_texture_transform."""
	document = base().uses("KHR_texture_transform")
	return edit(document, (f"{BASE_TEXTURE}/extensions", {"KHR_texture_transform": transform}))


def indexed(values, kind="u16", more_vertices=0, **primitive):
	"""The square, by these indices."""
	document = base(**primitive)
	if more_vertices:
		changes = {"POSITION": ("VEC3", CORNERS, [0, 0, -9]), "NORMAL": ("VEC3", [0, 0, 1] * 4, [0, 0, 1]),
		           "TEXCOORD_0": ("VEC2", [0, 1, 1, 1, 1, 0, 0, 0], [0, 0])}
		for name, (type, first, other) in changes.items():
			edit(document, (f"{ATTRIBUTES}/{name}", data("f32", type, first + other * more_vertices)))
	return edit(document, ("meshes/0/primitives/0/indices", data(kind, "SCALAR", values, target=34963)))


def sparse(indices=(2, 3), values=(1, 1, 0, -1, 1, 0), count=None, kind="u16", begun=True, indices_view=None,
           values_view=None):
	"""The square, whose last two corners are sparse; or all of them, where the accessor has no view."""
	document = base()
	if not begun:
		indices, values = (0, 1, 2, 3), CORNERS
	of_indices = document.view(pack(kind, indices), **(indices_view or {}))
	of_values = document.view(pack("f32", values), **(values_view or {}))
	wrong = document.view(pack("f32", CORNERS[:6] + [9] * 6))
	return edit(document, ("accessors/0/bufferView", wrong if begun else GONE),
	            ("accessors/0/sparse", {"count": count or len(indices),
	                                    "indices": {"bufferView": of_indices, "componentType": KINDS[kind][0]},
	                                    "values": {"bufferView": of_values}}))


def sparse_indices():
	"""The square, one of whose indices is sparse."""
	document = indexed([0, 1, 2, 0, 2, 1])
	return edit(document, (f"accessors/{document.primitive['indices']}/sparse", {
		"count": 1, "indices": {"bufferView": view(pack("u8", [5])), "componentType": KINDS["u8"][0]},
		"values": {"bufferView": view(pack("u16", [3]))}}))


def strided(values, width, gap):
	"""Floats, so many an item, with a gap of bytes after each."""
	return b"".join(pack("f32", values[i:i + width]) + bytes(gap) for i in range(0, len(values), width))


def shared_view():
	"""The square, whose positions and indices lie in one view."""
	document = base()
	views, new = document.json["bufferViews"], len(document.json["bufferViews"])
	changes = [(f"accessors/{i}/{key}", value) for i in (0, 3)
	           for key, value in (("byteOffset", views[i]["byteOffset"]), ("bufferView", new))]
	return edit(document, (f"bufferViews/{new}", {"buffer": 0, "byteLength": len(document.bytes[0])}), *changes)


def unaligned_in_view():
	"""The square, whose positions begin 2 bytes into a view that begins 2 bytes behind a multiple of 4."""
	document = base()
	document.view(bytes(4) + pack("f32", CORNERS))
	place = document.json["bufferViews"][-1]
	place.update(byteOffset=place["byteOffset"] + 2, byteLength=50)
	index = len(document.json["bufferViews"]) - 1
	return edit(document, ("accessors/0/bufferView", index), ("accessors/0/byteOffset", 2))


def byte_normals(kind, one):
	"""Normals of normalized bytes, along z."""
	place = view(bytes([0, 0, one, 0]) * 4, byteStride=4, target=34962)
	return {"NORMAL": data(kind, "VEC3", [], view=place, count=4, normalized=True)}


def with_fallback(extension):
	"""The square, whose texture names an image of this extension, too."""
	document = base().uses(extension)
	return edit(document, ("images/1", {"bufferView": view(b"RIFF0000WEBP0000"), "mimeType": "image/webp"}),
	            ("textures/0/extensions", {extension: {"source": 1}}))


def first_position(value):
	"""The square, of which one number of a corner is another."""
	document = base()
	start = document.json["bufferViews"][0]["byteOffset"]
	document.bytes[0] = document.bytes[0][:start] + pack("f32", [value]) + document.bytes[0][start + 4:]
	return document


def with_targets(weights=None, node_weights=None, target=None, count=4, times=1):
	"""The square with morph targets."""
	document = base()
	moved = document.accessor(data("f32", "VEC3", [1, 0, 0] * count, min=[1, 0, 0], max=[1, 0, 0]))
	targets = [{"POSITION": moved, **(target or {})}] * times
	edit(document, ("meshes/0/primitives/0/targets", targets))
	if weights is not None:
		edit(document, ("meshes/0/weights", weights))
	return edit(document, ("nodes/1/weights", node_weights)) if node_weights is not None else document


# ---- buffers and images ----

def buffered(uri, cut=0, more=b""):
	"""The square, whose buffer has this URI; uri(bytes) makes it of them."""
	document = base()
	content = document.bytes[0]
	kept = content[:len(content) - cut] + more
	return edit(document, ("buffers", [{"byteLength": len(content), "uri": uri(kept)}]))


def octets(content):
	return data_uri("application/octet-stream", content)


def buffer_in(uri, name, cut=0, more=b"", times=1):
	"""The square, whose buffer is the file `name` of its folder, by this URI; times: as so many buffers."""
	document = base()
	content = document.bytes[0]
	document.beside = {name: content[:len(content) - cut] + more}
	return edit(document, ("buffers", [{"byteLength": len(content), "uri": uri}] * times))


def image_in(uri, name):
	document = edit(base(), ("images", [{"uri": uri}]))
	document.beside = {name: quarters()}
	return document


def image_at(uri):
	return edit(base(), ("images", [{"uri": uri}]))


# ---- motion ----

def played(document, node, values, path="translation", times=(0, 1), kind="f32", mode=None, **output):
	"""The document with an animation of a node."""
	type = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}[len(values[0])]
	times = document.accessor(data("f32", "SCALAR", times, min=[min(times)], max=[max(times)]), 1)
	output = document.accessor(data(kind, type, flattened(values), **output), 1)
	sampler = {"input": times, "output": output, **({"interpolation": mode} if mode else {})}
	channel = {"sampler": 0, "target": {"node": node, "path": path}}
	document.add("animations", {"samplers": [sampler], "channels": [channel]})
	return document


STILL = ((0, 0, 0), (0, 0, 0))


def moving(values=STILL, path="translation", node=None, target=1, **more):
	"""The square, animated."""
	return played(base(node=node), target, values, path, **more)


def second_light(document):
	"""The document, whose light stands at another node too."""
	document.node(translation=[0, 0, 2], extensions={"KHR_lights_punctual": {"light": 0}})
	return document


def moved(x=0.0, y=0.0, z=0.0):
	return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1]


def skinned(joint=None, node=None, matrices=None, joints=(0, 0, 0, 0), weights=(1.0, 0, 0, 0), joints_kind="u8",
            weights_kind="f32", document=None):
	"""The square, all of it held by joint 0 at node 3; joint 1 is node 4, below it."""
	document = document or base(node=node)
	share = {"normalized": True} if weights_kind != "f32" else {}
	document.primitive["attributes"].update(
		JOINTS_0=document.accessor(data(joints_kind, "VEC4", joints * 4), 1),
		WEIGHTS_0=document.accessor(data(weights_kind, "VEC4", weights * 4, **share), 1))
	first = document.node(name="joint", children=[4], **(joint or {}))
	skin = {"joints": [first, document.node(root=False, name="tip")]}
	if matrices is not None:
		skin["inverseBindMatrices"] = document.accessor(data("f32", "MAT4", flattened(matrices)), 1)
	document.add("skins", skin)
	return edit(document, ("nodes/1/skin", 0))


def instanced(translations, listed=True, rotations=None, scales=None):
	"""Squares of 0.4 of the size, as instances of one node."""
	document = base(node={"scale": [0.4, 0.4, 0.4]})
	parts = {"TRANSLATION": ("VEC3", translations), "ROTATION": ("VEC4", rotations), "SCALE": ("VEC3", scales)}
	attributes = {name: data("f32", type, flattened(rows)) for name, (type, rows) in parts.items() if rows}
	edit(document, ("nodes/1/extensions", {INSTANCES: {"attributes": attributes}}))
	return document.uses(INSTANCES) if listed else document


def two_squares():
	"""What two instances are to look like."""
	document = base(node={"scale": [0.4, 0.4, 0.4], "translation": [-0.5, 0, 0]})
	document.node(mesh=0, scale=[0.4, 0.4, 0.4], translation=[0.5, 0, 0])
	return document


def small(**node):
	return base(node={"scale": [0.4, 0.4, 0.4], **node})


def quantized(kind="i16", normalized=False, used=True, required=True, padded=True):
	"""The square, whose corners are integers; the node scales them back."""
	one, size = (64, 1) if kind[1:] == "8" else (16384, 2)
	top = {"i8": 127, "u8": 255, "i16": 32767, "u16": 65535}[kind]
	unsigned = kind[0] == "u"
	low, high = (0, 2 * one) if unsigned else (-one, one)
	corners = [(low, low, 0), (high, low, 0), (high, high, 0), (low, high, 0)]
	scale = (top if normalized else 1) / one
	document = base(node={"scale": [scale] * 3, "translation": [-1, -1, 0] if unsigned else [0, 0, 0]})
	gap = -(3 * size) % 4 if padded else 0
	index = document.view(b"".join(pack(kind, corner) + bytes(gap) for corner in corners), target=34962,
	                      **({"byteStride": 3 * size + gap} if padded else {}))
	share = {"normalized": True} if normalized else {}
	edit(document, (f"{ATTRIBUTES}/POSITION", data(kind, "VEC3", [], view=index, count=4, min=[low, low, 0],
	                                               max=[high, high, 0], **share)))
	if used:
		document.uses("KHR_mesh_quantization")
	return edit(document, ("extensionsRequired", ["KHR_mesh_quantization"])) if required else document


# ---- lights ----

def point_light(z=2.0, scale=None, **light):
	"""A point light above the middle of a lit square."""
	document = base(LIT, light=False)
	document.light({"translation": [0, 0, z], **({"scale": scale} if scale else {})},
	               {"type": "point", "intensity": 8, **light})
	return document


def spot(cone=None, rotation=None):
	document = base(LIT, light=False)
	document.light({"rotation": rotation} if rotation else {},
	               {"type": "spot", "intensity": 8, **({"spot": cone} if cone is not None else {})})
	return document


def emitting(**strength):
	"""A dark square that emits."""
	name = "KHR_materials_emissive_strength"
	return base({"pbrMetallicRoughness": DARK, "emissiveFactor": [1, 0.5, 0], "extensions": {name: strength}})


# ---- points ----

def points(attributes=None, material=None, normal=True):
	"""Sixteen points before the camera."""
	document = Document()
	camera(document)
	places = flattened((x * 0.5 - 0.75, y * 0.5 - 0.75, 0) for y in range(4) for x in range(4))
	parts = {"POSITION": data("f32", "VEC3", places, min=[-0.75, -0.75, 0], max=[0.75, 0.75, 0])}
	if normal:
		parts["NORMAL"] = data("f32", "VEC3", [0, 0, 1] * 16)
	primitive = {"attributes": document.taken({**parts, **(attributes or {})}), "mode": 0}
	if material is not None:
		primitive["material"] = document.add("materials", material)
	document.node(mesh=document.add("meshes", {"primitives": [primitive]}))
	document.light()
	return document
