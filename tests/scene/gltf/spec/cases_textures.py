"""Textures, images, samplers and materials."""
from document import (BLACK, BLUE, GAMMA_1, GONE, GREEN, RED, WHITE, checks, chunk, data_uri, edit, flat, flattened,
                      png, quarters)
from judges import BASE, MAY, MUST, SHOULD, Chapter, ignored, more_than, noted, pixels, point_colour, refused, same
from scenes import (DARK, FOUR, HALF, LIT, SKY, TURNED, all_of, at, base, colours, image_in, lit, normal_map, normals,
                    points, sampled, shown, solid, textured, tilted)

CHAPTER = Chapter("3.8 and 3.9: textures and materials")
row = CHAPTER.row

row("3.8.2", SHOULD, "a texture without source is undefined", "texture_no_source",
    edit(base(), ("textures/0/source", GONE)), noted("has no image that is read"))
row("3.8.2", MUST, "without sampler: repeat", "sampler_none",
    sampled(1, 2, 1, 2), pixels(FOUR))

row("3.8.3", MUST, "an image has uri or bufferView: both", "image_both",
    edit(base(), ("images/0/uri", data_uri("image/png", flat(*RED)))), refused("either uri or bufferView"))
row("3.8.3", MUST, "an image has uri or bufferView: neither", "image_neither",
    edit(base(), ("images/0/bufferView", GONE)), refused("either uri or bufferView"))
row("3.8.3", MUST, "an image of a bufferView has a mimeType", "image_no_mime",
    shown(quarters(), None), ignored(), "known by its first bytes")
row("3.8.3", SHOULD, "formats are known by their first bytes", "image_by_bytes",
    image_in("square.dat", "square.dat"), same(BASE))
row("3.8.3", MUST, "the data are what mimeType says", "image_mime_wrong",
    shown(quarters(), "image/jpeg"), ignored(), "read as the PNG that it is")
row("3.8.3", MUST, "the data are PNG or JPEG: a GIF", "image_gif",
    shown(b"GIF89a" + bytes(20), "image/gif"), noted("neither PNG nor JPEG"))
row("3.8.3", MUST, "the data are PNG or JPEG: nothing known", "image_junk",
    shown(b"no image at all"), refused("neither PNG nor JPEG"))
row("3.8.3", MUST, "(0, 0) is the upper left corner", "texture_upright",
    base(), pixels(FOUR))
row("3.8.3", MUST, "gamma values of a PNG are ignored", "png_gamma",
    shown(png(1, 1, (128, 128, 128), between=GAMMA_1 + chunk(b"sRGB", b"\x03"))), pixels(all_of(0.21586)))
row("3.8.3", MAY, "two images of one file", "image_twice",
    edit(image_in("square%20one.png", "square one.png"), ("images/1", {"uri": "square%20one.png"}),
         ("textures/1", {"source": 1}), ("materials/0/emissiveTexture", {"index": 1})), same(BASE))

row("3.8.4", MUST, "wrap: repeat", "wrap_repeat",
    sampled(-2, -1, 3, 4, wrapS=10497, wrapT=10497), pixels(FOUR))
row("3.8.4", MUST, "wrap: mirrored", "wrap_mirror",
    sampled(1, 2, -1, 0, wrapS=33648, wrapT=33648),
    pixels(at(upper_left=(1, 1, 1), upper_right=(0, 0, 1), lower_left=(0, 1, 0))))
row("3.8.4", MUST, "wrap: clamped", "wrap_clamp",
    sampled(1, 2, -3, -2, wrapS=33071, wrapT=33071), pixels(all_of(0, 1, 0)))
row("3.8.4", MUST, "wrap modes of S and T apart", "wrap_two",
    sampled(1, 2, -3, -2, wrapS=10497, wrapT=33071), pixels({(4, 8): (1, 0, 0), (11, 8): (0, 1, 0)}))
row("3.8.4", MUST, "wrap modes are three", "wrap_odd",
    sampled(0, 1, 0, 1, wrapS=10498), refused("wrap mode 10498"))
