/* Files and URIs of a glTF asset, and the GLB container, glTF 2.0 section 4.4: a 12-byte header, then a JSON chunk, an
 * optional BIN chunk and chunks of other kinds, which are skipped. Files are untrusted: nothing outside the asset's own
 * folder is opened, and neither devices nor pipes are read. */
#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>
#include "model/core.h"
#include "model/input.h"
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
	for (size_t i = ts_text_mark((const char *)head.data(), head.size()); i < head.size(); i++)
		if (!memchr(" \t\r\n", head[i], 4)) return head[i] == '{';
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

static constexpr uint64_t head_bytes = 4096;
static constexpr size_t most_at_once = 1 << 24;

struct descriptor {
	int fd;
	~descriptor()
	{
		if (fd >= 0) close(fd);
	}
};

/* Appends the next n bytes of a file. */
static void read_more(bytes &data, const descriptor &file, size_t n, const std::string &shown)
{
	size_t done = data.size();
	data.resize(done + n);
	while (done < data.size()) {
		if (ts_stopped(ts_stop_here()) && ts_go_on() != TS_OK) throw error{"", TS_KIND_NONE};
		ssize_t got = read(file.fd, data.data() + done, std::min(data.size() - done, most_at_once));
		if (got < 0 && errno == EINTR) continue;
		if (got < 0) fail_as(TS_KIND_FILE, "%s: %s", shown.c_str(), strerror(errno));
		if (got == 0) fail_as(TS_KIND_FILE, "%s: the file became shorter while it was read", shown.c_str());
		done += (size_t)got;
	}
}

static bytes read_all(const std::string &path, int flags, const extent &wanted, const std::string &shown)
{
	descriptor file{open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | flags)};
	struct stat info;
	if (file.fd < 0 || fstat(file.fd, &info) != 0) fail_as(TS_KIND_FILE, "%s: %s", shown.c_str(), strerror(errno));
	if (!S_ISREG(info.st_mode)) fail_as(TS_KIND_FILE, "%s: not a regular file", shown.c_str());
	uint64_t size = (uint64_t)info.st_size, limit = std::min(wanted.limit, ts_memory_limit());
	if (size > limit)
		fail("%s: %llu bytes; at most %llu are read", shown.c_str(), (unsigned long long)size,
		     (unsigned long long)limit);
	size = std::min(size, wanted.most);
	bytes data;
	read_more(data, file, (size_t)std::min(size, head_bytes), shown);
	if (wanted.is_worth && !wanted.is_worth(data)) return data;
	data.reserve((size_t)size);
	read_more(data, file, (size_t)size - data.size(), shown);
	return data;
}

bytes file_read(const std::string &path, const extent &wanted) { return read_all(path, 0, wanted, "the file"); }

static std::string resolve(const std::string &path, const std::string &shown)
{
	std::unique_ptr<char, void (*)(void *)> real(realpath(path.c_str(), nullptr), free);
	if (!real) fail_as(TS_KIND_FILE, "%s: %s", shown.c_str(), strerror(errno));
	return real.get();
}

bytes file_read_beside(const loader &in, const std::string &relative, const extent &wanted)
{
	size_t slash = in.path.rfind('/');
	std::string shown = "file " + quoted(relative);
	if (in.in_memory)
		fail_as(TS_KIND_ARGUMENT, "%s: a scene in memory has no files beside it; a .glb, or data URIs, would be right",
		        shown.c_str());
	std::string folder = resolve(slash == std::string::npos ? "." : in.path.substr(0, slash + 1), "its folder");
	if (folder.back() != '/') folder += '/';
	std::string real = resolve(folder + relative, shown);
	if (real.compare(0, folder.size(), folder) != 0) fail("%s: a link out of the scene's folder", shown.c_str());
	return read_all(real, O_NOFOLLOW, wanted, shown);
}

static int hex_digit(char c)
{
	if (c >= '0' && c <= '9') return c - '0';
	if (c >= 'a' && c <= 'f') return c - 'a' + 10;
	if (c >= 'A' && c <= 'F') return c - 'A' + 10;
	return -1;
}

