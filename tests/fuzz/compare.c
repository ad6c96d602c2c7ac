/* libFuzzer on candidates: `make fuzz`. An input is a byte of flags, then keys, records, splats, look-ups, pixels and
 * sums of a candidate, cut into files by a byte of length each, bare or with a header of its own; it is compared with a
 * small reference, and its first differences put into words. */
#include "compare/compare.h"
#include "kernels/base/num.h"
#include "tests/fuzz/folder.h"

enum { MOST = 3, N_POINTS = 6, N_TEXELS = 24, N_FILES = 6, N_SUMS = 5 };
static const ts_buffer_id ids[N_FILES] = {TS_B_points_key,   TS_B_points_record,       TS_B_splat_depth_index,
                                          TS_B_lookup_point, TS_B_mirror_pixel_record, TS_B_points_offset};
static const char *files[N_FILES];
static ts_trace *reference;

/* A wall before a cube of two texels a side, and points on it, two of them alike. */
static void begin(void)
{
	static const u64 keys[N_POINTS] = {10, 20, 30, 40, 50, 60};
	static const ts_face cube = {.radius = 10, .n = 2, .near = 0.01f};
	static const ts_piece piece = {.a = {-6, -6, -5}, .b = {6, -6, -5}, .c = {0, 6, -5}, .path = 1};
	static const ts_align frame = {.c = {0, -2, -5}, .s = 1, .u = {1, 0, 0}, .v = {0, 1, 0}};
	static const u64 bits = 0x3f;
	static const u32 sums[N_SUMS] = {0, 1, 1, 4, N_POINTS};
	static u8 ties[N_TEXELS];
	static ts_point points[N_POINTS];
	static u64 splats[N_TEXELS];
	static u32 lookups[8];
	static ts_pixel pixels[2];
	for (u32 i = 0; i < N_POINTS; i++) points[i] = (ts_point){.centre = {(f32)(i / 2), 0, -5}, .length = 2};
	for (u32 i = 0; i < N_TEXELS; i++) splats[i] = i % 5 == 0 ? TS_EMPTY : 0x40a00000ull << 32 | i % N_POINTS;
	for (u32 i = 0; i < 8; i++) lookups[i] = i % 3 == 0 ? TS_NONE : i % N_POINTS;
	memset(ties, 1, sizeof ties);
	fuzz_begin();
	fuzz_npy(fuzz_name("0.npy"), TS_B_points_key, N_POINTS, 0, keys);
	fuzz_npy(fuzz_name("1.npy"), TS_B_points_record, N_POINTS, 0, points);
	fuzz_npy(fuzz_name("2.npy"), TS_B_splat_depth_index, N_TEXELS, 0, splats);
	fuzz_npy(fuzz_name("3.npy"), TS_B_lookup_point, 2, 4, lookups);
	fuzz_npy(fuzz_name("4.npy"), TS_B_mirror_pixel_record, 2, 0, pixels);
	fuzz_npy(fuzz_name("5.npy"), TS_B_splat_tie, N_TEXELS, 0, ties);
	fuzz_npy(fuzz_name("6.npy"), TS_B_cube_size_face, 1, 0, &cube);
	fuzz_npy(fuzz_name("7.npy"), TS_B_split_piece, 1, 0, &piece);
	fuzz_npy(fuzz_name("8.npy"), TS_B_align_frame, 1, 0, &frame);
	fuzz_npy(fuzz_name("9.npy"), TS_B_visibility_bits, 1, 1, &bits);
	fuzz_npy(fuzz_name("10.npy"), TS_B_points_offset, N_SUMS, 0, sums);
	ts_trace like = {.pipeline = ts_pipeline_find("reflections", "epr")};
	ts_status status = ts_trace_open_layout(
		&reference, fuzz_root,
		"points.key=0.npy,points.record=1.npy,"
		"splat.depth_index=2.npy,lookup.point=3.npy,mirror_pixel.record=4.npy,splat.tie=5.npy,cube_size.face=6.npy,"
		"split.piece=7.npy,align.frame=8.npy,visibility.bits=9.npy,points.offset=10.npy",
		false, &like);
	assert(status == TS_OK);
	static const char *const names[N_FILES] = {"key", "record", "splat", "lookup", "pixel", "sums"};
	for (u32 i = 0; i < N_FILES; i++) files[i] = fuzz_name(names[i]);
}

static void judge(const ts_trace *candidate, const ts_relaxations *relaxations)
{
	static ts_comparison *c;
	char text[TS_VALUE_TEXT];
	if (c == NULL) c = ts_comparison_make(MOST);
	assert(c != NULL);
	ts_status status = ts_compare_traces(c, reference, candidate, relaxations);
	if (status == TS_ERROR) {
		fuzz_refused();
		return;
	}
	assert((status == TS_DIFFERENT) == (c->first != TS_N_BUFFERS));
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_verdict *v = &c->verdict[id];
		assert(v->list.n <= MOST && v->list.n <= v->n_different && (v->list.n > 0 || !v->has_first));
		for (u32 i = 0; i < v->list.n; i++) {
			const ts_difference *d = &v->list.items[i].difference;
			ts_difference_show(text, (ts_buffer_id)id, d, d->cand);
			assert(v->list.items[i].where[0] != 0);
		}
		assert(v->judgement != TS_SAME || v->n_different <= relaxations->allow);
		assert(v->judgement != TS_UNLIKE || v->n_different > 0);
	}
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	ts_trace *candidate;
	if (reference == NULL) begin();
	if (n == 0) return 0;
	u8 flags = data[0];
	size_t at = 1;
	char layout[256] = "";
	for (u32 i = 0; i < N_FILES; i++) {
		size_t bytes = at < n ? data[at++] : 0, used = strlen(layout);
		bytes = bytes < n - at ? bytes : n - at;
		fuzz_write(files[i], data + at, bytes);
		at += bytes;
		if (i > 0 && (flags >> i & 1) != 0) continue;
		snprintf(layout + used, sizeof layout - used, "%s%s=%s", used > 0 ? "," : "", ts_buffer_table[ids[i]].name,
		         strrchr(files[i], '/') + 1);
	}
	ts_relaxations relaxations = {
		.ulp = flags >> 6, .abs = (flags & 64) != 0 ? 0.5 : 0, .rel = (flags & 128) != 0 ? 0.5 : 0};
	if (ts_trace_open_layout(&candidate, fuzz_root, layout, (flags & 1) != 0, reference) != TS_OK) return 0;
	judge(candidate, &relaxations);
	ts_trace_close(candidate);
	return 0;
}