row("3.8.4", SHOULD, "filters are followed", "filter_nearest",
    sampled(0, 1, 0, 1, magFilter=9728, minFilter=9728), noted("samplers' filters are ignored"))
row("3.8.4", SHOULD, "filters that are none", "filter_odd",
    sampled(0, 1, 0, 1, magFilter=7), noted("samplers' filters are ignored"))
row("3.8.4", SHOULD, "mip levels are made", "mipmaps",
    shown(checks(64)), pixels(all_of(0.5)))
row("3.8.4", MUST, "a sampler without wrap modes repeats", "sampler_empty",
    edit(sampled(1, 2, 1, 2), ("samplers", [{}]), ("textures/0/sampler", 0)), pixels(FOUR))

row("3.8.4.5", SHOULD, "sides that are no powers of two", "texture_3x3",
    shown(png(3, 3, flattened((RED, GREEN, BLUE, WHITE, BLACK, WHITE, RED, RED, RED)))),
    pixels({(2, 2): (0.9697, 0, 0.0303)}))

row("3.9.2", MUST, "without textures their components are 1; factors have their defaults", "material_defaults",
    base({}),
    same(base({"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "metallicFactor": 1, "roughnessFactor": 1},
               "emissiveFactor": [0, 0, 0], "alphaMode": "OPAQUE", "doubleSided": False})))
row("3.9.2", MUST, "a factor multiplies its texture", "base_product",
    base(textured(pbrMetallicRoughness={"baseColorTexture": {"index": 0}, "baseColorFactor": [0.5, 0.25, 1, 1]}),
         image=flat(255, 255, 0)), pixels(all_of(0.5, 0.25, 0)))
row("3.9.2", MUST, "base colour is decoded from sRGB", "base_srgb",
    shown(flat(64, 124, 231)), pixels(all_of(0.0513, 0.2016, 0.7991)))
row("3.9.2", SHOULD, "base colour is decoded before it is interpolated", "base_srgb_first",
    shown(png(2, 1, BLACK + WHITE)), pixels({(7, 8): (0.4375,) * 3, (8, 8): (0.5625,) * 3}))
row("3.9.2", MUST, "metallic-roughness is linear; roughness is green, metalness blue; red and alpha count for nothing",
    "metal_rough",
    tilted(base({"pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0},
                                          "baseColorFactor": [0.5, 0.6, 0.7, 1]}}, image=flat(7, 128, 64, 9))),
    same(tilted(base({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.6, 0.7, 1], "roughnessFactor": 128 / 255,
                                               "metallicFactor": 64 / 255}}))))
row("3.9.2", MUST, "COLOR_0 multiplies the base colour, linearly", "colour_product",
    solid((0.5, 1, 1), 1, colours([0.5, 0.25, 1, 1] * 4)), pixels(all_of(0.25, 0.25, 1)))
