/* Image files through OpenImageIO, which is named nowhere else. Input is untrusted: the size in the header is read and
 * judged here before the library sees the file, and of a PNG it sees a checked copy. */
#include "../core/core.h"
#include "png.h"
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <touchstone/image.h>
#include <vector>

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

static constexpr uint64_t most_pixels = 1u << 28;

struct size {
	uint64_t width, height;
};

static unsigned big_endian(const uint8_t *p, int n)
{
	unsigned value = 0;
	for (int i = 0; i < n; i++)
		value = value << 8 | p[i];
	return value;
}

static bool is_png(const uint8_t *p, size_t n) { return n >= 8 && memcmp(p, "\x89PNG\r\n\x1a\n", 8) == 0; }

static bool is_jpeg(const uint8_t *p, size_t n) { return n >= 3 && p[0] == 0xff && p[1] == 0xd8 && p[2] == 0xff; }

static size png_size(const uint8_t *p, size_t n)
{
	if (n < 24 || memcmp(p + 12, "IHDR", 4) != 0) return {0, 0};
	return {big_endian(p + 16, 4), big_endian(p + 20, 4)};
}

/* The first frame header (SOF0 to SOF15 without DHT, JPG and DAC). */
static size jpeg_size(const uint8_t *p, size_t n)
{
	for (size_t at = 2; at + 9 <= n;) {
		if (p[at] != 0xff) return {0, 0};
		unsigned marker = p[at + 1];
		bool bare = marker == 0xff || marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
		if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc)
			return {big_endian(p + at + 7, 2), big_endian(p + at + 5, 2)};
		if (marker == 0xff)
			at += 1;
		else
			at += bare ? 2 : 2 + big_endian(p + at + 2, 2);
	}
	return {0, 0};
}

/* OpenImageIO's message as one line. */
static std::string reason(const std::string &message)
{
	std::string line = message.substr(0, message.find('\n'));
	return line.empty() ? "damaged" : line;
}

/* 1 to 4 channels of 8 bits to RGBA: grey is replicated, missing alpha is 255. */
static void to_rgba(uint8_t *rgba, const uint8_t *pixels, uint64_t n, int channels)
{
	for (uint64_t i = 0; i < n; i++) {
		const uint8_t *from = pixels + i * (uint64_t)channels;
		bool grey = channels < 3;
		for (int c = 0; c < 3; c++)
			rgba[4 * i + (uint64_t)c] = from[grey ? 0 : c];
		rgba[4 * i + 3] = channels == 2 ? from[1] : channels == 4 ? from[3] : 255;
	}
}

static ts_status read_8bit(std::vector<uint8_t> &pixels, ImageInput &in, const char *what)
{
	const ImageSpec &spec = in.spec();
	uint64_t n = (uint64_t)spec.width * (uint64_t)spec.height * (uint64_t)spec.nchannels;
	pixels.resize(n);
	if (spec.format == TypeDesc::UINT16) {
		std::vector<uint16_t> wide(n);
		if (!in.read_image(0, 0, 0, spec.nchannels, TypeDesc::UINT16, wide.data()))
			return ts_fail("%s: %s; a whole PNG or JPEG is expected", what, reason(in.geterror()).c_str());
		for (uint64_t i = 0; i < n; i++)
			pixels[i] = (uint8_t)((wide[i] * 255u + 32767u) / 65535u);
		return TS_OK;
	}
	if (!in.read_image(0, 0, 0, spec.nchannels, TypeDesc::UINT8, pixels.data()))
		return ts_fail("%s: %s; a whole PNG or JPEG is expected", what, reason(in.geterror()).c_str());
	return TS_OK;
}

static ts_status decode(uint8_t **rgba, size stated, const void *file, size_t file_bytes, bool png, const char *what)
{
	OIIO::Filesystem::IOMemReader memory(const_cast<void *>(file), file_bytes);
	ImageSpec spec, config;
	config.attribute("oiio:UnassociatedAlpha", 1);
	std::unique_ptr<ImageInput> in = ImageInput::create(png ? "png" : "jpeg");
	if (!in || !in->set_ioproxy(&memory))
		return ts_fail("%s: OpenImageIO was built without %s", what, png ? "PNG" : "JPEG");
	if (!in->open("", spec, config))
		return ts_fail("%s: %s; a PNG or JPEG is expected", what, reason(in->geterror()).c_str());
	if ((uint64_t)spec.width != stated.width || (uint64_t)spec.height != stated.height)
		return ts_fail("%s: its header says %llu by %llu, its contents %d by %d", what,
					   (unsigned long long)stated.width, (unsigned long long)stated.height, spec.width, spec.height);
	if (spec.nchannels < 1 || spec.nchannels > 4)
		return ts_fail("%s: %d channels; 1 to 4 are read", what, spec.nchannels);
	std::vector<uint8_t> pixels;
	if (read_8bit(pixels, *in, what) != TS_OK) return TS_ERROR;
	*rgba = (uint8_t *)ts_alloc(stated.width * stated.height, 4, what);
	if (!*rgba) return TS_ERROR;
	to_rgba(*rgba, pixels.data(), stated.width * stated.height, spec.nchannels);
	return TS_OK;
}

/* Runs `work`; whatever it throws becomes a failure. */
template <typename Work> static ts_status guarded(const char *what, Work work)
{
	try {
		return work();
	} catch (const std::bad_alloc &) {
		return ts_fail("%s: no memory for the image", what);
	} catch (const std::exception &e) {
		return ts_fail("%s: %s", what, e.what());
	} catch (...) {
		return ts_fail("%s: the image library failed", what);
	}
}

