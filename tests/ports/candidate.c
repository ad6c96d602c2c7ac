/* include/touchstone/candidate.h: its table is that of records.def, and what it writes is what ours are, through every
 * convention that it undoes. Beside the tests:
 *   candidate table              prints the rows between the header's markers
 *   candidate copy TRACE FOLDER  a candidate of the trace's buffers, held as a port holds them */
#include <sys/stat.h>
#include <touchstone/candidate.h>
#include "tests/model/test.h"
#include "trace/read.h"

/* Rows of the header's table that records.def has too. */
enum { N_BOTH = (int)TS_CANDIDATE_BUFFERS < (int)TS_N_BUFFERS ? (int)TS_CANDIDATE_BUFFERS : (int)TS_N_BUFFERS };

static u32 rank_of(ts_buffer_id id)
{
	u32 rank = 1;
	for (const char *s = ts_buffer_table[id].shape; *s != 0; s++) rank += *s == ' ';
	return rank;
}

static void the_table_is_that_of_the_records(void **state)
{
	(void)state;
	assert_int_equal(TS_CANDIDATE_BUFFERS, TS_N_BUFFERS);
	for (u32 id = 0; id < N_BOTH; id++) {
		const ts_candidate_buffer *b = &ts_candidate_buffers[id];
		char descr[TS_NPY_DESCR];
		ts_npy_descr(descr, (ts_buffer_id)id);
		assert_string_equal(b->name, ts_buffer_table[id].name);
		assert_string_equal(b->descr, descr);
		assert_int_equal(b->bytes, ts_buffer_table[id].element_bytes);
		assert_int_equal(b->n_dims, rank_of((ts_buffer_id)id));
	}
}

/* Rows of the table, a text of at most WIDTH characters a line. */
static void print_table(void)
{
	enum { WIDTH = 108 };
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		char descr[TS_NPY_DESCR];
		ts_npy_descr(descr, (ts_buffer_id)id);
		printf("\t{\"%s\", %zu, %u,", ts_buffer_table[id].name, ts_buffer_table[id].element_bytes,
		       (unsigned)rank_of((ts_buffer_id)id));
		for (const char *at = descr; *at != 0;) {
			size_t n = strlen(at);
			if (n > WIDTH - (at == descr ? 16 : 0)) {
				for (n = n < WIDTH ? n : WIDTH; strncmp(at + n, "('", 2) != 0; n--) {
				}
			}
			printf("%s\"%.*s\"", n < strlen(descr) ? "\n\t\t" : " ", (int)n, at);
			at += n;
		}
		printf("},\n");
	}
}

/* A candidate in a folder of its own. */
static void begin(ts_candidate *c, char folder[64])
{
	snprintf(folder, 64, "%s/candidate-XXXXXX", getenv("TMPDIR") != NULL ? getenv("TMPDIR") : "/tmp");
	assert_non_null(mkdtemp(folder));
	assert_int_equal(ts_candidate_begin(c, folder, "epr", "canonical", "a port", "1"), 0);
}

/* The elements of a file that it wrote. */
static void read_back(const char *folder, const char *name, void *data, size_t bytes)
{
	char path[128], header[128];
	snprintf(path, sizeof path, "%s/%s.npy", folder, name);
	FILE *file = fopen(path, "rb");
	assert_non_null(file);
	assert_int_equal(fread(header, 1, 10, file), 10);
	assert_int_equal(fseek(file, 10 + (u8)header[8] + 256 * (u8)header[9], SEEK_SET), 0);
	assert_int_equal(ftell(file) % 64, 0);
	assert_int_equal(fread(data, 1, bytes, file), bytes);
	assert_int_equal(fgetc(file), EOF);
	fclose(file);
}

static void any_strides_write_the_same(void **state)
{
	(void)state;
	/* 2 rows from below of 3 pixels RGBA, each row 16 bytes. */
	const u8 memory[32] = {11, 12, 13, 0, 21, 22, 23, 0, 31, 32, 33, 0, 9, 9, 9, 9, 1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0};
	const u8 right[18] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 13, 21, 22, 23, 31, 32, 33};
	const uint64_t shape[3] = {2, 3, 3};
	const ts_candidate_view view = {memory + 16, {-16, 4, 1}};
	char folder[64];
	u8 found[18];
	ts_candidate c;
	begin(&c, folder);
	assert_int_equal(ts_candidate_open(&c, "image.srgb", 3, shape), 0);
	assert_int_equal(ts_candidate_put(&c, 3, shape, &view), 0);
	assert_int_equal(ts_candidate_end(&c), 0);
	read_back(folder, "image.srgb", found, sizeof found);
	assert_memory_equal(found, right, sizeof right);
}

