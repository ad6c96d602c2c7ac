"""Extensions: those that are read, and what becomes of the others."""
import math

from document import GONE, UNLIT, data, edit, flat
from judges import (BASE, MUST, Chapter, by_test, ignored, inside_alone, middle_as, more_than, noted, pixels, refused,
                    same)
from scenes import (DARK, FOUR, HALF, INSTANCES, INSTANCES_OF, LIGHT, SKY, TURNED, all_of, at, base, byte_normals,
                    colours, emitting, instanced, lit, moving, played, point_light, quantized, second_light,
                    second_set, skinned, small, solid, spot, textured, tilted, transformed, two_squares, with_fallback)

CHAPTER = Chapter("extensions")
row = CHAPTER.row
X, Q = "KHR_texture_transform", "KHR_mesh_quantization"
SMALLER = [1 / 16384, 0, 0, 0, 0, 1 / 16384, 0, 0, 0, 0, 1 / 16384, 0, 0, 0, 0, 1]

row("EXT_mesh_gpu_instancing", MUST, "a mesh is drawn once an instance, not by itself: world * instance", "instancing",
    instanced([(-1.25, 0, 0), (1.25, 0, 0)]), same(two_squares()))
row("EXT_mesh_gpu_instancing", MUST, "T * R * S of each instance", "instancing_trs",
    instanced([(1.25, 0, 0)], rotations=[(0, 0, HALF, HALF)], scales=[(0.5, 1, 1)]),
    same(small(translation=[0.5, 0, 0], rotation=[0, 0, HALF, HALF], scale=[0.2, 0.4, 0.4])))
row("EXT_mesh_gpu_instancing", MUST, "attributes of instances have one count", "instancing_counts",
    instanced([(0, 0, 0)], scales=[(1, 1, 1)] * 2), refused("TRANSLATION has 1 items, another attribute has 2"))
row("EXT_mesh_gpu_instancing", MUST, "TRANSLATION is VEC3 of floats", "instancing_type",
    edit(instanced([(0, 0, 0)]), (f"{INSTANCES_OF}/TRANSLATION", 2)), refused("the type is not what this use needs"))
row("EXT_mesh_gpu_instancing", MUST, "instances of a node that an animation moves", "instancing_moved",
    played(instanced([(0, 0, 0)]), 1, ((0.5, 0, 0), (0.5, 0, 0))), same(small(translation=[0.5, 0, 0])))
row("EXT_mesh_gpu_instancing", MUST, "rotations of normalized bytes", "instancing_i8",
    edit(instanced([(0, 0, 0)]), (f"{INSTANCES_OF}/ROTATION", data("i8", "VEC4", [0, 0, 127, 0], normalized=True))),
    same(small(rotation=[0, 0, 1, 0])))
row("EXT_mesh_gpu_instancing", MUST, "the copies of a mirrored instance show their fronts", "instancing_mirrored",
    instanced([(0, 0, 0)], scales=[(-1, 1, 1)]), same(small(scale=[-0.4, 0.4, 0.4])))
row("EXT_mesh_gpu_instancing", MUST, "a node without a mesh has no instances", "instancing_no_mesh",
    edit(small().uses(INSTANCES), ("nodes/0/extensions", {INSTANCES: {"attributes": {"TRANSLATION": 0}}})),
    ignored(small()))

row("EXT_texture_webp", MUST, "a texture without a fallback", "webp_alone",
    edit(base().requires("EXT_texture_webp"), ("textures/0", {"extensions": {"EXT_texture_webp": {"source": 0}}})),
    noted("has no image that is read", "PNG or JPEG images only"))

row("KHR_draco_mesh_compression", MUST, "used, without copies", "draco_alone",
    edit(base().uses("KHR_draco_mesh_compression"), ("accessors/0/bufferView", GONE)), refused("is compressed by"))

row("KHR_lights_punctual", MUST, "a conforming client draws by these lights", "light_directional",
    lit(), pixels({(8, 8): [0.96 + 0.01] * 3}, size=17), "by hand: light and eye stand at right angles to the square")
row("KHR_lights_punctual", MUST, "a light has a type", "light_no_type",
    edit(base(), (LIGHT, {})), refused("type is missing"))
