/* SPDX-License-Identifier: Apache-2.0 */
/* Writes a candidate: a trace that `touchstone compare` can compare with the reference. One header for the source of a
 * port, C99 or C++11, for little-endian machines. It needs the C library and nothing else of touchstone.
 * reference/TRACES.md says what is written, reference/PORTING.md how to go on:
 *   ts_candidate c;
 *   uint64_t shape[1] = {n_texels};
 *   ts_candidate_begin(&c, "out/candidate", "epr", "arrival", "my port", "0.3");  the folder exists
 *   ts_candidate_add(&c, "splat.depth_index", 1, shape, texels);
 *   if (ts_candidate_end(&c) != 0) fprintf(stderr, "%s\n", c.message);
 *
 * Every function returns 0, or 1 with a line in c.message. After a failure all later calls do nothing and return 1, so
 * it is enough to ask at the end. ts_candidate_end writes trace.json last: without this file there is no candidate.
 * One buffer is open at a time; begin and end come in pairs, also after a failure. Any number of candidates can be
 * written at once, each by one thread. Nothing is allocated; the caller's memory is only read.
 *
 * CONVENTIONS of the caller's memory are undone while writing:
 * - Rows from below, row pitches, 4-component vectors, column-major arrays: strides in bytes (ts_candidate_view). For
 *   rows from below let `data` be the last row and the first stride negative. Faces of cubes are put one by one.
 * - Records kept as separate arrays: ts_candidate_put_fields.
 * - Depth and index in two arrays, depth not axial: ts_candidate_put_keys. With d what the depth buffer holds, n and f
 *   near and far plane, z the axial depth that a key wants:
 *     TS_DEPTH_AXIAL              z = d           also distances: splat.depth_index wants |p - centre|
 *     TS_DEPTH_STANDARD           z = n f / (f - d (f - n))      d 0 at near, 1 at far; of OpenGL d = (ndc + 1) / 2
 *     TS_DEPTH_REVERSED           z = n f / (n + d (f - n))      d 1 at near, 0 at far
 *     TS_DEPTH_REVERSED_INFINITE  z = n / d                      d 1 at near, 0 at infinity
 *     unorm of b bits             d = code / (2^b - 1), then one of these
 *   in binary64, rounded once to binary32. Only TS_DEPTH_AXIAL can give equal bits: the others have lost them when the
 *   depth buffer rounded, a unorm one by up to half a code, so the keys cannot be equal. Compare such buffers by their
 *   indices, or write the axial depth from the shader. */
#ifndef TOUCHSTONE_CANDIDATE_H
#define TOUCHSTONE_CANDIDATE_H
#include <float.h>
#include <inttypes.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define TS_CANDIDATE_DIMS 4
#define TS_CANDIDATE_PATH 1024
#define TS_CANDIDATE_MOST ((uint64_t)1 << 56) /* elements of a buffer */
#define TS_CANDIDATE_NONE 0xffffffffu         /* an index that names nothing */

typedef struct {
	const char *name; /* of the buffer */
	unsigned bytes;   /* an element */
	unsigned n_dims;
	const char *descr; /* dtype, as numpy writes it */
} ts_candidate_buffer;