static void fields_apart_make_up_records(void **state)
{
	(void)state;
	const f32 x[2] = {1, 2}, y[2] = {3, 4}, z[2] = {5, 6}, lengths[4] = {7, 0, 8, 0};
	f32 planes[6];
	memcpy(planes, x, sizeof x);
	memcpy(planes + 2, y, sizeof y);
	memcpy(planes + 4, z, sizeof z);
	const u32 pieces[2] = {9, 10};
	const ts_candidate_field fields[] = {
		{"centre", planes, sizeof(f32), 2 * sizeof(f32)}, {"length", lengths, 8, 0}, {"piece", pieces, 4, 0}};
	const ts_point right[2] = {{{1, 3, 5}, 7, 9, 0, {0, 0}}, {{2, 4, 6}, 8, 10, 0, {0, 0}}};
	const uint64_t shape[1] = {2};
	char folder[64];
	ts_point found[2];
	ts_candidate c;
	begin(&c, folder);
	assert_int_equal(ts_candidate_open(&c, "points.record", 1, shape), 0);
	assert_int_equal(ts_candidate_put_fields(&c, 2, fields, 3), 0);
	assert_int_equal(ts_candidate_end(&c), 0);
	read_back(folder, "points.record", found, sizeof found);
	assert_memory_equal(found, right, sizeof right);
}

static void every_field_is_found_at_its_place(void **state)
{
	(void)state;
	size_t n;
	const ts_field_info *fields = ts_field_table(&n);
	for (u32 id = 0; id < N_BOTH; id++) {
		unsigned at = 0, offset, count, bytes = 0;
		for (size_t i = 0; i < n; i++) {
			if (strcmp(fields[i].record, ts_buffer_table[id].element) != 0) continue;
			bytes = ts_candidate_find(ts_candidate_buffers[id].descr, fields[i].name, &offset, &count);
			assert_int_equal(offset, at);
			assert_int_equal(count, fields[i].count);
			at += bytes * count;
		}
		if (bytes != 0) assert_int_equal(at, ts_buffer_table[id].element_bytes);
	}
}

static float axial(ts_candidate_depth kind, unsigned unorm_bits, const void *stored)
{
	const ts_candidate_projection p = {kind, unorm_bits, 1, 3};
	return ts_candidate_axial(&p, stored);
}

/* Near plane 1, far plane 3: depth 2 is 3/4, reversed 1/4, without a far plane 1/2. */
static void each_kind_of_depth_becomes_axial(void **state)
{
	(void)state;
	const f32 two = 2, standard = 0.75f, reversed = 0.25f, infinite = 0.5f, zero = 0, one = 1;
	const u32 least = 0, most16 = 0xffff, most24 = 0xffffff, most32 = 0xffffffff;
	assert_true(axial(TS_DEPTH_AXIAL, 0, &two) == 2);
	assert_true(axial(TS_DEPTH_STANDARD, 0, &standard) == 2);
	assert_true(axial(TS_DEPTH_STANDARD, 0, &zero) == 1);
	assert_true(axial(TS_DEPTH_STANDARD, 0, &one) == 3);
	assert_true(axial(TS_DEPTH_REVERSED, 0, &reversed) == 2);
	assert_true(axial(TS_DEPTH_REVERSED, 0, &one) == 1);
	assert_true(axial(TS_DEPTH_REVERSED_INFINITE, 0, &infinite) == 2);
	assert_true(axial(TS_DEPTH_REVERSED_INFINITE, 0, &zero) == 0);
	assert_true(axial(TS_DEPTH_STANDARD, 16, &least) == 1);
	assert_true(axial(TS_DEPTH_STANDARD, 16, &most16) == 3);
	assert_true(axial(TS_DEPTH_STANDARD, 24, &most24) == 3);
	assert_true(axial(TS_DEPTH_REVERSED, 32, &most32) == 1);
}

