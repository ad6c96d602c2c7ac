"""What a file is, URIs, indices, axes, scenes and nodes."""
import math

from document import (FRAMES_AND_SHAPE, GAMMA_1, GONE, JPEG_PROFILE, PROFILE, data_uri, edit, glb, jpeg, percent_coded,
                      quarters, recoded, reworded)
from judges import BASE, MAY, MUST, SHOULD, Chapter, ignored, noted, pixels, refused, same
from scenes import (ATTRIBUTES, BASE_TEXTURE, FOUR, HALF, IDENTITY, SKY, all_of, at, base, buffer_in, buffered,
                    child_of, image_at, moving, shifted, shown, skinned, with_targets)

CHAPTER = Chapter("2 to 3.5: files, scenes and nodes")
row = CHAPTER.row

row("2.4", MUST, "an asset says its version", "asset_version_none",
    edit(base(), ("asset", {})), refused("asset/version is missing"))

row("2.5", MUST, "a client of 2.0 reads a file of 2.1 and ignores what it does not know", "version_2_1",
    edit(base(), ("asset/version", "2.1"), ("nodes/1/novelty", {"a": [1]}), ("novelties", [1])), same(BASE))
row("2.5", MUST, "properties that are unknown are ignored", "unknown_properties",
    edit(base(), ("materials/0/glow", 3), ("accessors/0/novelty", "x"), ("scenes/0/novelty", None)), same(BASE))

row("2.6", MUST, "animations, pixel ratios and colour profiles of PNG are ignored", "png_icc_gamma",
    shown(quarters(GAMMA_1 + PROFILE + FRAMES_AND_SHAPE)), same(BASE))
row("2.6", MUST, "a colour profile in a JPEG is ignored", "jpeg_icc",
    shown(jpeg(JPEG_PROFILE), "image/jpeg"), same(shown(jpeg(), "image/jpeg")))
row("2.6", SHOULD, "files end in .gltf or .glb; one that is not what its name says is read", "glb_named_gltf",
    glb(base(), suffix=".gltf"), same(BASE))

row("2.7.1", SHOULD, "a byte-order mark is not written; a reader may skip it (RFC 8259, 8.1)", "json_bom",
    recoded(base(), lambda text: text.encode("utf-8-sig")), same(BASE))
row("2.7.1", SHOULD, "the JSON is UTF-8", "json_utf16",
    recoded(base(), lambda text: text.encode("utf-16")), refused("JSON is expected"))

row("2.7.2", SHOULD, "escaped ASCII is the same text", "json_escaped_key",
    reworded(base(), ('"buffers"', '"\\u0062uffers"')), same(BASE))

row("2.7.3", MAY, "other characters may be escaped or not", "json_names",
    edit(base(), ("nodes/1/name", "\u043a\u0443\u0431"), ("materials/0/name", "\u7acb")), same(BASE))

row("2.7.4", SHOULD, "of a key that stands twice a client takes the last", "json_key_twice",
    reworded(base(), ('"scene": 0', '"scene": 7, "scene": 0')), refused("duplicate"),
    "a client should take the last value; a refusal that says why is stricter")

row("2.7.5", MAY, "whole numbers may be written 4.0 or 4e0", "json_decimals",
    reworded(base(), ('"count": 4', '"count": 4.0'), ('"count": 6', '"count": 6e0'),
             ('"componentType": 5126', '"componentType": 5126.0'), ('"mesh": 0', '"mesh": 0e0')), same(BASE))
row("2.7.5", MUST, "whole numbers have no fraction", "json_fraction",
    edit(base(), ("accessors/0/count", 3.5)), refused("accessors/0/count is 3.5"))

row("2.7.6", SHOULD, "numbers come back as they were written", "json_precision",
    edit(base(), ("nodes/1/translation", [1e-17, 0, 0])), same(BASE))

row("2.8", MUST, "a data URI's media type fits what it holds: of a buffer, octets", "uri_data_type",
    buffered(lambda content: data_uri("text/plain", content)), refused("media type"))
row("2.8", MUST, "a data URI's media type fits what it holds: of an image", "uri_image_type_wrong",
    image_at(data_uri("image/jpeg", quarters())), ignored(), "read by its first bytes, whatever the file calls it")
row("2.8", MUST, "a data URI of an image without a media type", "uri_image_type_none",
    image_at(data_uri("", quarters())), refused("media type"))
row("2.8", MAY, "data URIs may be percent-encoded (RFC 2397)", "uri_data_percent",
    buffered(percent_coded), same(BASE))
row("2.8", MUST, "reserved characters are percent-encoded, and read back", "uri_percent",
    buffer_in("square%20%5Bone%5D.bin", "square [one].bin"), same(BASE))
row("2.8", MUST, "reserved characters are percent-encoded: a colon", "uri_percent_colon",
    buffer_in("square%3Aone.bin", "square:one.bin"), same(BASE))
