/* Pictures of differences: white, in rows and columns, and on the faces of cubes. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "cli/compare.h"
#include "study/results/folder.h"

enum { MOST_FACE = 1 << 14 };

/* The marks of a buffer, 0 or 1. */
typedef struct {
	const ts_compared *compared;
	const ts_buffer_view *view; /* the reference's */
	u8 *of;
	u64 n, every; /* marks; marks per pixel or texel */
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
	const u64 *shape = m->view->shape;
	u64 pixels = shape[0] * shape[1];
	m->every = m->n / pixels;
	for (u64 i = 0; i < pixels; i++) m->of[i] = is_marked(m->of + i * m->every, m->every) ? 255 : 0;
	snprintf(name, sizeof name, "%s.png", m->view->name);
	return write_picture(name, m->of, (u32)shape[1], (u32)shape[0]);
}

/* Draws six faces of n x n texels, side by side. */
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
	snprintf(name, sizeof name, "%s-cube-%" PRIu64 ".png", m->view->name, cube);
	ts_status status = write_picture(name, picture, width, height);
	free(picture);
	return status;
}

/* Draws each of n cubes that differs; the levels of cubes follow one another. */
static ts_status draw_cubes(marks *m, const ts_buffer_view *faces, bool mips)
{
	u64 levels = 0;
	const ts_face *face = faces->data;
	for (u64 r = 0; r < faces->shape[0]; r++, face++) {
		u64 first = mips ? levels : face->offset, texels = face->n > 0 ? texels_of(face->n, mips) : 0;
		if (face->n > MOST_FACE || first > m->n / m->every || texels > m->n / m->every - first) {
			return ts_fail("%s: cube %" PRIu64 " of %u texels a side at %" PRIu64 ": %s has %" PRIu64 " texels",
			               m->compared->of->folder, r, (unsigned)face->n, first, m->view->name, m->n / m->every);
		}
		levels += texels;
		const u8 *of = m->of + first * m->every;
		if (!is_marked(of, texels * m->every)) continue;
		if (draw_cube(m, r, of, face->n, mips) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Whether the first dimension of the buffer is `what`. */
static bool counts(const char *buffer, const char *what)
{
	const ts_buffer_info *info;
	size_t i = 0;
	while ((info = ts_buffer_at(i)) != NULL && strcmp(info->name, buffer) != 0) i++;
	size_t n = strcspn(info->shape, " ");
	return n == strlen(what) && strncmp(info->shape, what, n) == 0;
}

static ts_status draw_texels(marks *m)
{
	const ts_buffer_view *faces = ts_trace_buffer(m->compared->reference, "cube_size.face");
	if (faces == NULL) return TS_ERROR;
	m->every = m->n / m->view->shape[0];
	return draw_cubes(m, faces, counts(m->view->name, "mip_texels"));
}

/* Whether the buffer's elements are texels of cubes. */
static bool is_of_cubes(const ts_compared *c, const char *buffer)
{
	return (counts(buffer, "texels") || counts(buffer, "mip_texels")) && ts_trace_has(c->reference, "cube_size.face");
}

static ts_status draw_buffer(const ts_compared *c, const char *buffer)
{
	marks m = {.compared = c, .view = ts_trace_look(c->reference, buffer), .n = 1};
	bool rows = ts_buffer_is_image(buffer);
	if (m.view == NULL) return TS_ERROR;
	for (u32 i = 0; i < m.view->n_dims; i++) m.n *= m.view->shape[i];
	if (m.n == 0 || (!rows && !is_of_cubes(c, buffer))) return TS_OK;
	m.of = ts_alloc_zero((size_t)m.n, 1, "a picture of differences");
	if (m.of == NULL) return TS_ERROR;
	ts_status status = ts_compare_marks(c->context, m.of, (size_t)m.n, buffer, c->reference, c->candidate, &c->options);
	if (status == TS_SKIPPED) {
		status = TS_OK; /* the points are in an unknown order */
	} else if (status != TS_ERROR) {
		status = rows ? draw_rows(&m) : draw_texels(&m);
	}
	free(m.of);
	return status;
}

ts_status ts_compare_draw(const ts_compared *c)
{
	const ts_verdict_info *v;
	ts_status status = TS_OK;
	for (size_t i = 0; (v = ts_verdicts_at(c->verdicts, i)) != NULL && status == TS_OK; i++) {
		if (v->judgement == TS_UNLIKE && !v->by_digest) status = draw_buffer(c, v->buffer);
	}
	return status;
}
