/* Primitives, glTF 2.0 section 3.7.2: lists, strips and fans become triangles; only vertices that a triangle uses are
 * kept, in the order of their first use. */
#include "gltf.h"

namespace gltf {

static constexpr uint64_t most_items = 1u << 28; /* triangles or vertices of a scene: 24 GB */

/* The corners of triangle i among the primitive's vertices. */
static void triangle_corners(int mode, size_t i, size_t corner[3])
{
	size_t odd = i & 1;
	switch (mode) {
	case TINYGLTF_MODE_TRIANGLE_STRIP: corner[0] = i, corner[1] = i + 1 + odd, corner[2] = i + 2 - odd; break;
	case TINYGLTF_MODE_TRIANGLE_FAN: corner[0] = i + 1, corner[1] = i + 2, corner[2] = 0; break;
	default: corner[0] = 3 * i, corner[1] = 3 * i + 1, corner[2] = 3 * i + 2; break;
	}
}

static size_t triangle_count(loader &in, int mode, size_t n)
{
	bool is_list = mode == TINYGLTF_MODE_TRIANGLES;
	size_t count = is_list ? n / 3 : n < 3 ? 0 : n - 2;
	if (n < 3 || (is_list && n % 3 != 0)) in.notes.insert("vertices that complete no triangle are ignored");
	if (count > most_items)
		fail("a primitive of %zu triangles; at most %llu are drawn", count, (unsigned long long)most_items);
	return count;
}

struct attributes {
	std::map<std::string, view> views;
	size_t count = 0;
	void open(loader &in, const tinygltf::Primitive &primitive, const std::string &where);
	ts_vertex read(size_t i) const;
};

struct form {
	const char *name;
	int type, other_type;
	unsigned forms;
	size_t offset; /* in floats of ts_vertex */
};
#define AT(field) (offsetof(ts_vertex, field) / sizeof(f32))
static const form known_forms[] = {
	{"POSITION", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT, AT(position)},
	{"NORMAL", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT, AT(normal)},
	{"TANGENT", TINYGLTF_TYPE_VEC4, TINYGLTF_TYPE_VEC4, AS_FLOAT, AT(tangent)},
	{"TEXCOORD_0", TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC2, AS_FLOAT | AS_UNORM, AT(uv)},
	{"TEXCOORD_1", TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC2, AS_FLOAT | AS_UNORM, AT(uv) + 2},
	{"COLOR_0", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4, AS_FLOAT | AS_UNORM, AT(colour)},
};

void attributes::open(loader &in, const tinygltf::Primitive &primitive, const std::string &where)
{
	for (const auto &attribute : primitive.attributes) {
		const form *match = nullptr;
		for (const form &f : known_forms)
			if (attribute.first == f.name) match = &f;
		if (!match) {
			in.notes.insert("the vertex attribute " + quoted(attribute.first) + " is ignored");
			continue;
		}
		view v = view_open(in, attribute.second, match->type, match->other_type, match->forms, attribute.first);
		if (count != 0 && v.count != count)
			fail("%s: %s has %zu items, another attribute has %zu", where.c_str(), match->name, v.count, count);
		count = v.count;
		views.emplace(attribute.first, std::move(v));
	}
}

ts_vertex attributes::read(size_t i) const
{
	f32 field[sizeof(ts_vertex) / sizeof(f32)] = {0.0f};
	for (int k = 0; k < 4; k++)
		field[AT(colour) + (size_t)k] = 1.0f;
	for (const form &f : known_forms) {
		auto found = views.find(f.name);
		if (found == views.end()) continue;
		for (int k = 0; k < found->second.components; k++)
			field[f.offset + (size_t)k] = found->second.number(i, k);
	}
	ts_vertex vertex;
	static_assert(sizeof vertex == sizeof field, "ts_vertex consists of 4-byte fields");
	memcpy(&vertex, field, sizeof vertex);
	return vertex;
}

static void note_missing_uv(loader &in, const tinygltf::Primitive &primitive, const attributes &a)
{
	unsigned sets = material_uv_sets(in, primitive.material);
	for (unsigned set = 0; set < 2; set++) {
		std::string name = "TEXCOORD_" + std::to_string(set);
		if ((sets >> set & 1) && !a.views.count(name))
			in.notes.insert("textured primitives without " + name + " are read at (0, 0)");
	}
}

/* Keeps the vertices that triangles use. `place` is the index that an accessor's item received. */
static void collect(piece &out, const attributes &a, const std::vector<uint32_t> &corners)
{
	std::map<uint32_t, u32> spread;
	bool is_small = a.count <= corners.size() * 4;
	std::vector<u32> dense(is_small ? a.count : 0, TS_NONE);
	for (uint32_t corner : corners) {
		u32 &place = is_small ? dense[corner] : spread.emplace(corner, TS_NONE).first->second;
		if (place == TS_NONE) {
			place = (u32)out.vertices.size();
			out.vertices.push_back(a.read(corner));
		}
		out.corners.push_back(place);
	}
}

static std::vector<uint32_t> read_corners(loader &in, const tinygltf::Primitive &primitive, int mode, size_t n_vertices,
										  const std::string &where)
{
	view list{};
	if (primitive.indices >= 0)
		list = view_open(in, primitive.indices, TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_SCALAR, AS_INDEX, "indices");
	size_t n = triangle_count(in, mode, primitive.indices >= 0 ? list.count : n_vertices);
	std::vector<uint32_t> corners;
	corners.reserve(3 * n);
	for (size_t i = 0; i < n; i++) {
		size_t at[3];
		triangle_corners(mode, i, at);
		for (size_t k : at)
			corners.push_back(primitive.indices >= 0 ? list.index(k) : (uint32_t)k);
	}
	for (size_t i = 0; primitive.indices >= 0 && i < list.count; i++)
		if (list.index(i) >= n_vertices)
			fail("%s: index %u at %zu; there are %zu vertices", where.c_str(), list.index(i), i, n_vertices);
	return corners;
}

piece piece_decode(loader &in, const tinygltf::Primitive &primitive, const std::string &where)
{
	piece out;
	attributes a;
	int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
	out.material = TS_NONE;
	if (mode < TINYGLTF_MODE_TRIANGLES) {
		in.notes.insert("points and lines are not drawn");
		return out;
	}
	a.open(in, primitive, where);
	if (!a.views.count("POSITION")) {
		in.notes.insert("primitives without POSITION are not drawn");
		return out;
	}
	std::vector<uint32_t> corners = read_corners(in, primitive, mode, a.count, where);
	if (corners.empty()) return out;
	out.corners.reserve(corners.size());
	collect(out, a, corners);
	out.material = material_build(in, primitive.material);
	note_missing_uv(in, primitive, a);
	return out;
}

void piece_place(ts_build *build, const piece &piece, const ts_place &place)
{
	u32 first = 0;
	for (size_t i = 0; i < piece.vertices.size() && !ts_build_failed(build); i++) {
		ts_vertex vertex = ts_place_vertex(&place, &piece.vertices[i]);
		u32 index = ts_build_vertex(build, &vertex);
		if (i == 0) first = index;
	}
	for (size_t i = 0; i < piece.corners.size() && !ts_build_failed(build); i += 3) {
		u32 b = piece.corners[i + 1], c = piece.corners[i + 2];
		if (place.side < 0.0f) std::swap(b, c);
		ts_build_triangle(build, first + piece.corners[i], first + b, first + c, piece.material);
	}
}

} // namespace gltf
