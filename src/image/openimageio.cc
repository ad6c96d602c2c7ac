/* The module libtouchstone-image.so: JPEG and EXR files through OpenImageIO, which is named nowhere else. */
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>
#include "image/codec.h"
#include "model/core.h"

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

/* Of a file: a page whatever its bytes, and what deflate can make of these. */
static constexpr uint64_t most_pixels = 1u << 28, free_pixels = 1u << 24, pixels_a_byte = 1032;

/* OpenImageIO's message as one line. */
static std::string reason(const std::string &message)
{
	std::string line = message.substr(0, message.find('\n'));
	if (line.find("bad_alloc") != std::string::npos) return "out of memory";
	return line.empty() ? "damaged" : line;
}

/* Why there is no reader or writer. */
static std::string why_none()
{
	std::string message = OIIO::geterror();
	return message.empty() ? "no reason given, as where memory or threads end" : reason(message);
}

/* 1 to 4 channels of 8 bits to RGBA: grey is replicated, missing alpha is 255. */
static void to_rgba(uint8_t *rgba, const uint8_t *pixels, uint64_t n, int channels)
{
	for (uint64_t i = 0; i < n; i++) {
		const uint8_t *from = pixels + i * (uint64_t)channels;
		bool grey = channels < 3;
		for (int c = 0; c < 3; c++) rgba[4 * i + (uint64_t)c] = from[grey ? 0 : c];
		rgba[4 * i + 3] = channels == 2 ? from[1] : channels == 4 ? from[3] : 255;
	}
}

static ts_status open_memory(std::unique_ptr<ImageInput> &in, ImageSpec &spec, OIIO::Filesystem::IOMemReader &memory,
                             const char *format, const char *what)
{
	ImageSpec config;
	config.attribute("oiio:UnassociatedAlpha", 1);
	in = ImageInput::create(format);
	if (!in || !in->set_ioproxy(&memory))
		return ts_fail("%s: OpenImageIO cannot read %s: %s", what, format, why_none().c_str());
	if (in->open("", spec, config)) return TS_OK;
	return ts_fail("%s: %s; a PNG, JPEG or EXR is expected", what, reason(in->geterror()).c_str());
}

static ts_status read_8bit(std::vector<uint8_t> &pixels, ImageInput &in, const char *what)
{
	const ImageSpec &spec = in.spec();
	uint64_t n = (uint64_t)spec.width * (uint64_t)spec.height * (uint64_t)spec.nchannels;
	pixels.resize(n);
	if (!in.read_image(0, 0, 0, spec.nchannels, TypeDesc::UINT8, pixels.data()))
		return ts_fail("%s: %s; a whole JPEG is expected", what, reason(in.geterror()).c_str());
	return TS_OK;
}

static ts_status read_memory(uint8_t *rgba, uint32_t width, uint32_t height, const char *format, const void *file,
                             size_t file_bytes, const char *what)
{
	OIIO::Filesystem::IOMemReader memory(const_cast<void *>(file), file_bytes);
	ImageSpec spec;
	std::unique_ptr<ImageInput> in;
	if (open_memory(in, spec, memory, format, what) != TS_OK) return TS_ERROR;
	if ((uint64_t)spec.width != width || (uint64_t)spec.height != height)
		return ts_fail("%s: its header says %u by %u, its contents %d by %d", what, width, height, spec.width,
		               spec.height);
	if (spec.nchannels < 1 || spec.nchannels > 4)
		return ts_fail("%s: %d channels; 1 to 4 are read", what, spec.nchannels);
	std::vector<uint8_t> pixels;
	if (read_8bit(pixels, *in, what) != TS_OK) return TS_ERROR;
	to_rgba(rgba, pixels.data(), (uint64_t)width * height, spec.nchannels);
	return TS_OK;
}

/* Runs `work`; whatever it throws becomes a failure. OpenEXR is left no threads, for where memory ends it may wait for
 * them for ever. */