row("3.9.2", MAY, "metallic-roughness of 16 bits", "metal_rough_16",
    tilted(base({"pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0}}},
                image=png(1, 1, (0, 0, 128, 128, 64, 64), depth=16))),
    same(tilted(base({"pbrMetallicRoughness": {"roughnessFactor": 128 / 255, "metallicFactor": 64 / 255}}))),
    "read to 8 bits")

row("3.9.3", MUST, "normal maps: 0 to 1 is -1 to 1, then unit length", "normal_map",
    normal_map(255, 128, 255), same(tilted(base(LIT, attributes=normals(HALF, 0.00278, HALF)))))
row("3.9.3", MUST, "scale multiplies x and y, before the length", "normal_scale",
    normal_map(191, 128, scale=2.0), same(normal_map(255, 128)), "(191 - 127.5) * 2 is about 127.5")
row("3.9.3", MUST, "a normal map's alpha is ignored", "normal_alpha",
    normal_map(255, 128, alpha=(3,)), same(normal_map(255, 128)))
row("3.9.3", SHOULD, "normal maps have blue above 0.5", "normal_blue",
    normal_map(128, 128, 10), pixels(all_of(0.0)), "drawn as the map says, into the surface")
row("3.9.3", MUST, "occlusion does not touch direct light", "occlusion_direct",
    base({**LIT, "occlusionTexture": {"index": 0}}, image=flat(0, 0, 0)), same(base(LIT)))
row("3.9.3", MUST, "occlusion weakens ambient light: red alone, 1 + strength * (red - 1)", "occlusion_ambient",
    base({**LIT, "occlusionTexture": {"index": 0, "strength": 0.5}}, False, image=flat(128, 255, 7)),
    more_than(base(LIT, False), [-0.3 * 0.5 * (1 - 128 / 255)] * 3), "ambient light is 0.3")
row("3.9.3", MUST, "emission is sRGB times its factor", "emissive",
    base({"pbrMetallicRoughness": DARK, "emissiveTexture": {"index": 0}, "emissiveFactor": [1, 0.5, 0]}, False,
         image=flat(128, 255, 255)),
    more_than(base({"pbrMetallicRoughness": DARK}, False), (0.21586, 0.5, 0)))

row("3.9.4", MUST, "OPAQUE: alpha is ignored", "alpha_opaque",
    solid((1, 0, 0), 0.1), pixels(all_of(1, 0, 0)))
row("3.9.4", MUST, "MASK: below the cutoff nothing is drawn; the cutoff is 0.5", "alpha_mask",
    solid((1, 0, 0), 0.49, alphaMode="MASK"), pixels(all_of(*SKY)))
row("3.9.4", MUST, "MASK: at the cutoff all is drawn", "alpha_mask_at",
    solid((1, 0, 0), 0.25, alphaMode="MASK", alphaCutoff=0.25), pixels(all_of(1, 0, 0)))
row("3.9.4", MUST, "BLEND: over what is behind", "alpha_blend",
    solid((1, 0, 0), 0.7, alphaMode="BLEND"), noted("drawn as a mask with cutoff 0.5"))
row("3.9.4", MUST, "BLEND ignores alphaCutoff", "alpha_blend_cutoff",
    solid((1, 0, 0), 0.7, alphaMode="BLEND", alphaCutoff=0.9),
    pixels(all_of(1, 0, 0), "drawn as a mask with cutoff 0.5"))

row("3.9.5", MUST, "single-sided: backs are not drawn", "side_single",
    solid(node=TURNED), pixels(all_of(*SKY)))
row("3.9.5", MUST, "double-sided: backs are drawn, with their normals reversed", "side_double",
    tilted(lit(node=TURNED, doubleSided=True)), same(tilted(lit())))

row("3.9.6", MUST, "the default material is a material without properties", "material_none_strip",
    base(None, mode=5, indices=None), same(base({}, mode=5, indices=None)))

row("3.9.7", SHOULD, "points without NORMAL are drawn without light", "points_no_normal",
    points(normal=False), point_colour((1, 1, 1), "points have no normals", "seen from both sides"))
row("3.9.7", SHOULD, "points without NORMAL, beside triangles", "points_no_normal_beside",
    edit(base(), ("meshes/0/primitives/1", {"mode": 0, "attributes": {"POSITION": 0}})),
    same(BASE, "points have no normals", "seen from both sides"))
row("3.9.7", SHOULD, "points with NORMAL are lit", "points_normal",
    points(), point_colour((1, 1, 1)), "methods of surfels draw them")
row("3.9.7", SHOULD, "points with NORMAL in an effect of triangles", "points_in_reflections",
    points(), refused("has surfels only; reflections by mvr draws triangles"))
row("3.9.7", SHOULD, "points are lit by their material: emission and metalness", "points_emissive",
    points(material={"emissiveFactor": [1, 0, 0], "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1]}}),
    point_colour((0, 0, 0), "materials of points"))
row("3.9.7", SHOULD, "points and lines are one pixel wide", "points_width",
    points(), point_colour((1, 1, 1)), "as wide as their neighbours are far")
