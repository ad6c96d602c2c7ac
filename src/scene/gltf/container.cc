/* The GLB container, glTF 2.0 section 4.4: a 12-byte header, then a JSON chunk, an optional BIN chunk and chunks of
 * other kinds, which are skipped. */
#include <cstring>
#include "scene/gltf/gltf.h"

namespace gltf {

static constexpr uint32_t magic = 0x46546c67, json_kind = 0x4e4f534a, bin_kind = 0x004e4942;

static uint32_t word(const bytes &file, size_t at)
{
	return (uint32_t)file[at] | (uint32_t)file[at + 1] << 8 | (uint32_t)file[at + 2] << 16 |
	       (uint32_t)file[at + 3] << 24;
}

static void take_chunk(container &parts, uint32_t kind, size_t begin, size_t n, unsigned place)
{
	if ((place == 0) != (kind == json_kind))
		fail("chunk %u: kind %08x; the first chunk, and no other, must be JSON", place, kind);
	if (kind == json_kind) {
		parts.json_begin = begin;
		parts.json_bytes = n;
	}
	if (kind != bin_kind) return;
	if (place != 1) fail("chunk %u: the BIN chunk must be the second and only one", place);
	parts.has_bin = true;
	parts.bin_begin = begin;
	parts.bin_bytes = n;
}

bool container_is_worth(const bytes &head)
{
	if (head.size() >= 8 && word(head, 0) == magic) return word(head, 4) == 2;
	for (unsigned char c : head)
		if (c != ' ' && c != '\t' && c != '\r' && c != '\n') return c == '{';
	return true;
}

container container_split(const bytes &file, bool expect_glb)
{
	container parts;
	bool is_glb = file.size() >= 4 && word(file, 0) == magic;
	if (file.empty()) fail("the file is empty; glTF 2.0 is expected");
	if (!is_glb && expect_glb) fail("the file does not begin with \"glTF\"; a binary glTF 2.0 file is expected");
	if (!is_glb) {
		parts.json_bytes = file.size();
		return parts;
	}
	if (file.size() < 12) fail("the header is cut after %zu of 12 bytes", file.size());
	if (word(file, 4) != 2) fail("container version %u; 2 is expected", word(file, 4));
	size_t length = word(file, 8);
	if (length > file.size()) fail("the header says %zu bytes; the file has %zu", length, file.size());
	if (length < 20) fail("the header says %zu bytes; a JSON chunk needs at least 20", length);
	parts.trailing_bytes = file.size() - length;
	size_t at = 12;
	for (unsigned place = 0; at < length; place++) {
		if (length - at < 8) fail("chunk %u: its header is cut after %zu of 8 bytes", place, length - at);
		size_t n = word(file, at);
		if (n > length - at - 8) fail("chunk %u: says %zu bytes; %zu are left", place, n, length - at - 8);
		if (n % 4 != 0) fail("chunk %u: %zu bytes; a multiple of 4 is expected", place, n);
		take_chunk(parts, word(file, at + 4), at + 8, n, place);
		at += 8 + n;
	}
	return parts;
}

} // namespace gltf