template <typename Work> static ts_status guarded(const char *what, Work work)
{
	try {
		OIIO::attribute("exr_threads", -1);
		return work();
	} catch (const std::bad_alloc &) {
		return ts_fail_as(TS_KIND_MEMORY, "%s: no memory for the image", what);
	} catch (const std::exception &e) {
		return ts_fail("%s: %s", what, e.what());
	} catch (...) {
		return ts_fail("%s: the image library failed", what);
	}
}

static ts_status decode(uint8_t *rgba, uint32_t width, uint32_t height, const char *format, const void *file,
                        size_t file_bytes, const char *what)
{
	return guarded(what, [&] { return read_memory(rgba, width, height, format, file, file_bytes, what); });
}

/* A file in memory, where only a lack of that can keep it from being written. */
struct encoded {
	void **file;
	size_t *bytes;
	const char *path;

	ts_status write(const char *format, const ImageSpec &spec, TypeDesc type, const void *pixels) const
	{
		OIIO::Filesystem::IOVecOutput proxy;
		std::unique_ptr<ImageOutput> out = ImageOutput::create(format);
		if (!out) return ts_fail("%s: OpenImageIO cannot write %s: %s", path, format, why_none().c_str());
		bool good = out->set_ioproxy(&proxy) && out->open(path, spec) && out->write_image(type, pixels);
		good = out->close() && good;
		if (!good)
			return ts_fail_as(TS_KIND_MEMORY, "%s: %s, as where memory ends", path, reason(out->geterror()).c_str());
		*bytes = proxy.buffer().size();
		*file = ts_alloc(*bytes, 1, path);
		if (*file == nullptr) return TS_ERROR;
		memcpy(*file, proxy.buffer().data(), *bytes);
		return TS_OK;
	}
};

static void add_texts(ImageSpec &spec, const ts_image_text *texts)
{
	for (; texts != nullptr && texts->name != nullptr; texts++) spec.attribute(texts->name, texts->text);
}

static bool read_codes(float *pixels, ImageInput &in, uint64_t n)
{
	std::vector<uint8_t> codes(n);
	if (!in.read_image(0, 0, 0, in.spec().nchannels, TypeDesc::UINT8, codes.data())) return false;
	for (uint64_t i = 0; i < n; i++) pixels[i] = (float)codes[i] / 255.0f;
	return true;
}

static bool is_whole(const ImageSpec &spec, int channel) { return spec.channelformat(channel) == TypeDesc::UINT32; }

static ts_image_frame frame_of(ImageInput &in)
{
	const ImageSpec spec = in.spec();
	ts_image_frame frame = {{spec.x, spec.y}, {spec.full_x, spec.full_y, spec.full_width, spec.full_height}, 1, 0};
	for (int c = 0; c < spec.nchannels && c < 4; c++) frame.whole |= (uint32_t)is_whole(spec, c) << c;
	while (in.seek_subimage((int)frame.parts, 0)) frame.parts++;
	(void)in.geterror();
	in.seek_subimage(0, 0);
	return frame;
}

/* The bits of whole numbers, which floats do not hold. */
static bool read_whole(float *pixels, ImageInput &in, uint64_t n)
{
	const ImageSpec spec = in.spec();
	std::vector<uint32_t> codes(n);
	bool good = true;
	for (int c = 0; c < spec.nchannels && good; c++) {
		if (!is_whole(spec, c)) continue;
		good = in.read_image(0, 0, c, c + 1, TypeDesc::UINT32, codes.data());
		for (uint64_t i = 0; i < n && good; i++)
			memcpy(pixels + i * (uint64_t)spec.nchannels + (uint64_t)c, &codes[i], sizeof codes[i]);
	}
	return good;
}

