"""What the schema alone says."""
from document import GONE, edit, flat
from judges import BASE, MAY, MUST, SHOULD, Chapter, ignored, noted, pixels, refused, same
from scenes import (ATTRIBUTES, BASE_TEXTURE, SKY, all_of, base, buffered, coordinates, lit, moving, octets, shown,
                    skinned, solid, sparse, with_targets)

CHAPTER = Chapter("5: the schema")
row = CHAPTER.row

row("5.1", MUST, "an accessor without a view is zeros", "unbacked",
    edit(base(), ("accessors/2/bufferView", GONE)), same(base(attributes=coordinates(0, 0, 0, 0))),
    "texture coordinates are all 0")
row("5.1", MUST, "componentType, count and type are there", "accessor_no_count",
    edit(base(), ("accessors/0/count", GONE)), refused("accessors/0/count is missing"))
row("5.1", MUST, "count is 1 or more", "accessor_count_0",
    edit(base(), ("accessors/0/count", 0)), refused("accessors/0/count is 0"))
row("5.1", MUST, "type is one of seven", "accessor_vec5",
    edit(base(), ("accessors/0/type", "VEC5")), refused("one of SCALAR"))
row("5.1", MUST, "unsigned int is for indices alone", "attribute_u32",
    edit(base(), ("accessors/2/componentType", 5125)), refused("componentType 5125"))
row("5.1", MUST, "float is not normalized", "float_normalized",
    edit(base(), ("accessors/0/normalized", True)), refused("normalized"))
row("5.1", MUST, "unsigned int is not normalized", "index_normalized",
    edit(base(), ("accessors/3/normalized", True)), refused("normalized"))
row("5.1", MUST, "byteOffset needs bufferView", "offset_without_view",
    edit(base(), ("accessors/2/bufferView", GONE), ("accessors/2/byteOffset", 4)),
    ignored(base(attributes=coordinates(0, 0, 0, 0))), "zeros, as without byteOffset")
row("5.1", MUST, "names are text: of what is not read", "name_number_unread",
    edit(base(), ("accessors/0/name", 5), ("asset/generator", 7)), ignored())

row("5.3", MUST, "views of sparse indices have no byteStride", "sparse_indices_stride",
    sparse(indices_view={"byteStride": 4}), same(BASE, "byteStride"))
row("5.3", MUST, "views of sparse indices have no target", "sparse_target",
    sparse(indices_view={"target": 34963}), ignored(), "target is not read")
row("5.3", MUST, "sparse indices are unsigned", "sparse_signed",
    sparse(kind="i16"), refused("componentType"))

row("5.4", MUST, "views of sparse values have no byteStride", "sparse_values_stride",
    sparse(values_view={"byteStride": 12}), same(BASE, "byteStride"))

row("5.5", MUST, "an animation has channels and samplers", "anim_no_channels",
    edit(moving(), ("animations/0/channels", [])), refused("an array with something in it"))
row("5.5", MUST, "animations that are not played are checked too", "anim_second_bad",
    edit(moving(),
         ("animations/1",
          {"samplers": [{"input": 0, "output": 0}],
           "channels": [{"sampler": 7, "target": {"node": 1, "path": "scale"}}]})), noted("is played"),
    "one animation is played; the others are not opened")

row("5.6", MUST, "a channel's sampler exists", "anim_sampler_beyond",
    edit(moving(), ("animations/0/channels/0/sampler", 4)), refused("the animation has 1 samplers"))

row("5.8", MUST, "times begin at 0 or later", "anim_negative",
    moving(times=(-1, 1)), refused("a time from 0 is expected"))
row("5.8", MUST, "times grow", "anim_unsorted",
    moving(times=(1, 1)), refused("a time after 1 is expected"))
row("5.8", MUST, "as many outputs as inputs", "anim_few",
    moving(times=(0, 1, 2)), refused("2 items for 3 times"))
row("5.8", MUST, "interpolation is one of three", "anim_mode_odd",
    moving(mode="SMOOTH"), refused("one of LINEAR STEP CUBICSPLINE"))