/* begin table: printed by the test program tests/ports/candidate with the argument `table` */
static const ts_candidate_buffer ts_candidate_buffers[] = {
	{"scene.vertex", 80, 1,
     "[('position', '<f4', (3,)), ('object', '<u4'), ('normal', '<f4', (3,)), ('pad', '<u4'), "
     "('tangent', '<f4', (4,)), ('uv', '<f4', (4,)), ('colour', '<f4', (4,))]"},
	{"scene.triangle", 16, 1, "[('vertex', '<u4', (3,)), ('material', '<u4')]"},
	{"scene.material", 80, 1,
     "[('base', '<f4', (4,)), ('emissive', '<f4', (3,)), ('metallic', '<f4'), ('roughness', '<f4'), "
     "('normal_scale', '<f4'), ('occlusion', '<f4'), ('alpha_cutoff', '<f4'), ('slot', '<u4', (5,)), "
     "('flags', '<u4'), ('pad', '<u4', (2,))]"},
	{"scene.slot", 48, 1,
     "[('image', '<u4'), ('uv_set', '<u4'), ('wrap', '<u4', (2,)), ('transform', '<f4', (6,)), "
     "('pad', '<u4', (2,))]"},
	{"scene.image", 24, 1,
     "[('width', '<u4'), ('height', '<u4'), ('n_levels', '<u4'), ('pad', '<u4'), "
     "('first_texel', '<u8')]"},
	{"scene.texel", 8, 1, "'<u8'"},
	{"scene.light", 64, 1,
     "[('position', '<f4', (3,)), ('kind', '<u4'), ('direction', '<f4', (3,)), ('range', '<f4'), "
     "('intensity', '<f4', (3,)), ('spot_scale', '<f4'), ('spot_offset', '<f4'), ('pad', '<u4', (3,))]"},
	{"scene.object", 48, 1,
     "[('first_vertex', '<u4'), ('n_vertices', '<u4'), ('reflector', '<u4'), ('period', '<u4'), "
     "('centre', '<f4', (3,)), ('phase', '<f4'), ('axis', '<f4', (2,)), ('bob', '<f4'), ('spin', '<f4')]"},
	{"scene.surfel", 48, 1,
     "[('centre', '<f4', (3,)), ('u', '<f4', (3,)), ('v', '<f4', (3,)), ('colour', '<f4', (3,))]"},
	{"scene.stand", 24, 1, "[('position', '<f4', (3,)), ('target', '<f4', (3,))]"},
	{"scene.path", 64, 1,
     "[('eye', '<f4', (3,)), ('yfov', '<f4'), ('right', '<f4', (3,)), ('pad0', '<u4'), ('up', '<f4', (3,)), "
     "('pad1', '<u4'), ('back', '<f4', (3,)), ('pad2', '<u4')]"},
	{"scene.motion", 96, 2,
     "[('linear', '<f4', (9,)), ('origin', '<f4', (3,)), ('normal', '<f4', (9,)), ('moves', '<u4'), "
     "('pad', '<u4', (2,))]"},
	{"scene.info", 112, 1,
     "[('eye', '<f4', (3,)), ('yfov', '<f4'), ('right', '<f4', (3,)), ('n_reflectors', '<u4'), "
     "('up', '<f4', (3,)), ('circles', '<u4'), ('back', '<f4', (3,)), ('ambient', '<f4'), "
     "('box_min', '<f4', (3,)), ('pad0', '<u4'), ('box_max', '<f4', (3,)), ('pad1', '<u4'), "
     "('hall_min', '<f4', (2,)), ('hall_max', '<f4', (2,))]"},
	{"pose.vertex", 80, 1,
     "[('position', '<f4', (3,)), ('object', '<u4'), ('normal', '<f4', (3,)), ('pad', '<u4'), "
     "('tangent', '<f4', (4,)), ('uv', '<f4', (4,)), ('colour', '<f4', (4,))]"},
	{"eye.view", 64, 1,
     "[('eye', '<f4', (3,)), ('focal', '<f4'), ('right', '<f4', (3,)), ('width', '<u4'), ('up', '<f4', (3,)), "
     "('height', '<u4'), ('back', '<f4', (3,)), ('near', '<f4')]"},
	{"cube_size.face", 64, 1,
     "[('centre', '<f4', (3,)), ('radius', '<f4'), ('box_min', '<f4', (3,)), ('n', '<u4'), "
     "('box_max', '<f4', (3,)), ('near', '<f4'), ('offset', '<u8'), ('object', '<u4'), ('pad', '<u4')]"},
	{"lamp.light", 64, 1,
     "[('position', '<f4', (3,)), ('kind', '<u4'), ('direction', '<f4', (3,)), ('range', '<f4'), "
     "('intensity', '<f4', (3,)), ('spot_scale', '<f4'), ('spot_offset', '<f4'), ('pad', '<u4', (3,))]"},
	{"lamp.shape", 16, 1, "[('radius', '<f4'), ('samples', '<u4'), ('first', '<u4'), ('pad', '<u4')]"},
	{"offscreen.view", 96, 1,
     "[('eye', '<f4', (3,)), ('focal', '<f4'), ('right', '<f4', (3,)), ('width', '<u4'), ('up', '<f4', (3,)), "
     "('height', '<u4'), ('back', '<f4', (3,)), ('near', '<f4'), ('reach', '<f4', (2,)), ('offset', '<u8'), "
     "('orthographic', '<u4'), ('object', '<u4'), ('light', '<u4'), ('pad', '<u4')]"},
	{"eye.depth_triangle", 8, 2, "'<u8'"},
	{"eye.margin", 8, 3, "'<u8'"},
	{"mirror_pixel.offset", 4, 1, "'<u4'"},
	{"visibility.bits", 8, 2, "'<u8'"},
	{"shade.radiance", 4, 2, "'<f4'"},
	{"cube_face.depth_triangle", 8, 1, "'<u8'"},
	{"cube_face.margin", 8, 2, "'<u8'"},
	{"depth_map.depth", 4, 1, "'<u4'"},
	{"depth_map.margin", 8, 2, "'<u8'"},
	{"shadow_test.lit", 4, 3, "'<u4'"},
	{"shadow_test.margin", 8, 4, "'<u8'"},
	{"rsm.depth_triangle", 8, 1, "'<u8'"},
	{"rsm.patch", 64, 1,
     "[('a', '<f4', (3,)), ('b', '<f4', (3,)), ('c', '<f4', (3,)), ('normal', '<f4', (3,)), "
     "('exitance', '<f4', (3,)), ('pad', '<u4')]"},
	{"gbuffer.pixel", 48, 2,
     "[('position', '<f4', (3,)), ('depth', '<f4'), ('normal', '<f4', (3,)), ('pad0', '<u4'), "
     "('albedo', '<f4', (3,)), ('pad1', '<u4')]"},
	{"indirect.irradiance", 4, 3, "'<f4'"},
	{"indirect.specular", 4, 3, "'<f4'"},
	{"image.sample_radiance", 4, 3, "'<f4'"},
	{"image.radiance", 4, 3, "'<f4'"},
	{"image.srgb", 1, 3, "'|u1'"},
	{"shadow_cube_size.least_ratio", 4, 1, "'<u4'"},
	{"mirror_pixel.record", 96, 1,
     "[('position', '<f4', (3,)), ('index', '<u4'), ('normal', '<f4', (3,)), ('reflector', '<u4'), "
     "('position_dx', '<f4', (3,)), ('tint_r', '<f4'), ('position_dy', '<f4', (3,)), ('tint_g', '<f4'), "
     "('normal_dx', '<f4', (3,)), ('tint_b', '<f4'), ('normal_dy', '<f4', (3,)), ('pad', '<u4')]"},
	{"split.triangle_density", 4, 1, "'<f4'"},
	{"split.offset", 4, 1, "'<u4'"},
	{"split.piece", 48, 1,
     "[('a', '<f4', (3,)), ('triangle', '<u4'), ('b', '<f4', (3,)), ('path', '<u4'), ('c', '<f4', (3,)), "
     "('pad', '<u4')]"},
	{"split.density", 4, 1, "'<f4'"},
	{"cull.keep", 4, 1, "'<u4'"},
	{"cull.margin", 4, 1, "'<f4'"},
	{"align.frame", 80, 1,
     "[('c', '<f4', (3,)), ('s', '<f4'), ('u', '<f4', (3,)), ('pad0', '<u4'), ('v', '<f4', (3,)), "
     "('pad1', '<u4'), ('q', '<i4', (6,)), ('pad2', '<u4', (2,))]"},
	{"points.offset", 4, 1, "'<u4'"},
	{"points.key", 8, 1, "'<u8'"},
	{"points.record", 32, 1,
     "[('centre', '<f4', (3,)), ('length', '<f4'), ('piece', '<u4'), ('flags', '<u4'), "
     "('pad', '<u4', (2,))]"},
	{"splat.depth_index", 8, 1, "'<u8'"},
	{"forward.colour", 4, 1, "'<u4'"},
	{"splat.depth_colour", 8, 1, "'<u8'"},
	{"splat.tie", 1, 1, "'|u1'"},
	{"lookup.point", 4, 2, "'<u4'"},
	{"lookup.colour", 4, 2, "'<u4'"},
	{"lookup.second_offset", 4, 1, "'<u4'"},
	{"lookup.second_parent", 16, 1, "[('parent', '<u4'), ('point', '<u4'), ('reflector', '<u4'), ('from', '<u4')]"},
	{"lookup.second_point", 4, 2, "'<u4'"},
	{"lookup.third_offset", 4, 1, "'<u4'"},
	{"lookup.third_parent", 16, 1, "[('parent', '<u4'), ('point', '<u4'), ('reflector', '<u4'), ('from', '<u4')]"},
	{"lookup.third_point", 4, 2, "'<u4'"},
	{"shade.third_radiance", 4, 2, "'<f4'"},
	{"shade.second_radiance", 4, 2, "'<f4'"},
	{"shade.n_samples", 4, 1, "'<u4'"},
	{"cube_face.mip", 4, 2, "'<f4'"},
	{"scatter.colour", 4, 1, "'<u4'"},
	{"depth_grid.depth", 4, 2, "'<f4'"},
	{"segment.label", 4, 2, "'<u4'"},
	{"segment.margin", 4, 2, "'<f4'"},
	{"segment.extent", 4, 2, "'<u4'"},
	{"segment.box_offset", 4, 1, "'<u4'"},
	{"segment.box", 32, 1,
     "[('low', '<u4', (2,)), ('high', '<u4', (2,)), ('nearest', '<f4'), ('farthest', '<f4'), ('label', '<u4'), "
     "('pad', '<u4')]"},
	{"polygon.patch", 64, 2,
     "[('a', '<f4', (3,)), ('b', '<f4', (3,)), ('c', '<f4', (3,)), ('normal', '<f4', (3,)), "
     "('exitance', '<f4', (3,)), ('pad', '<u4')]"},
	{"corner.moment", 64, 2,
     "[('position', '<f4', (3,)), ('depth', '<f4'), ('sum', '<f4', (3,)), "
     "('direction', '<f4', (9,))]"},
	{"corner.lobes", 64, 2, "[('mu', '<f4', (3,)), ('lambda', '<f4', (3,)), ('phi', '<f4', (9,)), ('pad', '<u4')]"},
	{"hull.box", 4, 2, "'<u4'"},
	{"hull.margin", 4, 2, "'<f4'"},
	{"gloss.pixel", 16, 2, "[('f0', '<f4', (3,)), ('alpha_squared', '<f4')]"},
	{"octree.root_least", 4, 1, "'<u4'"},
	{"octree.root", 16, 1, "[('lower', '<f4', (3,)), ('side', '<f4')]"},
	{"voxel.mask", 8, 1, "'<u8'"},
	{"voxel.before", 4, 1, "'<u4'"},
	{"octree.level", 4, 1, "'<u4'"},
	{"octree.node", 32, 1,
     "[('centre', '<f4', (3,)), ('radius', '<f4'), ('child', '<u4'), ('children', '<u4'), ('parent', '<u4'), "
     "('level', '<u4')]"},
	{"octree.offset", 4, 1, "'<u4'"},
	{"octree.triangle", 4, 1, "'<u4'"},
	{"octree.surface", 48, 1,
     "[('base', '<f4', (3,)), ('metallic', '<f4'), ('normal', '<f4', (3,)), ('roughness', '<f4'), "
     "('emissive', '<f4', (3,)), ('occlusion', '<f4')]"},
	{"octree.reflector", 4, 1, "'<u4'"},
	{"vpl.area", 4, 1, "'<u4'"},
	{"vpl.offset", 4, 1, "'<u4'"},
	{"vpl.path", 4, 1, "'<u4'"},
	{"vpl.light", 48, 1,
     "[('position', '<f4', (3,)), ('bounce', '<u4'), ('normal', '<f4', (3,)), ('pad0', '<u4'), "
     "('flux', '<f4', (3,)), ('pad1', '<u4')]"},
	{"view_octree.voxel_mask", 8, 1, "'<u8'"},
	{"view_octree.voxel_before", 4, 1, "'<u4'"},
	{"view_octree.level", 4, 1, "'<u4'"},
	{"view_octree.node", 32, 1,
     "[('centre', '<f4', (3,)), ('radius', '<f4'), ('child', '<u4'), ('children', '<u4'), ('parent', '<u4'), "
     "('level', '<u4')]"},
	{"view_octree.offset", 4, 1, "'<u4'"},
	{"view_octree.view", 4, 1, "'<u4'"},
	{"view_octree.leaf", 4, 1, "'<u4'"},
	{"view_octree.cone_sum", 8, 2, "'<u8'"},
	{"view_octree.cone_least", 4, 1, "'<u4'"},
	{"view_octree.cone", 32, 1,
     "[('axis', '<f4', (3,)), ('cosine', '<f4'), ('first', '<u4'), ('views', '<u4'), "
     "('pad', '<u4', (2,))]"},
	{"traverse.rendered", 8, 1, "'<u8'"},
	{"view_map.depth_node", 8, 2, "'<u8'"},
	{"view_map.margin", 4, 2, "'<u4'"},
	{"view_map.fused_depth", 4, 2, "'<u4'"},
	{"view_map.fused_node", 4, 2, "'<u4'"},
	{"view_map.colour", 4, 3, "'<f4'"},
	{"vpl_gather.pair_offset", 4, 1, "'<u4'"},
	{"vpl_gather.pair_node", 4, 1, "'<u4'"},
	{"vpl_gather.pair_views", 4, 1, "'<u4'"},
	{"vpl_gather.irradiance", 4, 3, "'<f4'"},
	{"vpl_gather.margin", 4, 2, "'<f4'"},
	{"bilateral.filtered_rows", 4, 3, "'<f4'"},
	{"surfel_near.surfel", 4, 2, "'<u4'"},
	{"normal_field.slope", 4, 3, "'<f4'"},
	{"surfel_setup.epsilon", 4, 1, "'<f4'"},
	{"surfel_setup.disc", 96, 1,
     "[('pixel', '<i4', (2,)), ('fraction', '<f4', (2,)), ('a', '<f4', (2,)), ('b', '<f4', (2,)), "
     "('g', '<f4', (2,)), ('depth', '<f4'), ('flags', '<u4'), ('low', '<i4', (2,)), ('high', '<i4', (2,)), "
     "('conic', '<f4', (3,)), ('peak', '<f4'), ('normal', '<f4', (3,)), ('pad', '<u4')]"},
	{"surfel_depth.surfel", 8, 2, "'<u8'"},
	{"surfel_depth.margin", 8, 3, "'<u8'"},
	{"fragment_list.offset", 4, 1, "'<u4'"},
	{"fragment_list.surfel", 4, 1, "'<u4'"},
	{"surfel_blend.sum", 8, 3, "'<u8'"},
	{"surfel_blend.heaviest", 8, 2, "'<u8'"},
	{"surfel_blend.margin", 8, 3, "'<u8'"},
	{"deferred.margin", 4, 2, "'<f4'"},
};
/* end table */

