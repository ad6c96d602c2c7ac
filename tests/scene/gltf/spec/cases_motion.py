"""Cameras and animations; shading and interpolation, which the appendices have."""
import math

from document import GONE, edit
from judges import BASE, MUST, SHOULD, Chapter, by_test, ignored, noted, pixels, refused, same
from scenes import FOUR, HALF, at, base, lit, moving, shifted

CHAPTER = Chapter("3.10, 3.11, B and C: cameras and animations")
row = CHAPTER.row
TARGET = "animations/0/channels/0/target"
EIGHTH_Z = [0, 0, math.sin(math.pi / 8), math.cos(math.pi / 8)]

row("3.10.2", MUST, "+X right, looks along -Z, +Y up", "camera_axes",
    base(), pixels(FOUR))
row("3.10.2", MUST, "the scale of a camera's node is ignored", "camera_scale",
    edit(base(), ("nodes/0/scale", [3, 0.5, 7])), same(BASE))
row("3.10.2", MUST, "a turned camera", "camera_turned",
    edit(base(), ("nodes/0/rotation", [0, 0, HALF, HALF])),
    pixels(at(upper_left=(0, 0, 1), upper_right=(1, 0, 0), lower_right=(0, 1, 0))))

row("3.10.3", SHOULD, "perspective: yfov is the whole vertical angle in radians", "camera_yfov",
    base(), pixels(FOUR))
row("3.10.3", SHOULD, "a picture of another shape than aspectRatio is neither cropped nor stretched", "camera_aspect",
    edit(base(), ("cameras/0/perspective/aspectRatio", 4)), ignored(),
    "not read: the height of a picture is that of the camera")
row("3.10.3", SHOULD, "nothing nearer than znear", "camera_near",
    edit(base(), ("cameras/0/perspective/znear", 5)), ignored(), "not read: what is nearer is drawn")
row("3.10.3", SHOULD, "nothing farther than zfar", "camera_far",
    edit(base(), ("cameras/0/perspective/znear", 0.1), ("cameras/0/perspective/zfar", 1)), ignored(),
    "not read: what is farther is drawn")
row("3.10.3", SHOULD, "orthographic projection", "camera_orthographic",
    edit(base(),
         ("cameras/0", {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 9}})),
    noted("it is not a perspective one"))

row("3.11", MUST, "a channel moves what it names", "anim_move",
    moving(values=((1, 0, 0), (1, 0, 0))), same(shifted(1)))
row("3.11", MUST, "what is not animated keeps its value", "anim_keeps",
    moving(((0.5, 0, 0), (0.5, 0, 0)),
           node={"scale": [0.5, 0.5, 1], "rotation": [0, 0, HALF, HALF], "translation": [9, 9, 9]}),
    same(base(node={"scale": [0.5, 0.5, 1], "rotation": [0, 0, HALF, HALF], "translation": [0.5, 0, 0]})))
row("3.11", SHOULD, "a channel without a node is ignored", "anim_no_node",
    edit(moving(((1, 0, 0), (1, 0, 0))), (f"{TARGET}/node", GONE)), same(BASE, "without a node"))
row("3.11", MUST, "paths are four; others are ignored", "anim_path_odd",
    edit(moving(), (f"{TARGET}/path", "colour")), same(BASE, "are ignored"))
row("3.11", MUST, "weights move nodes with morph targets alone", "anim_weights",
    moving(((0.0,), (0.0,)), "weights"), same(BASE, "animations of morph targets are ignored"))
row("3.11", MUST, "one channel a node and path", "anim_twice",
    edit(moving(), ("animations/0/channels/1", {"sampler": 0, "target": {"node": 1, "path": "translation"}})),
    refused("is animated already"))
row("3.11", MUST, "before the first keyframe its value stands", "anim_before",
    moving(times=(1, 2), values=((1, 0, 0), (9, 0, 0))), same(shifted(1)))
row("3.11", MUST, "output: translation is VEC3 of floats", "anim_translation_i16",
    moving(kind="i16", normalized=True), refused("componentType"))
row("3.11", MUST, "output: rotation is VEC4", "anim_rotation_vec3",
    moving(path="rotation"), refused("the type is not what this use needs"))
row("3.11", MUST, "output: scale is VEC3 of floats", "anim_scale_i8",
    moving(path="scale", kind="i8", normalized=True), refused("componentType"))
row("3.11", MUST, "normalized integers: max(c / 127, -1), c / 255, max(c / 32767, -1), c / 65535", "anim_rotation_i8",
    moving(path="rotation", kind="i8", normalized=True, values=((0, 0, -128, 0), (0, 0, -128, 0))),
    same(base(node={"rotation": [0, 0, 1, 0]})))
