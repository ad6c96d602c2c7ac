/* Materials, textures, samplers and images, glTF 2.0 sections 3.8 and 3.9, KHR_texture_transform, KHR_materials_unlit,
 * KHR_materials_emissive_strength. Base colour and emissive images are sRGB, the others linear. */
#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <touchstone/image.h>
#include "image/format.h"
#include "kernels/base/texture.h"
#include "scene/gltf/gltf.h"

namespace gltf {

/* A byte of a PNG holds at most 1032 bytes of a flat 8-bit image, a byte of a JPEG far fewer texels. */
static constexpr uint64_t texels_a_byte = 1032, free_texels = 65536, most_texels = 1u << 28,
						  most_image_bytes = 1u << 30;

uint64_t texel_budget(uint64_t file_bytes) { return std::min(most_texels, free_texels + file_bytes * texels_a_byte); }

/* Whether the image is of a format that is known, but not read; noted. By its contents, or by what the file says of it
 * where those say nothing. */
static bool is_foreign(loader &in, int index, const unsigned char *data, size_t n)
{
	const std::string &type = in.doc.images.at((size_t)index).type;
	const char *name = nullptr;
	if (ts_image_format_is_decoded(ts_image_format_find(data, n, &name))) return false;
	if (!name && (type.empty() || type == "image/png" || type == "image/jpeg")) return false;
	in.notes.insert("images/" + std::to_string(index) + " is " + (name ? name : quoted(type)) +
	                ", neither PNG nor JPEG: its textures are left out");
	return true;
}

static bool is_decoded(const bytes &head)
{
	return ts_image_format_is_decoded(ts_image_format_find(head.data(), head.size(), nullptr));
}

/* TS_NONE of a format that is not read. */
static u32 image_build(loader &in, int index, bool srgb)
{
	auto known = in.images.find({index, srgb});
	if (known != in.images.end()) return known->second;
	const picture &image = in.doc.images.at((size_t)index);
	std::string what = in.path + ": images/" + std::to_string(index);
	const unsigned char *data = image.from.data.data();
	size_t n = image.from.data.size();
	bytes external;
	if (image.view >= 0) {
		const tinygltf::BufferView &view = in.model.bufferViews.at((size_t)image.view);
		data = in.model.buffers.at((size_t)view.buffer).data.data() + view.byteOffset;
		n = view.byteLength;
	} else if (n == 0) {
		external = file_read_beside(in, image.from.path, {most_image_bytes, most_image_bytes, is_decoded});
		data = external.data();
		n = external.size();
		in.texel_budget = std::min(most_texels, in.texel_budget + n * texels_a_byte);
	}
	if (is_foreign(in, index, data, n)) return in.images[{index, srgb}] = TS_NONE;
	uint8_t *rgba = nullptr;
	uint32_t width = 0, height = 0;
	uint64_t limit = std::min(in.texel_budget, free_texels + n * texels_a_byte);
	if (ts_image_decode(&rgba, &width, &height, data, n, limit, what.c_str()) != TS_OK) throw error{"", TS_KIND_NONE};
	std::unique_ptr<uint8_t, void (*)(void *)> owner(rgba, free);
	in.texel_budget -= (uint64_t)width * height;
	u32 built = ts_build_image(in.build, rgba, width, height, srgb);
	in.images[{index, srgb}] = built;
	return built;
}

static u32 wrap_mode(int mode, int sampler)
{
	switch (mode) {
	case TINYGLTF_TEXTURE_WRAP_REPEAT: return TS_REPEAT;
	case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT: return TS_MIRROR;
	case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE: return TS_CLAMP;
	default: fail("samplers/%d: wrap mode %d; 10497, 33071 or 33648 is expected", sampler, mode);
	}
}

static f32 number_at(const tinygltf::Value &object, const char *key, size_t i, f32 otherwise)
{
	if (!object.Has(key)) return otherwise;
	const tinygltf::Value &value = object.Get(key);
	return ts_number((value.IsArray() ? value.Get(i) : value).GetNumberAsDouble());
}

static const tinygltf::Value *transform_of(const tinygltf::ExtensionMap &extensions)
{
	auto found = extensions.find("KHR_texture_transform");
	return found == extensions.end() ? nullptr : &found->second;
}

/* A texture as a material names it. */
struct texture_use {
	int index, set;
	const tinygltf::ExtensionMap *extensions;
};

template <typename Info> static texture_use use_of(const Info &info)
{
	const tinygltf::Value *t = transform_of(info.extensions);
	return {info.index, t && t->Has("texCoord") ? t->Get("texCoord").GetNumberAsInt() : info.texCoord,
	        &info.extensions};
}

/* In the order of the slots. */
static std::array<texture_use, TS_N_SLOTS> uses_of(const tinygltf::Material &m)
{
	return {use_of(m.pbrMetallicRoughness.baseColorTexture), use_of(m.pbrMetallicRoughness.metallicRoughnessTexture),
	        use_of(m.normalTexture), use_of(m.occlusionTexture), use_of(m.emissiveTexture)};
}

uv_sets material_uv_sets(const loader &in, int index)
{
	uv_sets plain = {{0, 1}, {false, false}}, named = {{-1, -1}, {false, false}};
	if (index < 0) return plain;
	bool is_plain = true;
	for (const texture_use &use : uses_of(in.model.materials.at((size_t)index))) {
		if (use.index < 0) continue;
		size_t place = named.set[0] < 0 || named.set[0] == use.set ? 0 : 1;
		if (named.set[place] < 0) named.set[place] = use.set;
		named.used[place] = true;
		if (use.set < 2)
			plain.used[use.set] = true;
		else
			is_plain = false;
	}
	if (named.set[1] < 0) named.set[1] = 0;
	return is_plain ? plain : named;
}

static u32 slot_build(loader &in, const texture_use &use, u32 uv_set, bool srgb)
{
	const tinygltf::Texture &texture = in.model.textures.at((size_t)use.index);
	ts_slot slot = {};
	if (texture.source < 0) {
		in.notes.insert("textures/" + std::to_string(use.index) + " has no image that is read: it is left out");
		return TS_NONE;
	}
	if (texture.sampler >= 0) {
		const tinygltf::Sampler &sampler = in.model.samplers.at((size_t)texture.sampler);
		slot.wrap[0] = wrap_mode(sampler.wrapS, texture.sampler);
		slot.wrap[1] = wrap_mode(sampler.wrapT, texture.sampler);
	}
	f32 offset[2] = {0.0f, 0.0f}, scale[2] = {1.0f, 1.0f}, rotation = 0.0f;
	if (const tinygltf::Value *t = transform_of(*use.extensions)) {
		for (size_t i = 0; i < 2; i++) offset[i] = number_at(*t, "offset", i, 0.0f);
		for (size_t i = 0; i < 2; i++) scale[i] = number_at(*t, "scale", i, 1.0f);
		rotation = number_at(*t, "rotation", 0, 0.0f);
	}
	ts_number_uv_transform(slot.transform, offset, rotation, scale);
	slot.uv_set = uv_set;
	slot.image = image_build(in, texture.source, srgb);
	return slot.image == TS_NONE ? TS_NONE : ts_build_slot(in.build, &slot);
}

static void take_slots(loader &in, ts_material &m, const tinygltf::Material &from, int index)
{
	std::array<texture_use, TS_N_SLOTS> uses = uses_of(from);
	uv_sets sets = material_uv_sets(in, index);
	for (size_t k = 0; k < uses.size(); k++) {
		bool srgb = k == TS_SLOT_BASE || k == TS_SLOT_EMISSIVE;
		u32 place = uses[k].set == sets.set[0] ? 0 : 1;
		if (uses[k].index >= 0 && uses[k].set != sets.set[place])
			in.notes.insert("materials/" + std::to_string(index) +
			                " reads more than two sets of texture coordinates: what uses TEXCOORD_" +
			                std::to_string(uses[k].set) + " is left out");
		else if (uses[k].index >= 0)
			m.slot[k] = slot_build(in, uses[k], place, srgb);
	}
	m.normal_scale = ts_number(from.normalTexture.scale);
	m.occlusion = ts_number(from.occlusionTexture.strength);
}

static void take_factors(ts_material &m, const tinygltf::Material &from)
{
	const auto &pbr = from.pbrMetallicRoughness;
	f32 emissive[3], strength = 1.0f;
	auto found = from.extensions.find("KHR_materials_emissive_strength");
	if (found != from.extensions.end()) strength = number_at(found->second, "emissiveStrength", 0, 1.0f);
	for (size_t i = 0; i < 4; i++) m.base[i] = ts_number(pbr.baseColorFactor.at(i));
	for (size_t i = 0; i < 3; i++) emissive[i] = ts_number(from.emissiveFactor.at(i));
	ts_number_scale3(m.emissive, emissive, strength);
	m.metallic = ts_number(pbr.metallicFactor);
	m.roughness = ts_number(pbr.roughnessFactor);
}

static void take_flags(loader &in, ts_material &m, const tinygltf::Material &from)
{
	if (from.doubleSided) m.flags |= TS_DOUBLE_SIDED;
	if (from.extensions.count("KHR_materials_unlit")) m.flags |= TS_UNLIT;
	if (from.alphaMode == "MASK") {
		m.flags |= TS_MASKED;
		m.alpha_cutoff = ts_number(from.alphaCutoff);
	}
	if (from.alphaMode == "BLEND") {
		m.flags |= TS_MASKED;
		m.alpha_cutoff = 0.5f;
		in.notes.insert("the blended material " + quoted(from.name) + " is drawn as a mask with cutoff 0.5");
	}
}

/* Section 3.9.6: all properties have their defaults. */
static u32 default_build(loader &in)
{
	ts_material m = ts_material_default();
	m.metallic = 1.0f;
	return ts_build_material(in.build, &m);
}

u32 material_build(loader &in, int index)
{
	u32 &place = index < 0 ? in.default_material : in.materials.at((size_t)index);
	if (place != TS_NONE) return place;
	if (index < 0) return place = default_build(in);
	const tinygltf::Material &from = in.model.materials.at((size_t)index);
	ts_material m = ts_material_default();
	take_factors(m, from);
	take_flags(in, m, from);
	take_slots(in, m, from, index);
	place = ts_build_material(in.build, &m);
	return place;
}

} // namespace gltf