static void depths_and_indices_become_keys(void **state)
{
	(void)state;
	const f32 depth[4] = {1, 2, 0, 3};
	const u32 index[4] = {7, TS_CANDIDATE_NONE, 5, 0};
	const u64 right[4] = {0x3f80000000000007u, ~(u64)0, ~(u64)0, 0x4040000000000000u};
	const ts_candidate_view depths = {depth, {8, 4}}, indices = {index, {8, 4}};
	const ts_candidate_projection axial_depth = {TS_DEPTH_AXIAL, 0, 0, 0};
	const uint64_t shape[2] = {2, 2};
	char folder[64];
	u64 found[4];
	ts_candidate c;
	begin(&c, folder);
	assert_int_equal(ts_candidate_open(&c, "eye.depth_triangle", 2, shape), 0);
	assert_int_equal(ts_candidate_put_keys(&c, 2, shape, &depths, &axial_depth, &indices), 0);
	assert_int_equal(ts_candidate_end(&c), 0);
	read_back(folder, "eye.depth_triangle", found, sizeof found);
	assert_memory_equal(found, right, sizeof right);
}

/* A failure is told once, stays, and leaves no trace.json. */
static void assert_failed(ts_candidate *c, const char *folder, const char *message)
{
	char path[128];
	struct stat info;
	assert_int_equal(ts_candidate_end(c), 1);
	assert_non_null(strstr(c->message, message));
	snprintf(path, sizeof path, "%s/trace.json", folder);
	assert_int_not_equal(stat(path, &info), 0);
}

static void a_failure_is_told_once_and_stays(void **state)
{
	(void)state;
	const uint64_t shape[2] = {3, 1};
	const u32 data[4] = {0};
	char folder[64];
	ts_candidate c;
	begin(&c, folder);
	assert_int_equal(ts_candidate_add(&c, "cull.kept", 1, shape, data), 1);
	assert_int_equal(ts_candidate_add(&c, "cull.keep", 1, shape, data), 1);
	assert_failed(&c, folder, "cull.kept: no such buffer");
	begin(&c, folder);
	assert_int_equal(ts_candidate_add(&c, "cull.keep", 2, shape, data), 1);
	assert_failed(&c, folder, "number of dimensions");
	begin(&c, folder);
	assert_int_equal(ts_candidate_add(&c, "cull.keep", 1, shape, data), 0);
	assert_int_equal(ts_candidate_add(&c, "cull.keep", 1, shape, data), 1);
	assert_failed(&c, folder, "added before");
	begin(&c, folder);
	assert_int_equal(ts_candidate_open(&c, "cull.keep", 1, shape), 0);
	assert_int_equal(ts_candidate_write(&c, data, 2), 0);
	assert_failed(&c, folder, "fewer elements");
	begin(&c, folder);
	assert_int_equal(ts_candidate_open(&c, "cull.keep", 1, shape), 0);
	assert_int_equal(ts_candidate_write(&c, data, 4), 1);
	assert_failed(&c, folder, "more elements");
	begin(&c, folder);
	const uint64_t wraps[] = {(uint64_t)1 << 62, 8};
	assert_int_equal(ts_candidate_open(&c, "visibility.bits", 2, wraps), 1);
	assert_failed(&c, folder, "more elements than a file can hold");
	assert_int_equal(ts_candidate_begin(&c, folder, "epr", "arrival",
	                                    "a p\xf6"
	                                    "rt",
	                                    "1"),
	                 1);
	assert_failed(&c, folder, "printable ASCII");
	assert_int_equal(ts_candidate_begin(&c, folder, "epr", "sorted", "a port", "1"), 1);
	assert_failed(&c, folder, "sorted: no order");
	assert_int_equal(ts_candidate_begin(&c, folder, "epr", "arrival", "a \"port\"", "1"), 1);
	assert_failed(&c, folder, "quotes");
	assert_int_equal(ts_candidate_begin(&c, "/nowhere", "epr", "arrival", "a port", "1"), 0);
	assert_failed(&c, folder, "/nowhere/trace.json: cannot be written");
}