ts_status ts_image_decode(uint8_t **rgba, uint32_t *width, uint32_t *height, const void *file, size_t file_bytes,
						  uint64_t max_texels, const char *what)
{
	const uint8_t *p = (const uint8_t *)file;
	bool png = is_png(p, file_bytes);
	*rgba = nullptr;
	if (!png && !is_jpeg(p, file_bytes)) return ts_fail("%s: neither PNG nor JPEG", what);
	size stated = png ? png_size(p, file_bytes) : jpeg_size(p, file_bytes);
	if (stated.width == 0 || stated.height == 0) return ts_fail("%s: no width or height in its header", what);
	if (stated.width > max_texels / stated.height)
		return ts_fail("%s: its header says %llu by %llu; at most %llu texels are justified", what,
					   (unsigned long long)stated.width, (unsigned long long)stated.height,
					   (unsigned long long)max_texels);
	uint8_t *clean = nullptr;
	size_t clean_bytes = 0;
	if (png && ts_png_clean(&clean, &clean_bytes, p, file_bytes, what) != TS_OK) return TS_ERROR;
	std::unique_ptr<uint8_t, void (*)(void *)> owner(clean, free);
	*width = (uint32_t)stated.width;
	*height = (uint32_t)stated.height;
	return guarded(what, [&] {
		return png ? decode(rgba, stated, clean, clean_bytes, png, what)
				   : decode(rgba, stated, file, file_bytes, png, what);
	});
}

/* Writes PATH.partial and renames it. */
static ts_status write_file(const char *path, const char *format, const ImageSpec &spec, TypeDesc type,
							const void *pixels)
{
	std::string partial = std::string(path) + ".partial";
	std::unique_ptr<ImageOutput> out = ImageOutput::create(format);
	if (!out) return ts_fail("%s: OpenImageIO was built without %s", path, format);
	errno = 0;
	if (!out->open(partial, spec))
		return ts_fail("%s: %s", path, errno ? strerror(errno) : reason(out->geterror()).c_str());
	bool good = out->write_image(type, pixels);
	good = out->close() && good;
	if (good && rename(partial.c_str(), path) == 0) return TS_OK;
	std::string why = good ? strerror(errno) : reason(out->geterror());
	remove(partial.c_str());
	return ts_fail("%s: %s", path, why.c_str());
}

ts_status ts_image_write_png(const char *path, const uint8_t *pixels, uint32_t width, uint32_t height,
							 uint32_t channels)
{
	return guarded(path, [&] {
		ImageSpec spec((int)width, (int)height, (int)channels, TypeDesc::UINT8);
		spec.attribute("oiio:UnassociatedAlpha", 1);
		spec.attribute("oiio:ColorSpace", "sRGB");
		return write_file(path, "png", spec, TypeDesc::UINT8, pixels);
	});
}

ts_status ts_image_write_exr(const char *path, const float *pixels, uint32_t width, uint32_t height, uint32_t channels)
{
	return guarded(path, [&] {
		ImageSpec spec((int)width, (int)height, (int)channels, TypeDesc::FLOAT);
		spec.attribute("compression", "zip");
		if (channels == 1) spec.channelnames.assign(1, "Y");
		return write_file(path, "openexr", spec, TypeDesc::FLOAT, pixels);
	});
}

template <typename Code> static bool read_codes(float *pixels, ImageInput &in, uint64_t n, TypeDesc type, float full)
{
	std::vector<Code> codes(n);
	if (!in.read_image(0, 0, 0, in.spec().nchannels, type, codes.data())) return false;
	for (uint64_t i = 0; i < n; i++)
		pixels[i] = (float)codes[i] / full;
	return true;
}

static ts_status read_file(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels, const char *path)
{
	ImageSpec config;
	config.attribute("oiio:UnassociatedAlpha", 1);
	std::unique_ptr<ImageInput> in = ImageInput::open(path, &config);
	if (!in) return ts_fail("%s: %s; a PNG, JPEG or EXR is expected", path, reason(OIIO::geterror()).c_str());
	const ImageSpec &spec = in->spec();
	if (spec.width < 1 || spec.height < 1 || (uint64_t)spec.width * (uint64_t)spec.height > most_pixels)
		return ts_fail("%s: %d by %d pixels; 1 to %llu are read", path, spec.width, spec.height,
					   (unsigned long long)most_pixels);
	if (spec.nchannels < 1 || spec.nchannels > 4)
		return ts_fail("%s: %d channels; 1 to 4 are read", path, spec.nchannels);
	uint64_t n = (uint64_t)spec.width * (uint64_t)spec.height * (uint64_t)spec.nchannels;
	float *out = (float *)ts_alloc(n, sizeof *out, path);
	if (!out) return TS_ERROR;
	std::unique_ptr<float, void (*)(void *)> owner(out, free);
	bool good = spec.format == TypeDesc::UINT8    ? read_codes<uint8_t>(out, *in, n, TypeDesc::UINT8, 255.0f)
				: spec.format == TypeDesc::UINT16 ? read_codes<uint16_t>(out, *in, n, TypeDesc::UINT16, 65535.0f)
												  : in->read_image(0, 0, 0, spec.nchannels, TypeDesc::FLOAT, out);
	if (!good) return ts_fail("%s: %s; a whole image is expected", path, reason(in->geterror()).c_str());
	*width = (uint32_t)spec.width;
	*height = (uint32_t)spec.height;
	*channels = (uint32_t)spec.nchannels;
	*pixels = owner.release();
	return TS_OK;
}

ts_status ts_image_read(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels, const char *path)
{
	*pixels = nullptr;
	return guarded(path, [&] { return read_file(pixels, width, height, channels, path); });
}
