/* Freedom of candidates in order of arrival: at a texel that is marked as a tie, another point that offers the same
 * distance, and nothing else. A wall of one triangle before one cube, with three points by hand. */
#include "kernels/base/num.h"
#include "kernels/points/splat.h"
#include "methods/points/tools/tools.h"
#include "tests/trace/folder.h"

enum { N = 16, TEXELS = 6 * N * N, POINTS = 4 };

static ts_trace reference;
static ts_face cube = {.radius = 10, .n = N, .near = 0.01f};
static ts_piece piece = {.a = {-6, -6, -5}, .b = {6, -6, -5}, .c = {0, 6, -5}, .path = 1};
static ts_align frame = {.c = {0, -2, -5}, .s = 1, .u = {1, 0, 0}, .v = {0, 1, 0}};
static ts_point points[POINTS] = {
	{.centre = {0, 0, -5}, .length = 2},
	{.centre = {0, 0, -5}, .length = 1},
	{.centre = {0.5f, 0, -5}, .length = 2},
	{.centre = {0, 0, -5}, .length = 2},
};
static u8 ties[TEXELS];
static u64 alone[POINTS][TEXELS]; /* what each point writes by itself */
static u64 bits = 0x3f;

static void put(ts_buffer_id id, const void *data, u64 n, u64 second)
{
	ts_trace_item *item = &reference.item[id];
	if (item->path == NULL) item->path = strdup(scratch_path("%s", ts_buffer_table[id].name));
	item->npy = (ts_npy){.n_dims = second != 0 ? 2 : 1, .shape = {n, second}, .n = n};
	file_write(item->path, data, (size_t)n * ts_buffer_table[id].element_bytes);
}

static void put_all(void)
{
	put(TS_B_splat_tie, ties, TEXELS, 0);
	put(TS_B_cube_size_face, &cube, 1, 0);
	put(TS_B_split_piece, &piece, 1, 0);
	put(TS_B_align_frame, &frame, 1, 0);
	put(TS_B_points_record, points, POINTS, 0);
	put(TS_B_visibility_bits, &bits, 1, 1);
}

static int begin(void **state)
{
	if (scratch_begin(state) != 0) return -1;
	ts_params_default(&reference.params);
	memset(ties, 1, sizeof ties);
	memset(alone, 0xff, sizeof alone);
	for (u32 p = 0; p < POINTS; p++) {
		i64 counts[2] = {0};
		ts_splat_args args = {.from = {.pieces = &piece, .frames = &frame, .points = points},
		                      .cubes = &cube,
		                      .bits = &bits,
		                      .texels = alone[p],
		                      .n_scatters = &counts[0],
		                      .n_writes = &counts[1],
		                      .n_cubes = 1,
		                      .n_words = 1,
		                      .clip = reference.params.splat_clip,
		                      .inset = TS_SPLAT_INSET,
		                      .plane_depth = reference.params.splat_plane_depth};
		ts_k_splat_item(&args, p);
		if (counts[1] == 0) fail_msg("point %u covers nothing", (unsigned)p);
	}
	put_all();
	return 0;
}

static int end(void **state)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) free(reference.item[id].path);
	return scratch_remove(state);
}

static bool allows(u64 texel, u64 ref, u64 cand)
{
	void *t;
	bool allowed = true;
	if (ts_splat_ties_open(&t, &reference) != TS_OK) fail_msg("%s", ts_error_message());
	if (t == NULL) return false;
	if (ts_splat_tie_allows(t, texel, ref, cand, &allowed) != TS_OK) fail_msg("%s", ts_error_message());
	ts_splat_ties_close(t);
	return allowed;
}

/* Every texel and pair of points against what each point writes alone. */
static void tied_points_may_change_places(void **state)
{
	(void)state;
	u32 n_allowed = 0, n_refused = 0;
	for (u64 texel = 0; texel < TEXELS; texel++) {
		for (u32 a = 0; a < POINTS; a++) {
			for (u32 b = 0; b < POINTS && alone[a][texel] != TS_EMPTY; b++) {
				u64 ref = alone[a][texel], cand = (ref >> 32 << 32) | b;
				bool expected = alone[b][texel] != TS_EMPTY && alone[b][texel] >> 32 == ref >> 32;
				if (allows(texel, ref, cand) != expected) fail_msg("texel %u: %u for %u", (unsigned)texel, b, a);
				n_allowed += expected && a != b;
				n_refused += !expected;
			}
		}
	}
	assert_true(n_allowed > 0 && n_refused > 0);
}

static u64 tied_texel(void)
{
	u64 texel = 0;
	while (alone[1][texel] == TS_EMPTY) texel++;
	return texel;
}

static void what_is_no_tie_is_refused(void **state)
{
	(void)state;
	u64 texel = tied_texel(), key = alone[0][texel];
	assert_true(allows(texel, key, key | 3) && allows(texel, key, key | 1));
	assert_false(allows(texel, key, key + (1ull << 32)));
	assert_false(allows(texel, key, key | 77) || allows(texel, key, key | (TS_NONE - 1)) ||
	             allows(texel, key, TS_EMPTY));
	u64 other = 0;
	while (alone[0][other] != TS_EMPTY) other++;
	assert_false(allows(other, key, key | 3));
	ties[texel] = 0;
	put_all();
	assert_false(allows(texel, key, key | 3));
	ties[texel] = 1;
	bits = 0;
	put_all();
	assert_false(allows(texel, key, key | 3));
	bits = 0x3f;
	cube.n = 0;
	put_all();
	assert_false(allows(texel, key, key | 3));
	cube.n = N;
	put_all();
}

/* Without one of the inputs nothing is free; inputs that name what is not there are an error, never a crash. */
static void without_an_input_nothing_is_free(void **state)
{
	(void)state;
	static const ts_buffer_id ids[] = {TS_B_splat_tie,   TS_B_cube_size_face, TS_B_split_piece,
	                                   TS_B_align_frame, TS_B_points_record,  TS_B_visibility_bits};
	u64 texel = tied_texel(), key = alone[0][texel];
	for (u32 i = 0; i < sizeof ids / sizeof *ids; i++) {
		char *path = reference.item[ids[i]].path;
		reference.item[ids[i]].path = NULL;
		assert_false(allows(texel, key, key | 3));
		reference.item[ids[i]].path = path;
	}
	void *t;
	bool allowed;
	points[3].piece = 9;
	put_all();
	assert_int_equal(ts_splat_ties_open(&t, &reference), TS_OK);
	assert_int_equal(ts_splat_tie_allows(t, texel, key, key | 3, &allowed), TS_ERROR);
	says("element 9 is named and not there");
	assert_int_equal(ts_splat_tie_allows(t, TEXELS, key, key | 3, &allowed), TS_ERROR);
	ts_splat_ties_close(t);
	points[3].piece = 0;
	piece.triangle = 5;
	put_all();
	assert_int_equal(ts_splat_ties_open(&t, &reference), TS_OK);
	assert_int_equal(ts_splat_tie_allows(t, texel, key, key | 3, &allowed), TS_ERROR);
	ts_splat_ties_close(t);
	piece.triangle = 0;
}

int main(void)
{
	const struct CMUnitTest tie[] = {
		cmocka_unit_test(tied_points_may_change_places),
		cmocka_unit_test(what_is_no_tie_is_refused),
		cmocka_unit_test(without_an_input_nothing_is_free),
	};
	return cmocka_run_group_tests(tie, begin, end);
}