/* A buffer of the trace, in memory; by free(). */
static void *load(const ts_trace *trace, ts_buffer_id id)
{
	const ts_trace_item *item = &trace->item[id];
	size_t bytes = (size_t)item->npy.n * ts_buffer_table[id].element_bytes;
	FILE *file = fopen(item->path, "rb");
	u8 *data = malloc(bytes + 1);
	bool good = file != NULL && data != NULL && fseek(file, (long)item->npy.data_at, SEEK_SET) == 0 &&
	            fread(data, 1, bytes, file) == bytes;
	if (file != NULL) fclose(file);
	if (good) return data;
	fprintf(stderr, "%s: cannot be read\n", item->path);
	exit(2);
}

/* Keys as a port has them: rows from below, depths and indices apart. */
static void copy_keys(ts_candidate *c, const ts_trace *trace, ts_buffer_id id)
{
	const ts_npy *npy = &trace->item[id].npy;
	u64 *keys = load(trace, id), height = npy->shape[0], width = npy->shape[1];
	f32 *depth = malloc(npy->n * sizeof *depth);
	u32 *index = malloc(npy->n * sizeof *index);
	for (u64 i = 0; i < npy->n; i++) {
		u64 to = (height - 1 - i / width) * width + i % width;
		depth[to] = ts_u2f((u32)(keys[i] >> 32));
		index[to] = (u32)keys[i];
	}
	ptrdiff_t row = (ptrdiff_t)width * 4;
	const ts_candidate_view depths = {depth + (height - 1) * width, {-row, 4}};
	const ts_candidate_view indices = {index + (height - 1) * width, {-row, 4}};
	const ts_candidate_projection projection = {TS_DEPTH_AXIAL, 0, 0, 0};
	ts_candidate_open(c, ts_buffer_table[id].name, 2, npy->shape);
	ts_candidate_put_keys(c, 2, npy->shape, &depths, &projection, &indices);
	free(keys);
	free(depth);
	free(index);
}

/* Faces from below, one by one. */
static void copy_cubes(ts_candidate *c, const ts_trace *trace, ts_buffer_id id)
{
	u64 *texels = load(trace, id);
	ts_face *cubes = load(trace, TS_B_cube_size_face);
	ts_candidate_open(c, ts_buffer_table[id].name, 1, trace->item[id].npy.shape);
	for (u64 r = 0; r < trace->item[TS_B_cube_size_face].npy.n; r++) {
		u64 n = cubes[r].n;
		u64 *face = malloc(n * n * sizeof *face + 1);
		const uint64_t shape[2] = {n, n};
		const ts_candidate_view view = {face + (n > 0 ? n - 1 : 0) * n, {-(ptrdiff_t)n * 8, 8}};
		for (u64 f = 0; f < 6; f++) {
			for (u64 i = 0; i < n * n; i++) face[(n - 1 - i / n) * n + i % n] = texels[cubes[r].offset + f * n * n + i];
			ts_candidate_put(c, 2, shape, &view);
		}
		free(face);
	}
	free(texels);
	free(cubes);
}

/* Depth maps from below, one by one. */
static void copy_maps(ts_candidate *c, const ts_trace *trace, ts_buffer_id id)
{
	u32 *texels = load(trace, id);
	ts_offscreen *views = load(trace, TS_B_offscreen_view);
	ts_candidate_open(c, ts_buffer_table[id].name, 1, trace->item[id].npy.shape);
	for (u64 v = 0; v < trace->item[TS_B_offscreen_view].npy.n; v++) {
		u64 width = views[v].width, height = views[v].height;
		u32 *map = malloc(width * height * sizeof *map);
		const uint64_t shape[2] = {height, width};
		const ts_candidate_view view = {map + (height - 1) * width, {-(ptrdiff_t)width * 4, 4}};
		for (u64 y = 0; y < height; y++) {
			memcpy(map + (height - 1 - y) * width, texels + views[v].offset + y * width, width * sizeof *map);
		}
		ts_candidate_put(c, 2, shape, &view);
		free(map);
	}
	free(texels);
	free(views);
}

