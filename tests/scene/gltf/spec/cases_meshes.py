"""Meshes, morph targets, skins and their use by nodes."""
from document import GONE, data, edit
from judges import BASE, MAY, MUST, SHOULD, Chapter, ignored, noted, pixels, point_colour, refused, same
from scenes import (ATTRIBUTES, BASE_TEXTURE, EIGHTH, HALF, IDENTITY, LIT, SKY, all_of, at, base, colours, indexed,
                    lit, moved, normal_map, normals, played, points, second_set, shifted, skinned, solid, tangents,
                    tilted, two_squares, with_targets, zeros)

CHAPTER = Chapter("3.7: meshes, morph targets and skins")
row = CHAPTER.row

row("3.7.2.1", MUST, "a primitive without material has the default material", "material_none",
    base(None), same(base({})))
row("3.7.2.1", MUST, "names of other attributes begin with _", "attribute_foreign",
    base(attributes={"HEAT": data("f32", "SCALAR", [1] * 4)}), noted('"HEAT" is ignored'))
row("3.7.2.1", MUST, "other attributes are not unsigned int", "attribute_custom_u32",
    base(attributes={"_ID": data("u32", "SCALAR", [1] * 4)}), noted('"_ID" is ignored'))
row("3.7.2.1", MUST, "TEXCOORD of normalized unsigned shorts", "texcoord_u16",
    base(attributes={"TEXCOORD_0": data("u16", "VEC2", [0, 65535, 65535, 65535, 65535, 0, 0, 0], normalized=True)}),
    same(BASE))
row("3.7.2.1", MUST, "TANGENT's w is 1 or -1", "tangent_w_half",
    normal_map(128, 255, attributes=tangents(0.25)), ignored(normal_map(128, 255, attributes=tangents(1))),
    "its sign counts")
row("3.7.2.1", MUST, "a VEC3 colour has alpha 1", "colour_vec3",
    solid((1, 1, 1), 1, colours([0.5, 1, 0] * 4, type="VEC3"), alphaMode="MASK", alphaCutoff=0.9),
    pixels(all_of(0.5, 1, 0)))
row("3.7.2.1", MUST, "a VEC4 colour's alpha multiplies", "colour_vec4",
    solid((1, 1, 1), 1, colours([0.5, 1, 0, 0.4] * 4), alphaMode="MASK"), pixels(all_of(*SKY)))
row("3.7.2.1", MUST, "COLOR_0 is clamped to 0 to 1", "colour_outside",
    solid((1, 1, 1), 1, colours([-1, 2, 0.5, 1] * 4)), pixels(all_of(0, 1, 0.5), "outside 0 to 1"))
row("3.7.2.1", MUST, "COLOR_0's alpha is clamped to 0 to 1", "colour_alpha_outside",
    solid((1, 1, 1), 0.4, colours([1, 1, 1, 2] * 4), alphaMode="MASK"), pixels(all_of(*SKY), "outside 0 to 1"),
    "0.4 * 1 is below the cutoff of 0.5; 0.4 * 2 is not")
row("3.7.2.1", MUST, "COLOR_0 of points is clamped to 0 to 1", "colour_outside_points",
    points(colours([-1, 2, 0.5, 1] * 16)), point_colour((0, 1, 0.5), "outside 0 to 1"))
row("3.7.2.1", MUST, "names of sets have no leading zeros", "texcoord_01",
    base(attributes={"TEXCOORD_01": data("f32", "VEC2", [0] * 8)}), noted('"TEXCOORD_01" is ignored'))
row("3.7.2.1", MUST, "sets begin at 0, one after the other", "texcoord_gap",
    edit(base(), (f"{ATTRIBUTES}/TEXCOORD_3", 2), (f"{ATTRIBUTES}/TEXCOORD_0", GONE), (f"{BASE_TEXTURE}/texCoord", 3)),
    same(BASE), "the set that the texture names is read")
row("3.7.2.1", SHOULD, "at least two sets of texture coordinates", "texcoord_two",
    edit(second_set(base()), (f"{BASE_TEXTURE}/texCoord", 1)), same(BASE))
row("3.7.2.1", SHOULD, "one vertex colour; a second one is left out", "colour_second",
    base(attributes={"COLOR_1": data("f32", "VEC4", [0] * 16)}), noted('"COLOR_1" is ignored'))
row("3.7.2.1", SHOULD, "one set of joints and weights", "joints_set",
    skinned(), same(BASE))
row("3.7.2.1", MUST, "attributes of a primitive have one count", "counts_differ",
    edit(base(), ("accessors/1/count", 3)), refused("another attribute has"))
row("3.7.2.1", MUST, "indices are below the count", "index_4",
    indexed([0, 1, 4, 0, 2, 3]), refused("index 4 at 2; there are 4"))