row("KHR_lights_punctual", MUST, "a light's type is one of three", "light_type_odd",
    edit(base(), (f"{LIGHT}/type", "area")), refused("one of directional point spot"))
row("KHR_lights_punctual", MUST, "a node's light is an index of the list", "light_beyond",
    edit(base(), ("nodes/2/extensions/KHR_lights_punctual/light", 4)), refused("light is 4"))
row("KHR_lights_punctual", MUST, "a node's light is there", "light_no_index",
    edit(base(), ("nodes/2/extensions/KHR_lights_punctual", {})), refused("light is missing"))
row("KHR_lights_punctual", MUST, "the list of lights is there", "light_no_list",
    edit(base(), ("extensions", GONE)), refused("the file has no lights"))
row("KHR_lights_punctual", MUST, "color is 1 1 1, intensity 1 where nothing is said", "light_defaults",
    edit(lit(), (LIGHT, {"type": "directional"})),
    same(edit(lit(), (LIGHT, {"type": "directional", "color": [1, 1, 1], "intensity": 1.0}))))
row("KHR_lights_punctual", MUST, "color has three numbers", "light_colour_4",
    edit(lit(), (f"{LIGHT}/color", [1, 1, 1, 1])), refused("an array of 3 numbers"))
row("KHR_lights_punctual", MUST, "color is 0 to 1 (schema)", "light_colour_2",
    edit(lit(), (f"{LIGHT}/color", [2, 2, 2])), same(edit(lit(), (f"{LIGHT}/intensity", 2 * math.pi))),
    "multiplied, as intensity would be")
row("KHR_lights_punctual", MUST, "intensity is not negative", "light_negative",
    edit(lit(), (f"{LIGHT}/intensity", -1)), refused("intensity is -1"))
row("KHR_lights_punctual", MUST, "an intensity beyond what a kernel holds", "light_1e30",
    edit(lit(), (f"{LIGHT}/intensity", 1e30)),
    same(edit(lit(), (f"{LIGHT}/intensity", 2.0**62)), "is 1e30, beyond all that is held: it is read as 4.6"))
row("KHR_lights_punctual", MUST, "a light shines along the node's -Z", "light_turned",
    edit(lit(), ("nodes/2/rotation", [0, 1, 0, 0])), pixels(all_of(0)))
row("KHR_lights_punctual", MUST, "a directional light has no place and no falloff", "light_far",
    edit(lit(), ("nodes/2/translation", [5, 5, 900])), same(lit()))
row("KHR_lights_punctual", MUST, "a node's scale changes no range and no intensity", "light_scale",
    point_light(scale=[3, 3, 3], range=3), same(point_light(range=3)))
row("KHR_lights_punctual", MUST, "a point light falls by the square of the distance", "light_square",
    point_light(1.0, intensity=2), middle_as(point_light(2.0, intensity=8)), "2 cd at 1 m is 8 cd at 2 m")
row("KHR_lights_punctual", MUST, "beyond range there is none", "light_range",
    point_light(range=1.5), pixels(all_of(0)))
row("KHR_lights_punctual", MUST, "range is above 0", "light_range_0",
    point_light(range=0), same(point_light(), "range"))
row("KHR_lights_punctual", MUST, "range is not negative", "light_range_negative",
    point_light(range=-1), refused("range is -1"))
row("KHR_lights_punctual", MUST, "directional lights have no range", "light_range_sun",
    edit(lit(), (f"{LIGHT}/range", 0.1)), ignored(lit()))
row("KHR_lights_punctual", MUST, "without range there is no end", "light_no_range",
    point_light(), same(point_light(range=999)))
row("KHR_lights_punctual", MUST, "a spot has `spot`", "spot_none",
    spot(), refused("lights/0 is of type spot and has no spot"))
row("KHR_lights_punctual", MUST, "angles are 0 and pi/4 where nothing is said", "spot_defaults",
    spot({}), same(spot({"innerConeAngle": 0, "outerConeAngle": math.pi / 4})))
row("KHR_lights_punctual", MUST, "the inner angle is below the outer one", "spot_equal",
    spot({"innerConeAngle": 0.5, "outerConeAngle": 0.5}), noted("cone"))
