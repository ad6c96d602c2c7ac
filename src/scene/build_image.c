/* Images as the kernels read them: 16-bit linear texels and their mip chain (CONTRACT rule 37). Integers only. */
#include "model/core.h"
#include "scene/build_parts.h"
#include "scene/srgb_table.h"

#define SIDE_LIMIT 65536u

static u64 texel(const u8 *rgba, bool srgb)
{
	u64 linear[4];
	for (u32 k = 0; k < 4; k++) linear[k] = srgb && k < 3 ? ts_srgb_linear[rgba[k]] : rgba[k] * 257u;
	return linear[0] | linear[1] << 16 | linear[2] << 32 | linear[3] << 48;
}

static u64 mean4(u64 a, u64 b, u64 c, u64 d)
{
	u64 mean = 0;
	for (u32 shift = 0; shift < 64; shift += 16) {
		u64 sum = (a >> shift & 65535) + (b >> shift & 65535) + (c >> shift & 65535) + (d >> shift & 65535);
		mean |= (sum + 2) >> 2 << shift;
	}
	return mean;
}

static u32 half(u32 n) { return n > 1 ? n >> 1 : 1; }

/* One level from the level above it, of width x height texels. */
static void halve(u64 *to, const u64 *from, u32 width, u32 height)
{
	for (u32 y = 0; y < half(height); y++) {
		const u64 *row0 = from + (u64)(2 * y) * width;
		const u64 *row1 = from + (u64)(2 * y + 1 < height ? 2 * y + 1 : height - 1) * width;
		for (u32 x = 0; x < half(width); x++) {
			u32 x1 = 2 * x + 1 < width ? 2 * x + 1 : width - 1;
			*to++ = mean4(row0[2 * x], row0[x1], row1[2 * x], row1[x1]);
		}
	}
}

static u32 levels(u64 *n_texels, u32 width, u32 height)
{
	u32 n = 1;
	for (*n_texels = (u64)width * height; width > 1 || height > 1; n++) {
		width = half(width);
		height = half(height);
		*n_texels += (u64)width * height;
	}
	return n;
}

u32 ts_build_image(ts_build *build, const u8 *rgba, u32 width, u32 height, bool srgb)
{
	ts_scene *scene = build->scene;
	u64 n_texels;
	if (build->failed) return 0;
	if (width == 0 || height == 0 || width > SIDE_LIMIT || height > SIDE_LIMIT)
		ts_build_fail(build, "%s: image %u: %u x %u texels; each side must be 1 to %u", scene->name, scene->n_images,
		              width, height, SIDE_LIMIT);
	if (!TS_BUILD_ROOM(build, images, "images")) return 0;
	ts_image image = {.width = width, .height = height, .first_texel = scene->n_texels};
	image.n_levels = levels(&n_texels, width, height);
	scene->texels = ts_build_room(build, scene->texels, scene->n_texels, n_texels, &build->capacity.texels,
	                              sizeof *scene->texels, "texels");
	if (build->failed) return 0;
	u64 *level = scene->texels + scene->n_texels;
	for (u64 i = 0; i < (u64)width * height; i++) level[i] = texel(rgba + 4 * i, srgb);
	while (width > 1 || height > 1) {
		u64 *below = level + (u64)width * height;
		halve(below, level, width, height);
		level = below;
		width = half(width);
		height = half(height);
	}
	scene->n_texels += n_texels;
	scene->images[scene->n_images] = image;
	return scene->n_images++;
}
