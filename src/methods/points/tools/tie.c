/* The kernel of stage splat itself decides whether a point offers a distance. */
#include <inttypes.h>
#include <stdlib.h>
#include "kernels/points/splat.h"
#include "methods/points/points.h"
#include "methods/points/tools/tools.h"
#include "trace/reader.h"

/* Inputs of that decision for a texel. */
typedef struct {
	const ts_trace *reference;
	ts_reader *tie, *face, *piece, *align, *point, *bits;
	u64 n_words;
} splat_ties;

static ts_reader *open_item(const ts_trace *trace, ts_buffer_id id, bool *has)
{
	const ts_trace_item *item = &trace->item[id];
	*has &= item->path != NULL;
	return item->path != NULL ? ts_trace_read(item, id) : NULL;
}

ts_status ts_splat_ties_open(void **ties, const ts_trace *reference)
{
	bool has = true;
	splat_ties *t = *ties = ts_alloc(1, sizeof *t, "ties");
	if (t == NULL) return TS_ERROR;
	*t = (splat_ties){.reference = reference,
	                  .tie = open_item(reference, TS_B_splat_tie, &has),
	                  .face = open_item(reference, TS_B_cube_size_face, &has),
	                  .piece = open_item(reference, TS_B_split_piece, &has),
	                  .align = open_item(reference, TS_B_align_frame, &has),
	                  .point = open_item(reference, TS_B_points_record, &has),
	                  .bits = open_item(reference, TS_B_visibility_bits, &has),
	                  .n_words = reference->item[TS_B_visibility_bits].npy.shape[1]};
	bool opened = t->tie && t->face && t->piece && t->align && t->point && t->bits;
	if (opened) return TS_OK;
	ts_splat_ties_close(t);
	*ties = NULL;
	return has ? TS_ERROR : TS_OK;
}

void ts_splat_ties_close(void *ties)
{
	splat_ties *t = ties;
	ts_reader *readers[] = {t->tie, t->face, t->piece, t->align, t->point, t->bits};
	for (u32 i = 0; i < sizeof readers / sizeof *readers; i++) ts_reader_close(readers[i]);
	free(t);
}

/* Copies one element; TS_ERROR also if the file has no such element. */
static ts_status fetch(ts_reader *reader, const ts_trace *trace, ts_buffer_id id, u64 index, void *to)
{
	u64 held;
	const ts_trace_item *item = &trace->item[id];
	if (index >= item->npy.n) return ts_fail("%s: element %" PRIu64 " is named and not there", item->path, index);
	const void *from = ts_reader_at(reader, index, &held);
	if (from == NULL) return TS_ERROR;
	memcpy(to, from, ts_buffer_table[id].element_bytes);
	return TS_OK;
}

/* The cube that a texel lies in, and its face; n = 0: none. */
static ts_status find_cube(splat_ties *t, u64 texel, ts_face *cube, u32 *reflector)
{
	u64 n = t->reference->item[TS_B_cube_size_face].npy.n;
	for (*reflector = 0; *reflector < n; (*reflector)++) {
		if (fetch(t->face, t->reference, TS_B_cube_size_face, *reflector, cube) != TS_OK) return TS_ERROR;
		u64 texels = (u64)6 * cube->n * cube->n;
		if (texel >= cube->offset && texel - cube->offset < texels && cube->n <= 4096) return TS_OK;
	}
	cube->n = 0;
	return TS_OK;
}

/* The key of index 0 that the point alone writes to the texel. */
static ts_status key_of(const ts_face *cube, u32 face, u64 inside, const ts_splat_args *args, u64 *key)
{
	u64 n = (u64)cube->n * cube->n;
	ts_splat_args alone = *args;
	alone.texels = ts_alloc((size_t)n, sizeof(u64), "a face");
	if (alone.texels == NULL) return TS_ERROR;
	memset(alone.texels, 0xff, (size_t)n * sizeof(u64));
	ts_camera_k view = ts_k_cube_view(cube, face);
	ts_cover cover = ts_k_splat_triangle(&view, args->from.pieces);
	ts_flight point = ts_k_flight_record(&args->from, 0);
	if (cover.n != 0) ts_k_splat(&alone, &view, &cover, &point, 0, 0);
	*key = alone.texels[inside];
	free(alone.texels);
	return TS_OK;
}

static ts_status offers(splat_ties *t, u64 texel, u32 index, u32 distance, bool *answer)
{
	const ts_trace *r = t->reference;
	ts_face cube;
	ts_point point;
	ts_piece piece;
	ts_align frame;
	u32 reflector;
	u64 word, key;
	*answer = false;
	if (index >= r->item[TS_B_points_record].npy.n) return TS_OK;
	if (find_cube(t, texel, &cube, &reflector) != TS_OK) return TS_ERROR;
	if (cube.n == 0) return TS_OK;
	if (fetch(t->point, r, TS_B_points_record, index, &point) != TS_OK ||
	    fetch(t->piece, r, TS_B_split_piece, point.piece, &piece) != TS_OK ||
	    fetch(t->align, r, TS_B_align_frame, point.piece, &frame) != TS_OK)
		return TS_ERROR;
	u32 face = (u32)((texel - cube.offset) / ((u64)cube.n * cube.n)), bit = 6 * reflector + face;
	u64 place = (u64)piece.triangle * t->n_words + bit / 64;
	if (fetch(t->bits, r, TS_B_visibility_bits, place, &word) != TS_OK) return TS_ERROR;
	if ((word >> (bit % 64) & 1) == 0) return TS_OK;
	point.piece = 0;
	ts_splat_args args = {.from = {.pieces = &piece, .frames = &frame, .points = &point},
	                      .clip = TS_PARAM(&r->params, splat_clip),
	                      .inset = ts_splat_inset(&r->params),
	                      .plane_depth = TS_PARAM(&r->params, splat_plane_depth)};
	u64 inside = texel - cube.offset - (u64)face * cube.n * cube.n;
	if (key_of(&cube, face, inside, &args, &key) != TS_OK) return TS_ERROR;
	*answer = key != TS_EMPTY && (u32)(key >> 32) == distance;
	return TS_OK;
}

ts_status ts_splat_tie_allows(void *ties, u64 texel, u64 ref, u64 cand, bool *allows)
{
	splat_ties *t = ties;
	u8 tied;
	*allows = false;
	if (ref >> 32 != cand >> 32) return TS_OK;
	if (fetch(t->tie, t->reference, TS_B_splat_tie, texel, &tied) != TS_OK) return TS_ERROR;
	return tied != 0 ? offers(t, texel, (u32)cand, (u32)(cand >> 32), allows) : TS_OK;
}
