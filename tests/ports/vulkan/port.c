/* Stages align, points.count, points, splat and lookup of EPR on Vulkan, as a porter writes them: each from the buffers
 * of a trace, or from what the stage before it made here, and all into a candidate.
 *
 *   glslangValidator -V -I../../glsl --target-env vulkan1.2 -o spirv/align.spv align.comp     and points, splat, lookup
 *   ../../spirv-exact spirv/align.spv spirv/points.spv spirv/splat.spv spirv/lookup.spv
 *   cc -std=c11 -D_GNU_SOURCE port.c gpu.c -lvulkan -o port
 *   ./port spirv TRACE CANDIDATE     the folders exist
 *
 * It has the default parameters, and no masked materials. Without a device it ends with status 77. */
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <touchstone/candidate.h>
#include "gpu.h"

enum { SAMPLES = 25, MASKED = 2 };

/* The host's view of three records (TRACES.md, section 2; `touchstone list buffers --json`). */
typedef struct {
	float centre[3], radius, box_min[3];
	uint32_t n;
	float box_max[3], near;
	uint64_t offset;
	uint32_t object, pad;
} face;
typedef struct {
	float factors[12];
	uint32_t slot[5], flags, pad[2];
} material;
typedef struct {
	float centre[3], length;
	uint32_t piece, flags, pad[2];
} point;
enum { BYTES_PIECE = 48, BYTES_FRAME = 80, BYTES_PIXEL = 96, BYTES_VIEW = 64 };

/* A buffer of the trace, or one that is made here. */
typedef struct {
	gpu_memory at;
	uint64_t n;
} array;

static const char *spirv, *trace;

static array make(uint64_t n, size_t bytes) { return (array){gpu_allocate(n * bytes), n}; }

/* NN-BUFFER.npy: behind 10 bytes, the last two of them its length, the header; then the elements. */
static array take(const char *buffer, size_t bytes)
{
	char pattern[1024];
	glob_t found;
	snprintf(pattern, sizeof pattern, "%s/[0-9]*-%s.npy", trace, buffer);
	if (glob(pattern, 0, NULL, &found) != 0) gpu_fail("%s: not there", pattern);
	size_t size;
	unsigned char *file = gpu_read(found.gl_pathv[0], &size);
	globfree(&found);
	size_t header = size >= 10 ? 10 + (file[8] | (size_t)file[9] << 8) : SIZE_MAX;
	if (header > size || (size - header) % bytes != 0) gpu_fail("%s: no elements of %zu bytes", pattern, bytes);
	array made = make((size - header) / bytes, bytes);
	memcpy(made.at.data, file + header, size - header);
	free(file);
	return made;
}

/* One run of a stage, whose push constants are 64-bit words: the number of items, then what else it takes. */
#define RUN(stage, ...) \
	do { \
		const uint64_t constants[] = {__VA_ARGS__}; \
		char path[1024]; \
		snprintf(path, sizeof path, "%s/" stage ".spv", spirv); \
		gpu_run(path, constants[0], constants, sizeof constants); \
	} while (0)

static uint64_t sums(uint32_t *counts, uint64_t n)
{
	uint32_t sum = 0;
	for (uint64_t i = 0; i < n; i++) {
		uint32_t count = counts[i];
		counts[i] = sum;
		sum += count;
	}
	counts[n] = sum;
	return sum;
}

static array empty_texels(const array *cubes)
{
	const face *cube = cubes->at.data;
	uint64_t n = 0;
	for (uint64_t i = 0; i < cubes->n; i++) n += 6 * (uint64_t)cube[i].n * cube[i].n;
	array made = make(n, sizeof(uint64_t));
	memset(made.at.data, 0xff, n * sizeof(uint64_t));
	return made;
}

static void refuse_masks(void)
{
	array materials = take("scene.material", sizeof(material));
	const material *all = materials.at.data;
	for (uint64_t i = 0; i < materials.n; i++)
		if (all[i].flags & MASKED) gpu_fail("%s: material %u is masked; this port has no textures", trace, (unsigned)i);
}

static void add(ts_candidate *to, const char *buffer, const array *made)
{
	ts_candidate_add(to, buffer, 1, &made->n, made->at.data);
}

static void port(ts_candidate *to)
{
	refuse_masks();
	array pieces = take("split.piece", BYTES_PIECE), density = take("split.density", sizeof(float));
	array keep = take("cull.keep", sizeof(uint32_t));
	array frames = make(pieces.n, BYTES_FRAME);
	RUN("align", pieces.n, pieces.at.address, density.at.address, keep.at.address, frames.at.address);

	array offsets = make(pieces.n + 1, sizeof(uint32_t));
	RUN("points", pieces.n, pieces.at.address, frames.at.address, offsets.at.address, 0, 0);
	uint64_t n_points = sums(offsets.at.data, pieces.n);
	array keys = make(n_points, sizeof(uint64_t)), points = make(n_points, sizeof(point));
	RUN("points", pieces.n, pieces.at.address, frames.at.address, offsets.at.address, keys.at.address,
	    points.at.address);

	array cubes = take("cube_size.face", sizeof(face)), bits = take("visibility.bits", sizeof(uint64_t));
	array texels = empty_texels(&cubes);
	uint64_t n_words = (6 * cubes.n + 63) / 64;
	RUN("splat", n_points, cubes.n, n_words, cubes.at.address, bits.at.address, pieces.at.address, frames.at.address,
	    points.at.address, texels.at.address);

	array eye = take("eye.view", BYTES_VIEW), pixels = take("mirror_pixel.record", BYTES_PIXEL);
	array found = make(pixels.n * SAMPLES, sizeof(uint32_t));
	RUN("lookup", found.n, eye.at.address, cubes.at.address, pixels.at.address, texels.at.address, found.at.address);

	add(to, "align.frame", &frames);
	add(to, "points.offset", &offsets);
	add(to, "points.key", &keys);
	add(to, "points.record", &points);
	add(to, "splat.depth_index", &texels);
	const uint64_t shape[2] = {pixels.n, SAMPLES};
	ts_candidate_add(to, "lookup.point", 2, shape, found.at.data);
}

int main(int argc, char **argv)
{
	if (argc != 4) gpu_fail("usage: port SPIRV TRACE CANDIDATE");
	spirv = argv[1];
	trace = argv[2];
	const char *name = gpu_open();
	if (name == NULL) {
		fputs("port: no Vulkan device that suffices\n", stderr);
		return 77;
	}
	ts_candidate candidate;
	ts_candidate_begin(&candidate, argv[3], "epr", "canonical", "vulkan port", "1");
	port(&candidate);
	if (ts_candidate_end(&candidate) != 0) gpu_fail("%s", candidate.message);
	printf("%s\n", name);
	gpu_close();
	return 0;
}