row("3.7.2.1", MUST, "indices do not hold the largest number: unsigned byte 255", "index_255",
    indexed([0, 1, 2, 0, 2, 3, 255, 255, 255], "u8", more_vertices=252), ignored(),
    "restarts nothing: read as the index that it is")
row("3.7.2.1", MUST, "indices are unsigned scalars", "index_signed",
    indexed([0, 1, 2, 0, 2, 3], "i16"), refused("componentType 5122"))
row("3.7.2.1", MUST, "triangles: a multiple of 3 indices", "index_count_7",
    indexed([0, 1, 2, 0, 2, 3, 0]), same(BASE, "vertices that complete no triangle"))
row("3.7.2.1", MUST, "strips: 3 indices at least", "strip_2",
    indexed([0, 1], mode=5), noted("vertices that complete no triangle"))
row("3.7.2.1", MUST, "strips: the order of corners", "strip",
    indexed([0, 1, 3, 2], mode=5), same(BASE))
row("3.7.2.1", MUST, "fans: the order of corners", "fan",
    indexed([0, 1, 2, 3], mode=6), same(BASE))
row("3.7.2.1", MUST, "without indices: one corner after the other", "no_indices",
    base(indices=None, mode=6), same(BASE))
row("3.7.2.1", MUST, "lines are lines", "lines",
    base(mode=1), noted("lines are not drawn"))
row("3.7.2.1", MUST, "lines: valid counts", "lines_odd",
    indexed([0], mode=3), noted("lines are not drawn"))
row("3.7.2.1", SHOULD, "no triangle with two corners in one place", "degenerate",
    indexed([0, 1, 2, 0, 2, 3, 0, 0, 1]), same(BASE), "`touchstone info` counts them")
row("3.7.2.1", SHOULD, "without positions nothing is drawn", "no_position",
    base(attributes={"POSITION": None}), noted("primitives without POSITION are not drawn"))
row("3.7.2.1", SHOULD, "without tangents those of MikkTSpace", "tangents_none",
    normal_map(255, 128, 255), same(normal_map(255, 128, 255, attributes=tangents(1))),
    "equal on a flat square; on curved meshes the tangents are those of each triangle")
row("3.7.2.1", MUST, "without normals flat ones", "normals_none",
    tilted(lit(attributes={"NORMAL": None})), same(tilted(lit())))
row("3.7.2.1", MUST, "without normals given tangents are ignored", "tangents_alone",
    normal_map(255, 128, attributes={**tangents(1, -1.0), "NORMAL": None}),
    same(normal_map(255, 128, attributes={"NORMAL": None}), "tangents of primitives without normals are ignored"))
row("3.7.2.1", MUST, "bitangent = cross(normal, tangent) * w", "bitangent",
    normal_map(128, 255, 255, attributes=tangents(-1)), same(normal_map(128, 0, 255, attributes=tangents(1))))
row("3.7.2.1", MUST, "bitangent = cross(normal, tangent) * w: w = 1 points up", "bitangent_up",
    normal_map(128, 255, 255, attributes=tangents(1)), same(normal_map(128, 255, 255)))
row("3.7.2.1", MUST, "NORMAL is of unit length", "normal_long",
    tilted(lit(attributes=normals(0, 0, 7))), same(tilted(lit())))
row("3.7.2.1", MUST, "NORMAL is of unit length: of length 0", "normal_zero",
    tilted(lit(attributes=normals(0, 0, 0))), same(tilted(lit())), "as without normals: the face's")
row("3.7.2.1", MUST, "TANGENT is of unit length", "tangent_long",
    normal_map(255, 128, 255, attributes=tangents(1, 9.0)), same(normal_map(255, 128, 255, attributes=tangents(1))))
row("3.7.2.1", MUST, "TANGENT of length 0", "tangent_zero",
    normal_map(255, 128, 255, attributes=tangents(1, 0.0)), same(normal_map(255, 128, 255)))
row("3.7.2.1", MAY, "more than four joints a vertex: a second set", "joints_second_set",
    edit(skinned(), (f"{ATTRIBUTES}/JOINTS_1", data("u8", "VEC4", [0] * 16)),
         (f"{ATTRIBUTES}/WEIGHTS_1", data("f32", "VEC4", [0.0] * 16))),
    same(BASE, '"JOINTS_1" is ignored', '"WEIGHTS_1" is ignored'))
for attribute, kind, type, count in (("POSITION", "f32", "VEC2", 8), ("NORMAL", "f32", "VEC4", 16),
                                     ("TANGENT", "f32", "VEC3", 12), ("TEXCOORD_0", "f32", "VEC3", 12),
                                     ("COLOR_0", "f32", "VEC2", 8)):
	row("3.7.2.1", MUST, f"the type of an attribute: {attribute}", f"type_{attribute.lower()}",
	    base(attributes={attribute: data(kind, type, [0] * count)}), refused("the type is not what this use needs"))