enum { TS_CANDIDATE_BUFFERS = sizeof ts_candidate_buffers / sizeof *ts_candidate_buffers };

typedef struct {
	char message[512]; /* of the first failure; "" */
	char folder[TS_CANDIDATE_PATH];
	char pipeline[64], order[16], producer[64], version[64];
	char params[4096]; /* as JSON */
	unsigned char added[TS_CANDIDATE_BUFFERS];
	const ts_candidate_buffer *open; /* NULL: none */
	FILE *file;
	uint64_t left; /* elements that the open buffer still lacks */
} ts_candidate;

/* Where element (i, j, ...) lies: data + i stride[0] + j stride[1] + ... bytes. */
typedef struct {
	const void *data;
	ptrdiff_t stride[TS_CANDIDATE_DIMS];
} ts_candidate_view;

typedef enum { TS_DEPTH_AXIAL, TS_DEPTH_STANDARD, TS_DEPTH_REVERSED, TS_DEPTH_REVERSED_INFINITE } ts_candidate_depth;

/* What a depth buffer holds. */
typedef struct {
	ts_candidate_depth kind;
	unsigned unorm_bits; /* 16, 24 or 32: elements are uint32_t codes; 0: float */
	double z_near, z_far;
} ts_candidate_projection;

/* One field of records: component k of element i lies at data + i stride + k component_stride. Planes of x, y, z:
 * stride sizeof(float), component_stride n times that. */
