/* The guard before tinygltf, which checks neither types nor references: the JSON is parsed strictly, held against the
 * table of rules.h, and written anew, so that tinygltf reads only what was checked. */
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include "model/core.h"
#include "model/input.h"
#include "model/json/read.h"
#include "output/json/text.h"
#include "scene/gltf/gltf.h"
#include "scene/gltf/rules.h"

namespace gltf {

struct checker {
	document doc;
	std::map<std::string, std::vector<const rule *>> children; /* by path of the parent */
	std::map<std::string, size_t> lengths;                     /* of the lists that indices name */
	void check_object(json_t *object, const std::string &path, const std::string &where);
	void check_value(json_t *parent, const char *key, json_t *value, const rule &r, const std::string &where);
	void take_unknown(const std::string &path, const char *key, const json_t *value);
	void check_spared(json_t *list, const rule &r, const std::string &where);
	void check_list(json_t *list, const rule &r, const std::string &where);
	void check_extras(json_t *parent, const char *key, json_t *value, const rule &r, const std::string &where);
	void check_extra_flag(json_t *parent, const char *key, const json_t *value, const std::string &where);
	double check_number(const json_t *value, const rule &r, const std::string &where);
	void check_numbers(json_t *list, const rule &r, const std::string &where);
	void check_indices(json_t *list, const rule &r, const std::string &where) const;
	void check_attributes(json_t *object, const rule &r, const std::string &where) const;
	json_int_t check_index(json_t *value, const rule &r, const std::string &where) const;
};

using owned = std::unique_ptr<json_t, void (*)(json_t *)>;

/* Stores a value that was just made. */
static void put(json_t *object, const char *key, json_t *value)
{
	if (json_object_set_new(object, key, value) != 0) throw std::bad_alloc();
}

static owned parse(const char *text, size_t n)
{
	size_t mark = ts_text_mark(text, n);
	owned root(ts_json_read(text + mark, n - mark, true, ""), json_decref);
	if (!root && ts_error_kind() == TS_KIND_MEMORY) throw std::bad_alloc();
	if (!root) fail("%s", ts_error_message());
	if (!json_is_object(root.get())) fail("the JSON is not an object");
	return root;
}

static std::string shown(const json_t *value)
{
	std::unique_ptr<char, void (*)(void *)> text(ts_json_text(value, JSON_ENCODE_ANY | JSON_COMPACT, "JSON"), free);
	if (!text) throw std::bad_alloc();
	std::string line = text.get();
	return line.size() > 40 ? line.substr(0, 37) + "..." : line;
}

[[noreturn]] static void refuse(const std::string &where, const json_t *value, const char *expected)
{
	fail("%s is %s; %s is expected", where.c_str(), shown(value).c_str(), expected);
}

static std::string range_text(const char *what, double low, double high)
{
	char text[96];
	if (high >= most_number)
		snprintf(text, sizeof text, low <= -most_number ? "%s" : "%s from %.10g", what, low);
	else
		snprintf(text, sizeof text, "%s from %.10g to %.10g", what, low, high);
	return text;
}

json_int_t checker::check_index(json_t *value, const rule &r, const std::string &where) const
{
	size_t n = lengths.at(r.of);
	if (n == 0) fail("%s is %s; the file has no %s", where.c_str(), shown(value).c_str(), r.of);
	json_int_t index;
	if (!ts_json_whole(&index, value, 0, (json_int_t)n - 1))
		refuse(where, value, range_text("a whole number", 0, (double)n - 1).c_str());
	return index;
}

/* A number that a rounding to binary32 put outside its range is the nearest inside, and noted; as is one beyond what
 * kernels hold (CONTRACT rule 10). */
double checker::check_number(const json_t *value, const rule &r, const std::string &where)
{
	double x = json_is_number(value) ? json_number_value(value) : HUGE_VAL,
		   inside = std::min(std::max(x, r.low), r.high);
	double rounding = 0x1p-22 * std::max(1.0, std::fabs(inside));
	if (!(std::fabs(x - inside) <= rounding)) refuse(where, value, range_text("a number", r.low, r.high).c_str());
	double held = std::min(std::max(inside, -(double)TS_MOST_INPUT), (double)TS_MOST_INPUT);
	if (x != held) {
		char text[40];
		snprintf(text, sizeof text, "%.10g", held);
		doc.notes.insert(where + " is " + shown(value) +
		                 (held != inside ? ", beyond all that is held" : ", a rounding outside its range") +
		                 ": it is read as " + text);
	}
	return held;
}

void checker::check_numbers(json_t *list, const rule &r, const std::string &where)
{
	if (!json_is_array(list) || json_array_size(list) != r.n)
		refuse(where, list, ("an array of " + std::to_string(r.n) + " numbers").c_str());
	for (size_t i = 0; i < r.n; i++) {
		double number = check_number(json_array_get(list, i), r, where + "/" + std::to_string(i));
		if (json_array_set_new(list, i, json_real(number)) != 0) throw std::bad_alloc();
	}
}

static void check_text(const json_t *value, const rule &r, const std::string &where)
{
	if (!json_is_string(value)) refuse(where, value, "a string");
	if (!r.of) return;
	std::string word(json_string_value(value), json_string_length(value));
	std::string all = std::string(" ") + r.of + " ";
	if (word.find(' ') != std::string::npos || all.find(" " + word + " ") == std::string::npos)
		refuse(where, value, (std::string("one of ") + r.of).c_str());
}

static void check_whole(json_t *parent, const char *key, json_t *value, const rule &r, const std::string &where)
{
	json_int_t n;
	if (!ts_json_whole(&n, value, (json_int_t)r.low, (json_int_t)r.high))
		refuse(where, value, range_text("a whole number", r.low, r.high).c_str());
	put(parent, key, json_integer(n));
}

void checker::check_list(json_t *list, const rule &r, const std::string &where)
{
	size_t i;
	json_t *item;
	if (!json_is_array(list) || (r.required && json_array_size(list) == 0))
		refuse(where, list, r.required ? "an array with something in it" : "an array");
	json_array_foreach (list, i, item) {
		std::string place = where + "/" + std::to_string(i);
		if (!json_is_object(item)) refuse(place, item, "an object");
		check_object(item, std::string(r.path) + "[]", place);
	}
}

void checker::check_spared(json_t *list, const rule &r, const std::string &where)
{
	size_t i;
	json_t *item;
	if (!json_is_array(list)) refuse(where, list, "an array");
	json_array_foreach (list, i, item) {
		std::string place = where + "/" + std::to_string(i);
		try {
			if (!json_is_object(item)) refuse(place, item, "an object");
			check_object(item, std::string(r.path) + "[]", place);
		} catch (const error &e) {
			doc.notes.insert(e.line + ": it is ignored");
			if (json_array_set_new(list, i, json_pack("{s:[]}", r.of)) != 0) throw std::bad_alloc();
		}
	}
}

void checker::check_indices(json_t *list, const rule &r, const std::string &where) const
{
	size_t i;
	json_t *item;
	if (!json_is_array(list)) refuse(where, list, "an array");
	json_array_foreach (list, i, item) {
		json_t *index = json_integer(check_index(item, r, where + "/" + std::to_string(i)));
		if (json_array_set_new(list, i, index) != 0) throw std::bad_alloc();
	}
}

void checker::check_attributes(json_t *object, const rule &r, const std::string &where) const
{
	const char *name;
	json_t *item;
	void *next;
	if (!json_is_object(object) || json_object_size(object) == 0) refuse(where, object, "an object with attributes");
	json_object_foreach_safe(object, next, name, item)
	{
		put(object, name, json_integer(check_index(item, r, where + "/" + name)));
	}
}

void checker::check_extras(json_t *parent, const char *key, json_t *value, const rule &r, const std::string &where)
{
	if (json_is_object(value))
		check_object(value, r.path, where);
	else
		json_object_del(parent, key);
}

void checker::check_extra_flag(json_t *parent, const char *key, const json_t *value, const std::string &where)
{
	if (json_is_boolean(value)) return;
	doc.notes.insert(where + " is " + shown(value) + ", neither true nor false: it is ignored");
	json_object_del(parent, key);
}

/* Holds a value against its rule. A number that may be written in several ways is stored in one. */
void checker::check_value(json_t *parent, const char *key, json_t *value, const rule &r, const std::string &where)
{
	switch (r.type) {
	case EXTRAS: check_extras(parent, key, value, r, where); break;
	case OBJECT:
		if (!json_is_object(value)) refuse(where, value, "an object");
		check_object(value, r.of ? r.of : r.path, where);
		break;
	case LIST: check_list(value, r, where); break;
	case SPARED: check_spared(value, r, where); break;
	case TEXT: check_text(value, r, where); break;
	case FLAG:
		if (!json_is_boolean(value)) refuse(where, value, "true or false");
		break;
	case WHOLE: check_whole(parent, key, value, r, where); break;
	case EXTRA_FLAG: check_extra_flag(parent, key, value, where); break;
	case NUMBER: put(parent, key, json_real(check_number(value, r, where))); break;
	case NUMBERS: check_numbers(value, r, where); break;
	case INDEX: put(parent, key, json_integer(check_index(value, r, where))); break;
	case INDICES: check_indices(value, r, where); break;
	case ATTRIBUTES: check_attributes(value, r, where); break;
	case NOTED:
		if (!json_is_array(value) || json_array_size(value) > 0) doc.notes.insert(r.of);
		json_object_del(parent, key);
		break;
	}
}

void fail_compressed(const std::string &where, const std::string &extension)
{
	fail("%s is compressed by %s, which is not read; write it without, for example by gltf-transform copy",
	     where.c_str(), extension.c_str());
}

static void take_extension(document &doc, const std::string &name, bool is_required)
{
	for (const extension &known : known_extensions) {
		if (name != known.name) continue;
		if (known.note) doc.notes.insert(known.note);
		if (name == "KHR_mesh_quantization") doc.is_quantized = true;
		if (known.compresses) doc.compression = name;
		if (known.compresses && is_required) fail_compressed("the file", name);
		return;
	}
	if (is_required) fail("the file requires the extension %s, which is not supported", quoted(name).c_str());
	doc.notes.insert("the extension " + quoted(name) + " is not supported and ignored");
}

/* Of an extension whose properties are not known, or of all in an object of them: the file need not list what it
 * uses. */
void checker::take_unknown(const std::string &path, const char *key, const json_t *value)
{
	static const std::string end = "extensions";
	bool inside = path.size() >= end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
	if (inside) take_extension(doc, key, false);
	if (end != key || !json_is_object(value)) return;
	const char *name;
	const json_t *item;
	json_object_foreach (const_cast<json_t *>(value), name, item) take_extension(doc, name, false);
}

void checker::check_object(json_t *object, const std::string &path, const std::string &where)
{
	static const std::vector<const rule *> none;
	auto found = children.find(path);
	const std::vector<const rule *> &known = found == children.end() ? none : found->second;
	size_t prefix = path.empty() ? 0 : path.size() + 1;
	std::string start = where.empty() ? where : where + "/";
	const char *key;
	json_t *value;
	void *next;
	json_object_foreach_safe(object, next, key, value)
	{
		const rule *match = nullptr;
		for (const rule *r : known)
			if (strcmp(r->path + prefix, key) == 0) match = r;
		if (match) {
			check_value(object, key, value, *match, start + key);
		} else {
			take_unknown(path, key, value);
			json_object_del(object, key);
		}
	}
	for (const rule *r : known)
		if (r->required && !json_object_get(object, r->path + prefix))
			fail("%s%s is missing", start.c_str(), r->path + prefix);
}

static std::string text_of(const json_t *value)
{
	return value ? std::string(json_string_value(value), json_string_length(value)) : std::string();
}

/* Extensions: what the file requires must be known, what it uses and is unknown is noted. */
static void check_extensions(checker &check, const json_t *root)
{
	for (const char *list : {"extensionsRequired", "extensionsUsed"}) {
		const json_t *names = json_object_get(root, list), *name;
		size_t i;
		if (!names) continue;
		if (!json_is_array(names)) refuse(list, names, "an array of strings");
		json_array_foreach (names, i, name) {
			if (!json_is_string(name)) refuse(std::string(list) + "/" + std::to_string(i), name, "a string");
			take_extension(check.doc, text_of(name), list[10] == 'R');
		}
	}
}

static size_t list_length(const json_t *parent, const char *key)
{
	const json_t *list = parent ? json_object_get(parent, key) : nullptr;
	if (list && !json_is_array(list)) refuse(key, list, "an array");
	return list ? json_array_size(list) : 0;
}

static const json_t *punctual_of(const json_t *root)
{
	const json_t *extensions = json_object_get(root, "extensions");
	return extensions ? json_object_get(extensions, "KHR_lights_punctual") : nullptr;
}

static void measure_lists(checker &check, const json_t *root)
{
	for (const char *name : {"scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers", "images", "samplers",
	                         "textures", "materials", "cameras", "skins"})
		check.lengths[name] = list_length(root, name);
	check.lengths["lights"] = list_length(punctual_of(root), "lights");
}

static void check_version(const json_t *root)
{
	const json_t *asset = json_object_get(root, "asset");
	std::string version = json_string_value(json_object_get(asset, "version"));
	const char *least = json_string_value(json_object_get(asset, "minVersion"));
	if (version.compare(0, 2, "2.") != 0) fail("asset/version is %s; 2.0 is expected", quoted(version).c_str());
	if (least && strcmp(least, "2.0") != 0) fail("asset/minVersion is %s; 2.0 is supported", quoted(least).c_str());
}

static uint64_t whole(const json_t *object, const char *key)
{
	const json_t *value = json_object_get(object, key);
	return value ? (uint64_t)json_integer_value(value) : 0;
}

static void check_transforms(const json_t *root)
{
	const json_t *node;
	size_t i;
	json_array_foreach (json_object_get(root, "nodes"), i, node) {
		for (const char *part : {"translation", "rotation", "scale"})
			if (json_object_get(node, part) && json_object_get(node, "matrix"))
				fail("nodes/%zu has both matrix and %s; one of them is expected", i, part);
	}
}

/* What a type needs stands beside it. */
static void check_types(const json_t *list, const char *of, const char *const types[2])
{
	const json_t *item;
	size_t i;
	json_array_foreach (list, i, item) {
		const std::string type = text_of(json_object_get(item, "type"));
		for (size_t k = 0; k < 2 && types[k]; k++)
			if (type == types[k] && !json_object_get(item, types[k]))
				fail("%s/%zu is of type %s and has no %s", of, i, types[k], types[k]);
	}
}

/* `lengths` are the buffers' own words for their lengths. */
static void check_views(const json_t *root, const std::vector<uint64_t> &lengths)
{
	const json_t *view;
	size_t i;
	json_array_foreach (json_object_get(root, "bufferViews"), i, view) {
		if (whole(view, "byteStride") % 4 != 0)
			fail("bufferViews/%zu: byteStride %llu; a multiple of 4 is expected", i,
			     (unsigned long long)whole(view, "byteStride"));
		uint64_t id = whole(view, "buffer"), end = whole(view, "byteOffset") + whole(view, "byteLength");
		if (end > lengths.at(id))
			fail("bufferViews/%zu ends at byte %llu; buffer %llu has %llu", i, (unsigned long long)end,
			     (unsigned long long)id, (unsigned long long)lengths.at(id));
	}
}

/* The bytes of a buffer's data URI. */
static bytes take_data(const std::string &uri, uint64_t length, const std::string &where)
{
	data_uri held = data_uri_decode(uri, where);
	if (held.type != "application/octet-stream" && held.type != "application/gltf-buffer")
		fail("%s: media type %s; application/octet-stream or application/gltf-buffer is expected", where.c_str(),
		     quoted(held.type).c_str());
	if (held.data.size() < length)
		fail("%s holds %zu bytes; byteLength says %llu", where.c_str(), held.data.size(), (unsigned long long)length);
	return std::move(held.data);
}

/* A buffer that holds more than it says is as long as it says. */
static void take_buffer(checker &check, json_t *buffer, size_t i, const container &parts)
{
	std::string where = "buffers/" + std::to_string(i) + "/uri", key = "buffer-" + std::to_string(i);
	std::string uri = text_of(json_object_get(buffer, "uri"));
	source &from = check.doc.buffers[key];
	from.byte_length = whole(buffer, "byteLength");
	if (!json_object_get(buffer, "uri")) {
		if ((i != 0 || !parts.has_bin) && !check.doc.compression.empty())
			fail_compressed("buffers/" + std::to_string(i), check.doc.compression);
		if (i != 0 || !parts.has_bin) fail("%s is missing and there is no BIN chunk for this buffer", where.c_str());
		if (from.byte_length > parts.bin_bytes)
			fail("buffers/0/byteLength is %llu; the BIN chunk has %zu bytes", (unsigned long long)from.byte_length,
			     parts.bin_bytes);
	} else if (is_data_uri(uri)) {
		from.data = take_data(uri, from.byte_length, where);
	} else {
		from.path = path_from_uri(uri, where);
	}
	put(buffer, "uri", json_string(key.c_str()));
}

static picture take_image(const json_t *image, size_t i)
{
	std::string where = "images/" + std::to_string(i);
	const json_t *view = json_object_get(image, "bufferView"), *text = json_object_get(image, "uri");
	picture taken = {{}, view ? (int)json_integer_value(view) : -1, text_of(json_object_get(image, "mimeType"))};
	if (!text == !view) fail("%s must have either uri or bufferView", where.c_str());
	if (view) return taken;
	std::string uri = text_of(text);
	where += "/uri";
	if (!is_data_uri(uri)) {
		taken.from.path = path_from_uri(uri, where);
		return taken;
	}
	data_uri held = data_uri_decode(uri, where);
	if (held.type.compare(0, 6, "image/") != 0)
		fail("%s: media type %s; image/png or image/jpeg is expected", where.c_str(), quoted(held.type).c_str());
	taken.from.data = std::move(held.data);
	taken.type = held.type;
	return taken;
}

/* What stands at an accessor's path, or null. */
static const json_t *view_of(const json_t *root, const json_t *index)
{
	const json_t *views = json_object_get(root, "bufferViews");
	return index ? json_array_get(views, (size_t)json_integer_value(index)) : nullptr;
}

/* Strides that the specification does not allow, and which are read or passed over. */
static void note_strides(document &doc, const json_t *root)
{
	const json_t *accessors = json_object_get(root, "accessors"), *item, *sampler;
	size_t i, k;
	json_array_foreach (accessors, i, item) {
		const json_t *sparse = json_object_get(item, "sparse");
		for (const char *part : {"indices", "values"}) {
			const json_t *view = view_of(root, json_object_get(json_object_get(sparse, part), "bufferView"));
			if (json_object_get(view, "byteStride"))
				doc.notes.insert("accessors/" + std::to_string(i) + "/sparse/" + part +
				                 ": the byteStride of its buffer view is ignored");
		}
	}
	json_array_foreach (json_object_get(root, "animations"), i, item)
		json_array_foreach (json_object_get(item, "samplers"), k, sampler)
			for (const char *part : {"input", "output"}) {
				const json_t *accessor = json_array_get(accessors, (size_t)whole(sampler, part));
				if (json_object_get(view_of(root, json_object_get(accessor, "bufferView")), "byteStride"))
					doc.notes.insert("animations/" + std::to_string(i) +
					                 ": keyframes are read by the byteStride of their buffer view");
			}
}

static void note_endless_lights(document &doc, const json_t *root)
{
	const json_t *light;
	size_t i;
	json_array_foreach (json_object_get(punctual_of(root), "lights"), i, light)
		if (json_object_get(light, "range") && json_number_value(json_object_get(light, "range")) == 0)
			doc.notes.insert("lights/" + std::to_string(i) + " has range 0: it is read as without an end");
}

static recorded take_animation(const json_t *animation)
{
	recorded taken;
	size_t i;
	const json_t *item;
	taken.name = text_of(json_object_get(animation, "name"));
	json_array_foreach (json_object_get(animation, "channels"), i, item) {
		const json_t *target = json_object_get(item, "target"), *node = json_object_get(target, "node");
		taken.channels.push_back({(size_t)whole(item, "sampler"), node ? (int)json_integer_value(node) : -1,
		                          text_of(json_object_get(target, "path"))});
	}
	json_array_foreach (json_object_get(animation, "samplers"), i, item) {
		std::string mode = text_of(json_object_get(item, "interpolation"));
		taken.samplers.push_back(
			{(int)whole(item, "input"), (int)whole(item, "output"), mode.empty() ? "LINEAR" : mode});
	}
	return taken;
}

/* tinygltf refuses indices without a buffer view, which are zeros as all without one: they get the first. */
static void back_accessors(checker &check, json_t *root)
{
	size_t i;
	json_t *accessor;
	json_array_foreach (json_object_get(root, "accessors"), i, accessor) {
		check.doc.unbacked.push_back(!json_object_get(accessor, "bufferView"));
		if (check.doc.unbacked.back()) put(accessor, "bufferView", json_integer(0));
	}
	if (json_array_size(json_object_get(root, "bufferViews")) == 0)
		put(root, "bufferViews", json_pack("[{s:i,s:i}]", "buffer", 0, "byteLength", 1));
}

document guard(const char *text, size_t n, const container &parts)
{
	checker check;
	owned root = parse(text, n);
	for (const rule &r : rules) {
		const char *dot = strrchr(r.path, '.');
		check.children[dot ? std::string(r.path, dot) : std::string()].push_back(&r);
	}
	check_extensions(check, root.get());
	measure_lists(check, root.get());
	check.check_object(root.get(), "", "");
	check_version(root.get());
	check_transforms(root.get());
	static const char *const cameras[2] = {"perspective", "orthographic"}, *const lights[2] = {"spot", nullptr};
	check_types(json_object_get(root.get(), "cameras"), "cameras", cameras);
	check_types(json_object_get(punctual_of(root.get()), "lights"), "lights", lights);
	note_strides(check.doc, root.get());
	note_endless_lights(check.doc, root.get());
	size_t i;
	json_t *item;
	std::vector<uint64_t> lengths;
	json_array_foreach (json_object_get(root.get(), "buffers"), i, item) {
		lengths.push_back(whole(item, "byteLength"));
		take_buffer(check, item, i, parts);
	}
	json_array_foreach (json_object_get(root.get(), "images"), i, item) check.doc.images.push_back(take_image(item, i));
	json_array_foreach (json_object_get(root.get(), "animations"), i, item)
		check.doc.animations.push_back(take_animation(item));
	json_object_del(root.get(), "images");
	json_object_del(root.get(), "animations");
	check_views(root.get(), lengths);
	back_accessors(check, root.get());
	std::unique_ptr<char, void (*)(void *)> json(
		ts_json_text(root.get(), JSON_COMPACT | JSON_REAL_PRECISION(17), "JSON"), free);
	if (!json) throw std::bad_alloc();
	check.doc.json = json.get();
	return std::move(check.doc);
}

} // namespace gltf