row("2.8", MUST, "a % that begins no code", "uri_percent_raw",
    buffer_in("square 10%.bin", "square 10%.bin"), same(BASE), "no valid URI, but exporters wrote it")
row("2.8", MAY, "paths beyond ASCII as they are", "uri_iri",
    buffer_in("sph\u00e8re.bin", "sph\u00e8re.bin"), same(BASE))
row("2.8", MAY, "paths beyond ASCII, percent-encoded", "uri_iri_percent",
    buffer_in("sph%C3%A8re.bin", "sph\u00e8re.bin"), same(BASE))
row("2.8", SHOULD, "schemes are the same in capitals (RFC 3986, 6.2.2.1)", "uri_data_capitals",
    buffered(lambda content: data_uri("", content).replace("data:;base64", "DATA:Application/Octet-Stream;Base64")),
    same(BASE))
row("2.8", SHOULD, "dot segments are removed (RFC 3986, 6.2.2.3)", "uri_dots",
    buffer_in("./nowhere/../square.bin", "square.bin"), same(BASE))
row("2.8", MAY, "other schemes need not be read", "uri_http",
    buffered(lambda _: "http://127.0.0.1/a.bin"), refused("is no file of the scene's folder"))
row("2.8", MAY, "absolute paths need not be read", "uri_absolute",
    buffered(lambda _: "/a.bin"), refused("is no file of the scene's folder"))
row("2.8", MAY, "two buffers of one URI", "uri_twice",
    buffer_in("twice.bin", "twice.bin", times=2), same(BASE), "nothing forbids it")

row("3.2", MUST, "there is an asset", "asset_none",
    edit(base(), ("asset", GONE)), refused("asset is missing"))
row("3.2", MUST, "version is text", "version_number",
    edit(base(), ("asset/version", 2.0)), refused("asset/version is"))
row("3.2", MUST, "a client reads only the major version that it knows: 1.0", "version_1",
    edit(base(), ("asset/version", "1.0")), refused('"1.0"; 2.0 is expected'))
row("3.2", MUST, "a client reads only the major version that it knows: 3.0", "version_3",
    edit(base(), ("asset/version", "3.0")), refused('"3.0"; 2.0 is expected'))
row("3.2", MUST, "a client supports minVersion, or does not load", "min_version_2_1",
    edit(base(), ("asset/version", "2.1"), ("asset/minVersion", "2.1")), refused("asset/minVersion is"))
row("3.2", MUST, "a client supports minVersion 2.0", "min_version_2_0",
    edit(base(), ("asset/minVersion", "2.0")), same(BASE))

row("3.3", MUST, "indices are whole and not negative", "index_negative",
    edit(base(), ("nodes/1/mesh", -1)), refused("nodes/1/mesh is -1"))
row("3.3", MUST, "indices are whole numbers", "index_text",
    edit(base(), ("nodes/1/mesh", "0")), refused("nodes/1/mesh is"))
row("3.3", MUST, "indices name what exists: joints of a skin", "index_beyond_joint",
    edit(skinned(), ("skins/0/joints/0", 99)), noted("skins/0/joints/0 is 99", "it is ignored"))
row("3.3", MUST, "indices name what exists: a node's skin", "index_beyond_skin",
    edit(base(), ("nodes/1/skin", 4)), refused("nodes/1/skin is"))
row("3.3", MUST, "indices name what exists: accessors of a morph target", "index_beyond_target",
    with_targets([1], target={"POSITION": 99}), noted("morph targets are ignored"))
row("3.3", MAY, "names need not be unique", "names_twice",
    edit(base(), ("nodes/1/name", "cam")), same(BASE))
for name, path in (
	("node_mesh", "nodes/1/mesh"), ("node_camera", "nodes/0/camera"), ("scene_node", "scenes/0/nodes/0"),
	("child", "nodes/1/children/0"), ("scene", "scene"), ("attribute", f"{ATTRIBUTES}/POSITION"),
	("indices", "meshes/0/primitives/0/indices"), ("material", "meshes/0/primitives/0/material"),
	("view", "accessors/0/bufferView"), ("buffer", "bufferViews/0/buffer"), ("texture", f"{BASE_TEXTURE}/index"),
	("source", "textures/0/source"), ("sampler", "textures/0/sampler"), ("image_view", "images/0/bufferView"),
	("light", "nodes/2/extensions/KHR_lights_punctual/light")):
	row("3.3", MUST, f"indices name what exists: {name.replace('_', ' ')}", f"index_beyond_{name}",
	    edit(base(node={"children": []}), (path, 99)), refused(f"{path} is 99"))

row("3.4", MUST, "right-handed, +Y up, a camera looks along -Z; the texture is upright", "axes",
    base(), pixels(FOUR))
row("3.4", MUST, "positive rotation is counter-clockwise, angles are radians", "turn_quarter",
    base(node={"rotation": [0, 0, math.sqrt(0.5), math.sqrt(0.5)]}),
    pixels(at(upper_left=(0, 1, 0), lower_left=(1, 0, 0), lower_right=(0, 0, 1))))