typedef struct {
	const char *name;
	const void *data;
	ptrdiff_t stride, component_stride;
} ts_candidate_field;

static inline int ts_candidate_fail(ts_candidate *c, const char *what, const char *name)
{
	if (c->message[0] == 0) snprintf(c->message, sizeof c->message, "%.300s: %.180s", name, what);
	return 1;
}

/* Copies a text of ASCII that JSON can hold as it is. */
static inline int ts_candidate_text(ts_candidate *c, char *to, size_t room, const char *text)
{
	size_t n = strlen(text), i;
	for (i = 0; i < n; i++) {
		if (text[i] < 32 || text[i] > 126 || text[i] == '"' || text[i] == '\\')
			return ts_candidate_fail(c, "a text with quotes, backslashes or what is not printable ASCII", text);
	}
	if (n >= room) return ts_candidate_fail(c, "a text that is too long", text);
	memcpy(to, text, n + 1);
	return 0;
}

static inline FILE *ts_candidate_file(ts_candidate *c, const char *name, const char *suffix)
{
	char path[TS_CANDIDATE_PATH + 128];
	FILE *file;
	snprintf(path, sizeof path, "%s/%s%s", c->folder, name, suffix);
	file = fopen(path, "wb");
	if (file == NULL) ts_candidate_fail(c, "cannot be written", path);
	return file;
}