for attribute, kind, type, width, normalized in (
	("POSITION", "u16", "VEC3", 6, False), ("NORMAL", "i8", "VEC3", 3, True), ("TANGENT", "i8", "VEC4", 4, True),
	("TEXCOORD_0", "u16", "VEC2", 4, False), ("TEXCOORD_0", "i16", "VEC2", 4, True),
	("COLOR_0", "u8", "VEC4", 4, False), ("COLOR_0", "i8", "VEC4", 4, True)):
	row("3.7.2.1", MUST, f"the component of an attribute: {attribute} of {kind}{', normalized' if normalized else ''}",
	    f"component_{attribute.lower()}_{kind}",
	    zeros(attribute, kind, type, width, normalized), refused("componentType"))

row("3.7.2.2", MUST, "targets move a mesh by its weights", "morph_weights",
    with_targets([1]), noted("morph targets are ignored"))
row("3.7.2.2", MUST, "without weights targets have none", "morph_no_weights",
    with_targets(), same(BASE, "morph targets are ignored"))
row("3.7.2.2", MUST, "a node's weights come before the mesh's", "morph_node_weights",
    with_targets([1], [0]), same(BASE, "morph targets are ignored"))
row("3.7.2.2", MUST, "a target's attribute is one of the primitive too", "morph_foreign",
    with_targets([0], target={"TANGENT": 1}), noted("morph targets are ignored"))
row("3.7.2.2", MUST, "targets have as many items as the primitive", "morph_count",
    with_targets([0], count=3), noted("morph targets are ignored"))
row("3.7.2.2", MUST, "primitives of a mesh have as many targets", "morph_unequal",
    edit(with_targets([0]), ("meshes/0/primitives/1", {"attributes": {"POSITION": 0}, "indices": 3})),
    noted("morph targets are ignored"))
row("3.7.2.2", MUST, "accessors of targets: type", "morph_vec2",
    with_targets([0], target={"POSITION": 2}), noted("morph targets are ignored"))
row("3.7.2.2", SHOULD, "three attributes, eight morphed attributes", "morph_eight",
    with_targets([0] * 8, times=8), noted("morph targets are ignored"))

row("3.7.3.1", MUST, "a skin has joints", "skin_no_joints",
    edit(skinned(), ("skins/0/joints", GONE)), noted("skins/0/joints is missing: it is ignored"))
row("3.7.3.1", MUST, "inverse bind matrices: as many as joints", "skin_matrices_few",
    skinned(matrices=[IDENTITY]), noted("inverse bind matrices for 2 joints: the skin is ignored"))
row("3.7.3.1", MUST, "inverse bind matrices: floats of MAT4", "skin_matrices_vec4",
    edit(skinned(), ("skins/0/inverseBindMatrices", data("f32", "VEC4", [0] * 8))),
    noted("the type is not what this use needs: the skin is ignored"))
row("3.7.3.1", MUST, "inverse bind matrices: the last row is 0 0 0 1", "skin_matrix_row",
    skinned(matrices=[[1, 0, 0, 0.5] + IDENTITY[4:], IDENTITY]),
    noted("the last row must be 0 0 0 1: the skin is ignored"))
row("3.7.3.1", MUST, "inverse bind matrices are applied", "skin_matrices",
    skinned(matrices=[moved(1), IDENTITY]), same(shifted(1)))
row("3.7.3.1", MUST, "more inverse bind matrices than joints are allowed", "skin_matrices_many",
    skinned(matrices=[moved(1), IDENTITY, IDENTITY]), same(shifted(1)))
row("3.7.3.1", MUST, "skeleton is a common root of the joints", "skin_skeleton",
    edit(skinned(), ("skins/0/skeleton", 0)), ignored(), "needless for drawing")

row("3.7.3.2", MUST, "joints move a skinned mesh", "skin_joint",
    skinned(joint={"translation": [1, 0, 0]}), same(shifted(1)))
row("3.7.3.2", MUST, "the node of a skinned mesh does not move it", "skin_node",
    skinned(node={"translation": [1, 0, 0]}), same(BASE))
row("3.7.3.2", MUST, "the parents of a skinned mesh's node do not move it", "skin_parent",
    edit(skinned(), ("nodes/5", {"children": [1], "translation": [1, 0, 0]}), ("scenes/0/nodes", [0, 2, 3, 5])),
    same(BASE))