row("3.11", MUST, "rotation of integers is normalized", "anim_rotation_i16",
    moving(path="rotation", kind="i16", values=((0, 0, 0, 1), (0, 0, 0, 1))), refused("normalized 5120 to 5123"))
row("3.11", MUST, "input is SCALAR of floats", "anim_times_vec3",
    edit(moving(), ("animations/0/samplers/0/input", 5)), refused("the type is not what this use needs"))
row("3.11", MUST, "input has min and max", "anim_bounds",
    edit(moving(), ("accessors/4/max", GONE)), ignored(), "min and max are not read")
row("3.11", MUST, "keyframes of morph weights lie end to end", "anim_weights_short",
    moving(((0.0,), (0.0,), (0.0,)), "weights"),
    same(BASE, "animations of morph targets are ignored"))
row("3.11", MUST, "keyframes of rotation are unit quaternions", "anim_rotation_long",
    moving(path="rotation", values=((0, 0, 2, 2), (0, 0, 2, 2))), same(base(node={"rotation": [0, 0, HALF, HALF]})),
    "divided by its length: there is no other reading")
row("3.11", MUST, "animations: a time beyond what can be played", "anim_long",
    moving(times=(0, 3000)), same(BASE, "the first 65520 frames are played"))

row("B.2", MUST, "metal and dielectric are mixed by metalness, Fresnel 0.04", "brdf_closed",
    lit({"roughnessFactor": 1, "baseColorFactor": [0.5, 0.5, 0.5, 1]}),
    pixels({(8, 8): [0.96 * 0.5 + 0.04 / 4] * 3}, size=17),
    "by hand: light and eye stand at right angles to the square")

row("B.2.4", MUST, "a BRDF is positive, the same both ways, and gives no energy", "brdf_energy",
    None,
    by_test("kernels/base/shade.c", "light_and_view_may_change_places", "white_never_returns_more_than_it_receives",
            "a_narrow_lobe_returns_what_it_receives"))

row("C.1", MUST, "at a keyframe its value stands as it is", "key_exact",
    None, by_test("scene/gltf/keyframe.c", "keyframes_give_themselves_unrounded"))
row("C.1", MUST, "LINEAR where nothing is said", "interp_default",
    moving(times=(0, 1), values=((0, 0, 0), (1, 0, 0))), same(shifted(0.5), frame=15))

row("C.2", MUST, "STEP keeps the value", "interp_step",
    moving(times=(0, 1, 2), values=((0, 0, 0), (1, 0, 0), (9, 0, 0)), mode="STEP"), same(shifted(1), frame=45))

row("C.3", MUST, "LINEAR is linear", "interp_linear",
    moving(times=(0, 1, 2), values=((0, 0, 0), (1, 0, 0), (0, 0, 0))), same(shifted(0.5), frame=15))

row("C.4", MUST, "rotations take the shorter arc, at even speed", "interp_slerp",
    moving(path="rotation", values=((0, 0, 0, 1), (0, 0, -HALF, -HALF))),
    same(base(node={"rotation": EIGHTH_Z}), frame=15))

row("C.5", MUST, "CUBICSPLINE: tangents and values, in, value, out", "interp_cubic",
    moving(times=(0, 1), values=((9, 9, 9), (0, 0, 0), (2, 0, 0), (0, 0, 0), (1, 0, 0), (9, 9, 9)), mode="CUBICSPLINE"),
    same(shifted(0.75), frame=15))
row("C.5", MUST, "CUBICSPLINE rotations are made unit", "interp_cubic_turn",
    moving(path="rotation", times=(0, 1),
           values=((0, 0, 0, 0), (0, 0, 0, 1), (0, 0, 0, 0), (0, 0, 0, 0), (0, 0, HALF, HALF), (0, 0, 0, 0)),
           mode="CUBICSPLINE"),
    same(base(node={"rotation": EIGHTH_Z}), frame=15))
row("C.5", MUST, "CUBICSPLINE has two keyframes at least", "interp_cubic_one",
    moving(times=(0,), values=((9, 9, 9), (1, 0, 0), (9, 9, 9)), mode="CUBICSPLINE"), same(shifted(1)),
    "its one value stands: there is no other reading")
row("C.5", MUST, "CUBICSPLINE has three times as many outputs", "interp_cubic_few",
    moving(mode="CUBICSPLINE"), refused("6 are expected"))
row("C.5", SHOULD, "no rotation of zeros comes out", "interp_zero",
    moving(path="rotation", times=(0, 1), values=((0, 0, 0, 0),) * 6, mode="CUBICSPLINE"), refused("length 0"))
