/* Points, glTF 2.0 section 3.7.2.1, as surfels. Beside the usual attributes they may have _SPLAT_U and _SPLAT_V, the
 * half-axes of an ellipse; without those they are circles in the plane of NORMAL, as wide as their neighbours are
 * far. */
#include "model/core.h"
#include "scene/gltf/gltf.h"
#include "scene/neighbours.h"
#include "scene/normals.h"

namespace gltf {

struct splat {
	f32 position[3], normal[3], colour[4], u[3], v[3];
};
static const form splat_forms[] = {
	{"POSITION", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT | AS_SMALL, AT(splat, position)},
	{"NORMAL", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT | AS_SNORM, AT(splat, normal)},
	{"COLOR_0", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4, AS_FLOAT | AS_UNORM, AT(splat, colour)},
	{"_SPLAT_U", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT, AT(splat, u)},
	{"_SPLAT_V", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC3, AS_FLOAT, AT(splat, v)},
};

struct cloud {
	std::vector<ts_surfel> surfels;
	std::vector<ts_v3> normals; /* none, where the axes say it */
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

static cloud read_cloud(loader &in, const attributes &a, const std::vector<uint32_t> &items, ts_v3 factor)
{
	cloud c;
	c.surfels.resize(items.size());
	if (a.has("NORMAL")) c.normals.resize(items.size());
	for (size_t i = 0; i < items.size(); i++) {
		splat s = read_splat(a, items[i]);
		memcpy(c.surfels[i].centre, s.position, sizeof s.position);
		memcpy(c.surfels[i].u, s.u, sizeof s.u);
		memcpy(c.surfels[i].v, s.v, sizeof s.v);
		ts_store3(c.surfels[i].colour, ts_mul(colour_of(in, s.colour), factor));
		if (a.has("NORMAL")) c.normals[i] = ts_load3(s.normal);
	}
	return c;
}

static void check(const char *fault, const std::string &where, size_t point)
{
	if (fault) fail("%s: point %zu: %s", where.c_str(), point, fault);
}

static void make_ellipses(cloud &c, const std::string &where)
{
	for (size_t i = 0; i < c.surfels.size(); i++) {
		f32 normal[3] = {0.0f, 0.0f, 0.0f};
		if (!c.normals.empty()) ts_store3(normal, c.normals[i]);
		check(ts_surfel_ellipse(&c.surfels[i], c.normals.empty() ? nullptr : normal), where, i);
	}
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
	if (centres.size() > TS_NORMALS_MOST)
		fail("%zu points without normals; at most %u can be estimated", centres.size(), TS_NORMALS_MOST);
	if (ts_normals_estimate(normals.data(), centres.data(), (u32)centres.size()) != TS_OK)
		throw error{"", TS_KIND_NONE};
	in.notes.insert("points have no normals: they are estimated by the points around each");
	size_t n = 0;
	for (size_t i = 0; i < normals.size(); i++) {
		if (ts_length(normals[i]) == 0.0f) continue;
		c.surfels[n++] = c.surfels[i];
		c.normals.push_back(normals[i]);
	}
	if (n < normals.size()) in.notes.insert("points that are on a line with their neighbours are not drawn");
	c.surfels.resize(n);
}

/* Points whose neighbours are all in the same place have no size and are left out. */
static void make_circles(loader &in, cloud &c, const std::string &where)
{
	std::vector<ts_v3> centres = centres_of(c);
	std::vector<f32> radii(centres.size());
	if (ts_neighbours_distance(radii.data(), centres.data(), (u32)centres.size(), in.neighbours) != TS_OK)
		throw error{"", TS_KIND_NONE};
	size_t n = 0;
	for (size_t i = 0; i < radii.size(); i++) {
		f32 normal[3];
		ts_store3(normal, c.normals[i]);
		if (radii[i] == 0.0f) continue;
		c.surfels[n] = c.surfels[i];
		check(ts_surfel_circle(&c.surfels[n++], normal, radii[i]), where, i);
	}
	if (n < radii.size())
		in.notes.insert("points whose neighbours are all in the same place are not drawn: they have no size");
	c.surfels.resize(n);
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
	cloud c = read_cloud(in, a, read_items(in, primitive, a.count, where), factor_of(in, primitive));
	if (!has_axes && !a.has("NORMAL")) estimate_normals(in, c);
	if (has_axes)
		make_ellipses(c, where);
	else
		make_circles(in, c, where);
	return std::move(c.surfels);
}

} // namespace gltf