row("3.7.3.2", MUST, "bind matrices before the joint: joint * inverse bind", "skin_bind",
    skinned(joint={"translation": [1, 0, 0], "rotation": [0, 0, HALF, HALF]}, matrices=[moved(0, 1), IDENTITY]),
    same(base(node={"rotation": [0, 0, HALF, HALF]})))
row("3.7.3.2", MUST, "a skin that changes nothing draws the mesh as modelled", "skin_identity",
    skinned(), same(BASE))
row("3.7.3.2", MUST, "joints that are animated move the mesh at each frame", "skin_animated",
    played(skinned(), 3, ((1, 0, 0), (1, 0, 0))), same(shifted(1), "joints that move stand as at frame 0"))
row("3.7.3.2", MUST, "joints have a common root in the scene", "skin_root",
    edit(skinned(), ("scenes/0/nodes", [0, 1, 2])), ignored())
row("3.7.3.2", MUST, "the node of a skinned mesh does not move it, animated either", "skin_node_animated",
    played(skinned(), 1, ((1, 0, 0), (1, 0, 0))), same(BASE))
row("3.7.3.2", MUST, "normals are turned by the joints too", "skin_normals",
    edit(skinned(joint={"rotation": EIGHTH}), ("materials/0", LIT)), same(base(LIT, node={"rotation": EIGHTH})))

row("3.7.3.3", MUST, "a skinned mesh has JOINTS_0 and WEIGHTS_0", "skin_no_weights",
    edit(skinned(), (f"{ATTRIBUTES}/JOINTS_0", GONE), (f"{ATTRIBUTES}/WEIGHTS_0", GONE)),
    noted("without JOINTS_0 and WEIGHTS_0 stand at their node"))
row("3.7.3.3", MUST, "JOINTS of unsigned bytes or shorts, VEC4", "skin_joints_float",
    skinned(joints_kind="f32"), noted("5121 or 5123 is expected: it is ignored", "stand at their node"))
row("3.7.3.3", MUST, "weights are not negative", "skin_weight_negative",
    skinned(weights=[-1, 2, 0, 0]), noted("weights below 0", "do not add up to 1"))
row("3.7.3.3", MUST, "a joint has one weight of a vertex", "skin_joint_twice",
    skinned(weights=[0.5, 0.5, 0, 0]), ignored())
row("3.7.3.3", SHOULD, "float weights sum to 1", "skin_weight_sum",
    skinned(weights=[0.5, 0, 0, 0]), noted("divided by their sum"))
row("3.7.3.3", MUST, "integer weights sum to 255 or 65535", "skin_weight_sum_u8",
    skinned(weights=[254, 0, 0, 0], weights_kind="u8"), ignored(), "divided by their sum; 254 is a rounding away")
row("3.7.3.3", MUST, "as many JOINTS as WEIGHTS sets", "skin_sets",
    edit(skinned(), (f"{ATTRIBUTES}/WEIGHTS_0", GONE)), noted("stand at their node"))
row("3.7.3.3", MUST, "joints are within the skin", "skin_joint_beyond",
    skinned(joints=[9, 0, 0, 0]), noted("joints that a skin does not have", "do not add up to 1"))
row("3.7.3.3", MUST, "a vertex between two joints", "skin_two",
    skinned(joints=[0, 1, 0, 0], weights=[0.5, 0.5, 0, 0], matrices=[moved(2), IDENTITY]), same(shifted(1)))
row("3.7.3.3", MUST, "weights of normalized bytes", "skin_weights_u8",
    skinned(joint={"translation": [1, 0, 0]}, weights=[255, 0, 0, 0], weights_kind="u8"), same(shifted(1)))
row("3.7.3.3", MUST, "joints of unsigned shorts", "skin_joints_u16",
    skinned(joint={"translation": [1, 0, 0]}, joints_kind="u16"), same(shifted(1)))

row("3.7.4", MUST, "one mesh at several nodes", "instances_of_nodes",
    two_squares(), pixels({(2, 6): (1, 0, 0), (10, 6): (1, 0, 0)}))
row("3.7.4", MUST, "a negative determinant turns the winding", "mirrored",
    base(node={"scale": [-1, 1, 1]}), pixels(at(upper_left=(0, 1, 0), upper_right=(1, 0, 0))))
row("3.7.4", MUST, "a positive determinant does not", "mirrored_twice",
    base(node={"scale": [-1, -1, 1]}), pixels(at(upper_left=(1, 1, 1), lower_right=(1, 0, 0))))
row("3.7.4", MUST, "mirrored tangent frames", "mirrored_bitangent",
    edit(normal_map(128, 255, attributes=tangents(1)), ("nodes/1/scale", [-1, 1, 1])), same(normal_map(127, 255)),
    "128 is x = 0.004, which a mirror turns")
