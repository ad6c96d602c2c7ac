/* Candidates whose points stand in the order of their arrival: the same by their keys, different where a record, an
 * index or a key is; and the memory that this takes. */
#include <sys/resource.h>
#include <sys/wait.h>
#include "compare/compare.h"
#include "kernels/base/num.h"
#include "tests/lcg.h"
#include "tests/model/test.h"
#include "tests/trace/small.h"

static ts_trace *ref, *cand;
static ts_comparison c;
static u32 *place; /* of the reference's points among the candidate's */
static u64 n_points;
static u32 seed = 17;

static void shuffle(u32 *items, u64 n)
{
	for (u64 i = 0; i < n; i++) items[i] = (u32)i;
	for (u64 i = n; i > 1; i--) {
		u32 j = lcg_below(&seed, (u32)i), kept = items[i - 1];
		items[i - 1] = items[j];
		items[j] = kept;
	}
}

/* Moves the records of a set to their places. */
static void move(ts_buffer_id id)
{
	size_t bytes, element = ts_buffer_table[id].element_bytes;
	u64 at = ref->item[id].npy.data_at;
	char *from = file_read(ref->item[id].path, &bytes), *to = file_read(ref->item[id].path, &bytes);
	for (u64 i = 0; i < n_points; i++) memcpy(to + at + place[i] * element, from + at + i * element, element);
	file_write(cand->item[id].path, to, bytes);
	free(from);
	free(to);
}

/* Renames the points that 32-bit words of a buffer name. */
static void rename_points(ts_buffer_id id, u32 first, u32 apart)
{
	size_t bytes;
	char *data = file_read(ref->item[id].path, &bytes);
	for (size_t at = ref->item[id].npy.data_at + first; at < bytes; at += apart) {
		u32 index;
		memcpy(&index, data + at, 4);
		if (index != TS_NONE) index = place[index];
		memcpy(data + at, &index, 4);
	}
	file_write(cand->item[id].path, data, bytes);
	free(data);
}

static void arrive(json_t *root, const void *user)
{
	(void)user;
	json_object_set_new(root, "order", json_string("arrival"));
}

static int begin(void **state)
{
	char dir[2][SCRATCH_PATH];
	ts_params params = small_params();
	ts_trace_options options = {.without = {[TS_B_scene_texel] = true}};
	if (scratch_begin(state) != 0) return -1;
	ts_scene *scene = small_scene(&params);
	snprintf(dir[0], sizeof dir[0], "%s", scratch_path("ref"));
	snprintf(dir[1], sizeof dir[1], "%s", scratch_path("cand"));
	small_trace(dir[0], "epr", scene, &params, options);
	ts_scene_free(scene);
	small_copy(dir[1], dir[0]);
	small_edit(dir[1], arrive, NULL);
	assert_int_equal(ts_trace_open_folder(&ref, dir[0]), TS_OK);
	assert_int_equal(ts_trace_open_folder(&cand, dir[1]), TS_OK);
	n_points = ref->item[TS_B_points_key].npy.n;
	place = malloc(n_points * sizeof *place);
	assert_true(place != NULL && n_points > 1000);
	shuffle(place, n_points);
	move(TS_B_points_key);
	move(TS_B_points_record);
	rename_points(TS_B_splat_depth_index, 0, 8);
	rename_points(TS_B_lookup_point, 0, 4);
	rename_points(TS_B_lookup_second_point, 0, 4);
	rename_points(TS_B_lookup_third_point, 0, 4);
	rename_points(TS_B_lookup_second_parent, offsetof(ts_bounce, point), sizeof(ts_bounce));
	rename_points(TS_B_lookup_third_parent, offsetof(ts_bounce, point), sizeof(ts_bounce));
	return 0;
}

static int end(void **state)
{
	ts_trace_close(ref);
	ts_trace_close(cand);
	free(place);
	return scratch_remove(state);
}

static ts_status compare(void)
{
	const ts_relaxations exact = {.ulp = 0};
	return ts_compare_traces(&c, ref, cand, &exact);
}

static void poke(ts_buffer_id id, u64 element, u32 offset, const void *data, void *old, size_t n)
{
	FILE *file = fopen(cand->item[id].path, "r+b");
	long at = (long)(cand->item[id].npy.data_at + element * ts_buffer_table[id].element_bytes + offset);
	assert_non_null(file);
	fseek(file, at, SEEK_SET);
	assert_int_equal(fread(old, 1, n, file), n);
	fseek(file, at, SEEK_SET);
	assert_int_equal(fwrite(data, 1, n, file), n);
	fclose(file);
}