/* Begins a candidate in a folder that exists; a trace.json that is there is removed first. `pipeline`: a
 * method, "epr", or an effect and a method, "soft-shadows/ivir"; without an effect it is of reflections.
 * `order`: "canonical", or "arrival" if points stand in the order in which threads appended them. */
static inline int ts_candidate_begin(ts_candidate *c, const char *folder, const char *pipeline, const char *order,
                                     const char *producer, const char *version)
{
	const uint32_t one = 1;
	char path[TS_CANDIDATE_PATH + 16];
	memset(c, 0, sizeof *c);
	if (*(const unsigned char *)&one != 1) return ts_candidate_fail(c, "not on a big-endian machine", "candidate.h");
	if (strlen(folder) >= sizeof c->folder) return ts_candidate_fail(c, "too long", folder);
	memcpy(c->folder, folder, strlen(folder) + 1);
	if (strcmp(order, "canonical") != 0 && strcmp(order, "arrival") != 0)
		return ts_candidate_fail(c, "no order; canonical or arrival would be right", order);
	snprintf(path, sizeof path, "%s/trace.json", folder);
	remove(path);
	return ts_candidate_text(c, c->pipeline, sizeof c->pipeline, pipeline) ||
	       ts_candidate_text(c, c->order, sizeof c->order, order) ||
	       ts_candidate_text(c, c->producer, sizeof c->producer, producer) ||
	       ts_candidate_text(c, c->version, sizeof c->version, version);
}

