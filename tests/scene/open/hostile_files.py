#!/usr/bin/python3
"""Writes hostile and odd scene files to FOLDER/files, each of them a small whole model with one thing changed, what
they name beside them, and FOLDER/manifest.tsv: a line each of the file, the triangles that it has or "refused", and
words of the line that refuses it. The same bytes each time. Usage: hostile_files.py FOLDER"""
import base64
import copy
import json
import os
import struct
import sys
import zlib

GONE = ...  # as a value: the member is taken out
NAN, INFINITE = float("nan"), float("inf")


# ---- whole files ----

def chunk(kind, data):
	return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


SIGNATURE, END = b"\x89PNG\r\n\x1a\n", chunk(b"IEND", b"")


def header(width, height, depth=8, colour=2, interlaced=0):
	return chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, interlaced))


def pixels(width, height, depth=8, colour=2, filtered=0):
	row = bytes([filtered]) + bytes((width * depth * {2: 3, 4: 2, 6: 4}.get(colour, 1) + 7) // 8)
	return chunk(b"IDAT", zlib.compress(height * row))


def png(width=3, height=2, depth=8, colour=2, between=b""):
	return SIGNATURE + header(width, height, depth, colour) + between + pixels(width, height, depth, colour) + END


def segment(marker, data):
	return struct.pack(">BBH", 0xFF, marker, len(data) + 2) + data


def jpeg():
	"""Eight by eight grey pixels, with Huffman tables of one code."""
	table = bytes([1] + 16 * [0])
	head = segment(0xDB, b"\0" + 64 * b"\1") + segment(0xC0, bytes([8, 0, 8, 0, 8, 1, 1, 17, 0]))
	tables = segment(0xC4, b"\0" + table) + segment(0xC4, b"\x10" + table)
	return b"\xff\xd8" + head + tables + segment(0xDA, bytes([1, 1, 0, 0, 63, 0])) + b"\x3f\xff\xd9"


def f32(*values):
	return struct.pack(f"<{len(values)}f", *values)


def u16(*values):
	return struct.pack(f"<{len(values)}H", *values)


def u32(*values):
	return struct.pack(f"<{len(values)}I", *values)


def cube():
	"""The document and the binary part of a textured cube of 12 triangles."""
	positions, normals, indices = [], [], []
	for face in range(6):
		axis, side = face // 2, 1 - face % 2 * 2
		for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
			at = {axis: side, (axis + 1) % 3: u * side, (axis + 2) % 3: v}
			positions += [at[0], at[1], at[2]]
			normals += [side * (k == axis) for k in range(3)]
		indices += [4 * face + k for k in (0, 1, 2, 0, 2, 3)]
	parts = [f32(*positions), f32(*normals), f32(*(24 * [0.25, 0.75])), u16(*indices), png()]
	doc = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
	       "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3,
	                                   "material": 0}]}],
	       "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
	       "textures": [{"source": 0, "sampler": 0}], "samplers": [{}],
	       "images": [{"bufferView": 4, "mimeType": "image/png"}],
	       "accessors": [{"bufferView": 0, "componentType": 5126, "count": 24, "type": "VEC3"},
	                     {"bufferView": 1, "componentType": 5126, "count": 24, "type": "VEC3"},
	                     {"bufferView": 2, "componentType": 5126, "count": 24, "type": "VEC2"},
	                     {"bufferView": 3, "componentType": 5123, "count": 36, "type": "SCALAR"}],
	       "bufferViews": []}
	data = b""
	for part in parts:
		doc["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
		data += part + bytes(-len(part) % 4)
	doc["buffers"] = [{"byteLength": len(data)}]
	return doc, data


DOC, DATA = cube()
NORMALS, UVS, INDICES, IMAGE = (view["byteOffset"] for view in DOC["bufferViews"][1:])


def text_of(doc):
	return json.dumps(doc, separators=(",", ":")).encode()


def glb_chunk(kind, data, pad):
	data += pad * (-len(data) % 4)
	return struct.pack("<I4s", len(data), kind) + data


def glb(text, data, more=b""):
	chunks = glb_chunk(b"JSON", text, b" ") + (glb_chunk(b"BIN\0", data, b"\0") if data is not None else b"") + more
	return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def put(data, at, new):
	return data[:at] + new + data[at + len(new):]


def change(doc, path, value):
	"""Sets the member at a/b/0/c, which may be one behind the end of an array."""
	*steps, last = (int(step) if step.isdigit() else step for step in path.split("/"))
	for step in steps:
		doc = doc[step]
	if value is GONE:
		del doc[last]
	elif isinstance(doc, list) and last == len(doc):
		doc.append(value)
	else:
		doc[last] = value


def changed(changes):
	"""The cube with the members of those paths changed; of the path bin/OFFSET, bytes;
	with `more`, bytes at the end."""
	doc, data = copy.deepcopy(DOC), DATA
	for path, value in changes.items():
		if path == "more":
			doc["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(value)})
			data += value + bytes(-len(value) % 4)
			doc["buffers"][0]["byteLength"] = len(data)
		elif path.startswith("bin/"):
			data = put(data, int(path[4:]), value)
		else:
			change(doc, path, copy.deepcopy(value))
	return doc, data


def textual(uri=None, image=None):
	"""The cube as .gltf: its buffer and image are there."""
	doc = copy.deepcopy(DOC)
	inside = "data:application/octet-stream;base64," + base64.b64encode(DATA).decode()
	doc["buffers"][0]["uri"] = uri if uri is not None else inside
	if image is not None:
		doc["images"] = [{"uri": image}]
	return text_of(doc)


# ---- the tables: a name, what is changed, and triangles or words ----

POSITION, NORMAL, UV, INDEX = ("accessors/" + str(i) for i in range(4))
PRIMITIVE, MATERIAL, NODE = "meshes/0/primitives/0", "materials/0", "nodes/0"
FACTORS = MATERIAL + "/pbrMetallicRoughness"

MEMBERS = [
	# Accessors.
	("acc_past_view", {POSITION + "/count": 25}, "accessors/0: ends at byte"),
	("acc_offset_past_view", {POSITION + "/byteOffset": 4096}, "accessors/0: ends at byte"),
	("acc_offset_negative", {POSITION + "/byteOffset": -12}, "accessors/0/byteOffset is"),
	("acc_offset_unaligned", {POSITION + "/byteOffset": 2}, "accessors/0: ends at byte"),
	("acc_count_zero", {POSITION + "/count": 0}, "accessors/0/count is"),
	("acc_count_negative", {POSITION + "/count": -24}, "accessors/0/count is"),
	("acc_count_half", {POSITION + "/count": 23.5}, "accessors/0/count is"),
	("acc_count_text", {POSITION + "/count": "24"}, "accessors/0/count is"),
	("acc_count_2p32", {POSITION + "/count": 2**32 - 1}, "accessors/0/count is"),
	("acc_count_wraps_32", {POSITION + "/count": 357913942}, "accessors/0: ends at byte"),
	("acc_count_wraps_64", {POSITION + "/count": 1537228672809129302}, "accessors/0/count is"),
	("acc_count_none", {POSITION + "/count": GONE}, "accessors/0/count is missing"),
	("acc_counts_differ", {NORMAL + "/count": 12},
	 "meshes/0/primitives/0: POSITION has 24 items, another attribute has 12"),
	("acc_index_count_1e9", {INDEX + "/count": 1000000000}, "accessors/3: ends at byte"),
	("acc_no_view", {POSITION + "/bufferView": GONE}, 12),
	("acc_no_view_1e9", {p + k: v for p in (POSITION, NORMAL, UV)
	                     for k, v in (("/bufferView", GONE), ("/count", 10**9))}, "accessors/1:"),
	("acc_view_beyond", {POSITION + "/bufferView": 66}, "accessors/0/bufferView is"),
	("acc_view_negative", {POSITION + "/bufferView": -1}, "accessors/0/bufferView is"),
	("acc_component_1234", {POSITION + "/componentType": 1234}, "accessors/0/componentType is"),
	("acc_component_double", {POSITION + "/componentType": 5130}, "accessors/0/componentType is"),
	("acc_position_ubyte", {POSITION + "/componentType": 5121}, "accessors/0 (POSITION): componentType"),
	("acc_position_vec2", {POSITION + "/type": "VEC2"}, "accessors/0 (POSITION): the type is not what this use needs"),
	("acc_position_mat4", {POSITION + "/type": "MAT4", POSITION + "/count": 4},
	 "accessors/0 (POSITION): the type is not what this use needs"),
	("acc_type_vec5", {POSITION + "/type": "VEC5"}, "accessors/0/type is"),
	("acc_type_number", {POSITION + "/type": 3}, "accessors/0/type is"),
	("acc_wrong_bounds", {POSITION + "/min": [-5, -5, -5], POSITION + "/max": [-5, -5, -5]}, 12),
	("acc_bounds_nan_text", {POSITION + "/min": ["a", None, {}]}, 12),
	("acc_null", {"accessors/0": None}, "accessors/0 is"),
	("acc_of_all_is_object", {"accessors": {}}, "accessors is"),
	# Sparse accessors: 2 of the 24 positions.
	*(("sparse_" + name, {"more": u16(3, 7) + f32(1, 2, 3, 4, 5, 6),
	                      "bufferViews/6": {"buffer": 0, "byteOffset": len(DATA) + 4, "byteLength": 24},
	                      POSITION + "/sparse": {"count": 2, "indices": {"bufferView": 5, "componentType": 5123},
	                                             "values": {"bufferView": 6}},
	                      **changes}, outcome) for name, changes, outcome in (
		("valid", {}, 12),
		("no_base_view", {POSITION + "/bufferView": GONE}, 12),
		("index_beyond", {f"bin/{len(DATA)}": u16(3, 60000)}, "accessors/0/sparse: index 60000 of 24"),
		("unsorted", {f"bin/{len(DATA)}": u16(7, 3)}, "accessors/0/sparse: indices must increase"),
		("count_1000", {POSITION + "/sparse/count": 1000}, "accessors/0/sparse/count is"),
		("count_2p32", {POSITION + "/sparse/count": 2**32 - 1}, "accessors/0/sparse/count is"),
		("count_zero", {POSITION + "/sparse/count": 0}, "accessors/0/sparse/count is"),
		("view_beyond", {POSITION + "/sparse/values/bufferView": 66}, "accessors/0/sparse/values/bufferView is"),
		("indices_float", {POSITION + "/sparse/indices/componentType": 5126},
		 "accessors/0/sparse/indices/componentType is"),
		("no_values", {POSITION + "/sparse/values": GONE}, "accessors/0/sparse/values is missing"),
		("is_array", {POSITION + "/sparse": [2]}, "accessors/0/sparse is"))),
	# Buffer views and buffers.
	("view_past_buffer", {"bufferViews/0/byteLength": 100000}, "bufferViews/0 ends at byte"),
	("view_offset_wraps_32", {"bufferViews/0/byteOffset": 2**32 - 4}, "bufferViews/0/byteOffset is"),
	("view_offset_2p53", {"bufferViews/0/byteOffset": 2**53}, "bufferViews/0/byteOffset is"),
	("view_offset_wraps_64", {"bufferViews/0/byteOffset": 2**64 - 16}, "JSON is expected"),
	("view_offset_negative", {"bufferViews/0/byteOffset": -4}, "bufferViews/0/byteOffset is"),
	("view_length_zero", {"bufferViews/0/byteLength": 0}, "bufferViews/0/byteLength is"),
	("view_length_none", {"bufferViews/0/byteLength": GONE}, "bufferViews/0/byteLength is missing"),
	("view_buffer_beyond", {"bufferViews/0/buffer": 3}, "bufferViews/0/buffer is"),
	("view_buffer_none", {"bufferViews/0/buffer": GONE}, "bufferViews/0/buffer is missing"),
	("view_stride_8", {"bufferViews/0/byteStride": 8}, "bufferViews/0: byteStride 8"),
	("view_stride_3", {"bufferViews/0/byteStride": 3}, "bufferViews/0/byteStride is"),
	("view_stride_252", {"bufferViews/0/byteStride": 252}, "accessors/0: ends at byte"),
	("view_stride_2p32", {"bufferViews/0/byteStride": 2**32 - 4}, "bufferViews/0/byteStride is"),
	("view_stride_16", {"bufferViews/0/byteStride": 16, POSITION + "/count": 18, NORMAL + "/count": 18,
	                    UV + "/count": 18, INDEX + "/count": 24}, 8),
	("buffer_longer_than_bin", {"buffers/0/byteLength": 10 << 20}, "buffers/0/byteLength is"),
	("buffer_length_negative", {"buffers/0/byteLength": -1}, "buffers/0/byteLength is"),
	("buffer_length_1e300", {"buffers/0/byteLength": 1e300}, "buffers/0/byteLength is"),
	("buffer_length_none", {"buffers/0/byteLength": GONE}, "buffers/0/byteLength is missing"),
	("buffer_shorter_than_bin", {"more": bytes(1000), "buffers/0/byteLength": len(DATA), "bufferViews/5": GONE}, 12),
	("buffers_none", {"buffers": GONE}, "bufferViews/0/buffer is"),
	("buffers_empty", {"buffers": []}, "bufferViews/0/buffer is"),
	# Indices.
	("idx_beyond_by_1", {f"bin/{INDICES}": u16(24)}, "meshes/0/primitives/0: index 24 at 0"),
	("idx_60000", {f"bin/{INDICES}": u16(60000)}, "meshes/0/primitives/0: index 60000 at 0"),
	("idx_restart_u16", {f"bin/{INDICES}": u16(65535)}, "meshes/0/primitives/0: index 65535 at 0"),
	("idx_u32", {"more": u32(*range(24)), INDEX + "/bufferView": 5, INDEX + "/componentType": 5125,
	             INDEX + "/count": 24}, 8),
	("idx_restart_u32", {"more": u32(0, 1, 2**32 - 1), INDEX + "/bufferView": 5, INDEX + "/componentType": 5125,
	                     INDEX + "/count": 3}, "meshes/0/primitives/0: index 4294967295 at 2"),
	("idx_wraps_u32", {"more": u32(0, 1, 357913942), INDEX + "/bufferView": 5, INDEX + "/componentType": 5125,
	                   INDEX + "/count": 3}, "meshes/0/primitives/0: index 357913942 at 2"),
	("idx_u8", {"more": bytes(range(24)), INDEX + "/bufferView": 5, INDEX + "/componentType": 5121,
	            INDEX + "/count": 24}, 8),
	("idx_restart_u8", {"more": bytes([0, 1, 255]), INDEX + "/bufferView": 5, INDEX + "/componentType": 5121,
	                    INDEX + "/count": 3}, "meshes/0/primitives/0: index 255 at 2"),
	("idx_not_3n", {INDEX + "/count": 35}, 11),
	("idx_2", {INDEX + "/count": 2}, 0),
	("idx_float", {INDEX + "/componentType": 5126, INDEX + "/count": 18}, "accessors/3 (indices): componentType"),
	("idx_signed", {INDEX + "/componentType": 5122}, "accessors/3 (indices): componentType"),
	("idx_vec2", {INDEX + "/type": "VEC2", INDEX + "/count": 18},
	 "accessors/3 (indices): the type is not what this use needs"),
	("idx_strided", {"bufferViews/3/byteStride": 4, INDEX + "/count": 18}, "bufferViews/3: a byteStride under indices"),
	# Primitives and their modes.
	("prim_none", {"meshes/0/primitives": []}, "meshes/0/primitives is"),
	("prim_null", {"meshes/0/primitives": [None]}, "meshes/0/primitives/0 is"),
	("prim_no_attributes", {PRIMITIVE + "/attributes": GONE}, "meshes/0/primitives/0/attributes is missing"),
	("prim_no_position", {PRIMITIVE + "/attributes/POSITION": GONE}, 0),
	("prim_attributes_array", {PRIMITIVE + "/attributes": [0, 1]}, "meshes/0/primitives/0/attributes is"),
	("prim_position_beyond", {PRIMITIVE + "/attributes/POSITION": 77}, "meshes/0/primitives/0/attributes/POSITION is"),
	("prim_indices_beyond", {PRIMITIVE + "/indices": 77}, "meshes/0/primitives/0/indices is"),
	("prim_indices_negative", {PRIMITIVE + "/indices": -2}, "meshes/0/primitives/0/indices is"),
	("prim_material_beyond", {PRIMITIVE + "/material": 3}, "meshes/0/primitives/0/material is"),
	("prim_mode_7", {PRIMITIVE + "/mode": 7}, "meshes/0/primitives/0/mode is"),
	("prim_mode_text", {PRIMITIVE + "/mode": "TRIANGLES"}, "meshes/0/primitives/0/mode is"),
	("prim_no_indices", {PRIMITIVE + "/indices": GONE}, 8),
	("prim_no_normals", {PRIMITIVE + "/attributes/NORMAL": GONE}, 12),
	("prim_no_uv", {PRIMITIVE + "/attributes/TEXCOORD_0": GONE}, 12),
	("prim_no_material", {PRIMITIVE + "/material": GONE}, 12),
	("prim_same_three_times", {"meshes/0/primitives": 3 * DOC["meshes"][0]["primitives"]}, 36),
	*((f"prim_mode_{mode}", {PRIMITIVE + "/mode": mode, PRIMITIVE + "/indices": GONE}, triangles)
	  for mode, triangles in ((0, 0), (1, 0), (2, 0), (3, 0), (5, 22), (6, 22))),
	# Vertices.
	("vtx_nan", {"bin/0": f32(NAN)}, "accessors/0: item 0 is not finite"),
	("vtx_infinite", {"bin/4": f32(INFINITE)}, "accessors/0: item 0 is not finite"),
	("vtx_all_nan", {"bin/0": f32(*(72 * [NAN]))}, "accessors/0: item 0 is not finite"),
	("vtx_3e38", {"bin/0": f32(3e38, -3e38, 3e38)}, "vertex 0: coordinate 4."),
	("vtx_denormal", {"bin/0": f32(*(k * 1e-41 for k in range(72)))}, 12),
	("vtx_all_equal", {"bin/0": f32(*(72 * [1]))}, 12),
	("vtx_far", {"bin/0": f32(*(1e6 + k % 5 for k in range(72)))}, 12),
	("vtx_normal_zero", {f"bin/{NORMALS}": f32(0, 0, 0)}, 12),
	("vtx_normals_nan", {f"bin/{NORMALS}": f32(*(72 * [NAN]))}, "accessors/1: item 0 is not finite"),
	("vtx_normals_long", {f"bin/{NORMALS}": f32(*(72 * [100]))}, 12),
	("vtx_uv_nan", {f"bin/{UVS}": f32(NAN, NAN)}, "accessors/2: item 0 is not finite"),
	("vtx_uv_1e30", {f"bin/{UVS}": f32(1e30, -1e30)}, 12),
	("vtx_uv_7", {FACTORS + "/baseColorTexture/texCoord": 7}, 12),
	("vtx_uv_negative_set", {FACTORS + "/baseColorTexture/texCoord": -1},
	 "materials/0/pbrMetallicRoughness/baseColorTexture/texCoord is"),
	("vtx_zero_area", {f"bin/{INDICES}": u16(5, 5, 5, 6, 6, 7)}, 12),
	("vtx_colours_ubyte_vec2", {PRIMITIVE + "/attributes/COLOR_0": 2},
	 "accessors/2 (COLOR_0): the type is not what this use needs"),
	("vtx_morphed", {PRIMITIVE + "/targets": [{"POSITION": 1}], "meshes/0/weights": [0.5]}, 12),
	("vtx_target_beyond", {PRIMITIVE + "/targets": [{"POSITION": 99}]}, 12),
	("vtx_target_count_differs", {PRIMITIVE + "/targets": [{"POSITION": 3}], "meshes/0/weights": [1]}, 12),
	("vtx_custom", {PRIMITIVE + "/attributes/_CUSTOM": 1, PRIMITIVE + "/attributes/TANGENT": 1},
	 "accessors/1 (TANGENT): the type is not what this use needs"),
	# Nodes, scenes and cameras.
	("node_mesh_beyond", {NODE + "/mesh": 5}, "nodes/0/mesh is"),
	("node_mesh_negative", {NODE + "/mesh": -2}, "nodes/0/mesh is"),
	("node_mesh_half", {NODE + "/mesh": 0.5}, "nodes/0/mesh is"),
	("node_mesh_text", {NODE + "/mesh": "0"}, "nodes/0/mesh is"),
	("node_mesh_2p32", {NODE + "/mesh": 2**32}, "nodes/0/mesh is"),
	("node_mesh_1e300", {NODE + "/mesh": 1e300}, "nodes/0/mesh is"),
	("node_child_beyond", {NODE + "/children": [99]}, "nodes/0/children/0 is"),
	("node_children_object", {NODE + "/children": {"0": 1}}, "nodes/0/children is"),
	("node_own_child", {NODE + "/children": [0]}, "nodes/0 is its own ancestor"),
	("node_circle_of_3", {"nodes": [{"mesh": 0, "children": [1]}, {"children": [2]}, {"children": [0]}]},
	 "nodes/0 is its own ancestor"),
	("node_two_parents", {"nodes": [{"children": [1, 2]}, {"children": [2]}, {"mesh": 0}]},
	 "nodes/2 is a child of nodes/0 and of nodes/1"),
	("node_root_three_times", {"scenes/0/nodes": [0, 0, 0]}, 12),
	("node_2p40_instances", {"nodes": [{"children": [k + 1, k + 1]} for k in range(40)] + [{"mesh": 0}]},
	 "nodes/1 is a child of nodes/0 and of nodes/0"),
	("node_chain_20000", {"nodes": [{"children": [k + 1]} for k in range(20000)] + [{"mesh": 0}]}, 12),
	("node_instances_1000", {"nodes": 1000 * [{"mesh": 0}], "scenes/0/nodes": list(range(1000))}, 12000),
	("node_camera_beyond", {NODE + "/camera": 4}, "nodes/0/camera is"),
	("node_nulls", {"nodes": [None]}, "nodes/0 is"),
	("nodes_object", {"nodes": {}}, "nodes is {}"),
	("meshes_text", {"meshes": "cube"}, "meshes is \"cube\""),
	("scene_beyond", {"scene": 9}, "scene is 9"),
	("scene_node_beyond", {"scenes/0/nodes": [7]}, "scenes/0/nodes/0 is"),
	("scene_empty", {"scenes/0/nodes": GONE}, 0),
	("scene_none", {"scene": GONE, "scenes": GONE}, 0),
	("scene_second", {"scene": 1, "scenes/1": {"nodes": [1, 2]}, "nodes": 3 * [{"mesh": 0}]}, 24),
	("xf_mirrored", {NODE + "/scale": [-1, 1, 1]}, 12),
	("xf_scale_zero", {NODE + "/scale": [0, 0, 0]}, 12),
	("xf_scale_flat", {NODE + "/scale": [1, 0, 1]}, 12),
	("xf_scale_2", {NODE + "/scale": [1, 1]}, "nodes/0/scale is"),
	("xf_rotation_zero", {NODE + "/rotation": [0, 0, 0, 0]}, "nodes/0/rotation is a quaternion of length 0"),
	("xf_rotation_long", {NODE + "/rotation": [0, 0, 0, 2]}, 12),
	("xf_rotation_text", {NODE + "/rotation": "0001"}, "nodes/0/rotation is"),
	("xf_matrix_15", {NODE + "/matrix": 15 * [1]}, "nodes/0/matrix is"),
	("xf_matrix_projective", {NODE + "/matrix": [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},
	 "nodes/0/matrix: the last row must be 0 0 0 1"),
	("xf_matrix_and_scale", {NODE + "/matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
	                         NODE + "/scale": [2, 2, 2]}, "nodes/0 has both matrix and scale"),
	("xf_translation_1e39", {NODE + "/translation": [1e39, 0, 0]}, "nodes/0: a number of its world matrix is beyond"),
	("xf_translation_1e7", {NODE + "/translation": [1e7, 0, 0]}, 12),
	("cam_bad_values", {"cameras": [{"type": "perspective",
	                                 "perspective": {"yfov": 0, "znear": -1, "zfar": -2, "aspectRatio": 0}}],
	                    NODE + "/camera": 0}, 12),
	("cam_no_type", {"cameras": [{}], NODE + "/camera": 0}, "cameras/0/type is missing"),
	# Materials, textures and lights.
	("mat_factor_of_3", {FACTORS + "/baseColorFactor": [1, 1, 1]},
	 "materials/0/pbrMetallicRoughness/baseColorFactor is"),
	("mat_factors_beyond", {FACTORS: {"baseColorFactor": [2, -1, 1e30, 1], "roughnessFactor": -3, "metallicFactor": 7}},
	 "materials/0/pbrMetallicRoughness/baseColorFactor/0 is"),
	("mat_factor_text", {FACTORS + "/roughnessFactor": "rough"}, "materials/0/pbrMetallicRoughness/roughnessFactor is"),
	("mat_alpha_unknown", {MATERIAL + "/alphaMode": "GLASS"}, "materials/0/alphaMode is"),
	("mat_alpha_mask", {MATERIAL + "/alphaMode": "MASK", MATERIAL + "/alphaCutoff": 0.9}, 12),
	("mat_unlit", {MATERIAL + "/extensions": {"KHR_materials_unlit": {}}, "extensionsUsed": ["KHR_materials_unlit"]},
	 12),
	("mat_pbr_array", {FACTORS: [1]}, "materials/0/pbrMetallicRoughness is"),
	("mat_texture_beyond", {FACTORS + "/baseColorTexture/index": 3},
	 "materials/0/pbrMetallicRoughness/baseColorTexture/index is"),
	("mat_texture_no_index", {FACTORS + "/baseColorTexture": {}},
	 "materials/0/pbrMetallicRoughness/baseColorTexture/index is missing"),
	("tex_source_beyond", {"textures/0/source": 3}, "textures/0/source is"),
	("tex_no_source", {"textures/0/source": GONE}, 12),
	("tex_sampler_beyond", {"textures/0/sampler": 3}, "textures/0/sampler is"),
	("tex_wrap_7", {"samplers/0/wrapS": 7, "samplers/0/minFilter": 1}, "samplers/0/wrapS is"),
	("tex_nearest", {"samplers/0": {"wrapS": 33071, "wrapT": 33648, "minFilter": 9728, "magFilter": 9728}}, 12),
	("light_beyond", {NODE + "/extensions": {"KHR_lights_punctual": {"light": 9}},
	                  "extensionsUsed": ["KHR_lights_punctual"]}, "nodes/0/extensions/KHR_lights_punctual/light is"),
	("light_range_0", {"extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "range": 0,
	                                                                      "intensity": -1}]}},
	                   NODE + "/extensions": {"KHR_lights_punctual": {"light": 0}},
	                   "extensionsUsed": ["KHR_lights_punctual"]},
	 "extensions/KHR_lights_punctual/lights/0/intensity is"),
	("light_type_sun", {"extensions": {"KHR_lights_punctual": {"lights": [{"type": "sun"}]}},
	                    NODE + "/extensions": {"KHR_lights_punctual": {"light": 0}},
	                    "extensionsUsed": ["KHR_lights_punctual"]}, "extensions/KHR_lights_punctual/lights/0/type is"),
	# Skins and animations.
	("skin_beyond", {NODE + "/skin": 4}, "nodes/0/skin is"),
	("skin_joint_beyond", {"skins": [{"joints": [9]}], NODE + "/skin": 0}, 12),
	("skin_no_joints", {"skins": [{}], NODE + "/skin": 0}, 12),
	("skin_matrices_beyond", {"skins": [{"joints": [0], "inverseBindMatrices": 44}], NODE + "/skin": 0}, 12),
	*(("anim_" + name, {"more": f32(0, 1, 2) + f32(*range(9)), "bufferViews/5/byteLength": 12,
	                    "bufferViews/6": {"buffer": 0, "byteOffset": len(DATA) + 12, "byteLength": 36},
	                    "accessors/4": {"bufferView": 5, "componentType": 5126, "count": 3, "type": "SCALAR",
	                                    "min": [0], "max": [2]},
	                    "accessors/5": {"bufferView": 6, "componentType": 5126, "count": 3, "type": "VEC3"},
	                    "animations": [{"samplers": [{"input": 4, "output": 5}],
	                                    "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
	                    **changes}, outcome) for name, changes, outcome in (
		("valid", {}, 12),
		("sampler_beyond", {"animations/0/channels/0/sampler": 9}, "animations/0/channels/0/sampler is"),
		("node_beyond", {"animations/0/channels/0/target/node": 9}, "animations/0/channels/0/target/node is"),
		("input_beyond", {"animations/0/samplers/0/input": 99}, "animations/0/samplers/0/input is"),
		("output_short", {"accessors/5/count": 2}, "accessors/5 (translation): 2 items for 3 times"),
		("output_vec2", {"accessors/5/type": "VEC2"}, "accessors/5 (translation): the type is not what this use needs"),
		("path_unknown", {"animations/0/channels/0/target/path": "colour"}, 12),
		("interpolation_unknown", {"animations/0/samplers/0/interpolation": "SMOOTH"},
		 "animations/0/samplers/0/interpolation is"),
		("times_fall", {f"bin/{len(DATA)}": f32(2, 1, 0)}, "accessors/4 (times): item 1 is"),
		("times_nan", {f"bin/{len(DATA)}": f32(NAN)}, "accessors/4: item 0 is not finite"),
		("times_negative", {f"bin/{len(DATA)}": f32(-1)}, "accessors/4 (times): item 0 is"),
		("value_infinite", {f"bin/{len(DATA) + 12}": f32(INFINITE)}, "accessors/5: item 0 is not finite"),
		("no_channels", {"animations/0/channels": GONE}, "animations/0/channels is missing"),
		("channel_null", {"animations/0/channels": [None]}, "animations/0/channels/0 is"))),
	# Documents and extensions.
	("doc_no_asset", {"asset": GONE}, "asset is missing"),
	("doc_version_1", {"asset/version": "1.0"}, "asset/version is"),
	("doc_least_version_3", {"asset/minVersion": "3.0"}, "asset/minVersion is"),
	("doc_version_number", {"asset/version": 2.0}, "asset/version is"),
	("ext_required_unknown", {"extensionsRequired": ["VENDOR_none"], "extensionsUsed": ["VENDOR_none"]},
	 "the file requires the extension \"VENDOR_none\", which is not supported"),
	("ext_used_unknown", {"extensionsUsed": ["VENDOR_none"]}, 12),
	("ext_required_text", {"extensionsRequired": "VENDOR_none"}, "extensionsRequired is"),
	("ext_draco_required", {"extensionsRequired": ["KHR_draco_mesh_compression"],
	                        "extensionsUsed": ["KHR_draco_mesh_compression"]},
	 "the file is compressed by KHR_draco_mesh_compression, which is not rea"),
	("ext_meshopt_required", {"extensionsRequired": ["EXT_meshopt_compression"],
	                          "extensionsUsed": ["EXT_meshopt_compression"]},
	 "the file is compressed by EXT_meshopt_compression, which is not read"),
	("doc_extras", {"extras": [1, None, {"a": {}}], NODE + "/extras": "text", PRIMITIVE + "/extras": 0}, 12),
	("doc_names", {NODE + "/name": "\u202e\0../\U0001f600" + 10000 * "x", MATERIAL + "/name": ""}, 12),
	# Images.
	("img_view_beyond", {"images/0/bufferView": 99}, "images/0/bufferView is"),
	("img_no_source", {"images/0/bufferView": GONE}, "images/0 must have either uri or bufferView"),
	("img_null", {"images/0": None}, "images/0 is null"),
]

IMAGES = [
	*((f"img_{colour}_{depth}", png(5, 3, depth, colour, between), 12) for colour, depths, between in (
		(0, (1, 2, 4, 8, 16), b""), (2, (8, 16), b""), (4, (8, 16), b""), (6, (8, 16), b""),
		(3, (1, 2, 4, 8), chunk(b"PLTE", bytes(6)))) for depth in depths),
	("img_1x256", png(1, 256), 12),
	("img_jpeg", jpeg(), 12),
	("img_jpeg_cut", jpeg()[:40], "images/0: no width or height in its header"),
	("img_jpeg_size_0", jpeg().replace(b"\x08\0\x08\0\x08", b"\x08\0\0\0\0"),
	 "images/0: no width or height in its header"),
	("img_jpeg_size_65535", jpeg().replace(b"\x08\0\x08\0\x08", b"\x08\xff\xff\xff\xff"), "images/0: its header says"),
	("img_empty", b"", "bufferViews/5/byteLength is"),
	("img_garbage", b"no image at all, but some bytes",
	 "images/0: neither PNG nor JPEG: its first bytes are those of no format"),
	("img_gif", b"GIF89a\1\0\1\0\0\0\0;", 12),
	("png_signature_alone", SIGNATURE, "images/0: no width or height in its header"),
	("png_cut_in_header", png()[:20], "images/0: no width or height in its header"),
	("png_cut_in_data", png()[:50], "images/0: damaged: it is cut short"),
	("png_no_end", png()[:-12], "images/0: damaged: it is cut short"),
	("png_no_data", SIGNATURE + header(3, 2) + END, "images/0: damaged: it has no pixels"),
	("png_no_header", SIGNATURE + pixels(3, 2) + END, "images/0: no width or height in its header"),
	("png_two_headers", SIGNATURE + 2 * header(3, 2) + pixels(3, 2) + END,
	 "images/0: damaged: its header is not its first chunk"),
	("png_checksum", put(png(), 29, b"\0\0\0\0"), "images/0: damaged: a checksum is wrong"),
	("png_data_checksum", put(png(), 45, b"\xff"), "images/0: damaged: a checksum is wrong"),
	("png_chunk_2p32", SIGNATURE + header(3, 2) + u32(2**32 - 1) + b"IDAT" + bytes(30),
	 "images/0: damaged: it is cut short"),
	("png_chunk_past_end", SIGNATURE + header(3, 2) + b"\0\0\4\0IDAT" + bytes(30),
	 "images/0: damaged: it is cut short"),
	("png_unknown_critical", png(between=chunk(b"ABCD", b"x")),
	 "images/0: damaged: an unknown chunk that must be understood"),
	("png_size_0", SIGNATURE + header(0, 0) + pixels(3, 2) + END, "images/0: no width or height in its header"),
	("png_size_65535", SIGNATURE + header(65535, 65535) + pixels(1, 1) + END, "images/0: its header says"),
	("png_size_2p31", SIGNATURE + header(2**31 - 1, 2**31 - 1) + pixels(1, 1) + END, "images/0: its header says"),
	("png_depth_3", SIGNATURE + header(3, 2, 3) + pixels(3, 2) + END,
	 "images/0: damaged: no such colour type and bit depth"),
	("png_colour_5", SIGNATURE + header(3, 2, 8, 5) + pixels(3, 2) + END,
	 "images/0: damaged: no such colour type and bit depth"),
	("png_interlace_2", SIGNATURE + header(3, 2, 8, 2, 2) + pixels(3, 2) + END,
	 "images/0: damaged: unknown compression, filter or interlace method"),
	("png_filter_7", SIGNATURE + header(3, 2) + pixels(3, 2, filtered=7) + END, "images/0: damaged: an unknown filter"),
	("png_rows_missing", SIGNATURE + header(3, 9) + pixels(3, 2) + END, "images/0: damaged: pixels are missing"),
	("png_rows_too_many", SIGNATURE + header(3, 1) + pixels(3, 2) + END,
	 "images/0: damaged: it holds more than its pixels"),
	("png_not_deflated", SIGNATURE + header(3, 2) + chunk(b"IDAT", bytes(20)) + END,
	 "images/0: damaged: its pixels do not inflate"),
	("png_bomb", SIGNATURE + header(3, 2) + chunk(b"IDAT", zlib.compress(bytes(1 << 24))) + END,
	 "images/0: damaged: it holds more than its pixels"),
	("png_palette_none", png(colour=3), "images/0: damaged: it has no palette"),
	("png_palette_of_4_bytes", png(colour=3, between=chunk(b"PLTE", bytes(4))),
	 "images/0: damaged: its palette has a wrong size or place"),
	("png_palette_too_long", png(colour=3, depth=1, between=chunk(b"PLTE", bytes(9))),
	 "images/0: damaged: its palette has a wrong size or place"),
	("png_palette_short",
	 SIGNATURE + header(3, 1, 8, 3) + chunk(b"PLTE", bytes(3)) + chunk(b"IDAT", zlib.compress(b"\0\0\xff\x80")) + END,
	 12),
	("png_alpha_too_long", png(colour=3, between=chunk(b"PLTE", bytes(6)) + chunk(b"tRNS", bytes(9))),
	 "images/0: damaged: its transparency has a wrong size or place"),
	("png_alpha_of_rgb_short", png(between=chunk(b"tRNS", b"\0")),
	 "images/0: damaged: its transparency has a wrong size or place"),
]


WHOLE = glb(text_of(DOC), DATA)
TEXT = text_of(DOC)
FILES = [
	("glb_whole.glb", WHOLE, 12),
	("glb_empty.glb", b"", "the file is empty"),
	("glb_magic_alone.glb", WHOLE[:4], "the header is cut after 4 of 12 bytes"),
	("glb_cut_in_header.glb", WHOLE[:9], "the header is cut after 9 of 12 bytes"),
	("glb_header_alone.glb", put(WHOLE[:12], 8, u32(12)), "the header says 12 bytes"),
	("glb_magic.glb", put(WHOLE, 0, b"glTf"), "the file does not begin with \"glTF\""),
	("glb_version_1.glb", put(WHOLE, 4, u32(1)), "container version 1"),
	("glb_version_3.glb", put(WHOLE, 4, u32(3)), "container version 3"),
	("glb_length_too_long.glb", put(WHOLE, 8, u32(len(WHOLE) + 100)), "the header says"),
	("glb_length_too_short.glb", put(WHOLE, 8, u32(len(WHOLE) - 100)), "chunk 1: says"),
	("glb_length_0.glb", put(WHOLE, 8, u32(0)), "the header says 0 bytes"),
	("glb_bytes_behind.glb", WHOLE + bytes(256), 12),
	("glb_json_2p32.glb", put(WHOLE, 12, u32(2**32 - 1)), "chunk 0: says"),
	("glb_json_past_end.glb", put(WHOLE, 12, u32(len(WHOLE))), "chunk 0: says"),
	("glb_json_short.glb", put(WHOLE, 12, u32(len(TEXT) // 4 * 4 - 40)), "chunk 1: says"),
	("glb_first_is_bin.glb", put(WHOLE, 16, b"BIN\0"), "chunk 0: kind"),
	("glb_no_bin.glb", glb(TEXT, None), "buffers/0/uri is missing and there is no BIN chunk for this buffer"),
	("glb_bin_2p31.glb",
	 WHOLE.replace(struct.pack("<I4s", len(DATA), b"BIN\0"), struct.pack("<I4s", 2**31 - 1, b"BIN\0")),
	 "chunk 1: says"),
	("glb_bin_short.glb", glb(TEXT, DATA[:64]), "buffers/0/byteLength is"),
	("glb_bin_cut.glb", WHOLE[:-300], "the header says"),
	("glb_third_chunk.glb", glb(TEXT, DATA, glb_chunk(b"XTRA", b"more", b"\0")), 12),
	("glb_json_garbage.glb", glb(bytes(range(128, 256)), DATA), "JSON is expected"),
	("glb_json_half.glb", glb(TEXT[:len(TEXT) // 2], DATA), "JSON is expected"),
	("glb_json_deep.glb", glb(b"[" * 100000 + b"]" * 100000, DATA), "nested more than 64 deep"),
	("glb_extras_deep.glb", glb(TEXT[:-1] + b',"extras":' + b"[" * 20000 + b"]" * 20000 + b"}", DATA),
	 "nested more than 64 deep"),
	("glb_json_bom.glb", glb(b"\xef\xbb\xbf" + TEXT, DATA), 12),
	("glb_json_utf8.glb", glb(TEXT.replace(b'{"mesh":0}', b'{"mesh":0,"name":"\xff\xfe"}'), DATA), "JSON is expected"),
	("glb_json_nul.glb", glb(TEXT + bytes(-len(TEXT) % 4 + 4), DATA), "JSON is expected"),
	("glb_json_twice.glb", glb(TEXT[:-1] + b',"nodes":[]}', DATA), "JSON is expected"),
	("glb_json_nan.glb", glb(TEXT.replace(b'"count":24', b'"count":NaN', 1), DATA), "JSON is expected"),
	("glb_json_number.glb", glb(TEXT.replace(b'"count":24', b'"count":1e999', 1), DATA), "JSON is expected"),
	("doc_empty.gltf", b"", "the file is empty"),
	("doc_object.gltf", b"{}", "asset is missing"),
	("doc_array.gltf", b"[]", "the JSON is not an object"),
	("doc_number.gltf", b"7", "not an object"),
	("doc_html.gltf", b"<!DOCTYPE html><title>404</title>", "JSON is expected"),
	("doc_glb_inside.gltf", WHOLE, 12),
	("doc_text_inside.glb", textual(), "the file does not begin with \"glTF\""),
	# URIs of buffers; that of the canary would be whole.
	("uri_data.gltf", textual(), 12),
	("uri_beside.gltf", textual("cube%20data.bin"), 12),
	("uri_dot.gltf", textual("./cube%20data.bin"), 12),
	("uri_missing.gltf", textual("none.bin"), "file \"none.bin\": No such file or directory"),
	("uri_above.gltf", textual("../canary.bin"), "buffers/0/uri: \"../canary.bin\" is no file of the scene's folder"),
	("uri_above_encoded.gltf", textual("%2E%2e%2Fcanary.bin"),
	 "buffers/0/uri: \"%2E%2e%2Fcanary.bin\" is no file of the scene's folder"),
	("uri_above_inside.gltf", textual("a/../../canary.bin"),
	 "buffers/0/uri: \"a/../../canary.bin\" is no file of the scene's folder"),
	("uri_backslash.gltf", textual("..\\canary.bin"),
	 "buffers/0/uri: \"..\\canary.bin\" is no file of the scene's folder"),
	("uri_absolute.gltf", textual("/etc/hostname"),
	 "buffers/0/uri: \"/etc/hostname\" is no file of the scene's folder"),
	("uri_file.gltf", textual("file:///etc/hostname"),
	 "buffers/0/uri: \"file:///etc/hostname\" is no file of the scene's folder"),
	("uri_http.gltf", textual("http://127.0.0.1/cube.bin"), "buffers/0/uri: \"http://"),
	("uri_device.gltf", textual("/dev/zero"), "buffers/0/uri: \"/dev/zero\" is no file of the scene's folder"),
	("uri_folder.gltf", textual("folder"), "file \"folder\": not a regular file"),
	("uri_pipe.gltf", textual("pipe"), "file \"pipe\": not a regular file"),
	("uri_link.gltf", textual("link.bin"), "file \"link.bin\": a link out of the scene's folder"),
	("uri_empty.gltf", textual(""), "buffers/0/uri: an empty URI"),
	("uri_nul.gltf", textual("cube%00data.bin"), "buffers/0/uri: \"cube%00data.bin\" is no file of the scene's folder"),
	("uri_long.gltf", textual(65536 * "x"), "buffers/0/uri: a URI of"),
	("uri_self.gltf", textual("uri_self.gltf"), "meshes/0/primitives/0: index 13626 at 0"),
	("b64_characters.gltf", textual("data:application/octet-stream;base64,!!!!" + 4000 * "A"),
	 "buffers/0/uri: byte 0 of the data is no base64"),
	("b64_cut.gltf", textual("data:application/octet-stream;base64,AAAAA"), "buffers/0/uri: 5 base64 characters"),
	("b64_empty.gltf", textual("data:application/octet-stream;base64,"),
	 "buffers/0/uri: a data URI that holds nothing"),
	("b64_longer.gltf", textual("data:application/octet-stream;base64," + base64.b64encode(DATA + bytes(64)).decode()),
	 12),
	("b64_padding_within.gltf", textual("data:application/octet-stream;base64,AA==" + base64.b64encode(DATA).decode()),
	 "buffers/0/uri: byte 2 of the data is no base64"),
	("b64_no_comma.gltf", textual("data:application/octet-stream;base64"),
	 "buffers/0/uri: a data URI without a comma before its data"),
	("b64_not.gltf", textual("data:application/octet-stream,AAAA"), "buffers/0/uri holds 4 bytes"),
	("b64_buffer_type.gltf", textual("data:application/gltf-buffer;base64," + base64.b64encode(DATA).decode()), 12),
	("imguri_beside.gltf", textual(image="check.png"), 12),
	("imguri_data.gltf", textual(image="data:image/png;base64," + base64.b64encode(png()).decode()), 12),
	("imguri_missing.gltf", textual(image="none.png"), "file \"none.png\": No such file or directory"),
	("imguri_above.gltf", textual(image="../canary.bin"),
	 "images/0/uri: \"../canary.bin\" is no file of the scene's folder"),
	("imguri_device.gltf", textual(image="/dev/zero"), "images/0/uri: \"/dev/zero\" is no file of the scene's folder"),
	("imguri_base64.gltf", textual(image="data:image/png;base64,!!"), "images/0/uri: 2 base64 characters"),
]

XYZ, NORMALS_OF = ("".join(f"property float {n}{axis}\n" for axis in "xyz") for n in ("", "n"))
SPLATS = "element vertex 1\n" + XYZ + NORMALS_OF + "property float radius\nend_header\n"
# Before the vertices, so that it is read past.
LIST = "element face 1\nproperty list uchar int vertex_indices\n" + SPLATS
POINT = "0 0 0 0 0 1 1\n"
PLY = [
	("list", "ascii", LIST, "3 0 1 2\n" + POINT, 0),
	("splats", "ascii", SPLATS, POINT, 0),
	("splats_binary", "binary_little_endian", SPLATS, f32(0, 0, 0, 0, 0, 1, 1), 0),
	("splats_big_endian", "binary_big_endian", SPLATS, struct.pack(">7f", 0, 0, 0, 0, 0, 1, 1), 0),
	("format_unknown", "octal", SPLATS, "", "line 2: write format ascii, binary_little_endian or binary_big_endian,"),
	("no_end", "ascii", SPLATS.replace("end_header", "comment"), "", "line 12: the header has no end_header"),
	("count_negative", "ascii", SPLATS.replace("vertex 1", "vertex -1"), "", "line 3: write element NAME COUNT"),
	("count_2p32", "ascii", SPLATS.replace("vertex 1", "vertex 4294967296"), POINT, "element vertex:"),
	("count_2p64", "ascii", SPLATS.replace("vertex 1", "vertex 18446744073709551617"), POINT,
	 "line 3: write element NAME COUNT"),
	("count_wraps", "binary_little_endian", SPLATS.replace("vertex 1", "vertex 658812288346769701"),
	 f32(0, 0, 0, 0, 0, 1, 1), "element vertex:"),
	("count_0", "ascii", SPLATS.replace("vertex 1", "vertex 0"), "", "no points: element vertex is absent or empty"),
	("count_text", "ascii", SPLATS.replace("vertex 1", "vertex many"), "", "line 3: write element NAME COUNT"),
	("count_too_many", "ascii", SPLATS.replace("vertex 1", "vertex 2"), POINT,
	 "element vertex: 2 of at least 14 bytes each do not fit in a file of"),
	("element_none", "ascii", "end_header\n", "", "no points: element vertex is absent or empty"),
	("element_none_of_property", "ascii", XYZ + "end_header\n", "", "line 3: a property before the first element"),
	("elements_100000", "ascii", "".join(f"element e{k} 0\n" for k in range(100000)) + SPLATS, POINT,
	 "line 67: more than 63 elements before vertex"),
	("property_type", "ascii", SPLATS.replace("float radius", "number radius"), "", "line 10: no such type"),
	("property_twice", "ascii", SPLATS.replace("float radius", "float x"), "",
	 "line 10: a second property of this name"),
	("property_no_name", "ascii", SPLATS.replace("float radius", "float"), "",
	 "line 10: write property TYPE NAME or property list TYPE TYPE NAME"),
	("property_long", "ascii", SPLATS.replace("radius", 70000 * "r"), "",
	 "element vertex: 1 of at least 14 bytes each do not fit in a file of"),
	("property_no_z", "ascii", SPLATS.replace("property float z\n", ""), "0 0 0 0 1 1\n", "2 are there"),
	("list_of_vertices", "ascii", SPLATS.replace("float radius", "list uchar float radius"), "0 0 0 0 0 1 1 1\n",
	 "the property radius must not be a list"),
	("list_length_float", "ascii", LIST.replace("list uchar", "list float"), "3 0 1 2\n" + POINT,
	 "line 4: the first type of a list, that of its length, must be an integ"),
	("list_negative", "binary_little_endian", LIST.replace("list uchar", "list int"),
	 u32(2**32 - 1, 0, 1, 2) + f32(0, 0, 0, 0, 0, 1, 1), "face 0: vertex_indices has no length"),
	("list_2p32", "binary_little_endian", LIST.replace("list uchar", "list uint"),
	 u32(2**32 - 1, 0, 1, 2) + f32(0, 0, 0, 0, 0, 1, 1), "face 0: vertex_indices is missing: the file ends before it"),
	("list_cut", "ascii", LIST, "99 0 1 2\n" + POINT, "face 0: vertex_indices is missing: the file ends before it"),
	("list_length_256", "ascii", LIST, "256 0 1 3\n" + POINT, "face 0: vertex_indices has no length"),
	("list_length_half", "ascii", LIST, "1.5 0\n" + POINT, "face 0: vertex_indices has no length"),
	("list_value_text", "ascii", LIST, "3 0 x 2\n" + POINT, "face 0: vertex_indices is no number"),
	("value_nan", "ascii", SPLATS, "nan 0 0 0 0 1 1\n", "point 0: x is not finite"),
	("value_1e999", "ascii", SPLATS, "1e999 0 0 0 0 1 1\n", "point 0: x is not finite"),
	("value_text", "ascii", SPLATS, "x 0 0 0 0 1 1\n", "point 0: x is no number"),
	("value_nan_binary", "binary_little_endian", SPLATS, f32(NAN, 0, 0, 0, 0, 1, 1), "point 0: x is not finite"),
	("normal_0", "ascii", SPLATS, "0 0 0 0 0 0 1\n", 0),
	("radius_negative", "ascii", SPLATS, "0 0 0 0 0 1 -1\n", "point 0: the radius is not above 0 and at most"),
	("radius_infinite", "binary_little_endian", SPLATS, f32(0, 0, 0, 0, 0, 1, INFINITE),
	 "point 0: radius is not finite"),
	("body_none", "binary_little_endian", SPLATS, b"",
	 "element vertex: 1 of at least 28 bytes each do not fit in a file of"),
	("body_cut", "binary_little_endian", SPLATS, f32(0, 0, 0, 0, 0, 1),
	 "element vertex: 1 of at least 28 bytes each do not fit in a file of"),
	("body_nul", "ascii", SPLATS, "0 0 0 0 \0 1 1\n", "point 0: ny is no number"),
]


def all_files():
	"""Rows of a file's name, its bytes, and triangles or words."""
	yield from FILES
	for name, changes, outcome in MEMBERS:
		doc, data = changed(changes)
		yield name + ".glb", glb(text_of(doc), data), outcome
	for name, image, outcome in IMAGES:
		doc, data = changed({"more": image, "images/0/bufferView": 5})
		yield name + ".glb", glb(text_of(doc), data), outcome
	for name, form, head, body, outcome in PLY:
		body = body.encode() if isinstance(body, str) else body
		yield f"ply_{name}.ply", f"ply\nformat {form} 1.0\n{head}".encode() + body, outcome
	yield "ply_empty.ply", b"", "begins with a line"
	yield "ply_magic.ply", b"plx\n", "begins with a line"


def main(folder):
	files = folder + "/files"
	os.makedirs(files + "/folder")
	os.mkfifo(files + "/pipe")
	os.symlink("../canary.bin", files + "/link.bin")
	beside = {"../canary.bin": DATA, "cube data.bin": DATA, "check.png": png()}
	rows = list(all_files())
	assert len({row[0] for row in rows}) == len(rows), "two files of one name"
	for name, data in [*beside.items(), *(row[:2] for row in rows)]:
		with open(f"{files}/{name}", "wb") as file:
			file.write(data)
	with open(folder + "/manifest.tsv", "w", encoding="utf-8") as file:
		for name, _, outcome in rows:
			file.write(f"{name}\t" + (f"{outcome}\t\n" if isinstance(outcome, int) else f"refused\t{outcome}\n"))


if __name__ == "__main__":
	main(sys.argv[1])
