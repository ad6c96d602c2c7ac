/* EXT_mesh_gpu_instancing: a node draws its mesh at several places, each in the node's own space. */
#include "scene/gltf/gltf.h"

namespace gltf {

static const struct {
	const char *name;
	int type;
	unsigned forms;
} parts[] = {
	{"TRANSLATION", TINYGLTF_TYPE_VEC3, AS_FLOAT},
	{"ROTATION", TINYGLTF_TYPE_VEC4, AS_FLOAT | AS_NORM},
	{"SCALE", TINYGLTF_TYPE_VEC3, AS_FLOAT},
};

static size_t part_of(const std::string &name)
{
	size_t k = 0;
	while (k < N_PATHS && name != parts[k].name) k++;
	return k;
}

/* The views of the parts that the file has. */
static std::array<view, N_PATHS> open_parts(loader &in, const tinygltf::Value &attributes, const std::string &where,
                                            size_t *count)
{
	std::array<view, N_PATHS> views{};
	*count = 0;
	for (const std::string &name : attributes.Keys()) {
		size_t k = part_of(name);
		if (k == N_PATHS) {
			in.notes.insert("the attribute " + quoted(name) + " of instances is ignored");
			continue;
		}
		views[k] =
			view_open(in, attributes.Get(name).GetNumberAsInt(), parts[k].type, parts[k].type, parts[k].forms, name);
		if (*count != 0 && views[k].count != *count)
			fail("%s: %s has %zu items, another attribute has %zu", where.c_str(), name.c_str(), views[k].count,
			     *count);
		*count = views[k].count;
	}
	return views;
}

static void read(f32 *to, const view &from, size_t item)
{
	for (int k = 0; k < from.components; k++) to[k] = from.number(item, k);
}

std::vector<ts_place> instances_open(loader &in, const tinygltf::Node &node, const std::string &where)
{
	size_t count;
	std::vector<ts_place> places;
	const tinygltf::Value &attributes = node.extensions.at("EXT_mesh_gpu_instancing").Get("attributes");
	auto views = open_parts(in, attributes, where + "/EXT_mesh_gpu_instancing", &count);
	for (size_t i = 0; i < count; i++) {
		trs local = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
		if (views[TRANSLATION].count != 0) read(local.translation, views[TRANSLATION], i);
		if (views[ROTATION].count != 0) read(local.rotation, views[ROTATION], i);
		if (views[SCALE].count != 0) read(local.scale, views[SCALE], i);
		places.push_back(place_of_trs(local, where));
	}
	return places;
}

} // namespace gltf