/* Says which value a parameter had, as --set takes it. Replaying a stage from the candidate's buffers needs them. */
static inline int ts_candidate_param(ts_candidate *c, const char *name, const char *value)
{
	char a[64], b[128];
	size_t n = strlen(c->params);
	int wrote;
	if (c->message[0] != 0) return 1;
	if (ts_candidate_text(c, a, sizeof a, name) || ts_candidate_text(c, b, sizeof b, value)) return 1;
	wrote = snprintf(c->params + n, sizeof c->params - n, "%s\"%s\": \"%s\"", n != 0 ? ", " : "", a, b);
	if (wrote > 0 && (size_t)wrote < sizeof c->params - n) return 0;
	return ts_candidate_fail(c, "too many parameters", name);
}

static inline int ts_candidate_close(ts_candidate *c)
{
	const ts_candidate_buffer *b = c->open;
	int good;
	if (c->file == NULL) return 0;
	good = fclose(c->file) == 0;
	c->file = NULL;
	c->open = NULL;
	if (!good) return ts_candidate_fail(c, "cannot be written; the disk may be full", b->name);
	if (c->left != 0) return ts_candidate_fail(c, "fewer elements were put than its shape has", b->name);
	c->added[b - ts_candidate_buffers] = 1;
	return 0;
}

/* The header of an .npy file of version 1.0. */
static inline int ts_candidate_header(ts_candidate *c, unsigned n_dims, const uint64_t *shape)
{
	char text[4096], dims[128];
	size_t used = 0, n, length;
	unsigned i;
	for (i = 0; i < n_dims; i++)
		used += (size_t)snprintf(dims + used, sizeof dims - used, "%s%" PRIu64, i ? ", " : "", shape[i]);
	n = (size_t)snprintf(text + 10, sizeof text - 10, "{'descr': %s, 'fortran_order': False, 'shape': (%s%s), }",
	                     c->open->descr, dims, n_dims == 1 ? "," : "");
	length = (10 + n + 1 + 63) / 64 * 64;
	memset(text + 10 + n, ' ', length - 10 - n);
	text[length - 1] = '\n';
	memcpy(text, "\x93NUMPY\x01\x00", 8);
	text[8] = (char)((length - 10) & 255);
	text[9] = (char)((length - 10) >> 8);
	if (fwrite(text, 1, length, c->file) == length) return 0;
	return ts_candidate_fail(c, "cannot be written; the disk may be full", c->open->name);
}

/* Elements of an array; beyond TS_CANDIDATE_MOST more than that. */
static inline uint64_t ts_candidate_count(unsigned n_dims, const uint64_t *shape)
{
	uint64_t n = 1;
	unsigned k;
	for (k = 0; k < n_dims; k++) {
		if (shape[k] == 0) return 0;
		n = n > TS_CANDIDATE_MOST / shape[k] ? TS_CANDIDATE_MOST + 1 : n * shape[k];
	}
	return n;
}

