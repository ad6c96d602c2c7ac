/* Loading a glTF 2.0 file into a build: container, guard, tinygltf, then materials, meshes and nodes. The one entry
 * from C: no exception passes it. */
#include "scene/gltf/gltf.h"
#include <algorithm>
#include <cstdarg>
#include <cstring>
#include <new>
#include "model/core.h"

namespace gltf {

static constexpr uint64_t most_file_bytes = 2147483647; /* tinygltf counts in int */
static constexpr size_t most_notes = 100;

static error error_of(ts_kind kind, const char *format, va_list arguments)
{
	char line[512];
	vsnprintf(line, sizeof line, format, arguments);
	return {line, kind};
}

void fail(const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	error made = error_of(TS_KIND_FORMAT, format, arguments);
	va_end(arguments);
	throw made;
}

void fail_as(ts_kind kind, const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	error made = error_of(kind, format, arguments);
	va_end(arguments);
	throw made;
}

std::string quoted(const std::string &name)
{
	std::string text = name.substr(0, 48);
	std::replace(text.begin(), text.end(), '\0', '?');
	return "\"" + text + (name.size() > 48 ? "...\"" : "\"");
}

/* What tinygltf may ask of the file system: the buffers that the guard named, and nothing else. Of images it knows
 * nothing: materials read those they use. */
struct files {
	loader &in;
	error problem;
};

static bool file_exists(const std::string &key, void *user)
{
	return static_cast<files *>(user)->in.doc.buffers.count(key) != 0;
}

static std::string file_expand(const std::string &key, void *) { return key; }

static bool file_fetch(bytes *out, std::string *, const std::string &key, void *user)
{
	files &from = *static_cast<files *>(user);
	loader &in = from.in;
	try {
		source &wanted = in.doc.buffers.at(key);
		in.held_bytes += wanted.byte_length;
		if (in.held_bytes > ts_memory_limit())
			fail_as(TS_KIND_MEMORY, "its buffers have more than %llu bytes together",
			        (unsigned long long)ts_memory_limit());
		if (!wanted.data.empty()) {
			wanted.data.resize(wanted.byte_length);
			*out = std::move(wanted.data);
			return true;
		}
		if (wanted.path.empty()) {
			const unsigned char *bin = in.file.data() + in.parts.bin_begin;
			out->assign(bin, bin + wanted.byte_length);
			return true;
		}
		*out = file_read_beside(in, wanted.path, {most_file_bytes, wanted.byte_length, nullptr});
		if (out->size() < wanted.byte_length)
			fail("file %s: %zu bytes; byteLength says %llu", quoted(wanted.path).c_str(), out->size(),
			     (unsigned long long)wanted.byte_length);
		return true;
	} catch (const error &e) {
		from.problem = e;
		return false;
	}
}

/* file_fetch gives as many bytes as the document says, or fails. */
static bool file_size(size_t *out, std::string *, const std::string &key, void *user)
{
	*out = static_cast<files *>(user)->in.doc.buffers.at(key).byte_length;
	return true;
}

static bool file_store(std::string *, const std::string &, const bytes &, void *) { return false; }

/* tinygltf 2.9 refuses callbacks unless all are set, and has one more than 2.7: the size of a file. */
template <typename callbacks, typename function>
static auto file_size_set(callbacks &calls, function *size) -> decltype(void(calls.GetFileSizeInBytes))
{
	calls.GetFileSizeInBytes = size;
}
template <typename callbacks> static void file_size_set(callbacks &, ...) {}

static tinygltf::FsCallbacks file_callbacks(files *from)
{
	tinygltf::FsCallbacks calls{};
	calls.FileExists = file_exists;
	calls.ExpandFilePath = file_expand;
	calls.ReadWholeFile = file_fetch;
	calls.WriteWholeFile = file_store;
	calls.user_data = from;
	file_size_set(calls, file_size);
	return calls;
}

static void parse(loader &in)
{
	tinygltf::TinyGLTF parser;
	std::string problem, warning;
	files from{in, {}};
	parser.SetFsCallbacks(file_callbacks(&from));
	if (in.doc.json.size() > most_file_bytes)
		fail("%zu bytes of JSON; at most 2147483647 are read", in.doc.json.size());
	bool good =
		parser.LoadASCIIFromString(&in.model, &problem, &warning, in.doc.json.data(), (unsigned)in.doc.json.size(), "");
	if (!from.problem.line.empty()) throw from.problem;
	/* tinygltf catches it, and passes its name on. */
	if (!good && problem.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
	if (!good) fail("%s", problem.substr(0, problem.find('\n')).c_str());
}

static bool ends_in_glb(const std::string &path)
{
	return path.size() >= 4 && strcasecmp(path.c_str() + path.size() - 4, ".glb") == 0;
}

static void write_notes(loader &in)
{
	size_t n = 0;
	in.notes.insert(in.doc.notes.begin(), in.doc.notes.end());
	for (const std::string &note : in.notes)
		if (n++ < most_notes) ts_build_note(in.build, "%s", note.c_str());
	if (n > most_notes) ts_build_note(in.build, "and %zu more of the kind", n - most_notes);
}

static void load(loader &in, const ts_scene_file &file)
{
	const unsigned char *first = (const unsigned char *)file.bytes;
	if (file.n_bytes > most_file_bytes) fail("%zu bytes; at most 2147483647 are read", file.n_bytes);
	in.file = in.in_memory ? bytes(first, first + file.n_bytes)
	                       : file_read(in.path, {most_file_bytes, most_file_bytes, container_is_worth});
	in.parts = container_split(in.file, ends_in_glb(in.path));
	in.doc = guard((const char *)in.file.data() + in.parts.json_begin, in.parts.json_bytes, in.parts);
	in.held_bytes = in.file.size();
	parse(in);
	in.texel_budget = texel_budget(in.held_bytes);
	in.materials.assign(in.model.materials.size(), TS_NONE);
	if (in.parts.trailing_bytes > 0) in.notes.insert("bytes after the end that the header gives are ignored");
	animation_open(in);
	nodes_walk(in);
	write_notes(in);
}

} // namespace gltf

void ts_gltf_load(ts_build *build, const ts_scene_file *file, const char *reflector, const char *animation,
                  u32 neighbours)
{
	const char *path = file->name;
	ts_build_about(build, TS_KIND_FORMAT);
	try {
		gltf::loader in{};
		in.build = build;
		in.path = path;
		in.in_memory = file->bytes != nullptr;
		in.reflector = reflector;
		in.animation = animation;
		in.neighbours = neighbours;
		gltf::load(in, *file);
	} catch (const gltf::error &e) {
		ts_build_about(build, e.kind);
		if (e.line.empty())
			ts_build_adopt(build);
		else
			ts_build_fail(build, "%s: %s", path, e.line.c_str());
	} catch (const std::bad_alloc &) {
		ts_build_about(build, TS_KIND_MEMORY);
		ts_build_fail(build, "%s: out of memory", path);
	} catch (const std::exception &e) {
		ts_build_fail(build, "%s: %s", path, e.what());
	} catch (...) {
		ts_build_fail(build, "%s: cannot be read", path);
	}
}