row("5.9", MUST, "version is MAJOR.MINOR", "version_odd",
    edit(base(), ("asset/version", "2.x")), ignored(), "read as 2: there is no other reading")

row("5.10", MUST, "byteLength of a buffer is there, 1 or more", "buffer_length_0",
    edit(buffered(octets), ("buffers/0/byteLength", 0)), refused("byteLength is 0"))

row("5.11", MUST, "a view lies inside its buffer", "view_beyond",
    edit(base(), ("bufferViews/0/byteLength", 99999)), refused("bufferViews/0 ends at byte"))
row("5.11", MUST, "byteStride is 4 to 252", "stride_256",
    edit(base(), ("bufferViews/0/byteStride", 256)), refused("byteStride is"))
row("5.11", MUST, "buffer and byteLength of a view are there", "view_no_length",
    edit(base(), ("bufferViews/0/byteLength", GONE)), refused("byteLength is missing"))

row("5.12", MUST, "a camera has a type", "camera_no_type",
    edit(base(), ("cameras/0/type", GONE)), refused("cameras/0/type is missing"))
row("5.12", MUST, "a camera's type is one of two", "camera_type_odd",
    edit(base(), ("cameras/0/type", "fisheye")), refused("one of perspective orthographic"))
row("5.12", MUST, "a perspective camera has perspective", "camera_no_perspective",
    edit(base(), ("cameras/0/perspective", GONE)), refused("cameras/0 is of type perspective and has no perspective"))

row("5.13", MUST, "xmag and ymag are not 0", "camera_xmag_0",
    edit(base(),
         ("cameras/0", {"type": "orthographic", "orthographic": {"xmag": 0, "ymag": 1, "znear": 0, "zfar": 9}})),
    noted("it is not a perspective one"))

row("5.14", MUST, "yfov is there", "camera_no_yfov",
    edit(base(), ("cameras/0/perspective/yfov", GONE)), refused("yfov is missing"))
row("5.14", MUST, "yfov is above 0 (and below pi)", "camera_yfov_0",
    edit(base(), ("cameras/0/perspective/yfov", 0)), noted("yfov is not between 0 and pi"))
row("5.14", SHOULD, "yfov is below pi", "camera_yfov_pi",
    edit(base(), ("cameras/0/perspective/yfov", 3.2)), noted("yfov is not between 0 and pi"))
row("5.14", MUST, "znear is there and above 0", "camera_znear_0",
    edit(base(), ("cameras/0/perspective/znear", -1)), ignored(), "not read")
row("5.14", MUST, "zfar is above znear", "camera_zfar_low",
    edit(base(), ("cameras/0/perspective/zfar", 0.01)), ignored(), "not read")
row("5.14", MUST, "aspectRatio is above 0", "camera_aspect_0",
    edit(base(), ("cameras/0/perspective/aspectRatio", 0)), ignored(), "not read")

row("5.15", MUST, "extensions is an object", "ext_array",
    edit(base(), ("nodes/1/extensions", [])), refused("an object is expected"))

row("5.16", MAY, "extras may be anything", "extras_any",
    edit(base(), ("nodes/1/extras", [1, None]), ("extras", "x"), ("materials/0/extras", 7)), same(BASE))
row("5.16", MAY, "extras of other programs: our own key of another type", "extras_ours",
    edit(base(), ("nodes/1/extras", {"reflector": 1})), same(BASE, "reflector"))

row("5.17", MUST, "`scene` needs `scenes`", "scene_without_scenes",
    edit(base(), ("scenes", GONE)), refused("scene is 0; the file has no scenes"))
row("5.17", MUST, "lists are not empty", "lists_empty",
    edit(base(), ("skins", []), ("animations", []), ("nodes/1/children", [])), ignored())
row("5.17", MUST, "lists are lists", "list_object",
    edit(base(), ("nodes", {})), refused("nodes is"))
row("5.17", MUST, "items are objects", "list_null",
    edit(base(), ("meshes/0", None)), refused("meshes/0 is null"))