/* Begins a buffer whose elements come in parts, in C order. The next one, or the end, closes it. */
static inline int ts_candidate_open(ts_candidate *c, const char *name, unsigned n_dims, const uint64_t *shape)
{
	unsigned i = 0;
	if (c->message[0] != 0 || ts_candidate_close(c)) return 1;
	while (i < TS_CANDIDATE_BUFFERS && strcmp(ts_candidate_buffers[i].name, name) != 0) i++;
	if (i == TS_CANDIDATE_BUFFERS) return ts_candidate_fail(c, "no such buffer; see: touchstone list buffers", name);
	if (c->added[i]) return ts_candidate_fail(c, "was added before", name);
	if (n_dims != ts_candidate_buffers[i].n_dims) return ts_candidate_fail(c, "has another number of dimensions", name);
	if (ts_candidate_count(n_dims, shape) > TS_CANDIDATE_MOST)
		return ts_candidate_fail(c, "its shape has more elements than a file can hold", name);
	c->file = ts_candidate_file(c, name, ".npy");
	if (c->file == NULL) return 1;
	c->open = &ts_candidate_buffers[i];
	c->left = ts_candidate_count(n_dims, shape);
	return ts_candidate_header(c, n_dims, shape);
}

/* Writes n elements, packed. */
static inline int ts_candidate_write(ts_candidate *c, const void *data, uint64_t n)
{
	size_t bytes;
	if (c->message[0] != 0) return 1;
	if (c->open == NULL) return ts_candidate_fail(c, "ts_candidate_open comes first", "candidate.h");
	if (n > c->left) return ts_candidate_fail(c, "more elements were put than its shape has", c->open->name);
	bytes = (size_t)n * c->open->bytes;
	c->left -= n;
	if (bytes == 0 || fwrite(data, 1, bytes, c->file) == bytes) return 0;
	return ts_candidate_fail(c, "cannot be written; the disk may be full", c->open->name);
}

/* Adds a whole buffer that lies in memory as it is in the file. */
static inline int ts_candidate_add(ts_candidate *c, const char *name, unsigned n_dims, const uint64_t *shape,
                                   const void *data)
{
	if (ts_candidate_open(c, name, n_dims, shape)) return 1;
	return ts_candidate_write(c, data, c->left) || ts_candidate_close(c);
}

/* Where element `index`, counted in C order, of an array of that shape lies. */
static inline const unsigned char *ts_candidate_at(const ts_candidate_view *view, unsigned n_dims,
                                                   const uint64_t *shape, uint64_t index)
{
	const unsigned char *at = (const unsigned char *)view->data;
	unsigned k;
	for (k = n_dims; k-- > 0; index /= shape[k]) at += (ptrdiff_t)(index % shape[k]) * view->stride[k];
	return at;
}

/* Puts the next elements of the open buffer: an array of any shape with strides, a whole image or a face of a cube. */
static inline int ts_candidate_put(ts_candidate *c, unsigned n_dims, const uint64_t *shape,
                                   const ts_candidate_view *view)
{
	uint64_t n = ts_candidate_count(n_dims, shape), i;
	for (i = 0; i < n; i++) {
		if (ts_candidate_write(c, ts_candidate_at(view, n_dims, shape, i), 1)) return 1;
	}
	return c->message[0] != 0;
}

/* Axial depth, or 0 where the depth buffer holds nothing that is before the camera and at a finite place. */
static inline float ts_candidate_axial(const ts_candidate_projection *p, const unsigned char *at)
{
	double d, z, n = p->z_near, f = p->z_far;
	if (p->unorm_bits != 0) {
		uint32_t code;
		memcpy(&code, at, sizeof code);
		d = code / (double)(0xffffffffu >> (32 - p->unorm_bits));
	} else {
		float x;
		memcpy(&x, at, sizeof x);
		if (p->kind == TS_DEPTH_AXIAL) return x > 0 && x <= FLT_MAX ? x : 0;
		d = x;
	}
	z = p->kind == TS_DEPTH_STANDARD            ? n * f / (f - d * (f - n))
	    : p->kind == TS_DEPTH_REVERSED          ? n * f / (n + d * (f - n))
	    : p->kind == TS_DEPTH_REVERSED_INFINITE ? (d > 0 ? n / d : 0)
	                                            : d;
	return z > 0 && z <= FLT_MAX ? (float)z : 0;
}

/* Puts keys, depth bits << 32 | index, from an array of depths and one of uint32_t indices of the same shape. Where the
 * index is TS_CANDIDATE_NONE, or there is no depth, the key is empty. */