static void points_in_any_order_are_the_same(void **state)
{
	(void)state;
	if (compare() != TS_OK) fail_msg("%s", c.first < TS_N_BUFFERS ? ts_buffer_table[c.first].name : ts_error_message());
	assert_true(c.n_judged >= 39);
	cand->arrival = false;
	assert_int_equal(compare(), TS_DIFFERENT);
	assert_int_equal(c.first, TS_B_points_key);
	cand->arrival = true;
}

/* A field of one record is found at the reference's place. */
static void a_wrong_record_is_found_by_key(void **state)
{
	(void)state;
	f32 old, wrong = 0.77f;
	poke(TS_B_points_record, place[123], offsetof(ts_point, centre) + 4, &wrong, &old, 4);
	assert_int_equal(compare(), TS_DIFFERENT);
	const ts_verdict *v = &c.verdict[TS_B_points_record];
	assert_true(c.first == TS_B_points_record && c.n_unlike == 1 && v->n_different == 1 && v->first.element == 123);
	assert_true(v->first.field == 0 && v->first.component == 1);
	poke(TS_B_points_record, place[123], offsetof(ts_point, centre) + 4, &old, &wrong, 4);
}

/* A wrong index, one that is right only before mapping, and one that names nothing. */
static void a_wrong_index_is_found_after_mapping(void **state)
{
	(void)state;
	const u32 wrongs[] = {place[5], 5, (u32)n_points, TS_NONE - 1};
	u64 element = 0, k;
	u32 old, index;
	FILE *file = fopen(ref->item[TS_B_lookup_point].path, "rb");
	assert_non_null(file);
	fseek(file, (long)ref->item[TS_B_lookup_point].npy.data_at, SEEK_SET);
	while (fread(&index, 4, 1, file) == 1 && (index == TS_NONE || index == 5)) element++;
	fclose(file);
	for (k = 0; k < 4; k++) {
		if (wrongs[k] == place[index]) continue;
		poke(TS_B_lookup_point, element, 0, &wrongs[k], &old, 4);
		assert_int_equal(old, place[index]);
		assert_int_equal(compare(), TS_DIFFERENT);
		const ts_verdict *v = &c.verdict[TS_B_lookup_point];
		assert_true(c.first == TS_B_lookup_point && v->n_different == 1 && v->first.element == element);
		assert_int_equal(v->first.ref, index);
		if (k == 0) assert_int_equal(v->first.cand, 5);
		poke(TS_B_lookup_point, element, 0, &old, &(u32){0}, 4);
	}
}

/* Wrong records are listed in the reference's order, by their keys. */
static void wrong_records_are_listed_by_their_keys(void **state)
{
	(void)state;
	const ts_relaxations exact = {.ulp = 0};
	const u32 wrongs[] = {17, 123, 124, 900};
	f32 old[4], wrong = 0.77f;
	ts_comparison *listed = ts_comparison_make(9);
	assert_non_null(listed);
	for (u32 i = 0; i < 4; i++) {
		poke(TS_B_points_record, place[wrongs[i]], offsetof(ts_point, length), &wrong, &old[i], 4);
	}
	assert_int_equal(ts_compare_traces(listed, ref, cand, &exact), TS_DIFFERENT);
	const ts_verdict *v = &listed->verdict[TS_B_points_record];
	assert_true(listed->n_unlike == 1 && v->list.n == 4);
	assert_int_equal(v->n_field[1], 4);
	for (u32 i = 0; i < 4; i++) {
		char where[TS_WHERE_TEXT];
		assert_int_equal(ts_where(where, ref, TS_B_points_record, wrongs[i]), TS_OK);
		assert_int_equal(v->list.items[i].difference.element, wrongs[i]);
		assert_string_equal(v->list.items[i].where, where);
		poke(TS_B_points_record, place[wrongs[i]], offsetof(ts_point, length), &old[i], &wrong, 4);
	}
	ts_comparison_free(listed);
}