/* A % without two hexadecimal digits stands for itself: programs write names of files as they are. */
static std::string percent_decode(const std::string &uri)
{
	std::string text;
	for (size_t i = 0; i < uri.size(); i++) {
		bool is_code = uri[i] == '%' && i + 2 < uri.size();
		int high = is_code ? hex_digit(uri[i + 1]) : -1, low = is_code ? hex_digit(uri[i + 2]) : -1;
		if (high < 0 || low < 0) {
			text += uri[i];
			continue;
		}
		text += (char)(high * 16 + low);
		i += 2;
	}
	return text;
}

/* The path without dot segments (RFC 3986, 5.2.4); "" if it ever climbs above where it begins. */
static std::string without_dots(const std::string &path)
{
	std::vector<std::string> parts;
	std::string joined;
	for (size_t begin = 0; begin <= path.size();) {
		size_t end = std::min(path.find('/', begin), path.size());
		std::string part = path.substr(begin, end - begin);
		if (part == ".." && parts.empty()) return "";
		if (part == "..")
			parts.pop_back();
		else if (!part.empty() && part != ".")
			parts.push_back(part);
		begin = end + 1;
	}
	for (const std::string &part : parts) joined += (joined.empty() ? "" : "/") + part;
	return joined;
}

std::string path_from_uri(const std::string &uri, const std::string &where)
{
	if (uri.empty()) fail("%s: an empty URI; a file of the scene's folder is expected", where.c_str());
	if (uri.size() >= PATH_MAX)
		fail("%s: a URI of %zu bytes; at most %d are read", where.c_str(), uri.size(), PATH_MAX - 1);
	std::string path = percent_decode(uri);
	bool has_scheme = uri.substr(0, uri.find('/')).find(':') != std::string::npos;
	bool bad =
		path[0] == '/' || path.find('\\') != std::string::npos || path.find('\0') != std::string::npos || has_scheme;
	path = without_dots(path);
	if (bad || path.empty()) fail("%s: %s is no file of the scene's folder", where.c_str(), quoted(uri).c_str());
	return path;
}

/* Schemes and media types may be of capitals. */
static std::string lower(std::string text)
{
	for (char &c : text)
		if (c >= 'A' && c <= 'Z') c = (char)(c - 'A' + 'a');
	return text;
}

bool is_data_uri(const std::string &uri) { return lower(uri.substr(0, 5)) == "data:"; }

static int base64_digit(char c)
{
	if (c >= 'A' && c <= 'Z') return c - 'A';
	if (c >= 'a' && c <= 'z') return c - 'a' + 26;
	if (c >= '0' && c <= '9') return c - '0' + 52;
	return c == '+' ? 62 : c == '/' ? 63 : -1;
}

static bytes base64_decode(const std::string &text, const std::string &where)
{
	bytes data;
	size_t n = text.size(), padding = 0;
	if (n % 4 != 0) fail("%s: %zu base64 characters; a multiple of 4 is expected", where.c_str(), n);
	while (padding < 2 && padding < n && text[n - 1 - padding] == '=') padding++;
	data.reserve(n / 4 * 3);
	u32 word = 0;
	for (size_t i = 0; i < n; i++) {
		int digit = i < n - padding ? base64_digit(text[i]) : 0;
		if (digit < 0) fail("%s: byte %zu of the data is no base64", where.c_str(), i);
		word = word << 6 | (u32)digit;
		if (i % 4 == 3)
			for (int shift = 16; shift >= 0; shift -= 8) data.push_back((unsigned char)(word >> shift));
	}
	data.resize(data.size() - padding);
	return data;
}

data_uri data_uri_decode(const std::string &uri, const std::string &where)
{
	static const std::string mark = ";base64";
	size_t comma = uri.find(',');
	if (comma == std::string::npos) fail("%s: a data URI without a comma before its data", where.c_str());
	std::string head = lower(uri.substr(5, comma - 5)), text = uri.substr(comma + 1);
	bool is_base64 = head.size() >= mark.size() && head.compare(head.size() - mark.size(), mark.size(), mark) == 0;
	data_uri decoded;
	decoded.type = head.substr(0, head.find(';'));
	if (is_base64) {
		decoded.data = base64_decode(text, where);
	} else {
		text = percent_decode(text);
		decoded.data.assign(text.begin(), text.end());
	}
	if (decoded.data.empty()) fail("%s: a data URI that holds nothing", where.c_str());
	return decoded;
}

} // namespace gltf
