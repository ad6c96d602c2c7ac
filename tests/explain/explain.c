/* Explaining stages of one small trace: which items tell, which of them gives an element its value, and where two
 * traces part. */
#include "explain/explain.h"
#include "tests/methods/small.h"
#include "trace/item.h"
#include "trace/keep.h"

enum { MOST = 1 << 20 };

static ts_scene *scene;
static ts_trace *trace;

static int begin(void **state)
{
	(void)state;
	ts_params params = small_params(48, 32);
	params.reflectors_count = params.lookup_bounces = 1;
	params.cube_max_px = 16;
	scene = small_scene(&params);
	const ts_how how = {.threads = 1};
	const ts_keep keep = {.whole = true};
	const ts_pipeline *epr = ts_pipeline_find("reflections", "epr");
	return ts_trace_keep(&trace, epr, scene, &params, &how, &keep) == TS_OK ? 0 : -1;
}

static int end(void **state)
{
	(void)state;
	ts_trace_close(trace);
	ts_scene_free(scene);
	return 0;
}

/* All elements of a buffer of the trace, by free(). */
static void *elements_of(ts_buffer_id id)
{
	void *data = malloc((size_t)trace->item[id].npy.n * ts_buffer_table[id].element_bytes + 1);
	assert_non_null(data);
	assert_int_equal(ts_trace_copy(data, &trace->item[id], id), TS_OK);
	return data;
}

static ts_question launches(void)
{
	return (ts_question){.subject = TS_EXPLAIN_LAUNCHES, .kernel = TS_N_KERNELS, .most = MOST};
}

static ts_question item_of(u64 item, u64 most)
{
	return (ts_question){.subject = TS_EXPLAIN_ITEM, .kernel = TS_N_KERNELS, .item = item, .most = most};
}

static ts_question element_of(ts_buffer_id id, u64 element)
{
	return (ts_question){
		.subject = TS_EXPLAIN_ELEMENT, .kernel = TS_N_KERNELS, .buffer = id, .element = element, .most = MOST};
}

static void explained(ts_explanation *e, const char *stage, ts_question question)
{
	if (ts_explain(e, ts_stage_find(stage), &question, trace, NULL) != TS_OK) fail_msg("%s", ts_error_message());
}

/* A launch and the item that told, NULL lines if none did. */
static void told(const ts_explanation *e, size_t launch, ts_kernel kernel, u64 item, const char *first)
{
	const ts_explained_launch *l = &e->launch[launch];
	assert_true(launch < e->n_launches && l->kernel == kernel);
	assert_int_equal(l->item, item);
	assert_int_equal(l->n_lines != 0, first != NULL);
	if (first == NULL) return;
	const ts_told_line *line = &e->telling.lines[l->first_line];
	assert_true(line->depth == 0 && line->site->how == TS_TOLD_CALL);
	assert_string_equal(line->site->text, first);
}

/* Both launches of a stage have the item; or the one of the kernel that was asked for; or none. */
static void each_launch_with_the_item_tells(void **state)
{
	(void)state;
	ts_explanation e;
	u64 n = trace->item[TS_B_scene_triangle].npy.n;
	explained(&e, "split", launches());
	assert_true(e.n_launches == 2 && e.launch[0].n == n && e.launch[1].n == n && e.telling.n_lines == 0);
	told(&e, 0, TS_KERNEL_split_count, n, NULL);
	told(&e, 1, TS_KERNEL_split, n, NULL);
	ts_explain_end(&e);
	explained(&e, "split", item_of(n - 1, MOST));
	told(&e, 0, TS_KERNEL_split_count, n - 1, "ts_k_split_count_item");
	told(&e, 1, TS_KERNEL_split, n - 1, "ts_k_split_item");
	assert_true(e.launch[0].first_line == 0 && e.launch[1].first_line == e.launch[0].n_lines);
	assert_int_equal(e.launch[0].n_lines + e.launch[1].n_lines, e.telling.n_lines);
	ts_explain_end(&e);
	ts_question question = item_of(7, MOST);
	question.kernel = TS_KERNEL_split;
	explained(&e, "split", question);
	told(&e, 0, TS_KERNEL_split_count, n, NULL);
	told(&e, 1, TS_KERNEL_split, 7, "ts_k_split_item");
	ts_explain_end(&e);
}

/* The line that stores the element. */
static const ts_told_line *store_of(const ts_explanation *e, const char *element)
{
	char place[TS_VALUE_TEXT];
	assert_true(e->telling.stores < e->telling.n_lines);
	const ts_told_line *line = &e->telling.lines[e->telling.stores];
	assert_int_equal(line->site->how, TS_TOLD_STORE);
	ts_explain_place(place, e, line);
	assert_string_equal(place, element);
	return line;
}

/* Of an element only the launch tells that stores it, whichever of the stage's that is. */
static void only_the_launch_that_stores_tells(void **state)
{
	(void)state;
	ts_explanation e;
	u32 *offset = elements_of(TS_B_split_offset);
	u64 n = trace->item[TS_B_scene_triangle].npy.n;
	for (u32 triangle = 3; triangle < n; triangle += (u32)n / 3) {
		u32 count, first = offset[triangle];
		char element[TS_VALUE_TEXT];
		explained(&e, "split", element_of(TS_B_split_offset, triangle));
		told(&e, 0, TS_KERNEL_split_count, triangle, "ts_k_split_count_item");
		told(&e, 1, TS_KERNEL_split, n, NULL);
		snprintf(element, sizeof element, "split.offset:%u", (unsigned)triangle);
		memcpy(&count, e.telling.bytes + store_of(&e, element)->value, sizeof count);
		assert_int_equal(count, offset[triangle + 1] - first);
		ts_explain_end(&e);
		if (count == 0) continue;
		explained(&e, "split", element_of(TS_B_split_piece, first + count - 1));
		told(&e, 0, TS_KERNEL_split_count, n, NULL);
		told(&e, 1, TS_KERNEL_split, triangle, "ts_k_split_item");
		snprintf(element, sizeof element, "split.piece:%u", (unsigned)(first + count - 1));
		store_of(&e, element);
		ts_explain_end(&e);
	}
	free(offset);
}