/* Points as a port has them: centre and length in a vector of 4, the rest apart. */
static void copy_points(ts_candidate *c, const ts_trace *trace, ts_buffer_id id)
{
	u64 n = trace->item[id].npy.n;
	ts_point *points = load(trace, id);
	f32(*centre)[4] = malloc(n * sizeof *centre + 1);
	u32 *piece = malloc(n * sizeof *piece + 1), *flags = malloc(n * sizeof *flags + 1);
	for (u64 i = 0; i < n; i++) {
		memcpy(centre[i], points[i].centre, 12);
		centre[i][3] = points[i].length;
		piece[i] = points[i].piece;
		flags[i] = points[i].flags;
	}
	const ts_candidate_field fields[] = {{"centre", centre, 16, 4},
	                                     {"length", (const f32 *)centre + 3, 16, 0},
	                                     {"piece", piece, 4, 0},
	                                     {"flags", flags, 4, 0}};
	ts_candidate_open(c, ts_buffer_table[id].name, 1, trace->item[id].npy.shape);
	ts_candidate_put_fields(c, n, fields, 4);
	free(points);
	free(centre);
	free(piece);
	free(flags);
}

/* Radiance in planes: all red, all green, all blue. */
static void copy_planes(ts_candidate *c, const ts_trace *trace, ts_buffer_id id)
{
	const ts_npy *npy = &trace->item[id].npy;
	f32 *values = load(trace, id), *planes = malloc(npy->n * sizeof *planes + 1);
	u64 n = npy->shape[0];
	for (u64 i = 0; i < npy->n; i++) planes[i % 3 * n + i / 3] = values[i];
	const ts_candidate_view view = {planes, {4, (ptrdiff_t)n * 4}};
	ts_candidate_open(c, ts_buffer_table[id].name, 2, npy->shape);
	ts_candidate_put(c, 2, npy->shape, &view);
	free(values);
	free(planes);
}

static void copy_buffer(ts_candidate *c, const ts_trace *trace, ts_buffer_id id)
{
	if (trace->item[id].path == NULL) return;
	if (id == TS_B_eye_depth_triangle) {
		copy_keys(c, trace, id);
	} else if (id == TS_B_splat_depth_index) {
		copy_cubes(c, trace, id);
	} else if (id == TS_B_depth_map_depth) {
		copy_maps(c, trace, id);
	} else if (id == TS_B_points_record) {
		copy_points(c, trace, id);
	} else if (id == TS_B_shade_radiance) {
		copy_planes(c, trace, id);
	} else {
		void *data = load(trace, id);
		ts_candidate_add(c, ts_buffer_table[id].name, trace->item[id].npy.n_dims, trace->item[id].npy.shape, data);
		free(data);
	}
}

static int copy(const char *from, const char *to)
{
	ts_trace *trace;
	ts_candidate c;
	if (ts_trace_open_folder(&trace, from) != TS_OK) {
		fprintf(stderr, "%s\n", ts_error_message());
		return 2;
	}
	char method[64];
	snprintf(method, sizeof method, "%s/%s", trace->pipeline->effect->name, trace->pipeline->name);
	ts_candidate_begin(&c, to, method, "canonical", "candidate.h", "1");
	ts_candidate_param(&c, "lookup.bounces", "1");
	for (u32 id = 0; id < TS_N_BUFFERS; id++) copy_buffer(&c, trace, (ts_buffer_id)id);
	ts_trace_close(trace);
	if (ts_candidate_end(&c) == 0) return 0;
	fprintf(stderr, "%s\n", c.message);
	return 2;
}

int main(int argc, char **argv)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_table_is_that_of_the_records), cmocka_unit_test(any_strides_write_the_same),
		cmocka_unit_test(fields_apart_make_up_records),     cmocka_unit_test(every_field_is_found_at_its_place),
		cmocka_unit_test(each_kind_of_depth_becomes_axial), cmocka_unit_test(depths_and_indices_become_keys),
		cmocka_unit_test(a_failure_is_told_once_and_stays),
	};
	if (argc == 4 && strcmp(argv[1], "copy") == 0) return copy(argv[2], argv[3]);
	if (argc == 2 && strcmp(argv[1], "table") == 0) {
		print_table();
		return 0;
	}
	return cmocka_run_group_tests(tests, NULL, NULL);
}