static ts_status read_floats(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels,
                             ts_image_frame *frame, const char *format, const void *file, size_t file_bytes,
                             const char *path)
{
	OIIO::Filesystem::IOMemReader memory(const_cast<void *>(file), file_bytes);
	ImageSpec spec;
	std::unique_ptr<ImageInput> in;
	if (open_memory(in, spec, memory, format, path) != TS_OK) return TS_ERROR;
	uint64_t most = std::min(most_pixels, free_pixels + file_bytes * pixels_a_byte);
	if (spec.width < 1 || spec.height < 1 || (uint64_t)spec.width * (uint64_t)spec.height > most)
		return ts_fail("%s: its header says %d by %d; 1 to %llu pixels are justified", path, spec.width, spec.height,
		               (unsigned long long)most);
	if (spec.nchannels < 1 || spec.nchannels > 4)
		return ts_fail("%s: %d channels; 1 to 4 are read", path, spec.nchannels);
	uint64_t n = (uint64_t)spec.width * (uint64_t)spec.height * (uint64_t)spec.nchannels;
	float *out = (float *)ts_alloc(n, sizeof *out, path);
	if (!out) return TS_ERROR;
	std::unique_ptr<float, void (*)(void *)> owner(out, free);
	bool good = spec.format == TypeDesc::UINT8 ? read_codes(out, *in, n)
	                                           : in->read_image(0, 0, 0, spec.nchannels, TypeDesc::FLOAT, out);
	*frame = frame_of(*in);
	if (good && frame->whole != 0) good = read_whole(out, *in, (uint64_t)spec.width * (uint64_t)spec.height);
	if (!good) return ts_fail("%s: %s; a whole image is expected", path, reason(in->geterror()).c_str());
	*width = (uint32_t)spec.width;
	*height = (uint32_t)spec.height;
	*channels = (uint32_t)spec.nchannels;
	*pixels = owner.release();
	return TS_OK;
}

/* What was asked to stand in the header does. */
static bool has_header(const void *file, size_t bytes, const ImageSpec &asked)
{
	OIIO::Filesystem::IOMemReader memory(const_cast<void *>(file), bytes);
	ImageSpec spec;
	std::unique_ptr<ImageInput> in;
	if (open_memory(in, spec, memory, "openexr", "the picture") != TS_OK) return false;
	for (const auto &attribute : asked.extra_attribs) {
		if (spec.get_string_attribute(attribute.name()) != attribute.get_string()) return false;
	}
	return spec.channelnames == asked.channelnames;
}

/* Where memory ends scan lines or attributes may be left out, and nobody says so. */
static ts_status require_whole(void **file, size_t bytes, const char *path, const float *pixels, const ImageSpec &spec)
{
	float *back = nullptr;
	uint32_t width, height, channels;
	ts_image_frame frame;
	ts_status status = read_floats(&back, &width, &height, &channels, &frame, "openexr", *file, bytes, path);
	std::unique_ptr<float, void (*)(void *)> owner(back, free);
	bool whole = status == TS_OK && memcmp(back, pixels, spec.image_pixels() * channels * sizeof *pixels) == 0;
	if (whole && has_header(*file, bytes, spec)) return TS_OK;
	free(*file);
	*file = nullptr;
	return ts_fail_as(TS_KIND_MEMORY, "%s: its encoder left something out, as where memory ends", path);
}

/* OpenImageIO writes the time of day where no other is given. */
static ts_status encode_exr(void **file, size_t *bytes, const char *path, const float *pixels, uint32_t width,
                            uint32_t height, uint32_t channels, const ts_image_text *texts)
{
	*file = nullptr;
	return guarded(path, [&] {
		ImageSpec spec((int)width, (int)height, (int)channels, TypeDesc::FLOAT);
		spec.attribute("compression", "zip");
		spec.attribute("DateTime", "1970:01:01 00:00:00");
		add_texts(spec, texts);
		if (channels == 1) spec.channelnames.assign(1, "Y");
		ts_status status = encoded{file, bytes, path}.write("openexr", spec, TypeDesc::FLOAT, pixels);
		return status == TS_OK ? require_whole(file, *bytes, path, pixels, spec) : status;
	});
}

static ts_status read(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels, ts_image_frame *frame,
                      const char *format, const void *file, size_t file_bytes, const char *what)
{
	return guarded(what,
	               [&] { return read_floats(pixels, width, height, channels, frame, format, file, file_bytes, what); });
}

const ts_image_codec ts_image_codec_module = {decode, encode_exr, read, ts_error_message, ts_error_kind};