row("5.19", MUST, "emissiveFactor is 0 to 1", "emissive_2",
    lit(emissiveFactor=[2, 0, 0]), refused("a number from 0 to 1"))
row("5.19", MUST, "MASK: a cutoff above 1 leaves nothing", "alpha_mask_above",
    solid((1, 0, 0), 1, alphaMode="MASK", alphaCutoff=1.5), pixels(all_of(*SKY)))
row("5.19", MUST, "alphaCutoff needs alphaMode, and counts for MASK alone", "alpha_cutoff_alone",
    solid((1, 0, 0), 0.1, alphaCutoff=0.9), pixels(all_of(1, 0, 0)))
row("5.19", MUST, "alphaMode is one of three", "alpha_odd",
    solid(alphaMode="GLASS"), refused("one of OPAQUE MASK BLEND"))

row("5.21", MUST, "strength is 0 to 1", "occlusion_strength",
    lit(occlusionTexture={"index": 0, "strength": 2}), refused("a number from 0 to 1"))

row("5.22", MUST, "factors are 0 to 1", "factor_2",
    edit(base(), ("materials/0/pbrMetallicRoughness/baseColorFactor", [2, 1, 1, 1])), refused("a number from 0 to 1"))
row("5.22", MUST, "metallicFactor is 0 to 1", "metallic_7",
    lit({"metallicFactor": 7}), refused("metallicFactor is 7"))
row("5.22", MUST, "baseColorFactor has four numbers", "factor_of_3",
    edit(base(), ("materials/0/pbrMetallicRoughness/baseColorFactor", [1, 1, 1])), refused("an array of 4 numbers"))
row("5.22", MUST, "base colour is not premultiplied with alpha", "base_unmultiplied",
    shown(flat(255, 255, 255, 128)), pixels(all_of(1)))
row("5.22", MUST, "factors are 0 to 1: one rounding outside", "factor_rounded",
    solid((1.0000001192092896, 0, 0)), same(solid((1, 0, 0)), "read as 1"))

row("5.23", MUST, "a mesh has primitives", "mesh_no_primitives",
    edit(base(), ("meshes/0/primitives", [])), refused("an array with something in it"))

row("5.24", MUST, "a primitive has attributes", "prim_no_attributes",
    edit(base(), (ATTRIBUTES, {})), refused("an object with attributes"))
row("5.24", MUST, "mode is 0 to 6", "prim_mode_7",
    edit(base(), ("meshes/0/primitives/0/mode", 7)), refused("mode is 7"))

row("5.25", MUST, "children are each listed once", "node_child_twice",
    edit(base(), ("scenes/0/nodes", [0, 2, 3]), ("nodes/3", {"children": [1, 1]})), refused("is a child of"))
row("5.25", MUST, "a matrix has 16 numbers, scale 3, rotation 4", "matrix_15",
    edit(base(), ("nodes/1/matrix", [1] * 15)), refused("an array of 16 numbers"))
row("5.25", MUST, "weights are as many as targets", "morph_weights_many",
    with_targets(None, [1, 1]), noted("morph targets are ignored"))
row("5.25", MUST, "a skin needs a mesh", "skin_no_mesh",
    edit(skinned(), ("nodes/4/skin", 0)), ignored())
row("5.25", MUST, "names are text", "name_number",
    edit(base(), ("nodes/1/name", 5)), refused("nodes/1/name is 5"))

row("5.27", MUST, "a scene's nodes are each listed once", "root_twice",
    edit(base(), ("scenes/0/nodes", [0, 1, 1, 2])), same(BASE, "listed again"))

row("5.30", MUST, "a texture's use has an index", "texture_no_index",
    edit(base(), (BASE_TEXTURE, {})), refused("index is missing"))
row("5.30", MUST, "texCoord is not negative", "texcoord_negative",
    edit(base(), (f"{BASE_TEXTURE}/texCoord", -1)), refused("texCoord is -1"))
row("5.30", MUST, "the set that a texture names is there", "texcoord_absent",
    edit(base(), (f"{BASE_TEXTURE}/texCoord", 5)), noted("are read at (0, 0)"))
