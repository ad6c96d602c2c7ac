/* Pictures of what differs: white, in rows and columns, and on the faces of cubes. */
#include <inttypes.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "../study/folder.h"
#include "../trace/emit.h"
#include "../trace/reader.h"
#include "compare.h"

enum { MOST_FACE = 1 << 14 };

/* The marks of a buffer, 0 or 1. */
typedef struct {
	const ts_trace *reference;
	ts_buffer_id id;
	u8 *of;
	u64 n, every; /* marks; marks a pixel or texel */
} marks;

static bool is_marked(const u8 *of, u64 every) { return memchr(of, 1, every) != NULL; }

static ts_status write_picture(const char *name, const u8 *picture, u32 width, u32 height)
{
	const char *path = ts_folder_file(name);
	return path != NULL ? ts_image_write_png(path, picture, width, height, 1, NULL) : TS_ERROR;
}

static ts_status draw_rows(marks *m)
{
	char name[96];
	const ts_npy *npy = &m->reference->item[m->id].npy;
	u64 pixels = npy->shape[0] * npy->shape[1];
	m->every = m->n / pixels;
	for (u64 i = 0; i < pixels; i++) m->of[i] = is_marked(m->of + i * m->every, m->every) ? 255 : 0;
	snprintf(name, sizeof name, "%s.png", ts_buffer_table[m->id].name);
	return write_picture(name, m->of, (u32)npy->shape[1], (u32)npy->shape[0]);
}

/* Six faces of n x n texels, side by side. */
static void draw_faces(u8 *picture, u32 width, const u8 *of, u64 every, u32 n)
{
	for (u32 f = 0; f < 6; f++) {
		for (u32 y = 0; y < n; y++) {
			u8 *row = picture + (size_t)y * width + (size_t)f * n;
			for (u32 x = 0; x < n; x++, of += every) row[x] = is_marked(of, every) ? 255 : 0;
		}
	}
}

/* Texels of a cube, or the height of its picture, with its smaller levels if there are any. */
static u64 texels_of(u32 n, bool mips) { return 6 * (u64)n * n + (mips && n > 1 ? texels_of(n / 2, true) : 0); }
static u32 height_of(u32 n, bool mips) { return n + (mips && n > 1 ? height_of(n / 2, true) : 0); }

static ts_status draw_cube(const marks *m, u64 cube, const u8 *of, u32 n, bool mips)
{
	char name[96];
	u32 width = 6 * n, height = height_of(n, mips), top = 0;
	u8 *picture = ts_alloc_zero(width, height, "a picture of differences");
	if (picture == NULL) return TS_ERROR;
	for (u32 size = n; top < height; top += size, size /= 2) {
		draw_faces(picture + (size_t)top * width, width, of, m->every, size);
		of += texels_of(size, false) * m->every;
	}
	snprintf(name, sizeof name, "%s-cube-%" PRIu64 ".png", ts_buffer_table[m->id].name, cube);
	ts_status status = write_picture(name, picture, width, height);
	free(picture);
	return status;
}

/* Each of n cubes that differs; the levels of cubes follow one another. */
static ts_status draw_cubes(marks *m, ts_reader *faces, u64 n, bool mips)
{
	u64 held, levels = 0;
	for (u64 r = 0; r < n; r++) {
		const ts_face *face = ts_reader_at(faces, r, &held);
		if (face == NULL) return TS_ERROR;
		u64 first = mips ? levels : face->offset, texels = face->n > 0 ? texels_of(face->n, mips) : 0;
		if (face->n > MOST_FACE || first > m->n / m->every || texels > m->n / m->every - first) {
			return ts_fail("%s: cube %" PRIu64 " of %u texels a side at %" PRIu64 ": %s has %" PRIu64 " texels",
			               m->reference->dir, r, (unsigned)face->n, first, ts_buffer_table[m->id].name,
			               m->n / m->every);
		}
		levels += texels;
		const u8 *of = m->of + first * m->every;
		if (!is_marked(of, texels * m->every)) continue;
		if (draw_cube(m, r, of, face->n, mips) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static ts_status draw_texels(marks *m)
{
	const ts_trace_item *item = &m->reference->item[TS_B_cube_size_face];
	ts_reader *faces = ts_trace_read(item, TS_B_cube_size_face);
	if (faces == NULL) return TS_ERROR;
	m->every = m->n / m->reference->item[m->id].npy.shape[0];
	bool mips = ts_axis_counts(&ts_buffer_shape(m->id)->axis[0]) == TS_DIM_mip_texels;
	ts_status status = draw_cubes(m, faces, item->npy.n, mips);
	ts_reader_close(faces);
	return status;
}

/* Whether its elements are texels of cubes. */
static bool is_of_cubes(ts_buffer_id id, const ts_trace *reference)
{
	const ts_axis *axis = &ts_buffer_shape(id)->axis[0];
	ts_dim of = ts_axis_counts(axis);
	return (of == TS_DIM_texels || of == TS_DIM_mip_texels) && axis->more == 0 &&
	       reference->item[TS_B_cube_size_face].path != NULL;
}

static ts_status draw_buffer(ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                             const ts_order *order, const ts_relaxations *relaxations)
{
	marks m = {.reference = reference, .id = id, .n = reference->item[id].npy.n};
	bool rows = ts_shape_is_image(ts_buffer_shape(id));
	if (m.n == 0 || (!rows && !is_of_cubes(id, reference))) return TS_OK;
	m.of = ts_alloc_zero((size_t)m.n, 1, "a picture of differences");
	if (m.of == NULL) return TS_ERROR;
	ts_verdict v = {.marks = m.of};
	ts_status status = ts_compare_buffer(&v, id, reference, candidate, order, relaxations);
	if (status == TS_OK) status = rows ? draw_rows(&m) : draw_texels(&m);
	free(m.of);
	return status;
}

ts_status ts_compare_draw(const ts_comparison *c, const ts_trace *reference, const ts_trace *candidate,
                          const ts_relaxations *relaxations)
{
	ts_order order;
	ts_buffer_id ids[TS_N_BUFFERS];
	ts_emit_order(ids, reference->pipeline);
	ts_status status = ts_order_make(&order, ts_order_key(), reference, candidate);
	for (u32 i = 0; i < TS_N_BUFFERS && status == TS_OK; i++) {
		ts_buffer_id id = ids[i];
		if (c->verdict[id].judgement != TS_UNLIKE || c->verdict[id].aside) continue;
		status = draw_buffer(id, reference, candidate, &order, relaxations);
	}
	ts_order_free(&order);
	return status;
}