static inline int ts_candidate_put_keys(ts_candidate *c, unsigned n_dims, const uint64_t *shape,
                                        const ts_candidate_view *depth, const ts_candidate_projection *projection,
                                        const ts_candidate_view *index)
{
	uint64_t n = ts_candidate_count(n_dims, shape), i;
	if (c->open != NULL && strcmp(c->open->descr, "'<u8'") != 0)
		return ts_candidate_fail(c, "its elements are no keys", c->open->name);
	if (projection->unorm_bits > 32) return ts_candidate_fail(c, "unorm_bits is above 32", "candidate.h");
	for (i = 0; i < n; i++) {
		float z = ts_candidate_axial(projection, ts_candidate_at(depth, n_dims, shape, i));
		uint32_t named, bits;
		uint64_t key;
		memcpy(&named, ts_candidate_at(index, n_dims, shape, i), sizeof named);
		memcpy(&bits, &z, sizeof bits);
		key = named == TS_CANDIDATE_NONE || bits == 0 ? ~(uint64_t)0 : (uint64_t)bits << 32 | named;
		if (ts_candidate_write(c, &key, 1)) return 1;
	}
	return c->message[0] != 0;
}

/* Where in a record a field lies, from the text of the dtype. Returns the bytes of one component; 0: no such field. */
static inline unsigned ts_candidate_find(const char *descr, const char *name, unsigned *offset, unsigned *count)
{
	const char *at = descr;
	*offset = 0;
	while ((at = strstr(at, "('")) != NULL) {
		char field[32], type[8];
		unsigned bytes;
		*count = 1;
		if (sscanf(at, "('%31[^']', '%7[^']', (%u", field, type, count) < 2) return 0;
		bytes = (unsigned)(type[2] - '0');
		if (strcmp(field, name) == 0) return bytes;
		*offset += bytes * *count;
		at += 2;
	}
	return 0;
}

/* Puts the next n records of the open buffer from arrays of their fields. Fields that are not given are 0. */
static inline int ts_candidate_put_fields(ts_candidate *c, uint64_t n, const ts_candidate_field *fields,
                                          unsigned n_fields)
{
	unsigned char record[256];
	uint64_t i;
	unsigned f, k, offset, count;
	for (i = 0; i < n && c->open != NULL; i++) {
		memset(record, 0, sizeof record);
		for (f = 0; f < n_fields; f++) {
			unsigned bytes = ts_candidate_find(c->open->descr, fields[f].name, &offset, &count);
			if (bytes == 0) return ts_candidate_fail(c, "the open buffer has no such field", fields[f].name);
			for (k = 0; k < count; k++) {
				const unsigned char *from = (const unsigned char *)fields[f].data + (ptrdiff_t)i * fields[f].stride;
				memcpy(record + offset + k * bytes, from + (ptrdiff_t)k * fields[f].component_stride, bytes);
			}
		}
		if (ts_candidate_write(c, record, 1)) return 1;
	}
	return c->message[0] != 0;
}

/* Writes trace.json, unless something failed. */
static inline int ts_candidate_end(ts_candidate *c)
{
	FILE *file;
	int good, first = 1;
	unsigned i;
	const char *slash = strchr(c->pipeline, '/');
	ts_candidate_close(c);
	if (c->message[0] != 0) return 1;
	file = ts_candidate_file(c, "trace", ".json");
	if (file == NULL) return 1;
	fprintf(file, "{\n \"format\": \"touchstone-trace\",\n \"version\": 1,\n \"contract\": 1,\n");
	fprintf(file, " \"order\": \"%s\",\n", c->order);
	if (slash != NULL) fprintf(file, " \"effect\": \"%.*s\",\n", (int)(slash - c->pipeline), c->pipeline);
	fprintf(file, " \"pipeline\": \"%s\",\n \"producer\": {\"name\": \"%s\", \"version\": \"%s\"},\n",
	        slash != NULL ? slash + 1 : c->pipeline, c->producer, c->version);
	if (c->params[0] != 0) fprintf(file, " \"params\": {%s},\n", c->params);
	fprintf(file, " \"buffers\": [");
	for (i = 0; i < TS_CANDIDATE_BUFFERS; i++) {
		const char *name = ts_candidate_buffers[i].name;
		if (!c->added[i]) continue;
		fprintf(file, "%s\n  {\"name\": \"%s\", \"file\": \"%s.npy\"}", first ? "" : ",", name, name);
		first = 0;
	}
	fprintf(file, "\n ]\n}\n");
	good = ferror(file) == 0;
	good = fclose(file) == 0 && good;
	return good ? 0 : ts_candidate_fail(c, "trace.json cannot be written; the disk may be full", c->folder);
}

#endif