/* A changed key is a record that is missing and one that is beside; those that name it name nothing. */
static void a_changed_key_is_missing_and_beside(void **state)
{
	(void)state;
	u64 old, wrong = 3;
	const ts_relaxations exact = {.ulp = 0};
	ts_comparison *listed = ts_comparison_make(5);
	assert_non_null(listed);
	poke(TS_B_points_key, place[200], 0, &wrong, &old, 8);
	assert_int_equal(ts_compare_traces(listed, ref, cand, &exact), TS_DIFFERENT);
	const ts_verdict *v = &listed->verdict[TS_B_points_record];
	assert_true(listed->first == TS_B_points_key && v->n_missing == 1 && v->n_extra == 1 && v->n_different == 2 &&
	            !v->has_first);
	assert_true(v->list.n == 2 && v->list.items[0].difference.how == TS_LACKED &&
	            v->list.items[0].difference.element == 200);
	assert_true(v->list.items[1].difference.how == TS_BESIDE && v->list.items[1].difference.cand == 3);
	assert_string_equal(v->list.items[1].where, "key (piece 0, x -32765, y -32768)");
	ts_comparison_free(listed);
	poke(TS_B_points_key, place[200], 0, &old, &wrong, 8);
}

/* A trace of points alone. */
static ts_trace *points(const char *name, u64 n, bool arrival)
{
	ts_trace *trace;
	u32 *order = malloc(n * sizeof *order);
	u64 *keys = malloc(n * sizeof *keys);
	assert_true(order != NULL && keys != NULL);
	shuffle(order, n);
	for (u64 i = 0; i < n; i++) keys[i] = (u64)(arrival ? order[i] : i) << 30;
	assert_int_equal(mkdir(scratch_path("%s", name), 0777), 0);
	file_write(scratch_path("%s/key", name), keys, n * sizeof *keys);
	file_write(scratch_path("%s/record", name), "", 0);
	assert_int_equal(truncate(scratch_path("%s/record", name), (off_t)(n * sizeof(ts_point))), 0);
	assert_int_equal(
		ts_trace_open_layout(&trace, scratch_path("%s", name), "points.key=key,points.record=record", arrival, ref),
		TS_OK);
	free(order);
	free(keys);
	return trace;
}

static long most_kib(void)
{
	struct rusage usage;
	getrusage(RUSAGE_SELF, &usage);
	return usage.ru_maxrss;
}

/* 64 MiB and 16 bytes a record, beyond what the process has without comparing. */
static void comparing_takes_little_memory(void **state)
{
	(void)state;
	if (TS_TEST_SANITIZED) skip();
	enum { N = 3000000 };
	int result;
	ts_trace *a = points("a", N, false), *b = points("b", N, true);
	pid_t child = fork();
	if (child == 0) {
		const ts_relaxations exact = {.ulp = 0};
		long before = most_kib();
		ts_status status = ts_compare_traces(&c, a, b, &exact);
		long grown = most_kib() - before;
		if (status != TS_OK) fprintf(stderr, "# %s\n", ts_error_message());
		if (grown > (64 << 10) + 16l * N / 1024) fprintf(stderr, "# %ld KiB\n", grown);
		_exit(status != TS_OK || grown > (64 << 10) + 16l * N / 1024);
	}
	assert_int_equal(waitpid(child, &result, 0), child);
	assert_int_equal(result, 0);
	ts_trace_close(a);
	ts_trace_close(b);
}

static void fewer_records_than_keys_are_refused(void **state)
{
	(void)state;
	const ts_relaxations exact = {.ulp = 0};
	ts_trace *a = points("more", 1000, false), *b = points("fewer", 1000, true);
	b->item[TS_B_points_record].npy.n = b->item[TS_B_points_record].npy.shape[0] = 999;
	assert_int_equal(ts_compare_traces(&c, a, b, &exact), TS_ERROR);
	says("as many records as keys");
	ts_trace_close(a);
	ts_trace_close(b);
}

int main(void)
{
	const struct CMUnitTest arrival[] = {
		cmocka_unit_test(points_in_any_order_are_the_same),
		cmocka_unit_test(a_wrong_record_is_found_by_key),
		cmocka_unit_test(a_wrong_index_is_found_after_mapping),
		cmocka_unit_test(wrong_records_are_listed_by_their_keys),
		cmocka_unit_test(a_changed_key_is_missing_and_beside),
		cmocka_unit_test(comparing_takes_little_memory),
		cmocka_unit_test(fewer_records_than_keys_are_refused),
	};
	return cmocka_run_group_tests(arrival, begin, end);
}
