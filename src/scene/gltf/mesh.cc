/* Primitives, glTF 2.0 section 3.7.2: lists, strips and fans become triangles; only vertices that a triangle uses are
 * kept, in the order of their first use. */
#include "scene/gltf/gltf.h"

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

struct skinned {
	ts_vertex vertex;
	influence by;
};

static const form vertex_forms[] = {
	{"POSITION", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT | AS_SMALL, AT(ts_vertex, position), false},
	{"NORMAL", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT | AS_SNORM, AT(ts_vertex, normal), false},
	{"TANGENT", TINYGLTF_TYPE_VEC4, TINYGLTF_TYPE_VEC4, AS_FLOAT | AS_SNORM, AT(ts_vertex, tangent), false},
	{"TEXCOORD_0", TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC2, AS_FLOAT | AS_UNORM | AS_SMALL, AT(ts_vertex, uv), false},
	{"TEXCOORD_1", TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC2, AS_FLOAT | AS_UNORM | AS_SMALL, AT(ts_vertex, uv) + 2,
     false},
	{"COLOR_0", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4, AS_FLOAT | AS_UNORM, AT(ts_vertex, colour), false},
	{"JOINTS_0", TINYGLTF_TYPE_VEC4, TINYGLTF_TYPE_VEC4, AS_JOINT, AT(skinned, by.joint), true},
	{"WEIGHTS_0", TINYGLTF_TYPE_VEC4, TINYGLTF_TYPE_VEC4, AS_FLOAT | AS_UNORM, AT(skinned, by.weight), true},
};
static constexpr size_t n_unskinned = 6; /* of the forms */

static std::string uv_name(int set) { return "TEXCOORD_" + std::to_string(set); }

/* The table with the names of those sets. */
static attributes vertex_attributes(const uv_sets &sets, bool has_skins)
{
	attributes a(vertex_forms);
	if (!has_skins) a.forms.resize(n_unskinned, a.forms[0]);
	for (form &f : a.forms)
		for (size_t k = 0; k < 2; k++)
			if (f.offset == AT(ts_vertex, uv) + 2 * k) f.name = uv_name(sets.set[k]);
	return a;
}

static skinned read_vertex(const attributes &a, size_t i)
{
	f32 field[sizeof(skinned) / sizeof(f32)] = {0.0f};
	for (size_t k = 0; k < 4; k++) field[AT(ts_vertex, colour) + k] = 1.0f;
	a.read(i, field);
	skinned vertex;
	static_assert(sizeof vertex == sizeof field, "it consists of 4-byte fields");
	memcpy(&vertex, field, sizeof vertex);
	return vertex;
}

/* Section 3.7.2.1. */
static void drop_lone_tangents(loader &in, attributes &a)
{
	if (!a.has("TANGENT") || a.has("NORMAL")) return;
	a.views.erase("TANGENT");
	in.notes.insert("tangents of primitives without normals are ignored");
}

static void note_missing_uv(loader &in, const tinygltf::Primitive &primitive, const attributes &a)
{
	uv_sets sets = material_uv_sets(in, primitive.material);
	for (size_t k = 0; k < 2; k++) {
		std::string name = uv_name(sets.set[k]);
		if (sets.used[k] && !a.has(name))
			in.notes.insert("textured primitives without " + name + " are read at (0, 0)");
	}
}

/* Keeps the vertices that triangles use. `place` is the index that an accessor's item received. */
static void collect(loader &in, piece &out, const attributes &a, const std::vector<uint32_t> &corners)
{
	std::map<uint32_t, u32> spread;
	bool is_small = a.count <= corners.size() * 4, has_joints = a.has("JOINTS_0") && a.has("WEIGHTS_0");
	std::vector<u32> dense(is_small ? a.count : 0, TS_NONE);
	for (uint32_t corner : corners) {
		go_on(in);
		u32 &place = is_small ? dense[corner] : spread.emplace(corner, TS_NONE).first->second;
		if (place == TS_NONE) {
			place = (u32)out.vertices.size();
			skinned read = read_vertex(a, corner);
			out.vertices.push_back(read.vertex);
			if (has_joints) out.influences.push_back(read.by);
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
		go_on(in);
		size_t at[3];
		triangle_corners(mode, i, at);
		for (size_t k : at) corners.push_back(primitive.indices >= 0 ? list.index(k) : (uint32_t)k);
	}
	for (size_t i = 0; primitive.indices >= 0 && i < list.count; i++)
		if (list.index(i) >= n_vertices)
			fail("%s: index %u at %zu; there are %zu vertices", where.c_str(), list.index(i), i, n_vertices);
	return corners;
}

piece piece_decode(loader &in, const tinygltf::Primitive &primitive, const std::string &where)
{
	piece out;
	attributes a = vertex_attributes(material_uv_sets(in, primitive.material), !in.model.skins.empty());
	int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
	out.material = TS_NONE;
	if (mode == TINYGLTF_MODE_POINTS) {
		out.surfels = points_decode(in, primitive, where);
		return out;
	}
	if (mode < TINYGLTF_MODE_TRIANGLES) {
		in.notes.insert("lines are not drawn");
		return out;
	}
	a.open(in, primitive, where);
	drop_lone_tangents(in, a);
	if (!a.has("POSITION")) {
		in.notes.insert("primitives without POSITION are not drawn");
		return out;
	}
	std::vector<uint32_t> corners = read_corners(in, primitive, mode, a.count, where);
	if (corners.empty()) return out;
	out.corners.reserve(corners.size());
	collect(in, out, a, corners);
	out.material = material_build(in, primitive.material);
	note_missing_uv(in, primitive, a);
	return out;
}

static void surfels_place(ts_build *build, const piece &piece, const ts_place &place)
{
	if (place.side == 0.0f && !piece.surfels.empty()) ts_build_note(build, "points that a node flattens are not drawn");
	for (size_t i = 0; i < piece.surfels.size() && !ts_build_failed(build); i++) {
		ts_surfel surfel;
		if (ts_place_surfel(&place, &piece.surfels[i], &surfel)) ts_build_surfel(build, &surfel);
	}
}

void piece_place(ts_build *build, const piece &piece, const spot &at)
{
	surfels_place(build, piece, at.world);
	u32 first = 0;
	for (size_t i = 0; i < piece.vertices.size() && !ts_build_failed(build); i++) {
		ts_vertex vertex = ts_place_vertex(&at.world, &piece.vertices[i]);
		ts_vertex own = at.moves ? ts_place_vertex(&at.own, &piece.vertices[i]) : vertex;
		u32 index = at.moves ? ts_build_vertex_moving(build, &vertex, &own) : ts_build_vertex(build, &vertex);
		if (i == 0) first = index;
	}
	for (size_t i = 0; i < piece.corners.size() && !ts_build_failed(build); i += 3) {
		u32 b = piece.corners[i + 1], c = piece.corners[i + 2];
		if (at.mirrored) std::swap(b, c);
		ts_build_triangle(build, first + piece.corners[i], first + b, first + c, piece.material);
	}
}

} // namespace gltf
