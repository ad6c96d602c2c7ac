/* The attributes of a primitive, glTF 2.0 section 3.7.2.1, as floats of a record. */
#include "scene/gltf/gltf.h"

namespace gltf {

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
		view v = view_open(in, attribute.second, match->type, match->other_type, match->forms, attribute.first);
		if (count != 0 && v.count != count)
			fail("%s: %s has %zu items, another attribute has %zu", where.c_str(), match->name.c_str(), v.count, count);
		count = v.count;
		views.emplace(attribute.first, std::move(v));
	}
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
