/* The part of glTF 2.0 that the loader knows, as tables: the path, type and range of each property, and the extensions
 * that a file may require. guard.cc checks a document against them and removes the rest. */
#ifndef TS_SCENE_GLTF_RULES_H
#define TS_SCENE_GLTF_RULES_H

namespace gltf {

enum kind {
	EXTRAS, /* an OBJECT; a value of another type is ignored */
	OBJECT, /* `of`: the path under which its properties are listed, if not its own */
	LIST,   /* of objects */
	SPARED, /* the same; of one that is not as it should be a note says so, and its list `of` is empty */
	TEXT,   /* `of`: the words allowed, if not any */
	FLAG,
	EXTRA_FLAG, /* a FLAG of ours among other programs' extras: a value of another type is noted and ignored */
	WHOLE,      /* low to high */
	NUMBER,     /* low to high; a rounding outside is the nearest inside, and noted */
	NUMBERS,    /* `n` of them, the same */
	INDEX,      /* below the length of the list `of` */
	INDICES,
	ATTRIBUTES, /* an object of indices into the list `of` */
	NOTED,      /* ignored; `of` is what `touchstone info` says about it */
};

struct rule {
	const char *path; /* `[]` stands for an item of a list */
	kind type;
	bool required = false;
	const char *of = nullptr;
	double low = 0, high = 0;
	unsigned n = 0;
};

struct extension {
	const char *name;
	const char *note; /* what `touchstone info` says about it; NULL: it is read */
	bool compresses = false;
};

static constexpr const char *texture_note = "textures are read from their PNG or JPEG images only";

static const extension known_extensions[] = {
	{"EXT_mesh_gpu_instancing", nullptr},
	{"KHR_lights_punctual", nullptr},
	{"KHR_materials_emissive_strength", nullptr},
	{"KHR_materials_unlit", nullptr},
	{"KHR_mesh_quantization", nullptr},
	{"KHR_texture_transform", nullptr},
	{"KHR_materials_pbrSpecularGlossiness",
     "specular-glossiness materials are drawn by their metallic-roughness fallback"},
	{"KHR_texture_basisu", texture_note},
	{"EXT_texture_webp", texture_note},
	{"EXT_texture_avif", texture_note},
	{"MSFT_texture_dds", texture_note},
	{"KHR_draco_mesh_compression", "meshes of KHR_draco_mesh_compression are read from their uncompressed copies",
     true},
	{"EXT_meshopt_compression", "buffer views of EXT_meshopt_compression are read from their uncompressed copies",
     true},
	{"KHR_meshopt_compression", "buffer views of KHR_meshopt_compression are read from their uncompressed copies",
     true},
};

static constexpr double most_bytes = 2147483647, most_number = 1e300;

static const rule rules[] = {
	{"asset", OBJECT, true},
	{"asset.version", TEXT, true},
	{"asset.minVersion", TEXT},
	{"scene", INDEX, false, "scenes"},
	{"scenes", LIST},
	{"scenes[].nodes", INDICES, false, "nodes"},
	{"nodes", LIST},
	{"nodes[].name", TEXT},
	{"nodes[].mesh", INDEX, false, "meshes"},
	{"nodes[].camera", INDEX, false, "cameras"},
	{"nodes[].skin", INDEX, false, "skins"},
	{"nodes[].children", INDICES, false, "nodes"},
	{"nodes[].matrix", NUMBERS, false, nullptr, -most_number, most_number, 16},
	{"nodes[].translation", NUMBERS, false, nullptr, -most_number, most_number, 3},
	{"nodes[].rotation", NUMBERS, false, nullptr, -most_number, most_number, 4},
	{"nodes[].scale", NUMBERS, false, nullptr, -most_number, most_number, 3},
	{"nodes[].extras", EXTRAS},
	{"nodes[].extras.reflector", EXTRA_FLAG},
	{"nodes[].extensions", OBJECT},
	{"nodes[].extensions.KHR_lights_punctual", OBJECT},
	{"nodes[].extensions.KHR_lights_punctual.light", INDEX, true, "lights"},
	{"nodes[].extensions.EXT_mesh_gpu_instancing", OBJECT},
	{"nodes[].extensions.EXT_mesh_gpu_instancing.attributes", ATTRIBUTES, true, "accessors"},
	{"meshes", LIST},
	{"meshes[].name", TEXT},
	{"meshes[].primitives", LIST, true},
	{"meshes[].primitives[].attributes", ATTRIBUTES, true, "accessors"},
	{"meshes[].primitives[].indices", INDEX, false, "accessors"},
	{"meshes[].primitives[].material", INDEX, false, "materials"},
	{"meshes[].primitives[].mode", WHOLE, false, nullptr, 0, 6},
	{"meshes[].primitives[].targets", NOTED, false, "morph targets are ignored: meshes are drawn in their base shape"},
	{"accessors", LIST},
	{"accessors[].bufferView", INDEX, false, "bufferViews"},
	{"accessors[].byteOffset", WHOLE, false, nullptr, 0, most_bytes},
	{"accessors[].componentType", WHOLE, true, nullptr, 5120, 5126},
	{"accessors[].normalized", FLAG},
	{"accessors[].count", WHOLE, true, nullptr, 1, most_bytes},
	{"accessors[].type", TEXT, true, "SCALAR VEC2 VEC3 VEC4 MAT2 MAT3 MAT4"},
	{"accessors[].sparse", OBJECT},
	{"accessors[].sparse.count", WHOLE, true, nullptr, 1, most_bytes},
	{"accessors[].sparse.indices", OBJECT, true},
	{"accessors[].sparse.indices.bufferView", INDEX, true, "bufferViews"},
	{"accessors[].sparse.indices.byteOffset", WHOLE, false, nullptr, 0, most_bytes},
	{"accessors[].sparse.indices.componentType", WHOLE, true, nullptr, 5121, 5125},
	{"accessors[].sparse.values", OBJECT, true},
	{"accessors[].sparse.values.bufferView", INDEX, true, "bufferViews"},
	{"accessors[].sparse.values.byteOffset", WHOLE, false, nullptr, 0, most_bytes},
	{"bufferViews", LIST},
	{"bufferViews[].buffer", INDEX, true, "buffers"},
	{"bufferViews[].byteOffset", WHOLE, false, nullptr, 0, most_bytes},
	{"bufferViews[].byteLength", WHOLE, true, nullptr, 1, most_bytes},
	{"bufferViews[].byteStride", WHOLE, false, nullptr, 4, 252},
	{"buffers", LIST},
	{"buffers[].uri", TEXT},
	{"buffers[].byteLength", WHOLE, true, nullptr, 1, most_bytes},
	{"images", LIST},
	{"images[].name", TEXT},
	{"images[].uri", TEXT},
	{"images[].bufferView", INDEX, false, "bufferViews"},
	{"images[].mimeType", TEXT},
	{"samplers", LIST},
	{"samplers[].wrapS", WHOLE, false, nullptr, 10497, 33648},
	{"samplers[].wrapT", WHOLE, false, nullptr, 10497, 33648},
	{"samplers[].magFilter", NOTED, false, "samplers' filters are ignored: textures are read trilinearly"},
	{"samplers[].minFilter", NOTED, false, "samplers' filters are ignored: textures are read trilinearly"},
	{"textures", LIST},
	{"textures[].source", INDEX, false, "images"},
	{"textures[].sampler", INDEX, false, "samplers"},
	{"materials", LIST},
	{"materials[].name", TEXT},
	{"materials[].pbrMetallicRoughness", OBJECT},
	{"materials[].pbrMetallicRoughness.baseColorFactor", NUMBERS, false, nullptr, 0, 1, 4},
	{"materials[].pbrMetallicRoughness.metallicFactor", NUMBER, false, nullptr, 0, 1},
	{"materials[].pbrMetallicRoughness.roughnessFactor", NUMBER, false, nullptr, 0, 1},
	{"materials[].pbrMetallicRoughness.baseColorTexture", OBJECT, false, "texture"},
	{"materials[].pbrMetallicRoughness.metallicRoughnessTexture", OBJECT, false, "texture"},
	{"materials[].normalTexture", OBJECT, false, "texture"},
	{"materials[].occlusionTexture", OBJECT, false, "texture"},
	{"materials[].emissiveTexture", OBJECT, false, "texture"},
	{"texture.index", INDEX, true, "textures"},
	{"texture.texCoord", WHOLE, false, nullptr, 0, most_bytes},
	{"texture.scale", NUMBER, false, nullptr, -most_number, most_number},
	{"texture.strength", NUMBER, false, nullptr, 0, 1},
	{"texture.extensions", OBJECT},
	{"texture.extensions.KHR_texture_transform", OBJECT},
	{"texture.extensions.KHR_texture_transform.offset", NUMBERS, false, nullptr, -most_number, most_number, 2},
	{"texture.extensions.KHR_texture_transform.rotation", NUMBER, false, nullptr, -most_number, most_number},
	{"texture.extensions.KHR_texture_transform.scale", NUMBERS, false, nullptr, -most_number, most_number, 2},
	{"texture.extensions.KHR_texture_transform.texCoord", WHOLE, false, nullptr, 0, most_bytes},
	{"materials[].emissiveFactor", NUMBERS, false, nullptr, 0, 1, 3},
	{"materials[].alphaMode", TEXT, false, "OPAQUE MASK BLEND"},
	{"materials[].alphaCutoff", NUMBER, false, nullptr, 0, most_number},
	{"materials[].doubleSided", FLAG},
	{"materials[].extensions", OBJECT},
	{"materials[].extensions.KHR_materials_unlit", OBJECT},
	{"materials[].extensions.KHR_materials_emissive_strength", OBJECT},
	{"materials[].extensions.KHR_materials_emissive_strength.emissiveStrength", NUMBER, false, nullptr, 0, most_number},
	{"cameras", LIST},
	{"cameras[].name", TEXT},
	{"cameras[].type", TEXT, true, "perspective orthographic"},
	{"cameras[].perspective", OBJECT},
	{"cameras[].perspective.yfov", NUMBER, true, nullptr, -most_number, most_number},
	{"cameras[].perspective.znear", NUMBER, true, nullptr, -most_number, most_number},
	{"cameras[].orthographic", OBJECT},
	{"cameras[].orthographic.xmag", NUMBER, true, nullptr, -most_number, most_number},
	{"cameras[].orthographic.ymag", NUMBER, true, nullptr, -most_number, most_number},
	{"cameras[].orthographic.zfar", NUMBER, true, nullptr, -most_number, most_number},
	{"cameras[].orthographic.znear", NUMBER, true, nullptr, -most_number, most_number},
	{"extensions", OBJECT},
	{"extensions.KHR_lights_punctual", OBJECT},
	{"extensions.KHR_lights_punctual.lights", LIST, true},
	{"extensions.KHR_lights_punctual.lights[].name", TEXT},
	{"extensions.KHR_lights_punctual.lights[].type", TEXT, true, "directional point spot"},
	{"extensions.KHR_lights_punctual.lights[].color", NUMBERS, false, nullptr, 0, most_number, 3},
	{"extensions.KHR_lights_punctual.lights[].intensity", NUMBER, false, nullptr, 0, most_number},
	{"extensions.KHR_lights_punctual.lights[].range", NUMBER, false, nullptr, 0, most_number},
	{"extensions.KHR_lights_punctual.lights[].spot", OBJECT},
	{"extensions.KHR_lights_punctual.lights[].spot.innerConeAngle", NUMBER, false, nullptr, 0, 1.5707963267948967},
	{"extensions.KHR_lights_punctual.lights[].spot.outerConeAngle", NUMBER, false, nullptr, 0, 1.5707963267948967},
	{"skins", SPARED, false, "joints"},
	{"skins[].joints", INDICES, true, "nodes"},
	{"skins[].inverseBindMatrices", INDEX, false, "accessors"},
	{"animations", LIST},
	{"animations[].name", TEXT},
	{"animations[].channels", LIST, true},
	{"animations[].channels[].sampler", WHOLE, true, nullptr, 0, most_bytes},
	{"animations[].channels[].target", OBJECT, true},
	{"animations[].channels[].target.node", INDEX, false, "nodes"},
	{"animations[].channels[].target.path", TEXT, true},
	{"animations[].samplers", LIST, true},
	{"animations[].samplers[].input", INDEX, true, "accessors"},
	{"animations[].samplers[].output", INDEX, true, "accessors"},
	{"animations[].samplers[].interpolation", TEXT, false, "LINEAR STEP CUBICSPLINE"},
};

} // namespace gltf

#endif