row("3.4", MUST, "lengths are metres: a node's translation is in the unit of positions", "shift_one",
    shifted(1), pixels(at(upper_left=SKY, upper_right=(1, 0, 0))))

row("3.5.1", MUST, "a scene's nodes are nobody's children: one that is drawn as a child too", "root_is_child",
    child_of({}, [0, 1, 2, 3]), same(BASE, "listed again as a root"))
row("3.5.1", MUST, "a scene's nodes are nobody's children: one whose parent the scene does not draw",
    "root_below_undrawn",
    child_of({"translation": [1, 0, 0]}, [0, 1, 2]), same(BASE, "it stands without its parent"))
row("3.5.1", SHOULD, "`scene` is the scene that is shown", "scene_second",
    edit(base(), ("scenes", [{"nodes": [0]}, {"nodes": [0, 1, 2]}]), ("scene", 1)), same(BASE))
row("3.5.1", MAY, "without `scene` a client may choose: the first is drawn", "scene_unsaid",
    edit(base(), ("scene", GONE)), same(BASE))
row("3.5.1", SHOULD, "an asset without scenes is a library: nothing is drawn", "scenes_none",
    edit(base(), ("scene", GONE), ("scenes", GONE)), noted("the file has no scene"))
row("3.5.1", SHOULD, "a scene without nodes shows nothing", "scene_empty",
    edit(base(), ("scenes/0/nodes", GONE)), noted("nothing is drawn"))

row("3.5.2", MUST, "nodes form no circle", "node_circle",
    edit(base(), ("nodes/1/children", [3]), ("nodes/3", {"children": [1]})), refused("is its own ancestor"))
row("3.5.2", MUST, "nodes form no circle, seen from no root", "node_circle_apart",
    edit(base(), ("nodes/3", {"children": [4]}), ("nodes/4", {"children": [3]})), refused("is its own ancestor"))
row("3.5.2", MUST, "a node has one parent at most", "node_two_parents",
    edit(base(), ("scenes/0/nodes", [0, 2, 3, 4]), ("nodes/3", {"children": [1]}), ("nodes/4", {"children": [1]})),
    refused("is a child of"))

row("3.5.3", MUST, "a node has a matrix or translation, rotation, scale", "matrix_and_trs",
    base(node={"matrix": IDENTITY, "scale": [1, 1, 1]}), refused("both matrix and scale"))
row("3.5.3", MUST, "a matrix can be taken apart: no shear", "matrix_sheared",
    base(node={"matrix": [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}),
    pixels(at(upper_left=(1, 0, 0), lower_right=(1, 1, 1))), "drawn as the matrix says, normals too")
row("3.5.3", MUST, "a matrix can be taken apart: its last row is 0 0 0 1", "matrix_projective",
    base(node={"matrix": [1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}), refused("the last row must be 0 0 0 1"))
row("3.5.3", MUST, "a node that an animation moves has no matrix", "matrix_animated",
    edit(moving(), ("nodes/1/matrix", IDENTITY)), refused("has a matrix"))
row("3.5.3", MUST, "local = T * R * S: scale first, then rotation, then translation", "trs_order",
    base(node={"scale": [0.5, 1, 1], "rotation": [0, 0, HALF, HALF], "translation": [0, 0.25, 0]}),
    same(base(node={"matrix": [0, 0.5, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0.25, 0, 1]})))
row("3.5.3", MUST, "global = the parent's global * local", "parent_order",
    child_of({"scale": [0.5, 0.5, 1]}, [0, 2, 3], node={"translation": [1, 0, 0]}),
    same(base(node={"scale": [0.5, 0.5, 1], "translation": [0.5, 0, 0]})))
row("3.5.3", MUST, "a rotation is a unit quaternion", "rotation_long",
    base(node={"rotation": [0, 0, 2, 2]}), same(base(node={"rotation": [0, 0, HALF, HALF]})),
    "divided by its length: the only reading")
row("3.5.3", MUST, "a rotation is a unit quaternion: one of length 0", "rotation_zero",
    base(node={"rotation": [0, 0, 0, 0]}), refused("length 0"))
row("3.5.3", MAY, "a node of scale 0 need not be drawn", "scale_zero",
    base(node={"scale": [0, 0, 0]}), pixels(all_of(*SKY)))
row("3.5.3", MUST, "a matrix can be taken apart: its last number is one rounding from 1", "matrix_one_rounded",
    base(node={"matrix": IDENTITY[:15] + [0.9999999]}), same(BASE))
row("3.5.3", MUST, "a matrix can be taken apart: a number of its last row is one rounding from 0",
    "matrix_zero_rounded",
    base(node={"matrix": [1, 0, 0, 1e-09] + IDENTITY[4:]}), same(BASE))