/* Of the points that offer a texel their keys the one tells whose index the texel holds: others come before it and
 * behind it. */
static void the_winner_of_a_texel_tells(void **state)
{
	(void)state;
	u64 *keys = elements_of(TS_B_splat_depth_index);
	u32 n = 0;
	for (u64 texel = 0; texel < trace->item[TS_B_splat_depth_index].npy.n && n < 6; texel += 7) {
		if (keys[texel] == UINT64_MAX) continue;
		ts_explanation e;
		explained(&e, "splat", element_of(TS_B_splat_depth_index, texel));
		assert_int_equal(e.n_launches, 1);
		told(&e, 0, TS_KERNEL_splat, keys[texel] & 0xffffffffu, "ts_k_splat_item");
		ts_explain_end(&e);
		n++;
	}
	assert_int_equal(n, 6);
	free(keys);
}

/* Lines behind the most are counted; calls of primitives are more lines and change no other. */
static void lines_behind_the_most_are_counted(void **state)
{
	(void)state;
	ts_explanation all, few, deep;
	ts_question whole = item_of(1000, MOST);
	whole.primitives = true;
	explained(&all, "image", item_of(1000, MOST));
	explained(&few, "image", item_of(1000, 7));
	explained(&deep, "image", whole);
	assert_int_equal(few.telling.n_lines, 7);
	assert_int_equal(few.telling.n_lines + few.telling.n_more, all.telling.n_lines);
	assert_true(all.telling.n_more == 0 && deep.telling.n_lines > all.telling.n_lines);
	size_t k = 0;
	for (size_t i = 0; i < deep.telling.n_lines && k < all.telling.n_lines; i++) {
		k += deep.telling.lines[i].site == all.telling.lines[k].site;
	}
	assert_int_equal(k, all.telling.n_lines);
	ts_explain_end(&deep);
	ts_explain_end(&few);
	ts_explain_end(&all);
}

static void refused(const char *stage, ts_question question, const char *message)
{
	ts_explanation e;
	assert_int_equal(ts_explain(&e, ts_stage_find(stage), &question, trace, NULL), TS_ERROR);
	assert_string_equal(ts_error_message(), message);
	ts_explain_end(&e);
	ts_explain_end(&e);
}

static void items_that_are_not_there_are_refused(void **state)
{
	(void)state;
	char message[256];
	u64 n = trace->item[TS_B_scene_triangle].npy.n;
	snprintf(message, sizeof message,
	         "stage split: no launch has item %u; items of its launches: split_count %u, split %u", (unsigned)n,
	         (unsigned)n, (unsigned)n);
	refused("split", item_of(n, MOST), message);
	refused("image", item_of(48 * 32, 10), "stage image: no launch has item 1536; items of its launches: image 1536");
	ts_question other = item_of(0, 10);
	other.kernel = TS_KERNEL_splat;
	refused("image", other, "stage image: no launch has item 0; items of its launches: image 1536");
	refused("eye.view", item_of(0, 10), "stage eye.view: the host computes it, without a kernel");
	refused("eye.view", launches(), "stage eye.view: the host computes it, without a kernel");
	refused("image", element_of(TS_B_image_radiance, 48 * 32 * 3),
	        "stage image: no item writes element 4608 of image.radiance");
}

/* A bit of one input: the first line that differs is the one that reads it. */
static void the_line_that_reads_the_bit_differs(void **state)
{
	(void)state;
	size_t number;
	ts_explanation a, b;
	ts_point *points = elements_of(TS_B_points_record);
	((u8 *)&points[20].length)[0] ^= 1;
	ts_trace *candidate = ts_trace_new("candidate");
	assert_non_null(candidate);
	candidate->pipeline = trace->pipeline;
	assert_int_equal(ts_item_put(candidate, TS_B_points_record, &trace->item[TS_B_points_record].npy, points), TS_OK);
	for (u64 item = 19; item < 22; item++) {
		ts_question question = item_of(item, MOST);
		explained(&a, "splat", question);
		assert_int_equal(ts_explain(&b, ts_stage_find("splat"), &question, trace, candidate), TS_OK);
		assert_int_equal(ts_explain_differ(&number, &a, &b), item == 20);
		if (item == 20) {
			char text[TS_TOLD_TEXT];
			ts_explain_text(text, &a, number, &b);
			assert_non_null(strstr(text, "*record = .length "));
			assert_null(strstr(text, ".piece"));
		}
		ts_explain_end(&b);
		ts_explain_end(&a);
	}
	ts_trace_close(candidate);
	free(points);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_launch_with_the_item_tells),      cmocka_unit_test(only_the_launch_that_stores_tells),
		cmocka_unit_test(the_winner_of_a_texel_tells),          cmocka_unit_test(lines_behind_the_most_are_counted),
		cmocka_unit_test(items_that_are_not_there_are_refused), cmocka_unit_test(the_line_that_reads_the_bit_differs),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
