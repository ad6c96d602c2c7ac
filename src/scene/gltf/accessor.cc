/* Accessors, glTF 2.0 section 3.6.2, and the attributes of a primitive, 3.7.2.1, as floats of a record: bounds,
 * alignment and forms are checked when a view is opened, so that reading an item below `count` needs no check.
 * tinygltf checks none of this. */
#include <algorithm>
#include <cstring>
#include "scene/gltf/gltf.h"

namespace gltf {

static constexpr uint64_t unbacked_count = 65536; /* zeros that no byte of the file stands for */

static size_t component_bytes(int component_type)
{
	switch (component_type) {
	case TINYGLTF_COMPONENT_TYPE_BYTE:
	case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
	case TINYGLTF_COMPONENT_TYPE_SHORT:
	case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
	case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
	case TINYGLTF_COMPONENT_TYPE_FLOAT: return 4;
	default: return 0;
	}
}

/* `count` items of `item` bytes, `stride` apart, from `offset` of a buffer view. */
static const unsigned char *range(const loader &in, int view, uint64_t offset, uint64_t count, uint64_t item,
                                  uint64_t stride, size_t alignment, const std::string &where)
{
	const tinygltf::BufferView &v = in.model.bufferViews.at((size_t)view);
	uint64_t end = offset + (count - 1) * stride + item;
	if (end > v.byteLength)
		fail("%s: ends at byte %llu of bufferViews/%d; it has %zu", where.c_str(), (unsigned long long)end, view,
		     v.byteLength);
	if ((v.byteOffset + offset) % alignment != 0)
		fail("%s: begins at byte %llu of its buffer; a multiple of %zu is expected", where.c_str(),
		     (unsigned long long)(v.byteOffset + offset), alignment);
	return in.model.buffers.at((size_t)v.buffer).data.data() + v.byteOffset + offset;
}

static void open_sparse(const loader &in, view &v, const tinygltf::Accessor &a, const std::string &where)
{
	uint64_t count = (uint64_t)a.sparse.count;
	int type = a.sparse.indices.componentType;
	size_t width = component_bytes(type);
	if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
	    type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
		fail("%s/sparse/indices/componentType is %d; 5121, 5123 or 5125 is expected", where.c_str(), type);
	if (count > v.count) fail("%s/sparse/count is %llu of %zu", where.c_str(), (unsigned long long)count, v.count);
	view list{};
	list.count = count;
	list.stride = list.item_bytes = width;
	list.component_type = type;
	list.data = range(in, a.sparse.indices.bufferView, (uint64_t)a.sparse.indices.byteOffset, count, width, width,
	                  width, where + "/sparse/indices");
	v.sparse_data = range(in, a.sparse.values.bufferView, (uint64_t)a.sparse.values.byteOffset, count, v.item_bytes,
	                      v.item_bytes, component_bytes(v.component_type), where + "/sparse/values");
	for (size_t i = 0; i < count; i++) {
		uint32_t index = list.index(i);
		if (index >= v.count) fail("%s/sparse: index %u of %zu", where.c_str(), index, v.count);
		if (i > 0 && index <= v.sparse_index.back()) fail("%s/sparse: indices must increase", where.c_str());
		v.sparse_index.push_back(index);
	}
}

static bool is_small(int component_type)
{
	return component_type >= TINYGLTF_COMPONENT_TYPE_BYTE && component_type <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
}

static bool fits(const tinygltf::Accessor &a, unsigned forms, bool is_quantized)
{
	int c = a.componentType;
	bool is_unsigned = c == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || c == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
	if (c == TINYGLTF_COMPONENT_TYPE_FLOAT) return (forms & AS_FLOAT) && !a.normalized;
	if (forms & AS_INDEX) return (is_unsigned || c == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) && !a.normalized;
	if (forms & AS_JOINT) return is_unsigned && !a.normalized;
	if ((forms & AS_NORM) && is_small(c) && a.normalized) return true;
	if ((forms & AS_UNORM) && is_unsigned && a.normalized) return true;
	if (!is_quantized || !is_small(c)) return false;
	return (forms & AS_SMALL) || ((forms & AS_SNORM) && !is_unsigned && a.normalized);
}

static void check_form(const loader &in, const tinygltf::Accessor &a, int type, int other_type, unsigned forms,
                       const std::string &where)
{
	int c = a.componentType;
	bool asks = !in.doc.is_quantized && is_small(c) && (forms & (AS_SNORM | AS_SMALL));
	if (a.type != type && a.type != other_type) fail("%s: the type is not what this use needs", where.c_str());
	if (!fits(a, forms, in.doc.is_quantized))
		fail("%s: componentType %d%s; %s expected%s", where.c_str(), c, a.normalized ? ", normalized," : "",
		     forms & AS_INDEX   ? "5121, 5123 or 5125 is"
		     : forms & AS_JOINT ? "5121 or 5123 is"
		     : forms & AS_NORM  ? "5126, or normalized 5120 to 5123, is"
		     : forms & AS_UNORM ? "5126, or normalized 5121 or 5123, is"
		                        : "5126 (float) is",
		     asks ? " where KHR_mesh_quantization is not required" : "");
}

view view_open(const loader &in, int accessor, int type, int other_type, unsigned forms, const std::string &what)
{
	const tinygltf::Accessor &a = in.model.accessors.at((size_t)accessor);
	std::string where = "accessors/" + std::to_string(accessor);
	check_form(in, a, type, other_type, forms, where + " (" + what + ")");
	view v{};
	size_t width = component_bytes(a.componentType);
	v.id = accessor;
	v.count = a.count;
	v.component_type = a.componentType;
	v.normalized = a.normalized;
	v.components = tinygltf::GetNumComponentsInType((uint32_t)a.type);
	v.item_bytes = v.stride = width * (size_t)v.components;
	if (!in.doc.unbacked.at((size_t)accessor)) {
		size_t stride = in.model.bufferViews.at((size_t)a.bufferView).byteStride;
		if (stride != 0 && (forms & AS_INDEX)) fail("bufferViews/%d: a byteStride under indices", a.bufferView);
		if (stride != 0 && (stride % 4 != 0 || stride < v.item_bytes))
			fail("bufferViews/%d: byteStride %zu; a multiple of 4 from %zu is expected", a.bufferView, stride,
			     v.item_bytes);
		if (stride != 0) v.stride = stride;
		v.data = range(in, a.bufferView, a.byteOffset, v.count, v.item_bytes, v.stride, width, where);
	} else if (!a.sparse.isSparse && !in.doc.compression.empty()) {
		fail_compressed(where + " (" + what + ")", in.doc.compression);
	} else if (v.count > std::max(unbacked_count, in.held_bytes)) {
		fail("%s: %zu items without a bufferView; at most %llu are read", where.c_str(), v.count,
		     (unsigned long long)std::max(unbacked_count, in.held_bytes));
	}
	if (a.sparse.isSparse) open_sparse(in, v, a, where);
	return v;
}

const unsigned char *view::item(size_t i) const
{
	static const unsigned char zeros[64] = {0};
	auto found = std::lower_bound(sparse_index.begin(), sparse_index.end(), (uint32_t)i);
	if (found != sparse_index.end() && *found == i)
		return sparse_data + (size_t)(found - sparse_index.begin()) * item_bytes;
	return data ? data + i * stride : zeros;
}

static f32 small_number(const unsigned char *p, int component_type, bool normalized)
{
	i32 byte = p[0] < 128 ? p[0] : p[0] - 256;
	switch (component_type) {
	case TINYGLTF_COMPONENT_TYPE_BYTE: return normalized ? ts_number_snorm8(byte) : (f32)byte;
	case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return normalized ? ts_number_unorm8(p[0]) : (f32)p[0];
	}
	u32 code = p[0] | (u32)p[1] << 8;
	i32 number = code < 32768 ? (i32)code : (i32)code - 65536;
	if (component_type == TINYGLTF_COMPONENT_TYPE_SHORT) return normalized ? ts_number_snorm16(number) : (f32)number;
	return normalized ? ts_number_unorm16(code) : (f32)code;
}

f32 view::number(size_t i, int component) const
{
	const unsigned char *p = item(i) + (size_t)component * component_bytes(component_type);
	if (component_type != TINYGLTF_COMPONENT_TYPE_FLOAT) return small_number(p, component_type, normalized);
	u32 bits = p[0] | (u32)p[1] << 8 | (u32)p[2] << 16 | (u32)p[3] << 24;
	if ((bits & 0x7f800000u) == 0x7f800000u) fail("accessors/%d: item %zu is not finite", id, i);
	return ts_san(ts_u2f(bits));
}

uint32_t view::index(size_t i) const
{
	const unsigned char *p = item(i);
	if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return p[0];
	if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return p[0] | (u32)p[1] << 8;
	return p[0] | (u32)p[1] << 8 | (u32)p[2] << 16 | (u32)p[3] << 24;
}

void attributes::open(loader &in, const tinygltf::Primitive &primitive, const std::string &where)
{
	for (const auto &attribute : primitive.attributes) {
		const form *match = nullptr;
		for (const form &f : forms)
			if (attribute.first == f.name) match = &f;
		if (!match) {
			in.notes.insert("the vertex attribute " + quoted(attribute.first) + " is ignored");
			continue;
		}
		try {
			take(in, attribute.second, *match, where);
		} catch (const error &e) {
			if (!match->spared) throw;
			in.notes.insert(e.line + ": it is ignored");
		}
	}
}

void attributes::take(const loader &in, int accessor, const form &as, const std::string &where)
{
	view v = view_open(in, accessor, as.type, as.other_type, as.forms, as.name);
	if (count != 0 && v.count != count)
		fail("%s: %s has %zu items, another attribute has %zu", where.c_str(), as.name.c_str(), v.count, count);
	count = v.count;
	views.emplace(as.name, std::move(v));
}

void attributes::read(size_t i, f32 *field) const
{
	for (const form &f : forms) {
		auto found = views.find(f.name);
		if (found == views.end()) continue;
		for (int k = 0; k < found->second.components; k++) field[f.offset + (size_t)k] = found->second.number(i, k);
	}
}

} // namespace gltf
