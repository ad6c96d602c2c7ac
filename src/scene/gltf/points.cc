/* Points, glTF 2.0 section 3.7.2.1, as surfels. Beside the usual attributes they may have _SPLAT_U and _SPLAT_V, the
 * half-axes of an ellipse; without those they are circles in the plane of NORMAL, as wide as their neighbours are
 * far. */
#include <algorithm>
#include "model/core.h"
#include "scene/gltf/gltf.h"
#include "scene/neighbours.h"
#include "scene/normals.h"

namespace gltf {

struct splat {
	f32 position[3], normal[3], colour[4], u[3], v[3];
};
static const form splat_forms[] = {
	{"POSITION", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT | AS_SMALL, AT(splat, position), false},
	{"NORMAL", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT | AS_SNORM, AT(splat, normal), false},
	{"COLOR_0", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4, AS_FLOAT | AS_UNORM, AT(splat, colour), false},
	{"_SPLAT_U", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT, AT(splat, u), false},
	{"_SPLAT_V", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT, AT(splat, v), false},
};

struct cloud {
	std::vector<ts_surfel> surfels;
	std::vector<ts_v3> normals;   /* none, where the axes say it */
	std::vector<bool> both_sides; /* of each point, or of none */
	std::vector<uint32_t> items;  /* of the accessors, of each point */
	size_t n_left = 0;            /* points that are left out */
	std::string left;             /* the first of them, and why */
};

/* What points are multiplied by: the material's base colour without its texture. */
static ts_v3 factor_of(loader &in, const tinygltf::Primitive &primitive)
{
	if (primitive.material < 0) return ts_v3_make(1.0f, 1.0f, 1.0f);
	const tinygltf::Material &m = in.model.materials.at((size_t)primitive.material);
	const std::vector<double> &c = m.pbrMetallicRoughness.baseColorFactor, &emits = m.emissiveFactor;
	bool is_more = m.pbrMetallicRoughness.baseColorTexture.index >= 0 || m.emissiveTexture.index >= 0 ||
	               m.normalTexture.index >= 0 || m.alphaMode != "OPAQUE" ||
	               emits.at(0) + emits.at(1) + emits.at(2) > 0 || m.extensions.count("KHR_materials_unlit") != 0;
	if (is_more) in.notes.insert("of materials of points only the base colour's factor is read");
	return ts_v3_make(ts_number(c.at(0)), ts_number(c.at(1)), ts_number(c.at(2)));
}

/* The items that the points are, in order. */
static std::vector<uint32_t> read_items(loader &in, const tinygltf::Primitive &primitive, size_t n_items,
                                        const std::string &where)
{
	view list{};
	if (primitive.indices >= 0)
		list = view_open(in, primitive.indices, TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_SCALAR, AS_INDEX, "indices");
	size_t n = primitive.indices >= 0 ? list.count : n_items;
	if (n * (sizeof(ts_surfel) + sizeof(ts_v3)) > ts_memory_total() / 3)
		fail("%s: %zu points take more than a third of this machine's memory", where.c_str(), n);
	std::vector<uint32_t> items(n);
	for (size_t i = 0; i < n; i++) {
		items[i] = primitive.indices >= 0 ? list.index(i) : (uint32_t)i;
		if (items[i] >= n_items)
			fail("%s: index %u at %zu; there are %zu vertices", where.c_str(), items[i], i, n_items);
	}
	return items;
}

static splat read_splat(const attributes &a, size_t i)
{
	f32 field[sizeof(splat) / sizeof(f32)] = {0.0f};
	for (size_t k = 0; k < 4; k++) field[AT(splat, colour) + k] = 1.0f;
	a.read(i, field);
	splat s;
	static_assert(sizeof s == sizeof field, "a splat consists of floats");
	memcpy(&s, field, sizeof s);
	return s;
}

/* Section 3.7.2.1: clamped before the factor. */
static ts_v3 colour_of(loader &in, const f32 *colour)
{
	ts_v3 c = ts_load3(colour), none = {0.0f, 0.0f, 0.0f}, all = {1.0f, 1.0f, 1.0f};
	ts_v3 inside = ts_min3(ts_max3(c, none), all);
	if (inside.x != c.x || inside.y != c.y || inside.z != c.z)
		in.notes.insert("colours of points outside 0 to 1 are read as the nearest inside");
	return inside;
}

static void read_point(loader &in, cloud &c, const attributes &a, uint32_t item, ts_v3 factor)
{
	splat s = read_splat(a, item);
	ts_surfel surfel = {};
	memcpy(surfel.centre, s.position, sizeof s.position);
	memcpy(surfel.u, s.u, sizeof s.u);
	memcpy(surfel.v, s.v, sizeof s.v);
	ts_store3(surfel.colour, ts_mul(colour_of(in, s.colour), factor));
	c.surfels.push_back(surfel);
	c.items.push_back(item);
	if (a.has("NORMAL")) c.normals.push_back(ts_load3(s.normal));
}

/* A point that is none does not keep the others from being drawn. */
static void leave_out(cloud &c, size_t point, const std::string &fault)
{
	if (c.n_left++ == 0) c.left = "point " + std::to_string(point) + ": " + fault;
}

static void make_ellipses(cloud &c)
{
	size_t n = 0;
	for (size_t i = 0; i < c.surfels.size(); i++) {
		f32 normal[3] = {0.0f, 0.0f, 0.0f};
		if (!c.normals.empty()) ts_store3(normal, c.normals[i]);
		c.surfels[n] = c.surfels[i];
		const char *fault = ts_surfel_ellipse(&c.surfels[n], c.normals.empty() ? nullptr : normal);
		if (fault)
			leave_out(c, c.items[i], fault);
		else
			n++;
	}
	c.surfels.resize(n);
}

static std::vector<ts_v3> centres_of(const cloud &c)
{
	std::vector<ts_v3> centres;
	for (const ts_surfel &s : c.surfels) centres.push_back(ts_load3(s.centre));
	return centres;
}

/* As of .ply files. Points on a line with their neighbours are left out. */
static void estimate_normals(loader &in, cloud &c)
{
	std::vector<ts_v3> centres = centres_of(c), normals(centres.size());
	std::vector<u8> guessed(centres.size());
	if (centres.size() > TS_NORMALS_MOST)
		fail("%zu points without normals; at most %u can be estimated", centres.size(), TS_NORMALS_MOST);
	if (ts_normals_estimate(normals.data(), guessed.data(), centres.data(), (u32)centres.size()) != TS_OK)
		throw error{"", TS_KIND_NONE};
	in.notes.insert("points have no normals: they are estimated by the points around each");
	size_t n = 0;
	for (size_t i = 0; i < normals.size(); i++) {
		if (ts_length(normals[i]) == 0.0f) continue;
		c.items[n] = c.items[i];
		c.surfels[n++] = c.surfels[i];
		c.normals.push_back(normals[i]);
		c.both_sides.push_back(guessed[i] != 0);
	}
	if (std::find(c.both_sides.begin(), c.both_sides.end(), true) != c.both_sides.end())
		in.notes.insert("points of sheets, whose front is not known, are seen from both sides");
	if (n < normals.size()) in.notes.insert("points that are on a line with their neighbours are not drawn");
	c.surfels.resize(n);
}

/* Points whose neighbours are all in the same place have no size and are left out. */
static void make_circles(loader &in, cloud &c)
{
	std::vector<ts_v3> centres = centres_of(c);
	std::vector<ts_surfel> made;
	std::vector<f32> radii(centres.size());
	bool has_same = false;
	if (ts_neighbours_distance(radii.data(), centres.data(), (u32)centres.size(), in.neighbours) != TS_OK)
		throw error{"", TS_KIND_NONE};
	for (size_t i = 0; i < radii.size(); i++) {
		f32 normal[3];
		ts_store3(normal, c.normals[i]);
		has_same |= radii[i] == 0.0f;
		if (radii[i] == 0.0f) continue;
		made.push_back(c.surfels[i]);
		const char *fault = ts_surfel_circle(&made.back(), normal, radii[i]);
		if (fault) {
			leave_out(c, c.items[i], fault);
			made.pop_back();
		} else if (!c.both_sides.empty() && c.both_sides[i]) {
			made.push_back(made.back());
			ts_surfel_turn(&made.back());
		}
	}
	if (has_same) in.notes.insert("points whose neighbours are all in the same place are not drawn: they have no size");
	c.surfels = std::move(made);
}

std::vector<ts_surfel> points_decode(loader &in, const tinygltf::Primitive &primitive, const std::string &where)
{
	attributes a(splat_forms);
	a.open(in, primitive, where);
	bool has_axes = a.has("_SPLAT_U");
	if (has_axes != a.has("_SPLAT_V")) fail("%s: _SPLAT_U and _SPLAT_V go together", where.c_str());
	if (!a.has("POSITION")) {
		in.notes.insert("primitives without POSITION are not drawn");
		return {};
	}
	cloud c;
	ts_v3 factor = factor_of(in, primitive);
	std::vector<uint32_t> items = read_items(in, primitive, a.count, where);
	for (uint32_t item : items) {
		go_on(in);
		try {
			read_point(in, c, a, item, factor);
		} catch (const error &e) {
			if (e.kind != TS_KIND_FORMAT) throw;
			leave_out(c, item, e.line);
		}
	}
	auto is_none = [](ts_v3 n) { return n.x == 0.0f && n.y == 0.0f && n.z == 0.0f; };
	if (std::all_of(c.normals.begin(), c.normals.end(), is_none)) c.normals.clear(); /* as writers without any have */
	if (!has_axes && c.normals.empty()) estimate_normals(in, c);
	if (has_axes)
		make_ellipses(c);
	else
		make_circles(in, c);
	if (c.n_left > 0 && c.n_left == items.size()) fail("%s: no point can be drawn; %s", where.c_str(), c.left.c_str());
	if (c.n_left > 0)
		in.notes.insert(where + ": " + std::to_string(c.n_left) + " points are left out, the first: " + c.left);
	return std::move(c.surfels);
}

} // namespace gltf
