/* The attributes of a primitive, glTF 2.0 section 3.7.2.1, as floats of a record. */
#include "gltf.h"

namespace gltf {

void attributes::open(loader &in, const tinygltf::Primitive &primitive, const std::string &where)
{
	for (const auto &attribute : primitive.attributes) {
		const form *match = nullptr;
		for (size_t i = 0; i < n_forms; i++)
			if (attribute.first == forms[i].name) match = &forms[i];
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

void attributes::read(size_t i, f32 *field) const
{
	for (size_t f = 0; f < n_forms; f++) {
		auto found = views.find(forms[f].name);
		if (found == views.end()) continue;
		for (int k = 0; k < found->second.components; k++)
			field[forms[f].offset + (size_t)k] = found->second.number(i, k);
	}
}

} // namespace gltf