row("KHR_lights_punctual", MUST, "the outer angle is pi/2 at most", "spot_wide",
    spot({"outerConeAngle": 1.6}), refused("a number from 0 to 1.57"))
row("KHR_lights_punctual", MUST, "the inner angle is 0 or more", "spot_negative",
    spot({"innerConeAngle": -0.1}), refused("a number from 0"))
row("KHR_lights_punctual", MUST, "outside the cone there is none", "spot_outside",
    spot({"outerConeAngle": 0.2}), inside_alone())
row("KHR_lights_punctual", MUST, "a spot's node turns it", "spot_turned",
    spot({}, [0, 1, 0, 0]), pixels(all_of(0)))
row("KHR_lights_punctual", MUST, "a light below a node that moves", "light_moves",
    moving(((0, 0, 0, 1), (0, 0, 0, 1)), "rotation", target=2),
    noted("lights below a node that moves stand as at frame 0"))
row("KHR_lights_punctual", MUST, "one light at two nodes is two lights", "light_twice",
    second_light(lit()), same(edit(lit(), (f"{LIGHT}/intensity", 2 * math.pi))))
row("KHR_lights_punctual", MUST, "lights that no node has do not shine", "light_unused",
    edit(lit(), ("extensions/KHR_lights_punctual/lights/1", {"type": "directional", "intensity": 99})), same(lit()))
row("KHR_lights_punctual", MUST, "the outer angle is pi/2 at most: pi/2 as a binary32", "spot_half_pi",
    spot({"outerConeAngle": 1.5707963705062866}),
    same(spot({"outerConeAngle": math.pi / 2}), "a rounding outside its range"))
row("KHR_lights_punctual", MUST, "a spot's cone between its angles falls smoothly: (cos * scale + offset)^2",
    "spot_ramp",
    None, by_test("kernels/base/shade.c", "spot_light_fades_between_its_cones"))

row("KHR_materials_emissive_strength", MUST, "emission is multiplied", "strength",
    emitting(emissiveStrength=4), more_than(base({"pbrMetallicRoughness": DARK}), (4, 2, 0)))
row("KHR_materials_emissive_strength", MUST, "1 where nothing is said", "strength_default",
    emitting(), more_than(base({"pbrMetallicRoughness": DARK}), (1, 0.5, 0)))
row("KHR_materials_emissive_strength", MUST, "not negative", "strength_negative",
    emitting(emissiveStrength=-1), refused("emissiveStrength is -1"))
row("KHR_materials_emissive_strength", MUST, "not beside KHR_materials_unlit", "strength_unlit",
    solid((1, 0, 0), emissiveFactor=[1, 1, 1],
          extensions={UNLIT: {}, "KHR_materials_emissive_strength": {"emissiveStrength": 5}}), pixels(all_of(1, 0, 0)),
    "unlit decides")

row("KHR_materials_pbrSpecularGlossiness", MUST, "without support, metallic-roughness is the fallback", "spec_gloss",
    edit(base().uses("KHR_materials_pbrSpecularGlossiness"),
         ("materials/0/extensions/KHR_materials_pbrSpecularGlossiness", {"diffuseFactor": [0, 0, 0, 1]})),
    same(BASE, "specular-glossiness"))

row("KHR_materials_unlit", MUST, "the colour is base factor * texture * vertex colour, whatever the light", "unlit",
    base(textured(pbrMetallicRoughness={"baseColorTexture": {"index": 0}, "baseColorFactor": [0.5, 1, 0.5, 1]}),
         attributes=colours([1, 1, 0.5, 1] * 4), image=flat(255, 128, 255)), pixels(all_of(0.5, 0.21586, 0.25)))
row("KHR_materials_unlit", MUST, "other properties of light are ignored", "unlit_others",
    solid((1, 0, 0), emissiveFactor=[1, 1, 1]), pixels(all_of(1, 0, 0)))
row("KHR_materials_unlit", MUST, "alpha and doubleSided count", "unlit_mask",
    solid((1, 0, 0), 0.2, alphaMode="MASK"), pixels(all_of(*SKY)))
row("KHR_materials_unlit", MUST, "doubleSided counts", "unlit_double",
    solid((1, 0, 0), node=TURNED, doubleSided=True), pixels(all_of(1, 0, 0)))

row("KHR_mesh_quantization", MUST, "it is required, not only used", "quantized_used",
    quantized(required=False), ignored(), "read all the same")
row("KHR_mesh_quantization", MUST, "it is listed", "quantized_unlisted",
    quantized(used=False, required=False), refused("where KHR_mesh_quantization is not required"))
row("KHR_mesh_quantization", MUST, "items begin at multiples of 4", "quantized_tight",
    quantized("u8", padded=False), ignored(), "read tightly packed: there is no other reading")
row("KHR_mesh_quantization", MUST, "TEXCOORD of unnormalized integers", "quantized_uv",
    base(attributes={"TEXCOORD_0": data("i16", "VEC2", [0, 1, 1, 1, 1, 0, 0, 0], target=34962)}).requires(Q),
    same(BASE))
row("KHR_mesh_quantization", MUST, "NORMAL of signed bytes, normalized", "quantized_normal",
    tilted(lit(attributes=byte_normals("i8", 127)).requires(Q)), same(tilted(lit())))
row("KHR_mesh_quantization", MUST, "NORMAL is not of unsigned bytes", "quantized_normal_u8",
    lit(attributes=byte_normals("u8", 255)).requires(Q), refused("componentType 5121"))
row("KHR_mesh_quantization", MUST, "skinned meshes: the scale is in the inverse bind matrices", "quantized_skin",
    edit(skinned(document=quantized(), matrices=[SMALLER, SMALLER]), ("nodes/1/scale", GONE),
         ("nodes/1/translation", GONE)), same(BASE))
for kind in ("i8", "u8", "i16", "u16"):
	for normalized in (False, True):
		row(Q, MUST, f"POSITION of {kind}{', normalized' if normalized else ''}",
		    f"quantized_{kind}{'_n' if normalized else ''}", quantized(kind, normalized), same(BASE))

row("KHR_texture_transform", MUST, "offset", "transform_offset",
    transformed(offset=[0.5, 0]), pixels(at(upper_left=(0, 1, 0), upper_right=(1, 0, 0))))
row("KHR_texture_transform", MUST, "scale", "transform_scale",
    transformed(scale=[1, -1], offset=[0, 1]), pixels(at(upper_left=(0, 0, 1), lower_left=(1, 0, 0))))
row("KHR_texture_transform", MUST, "rotation turns uv counter-clockwise about the origin, after scale, before offset",
    "transform_rotation",
    transformed(offset=[0, 1], rotation=math.pi / 2),
    pixels(at(upper_left=(0, 0, 1), upper_right=(1, 0, 0), lower_left=(1, 1, 1))))
row("KHR_texture_transform", MUST, "the example of the extension: the lower left quadrant", "transform_example",
    transformed(offset=[0, 1], rotation=math.pi / 2, scale=[0.5, 0.5]), pixels(at(middle=(0, 0, 1))))
row("KHR_texture_transform", MUST, "texCoord stands before that of the texture", "transform_set",
    second_set(transformed(texCoord=1)), same(BASE))
row("KHR_texture_transform", MUST, "each texture has its own", "transform_each",
    base(textured(emissiveTexture={"index": 0, "extensions": {X: {"offset": [0.5, 0]}}}, emissiveFactor=[1, 1, 1])),
    pixels(FOUR))
row("KHR_texture_transform", MUST, "offset and scale have two numbers", "transform_short",
    transformed(offset=[1]), refused("an array of 2 numbers"))
row("KHR_texture_transform", MUST, "required and read", "transform_required",
    edit(transformed(offset=[0.5, 0]), ("extensionsRequired", [X])), pixels(at(upper_left=(0, 1, 0))))

for name in ("KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif", "MSFT_texture_dds"):
	row(name, MUST, "a texture with a fallback is read by it", f"fallback_{name.lower()}",
	    with_fallback(name), same(BASE, "PNG or JPEG images only"))
for name in ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"):
	row(name, MUST, "required: not loaded", f"required_{name.lower()}",
	    base().requires(name), refused(f"is compressed by {name}"))
	row(name, MUST, "used, with uncompressed copies: those are read", f"used_{name.lower()}",
	    base().uses(name), same(BASE, "are read from their uncompressed copies"))
