/* Where a candidate's pictures differ: each pixel has the first buffer that differs there, in the pipeline's order; the
 * first differences have their pixel; and as many pixels as there is room for are probed, on both sides. */
#include "tests/report/pages.h"
#include "tests/trace/small.h"
#include "trace/emitted/emit.h"

enum { W = 64, H = 36, MOST = 9 };

static int begin(void **state)
{
	ts_params params = small_params();
	if (scratch_begin(state) != 0) return -1;
	ts_scene *scene = small_scene(&params);
	small_trace(scratch_path("a"), "epr", scene, &params, (ts_trace_options){.margins = false});
	small_copy(scratch_path("b"), scratch_path("a"));
	params.width = 32;
	small_trace(scratch_path("small"), "epr", scene, &params, (ts_trace_options){.margins = false});
	ts_scene_free(scene);
	return 0;
}

/* Two traces of equal files, of which the second is changed in memory. */
typedef struct {
	ts_trace *a, *b;
	void *changed[TS_N_BUFFERS];
} sides;

static void open_both(sides *s)
{
	*s = (sides){.a = NULL};
	require(ts_trace_open_folder(&s->a, scratch_path("a")));
	require(ts_trace_open_folder(&s->b, scratch_path("b")));
}

static void close_both(sides *s)
{
	ts_trace_close(s->a);
	ts_trace_close(s->b);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) free(s->changed[id]);
}

/* Flips the lowest bit of an element. */
static void flip(sides *s, ts_buffer_id id, u64 element)
{
	const size_t size = ts_buffer_table[id].element_bytes;
	ts_trace_item *item = &s->b->item[id];
	if (s->changed[id] == NULL) {
		s->changed[id] = malloc((size_t)item->npy.n * size);
		assert_non_null(s->changed[id]);
		require(ts_trace_copy(s->changed[id], item, id));
		item->memory = s->changed[id];
	}
	assert_true(element < item->npy.n);
	((u8 *)s->changed[id])[element * size] ^= 1;
}

/* What compare --json says, as far as a page reads it. */
static json_t *said_of(const ts_comparison *c)
{
	json_t *list = json_array();
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_verdict *v = &c->verdict[id];
		if (v->judgement != TS_UNLIKE) continue;
		json_t *first = json_array();
		json_array_append_new(first, json_pack("{s:s}", "where", "a record without a partner"));
		for (u32 i = 0; i < v->list.n; i++) {
			json_int_t element = (json_int_t)v->list.items[i].difference.element;
			json_array_append_new(first, json_pack("{s:I}", "element", element));
		}
		json_array_append_new(list, json_pack("{s:s, s:o}", "buffer", ts_buffer_table[id].name, "first", first));
	}
	return json_pack("{s:o}", "differences", list);
}

/* The page of both sides; its first differences have a pixel only where `listed`. */
static ts_page *page_of(const sides *s, u32 n_probes, bool listed)
{
	ts_page *page = new_page(n_probes);
	ts_comparison *c = ts_comparison_make(listed ? MOST : 0);
	const ts_relaxations none = {0};
	if (ts_compare_traces(c, s->a, s->b, &none) == TS_ERROR) fail_msg("%s", ts_error_message());
	json_t *said = said_of(c);
	require(ts_page_add_trace(page, s->a));
	require(ts_page_add_trace(page, s->b));
	require(ts_page_add_comparison(page, c, s->a, s->b, &none, said));
	json_decref(said);
	ts_comparison_free(c);
	return page;
}

static bool is_of_pixels(const ts_trace *trace, ts_buffer_id id)
{
	const ts_trace_item *item = &trace->item[id];
	return item->path != NULL && item->npy.n > 0 && ts_shape_is_image(ts_buffer_shape(id)) && item->npy.n_dims >= 2 &&
	       item->npy.shape[1] == W && item->npy.shape[0] % H == 0;
}

static u64 a_pixel(const ts_trace *trace, ts_buffer_id id)
{
	const ts_npy *npy = &trace->item[id].npy;
	return npy->n / (npy->shape[0] * npy->shape[1]);
}

/* The marks of the page, one per pixel. */
static u8 *marks_of(const json_t *o)
{
	u32 width, height;
	u8 *rgba = pixels_of(get(o, "firsts"), &width, &height);
	assert_true(width == W && height == H);
	for (u32 i = 0; i < W * H; i++) rgba[i] = rgba[4 * i];
	return rgba;
}

static bool is_probed(const json_t *o, u32 pixel)
{
	u32 n = 0;
	for (size_t i = 0; i < json_array_size(get(o, "probes")); i++) {
		const json_t *probe = at(get(o, "probes"), i);
		n += number_of(probe, "x") == pixel % W && number_of(probe, "y") == pixel / W;
	}
	assert_true(n <= 1);
	return n == 1;
}

/* ---- layers ---- */

/* A difference in each buffer of pixels, each in a pixel of its own, and one pixel where all differ. */
static void each_buffer_of_pixels_has_its_layer(void **state)
{
	(void)state;
	sides s;
	ts_buffer_id ids[TS_N_BUFFERS], of[W * H];
	u32 n = 0, common = 7 * W + 3;
	open_both(&s);
	ts_emit_order(ids, s.a->pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS; i++) {
		if (!is_of_pixels(s.a, ids[i])) continue;
		u64 all = s.a->item[ids[i]].npy.n, own = (u64)(20 * W + 5 + 2 * n) * a_pixel(s.a, ids[i]);
		u64 images = s.a->item[ids[i]].npy.shape[0] / H;
		flip(&s, ids[i], own + (images - 1) * (all / images) + a_pixel(s.a, ids[i]) - 1);
		flip(&s, ids[i], common * a_pixel(s.a, ids[i]));
		of[n++] = ids[i];
	}
	assert_true(n >= 3);
	ts_page *page = page_of(&s, 0, true);
	const json_t *o = at(page->comparisons, 0), *layers = get(o, "layers");
	u8 *marks = marks_of(o);
	assert_int_equal(json_array_size(layers), n);
	for (u32 i = 0; i < n; i++) {
		assert_string_equal(text_of(at(layers, i), "buffer"), ts_buffer_table[of[i]].name);
		assert_int_equal(number_of(at(layers, i), "pixels"), i == 0 ? 2 : 1);
		assert_int_equal(marks[20 * W + 5 + 2 * i], i + 1);
	}
	assert_int_equal(marks[common], 1);
	u32 marked = 0;
	for (u32 i = 0; i < W * H; i++) marked += marks[i] != 0;
	assert_int_equal(marked, n + 1);
	assert_int_equal(json_array_size(get(o, "probes")), 0);
	free(marks);
	ts_page_free(page);
	close_both(&s);
}

/* A buffer that differs but is none of pixels is no layer. */
static void a_buffer_without_pixels_has_no_layer(void **state)
{
	(void)state;
	sides s;
	open_both(&s);
	flip(&s, TS_B_points_record, 1);
	ts_page *page = page_of(&s, 5, true);
	const json_t *o = at(page->comparisons, 0);
	assert_int_equal(json_array_size(get(get(o, "said"), "differences")), 1);
	assert_int_equal(json_array_size(get(o, "layers")), 0);
	assert_int_equal(json_array_size(get(o, "probes")), 0);
	u8 *marks = marks_of(o);
	for (u32 i = 0; i < W * H; i++) assert_int_equal(marks[i], 0);
	free(marks);
	ts_page_free(page);
	close_both(&s);
}

/* ---- probes ---- */

/* The first differences have their pixel, which is probed on both sides; and the comparison names both pictures. */
static void first_differences_are_probed_on_both_sides(void **state)
{
	(void)state;
	static const u32 pixels[] = {3, 5 * W + 60, 30 * W + 1};
	sides s;
	open_both(&s);
	for (u32 i = 0; i < 3; i++) flip(&s, TS_B_image_srgb, 3 * pixels[i] + i);
	ts_page *page = page_of(&s, 8, true);
	const json_t *o = at(page->comparisons, 0), *first = get(at(get(get(o, "said"), "differences"), 0), "first");
	assert_int_equal(json_array_size(first), 4);
	assert_false(has_key(at(first, 0), "x") || has_key(at(first, 0), "y"));
	assert_int_equal(json_array_size(get(o, "probes")), 3);
	for (u32 i = 0; i < 3; i++) {
		const json_t *probe = at(get(o, "probes"), i);
		assert_true(number_of(at(first, i + 1), "x") == pixels[i] % W &&
		            number_of(at(first, i + 1), "y") == pixels[i] / W);
		assert_true(is_probed(o, pixels[i]));
		for (u32 side = 0; side < 2; side++) {
			const json_t *answer = get(probe, side == 0 ? "reference" : "candidate"), *asked = get(answer, "pixel");
			assert_int_equal(json_integer_value(at(asked, 0)), number_of(probe, "x"));
			assert_int_equal(json_integer_value(at(asked, 1)), number_of(probe, "y"));
		}
	}
	assert_true(number_of(o, "reference") == 0 && number_of(o, "image") == 1);
	assert_true(json_array_size(page->pairs) == 1 && number_of(at(page->pairs, 0), "image") == 1);
	ts_page_free(page);
	close_both(&s);
}

/* Of a part of the eye's picture the pixel that is asked of is the eye's. */
static void parts_ask_at_the_eyes_pixel(void **state)
{
	(void)state;
	sides s;
	open_both(&s);
	flip(&s, TS_B_image_srgb, 3 * (4 * W + 10));
	s.a->item[TS_B_image_srgb].crop[0] = s.b->item[TS_B_image_srgb].crop[0] = 20;
	s.a->item[TS_B_image_srgb].crop[1] = s.b->item[TS_B_image_srgb].crop[1] = 3;
	ts_page *page = page_of(&s, 1, true);
	const json_t *probe = at(get(at(page->comparisons, 0), "probes"), 0),
				 *asked = get(get(probe, "reference"), "pixel");
	assert_true(number_of(probe, "x") == 10 && number_of(probe, "y") == 4);
	assert_true(json_integer_value(at(asked, 0)) == 30 && json_integer_value(at(asked, 1)) == 7);
	ts_page_free(page);
	close_both(&s);
}

/* Of `n` pixels that differ `room` are probed: all if they fit, else evenly spread. */
static void judge_spread(u32 n, u32 room, bool listed)
{
	sides s;
	open_both(&s);
	for (u32 i = 0; i < n; i++) flip(&s, TS_B_image_srgb, 3 * (10 * W + 3 * i) + 1);
	ts_page *page = page_of(&s, room, listed);
	const json_t *o = at(page->comparisons, 0);
	const u32 firsts = listed ? MOST < room ? MOST : room : 0;
	u32 probed = 0, gap = 0, least = n, most = 0;
	for (u32 i = 0; i < n; i++) {
		bool is = is_probed(o, 10 * W + 3 * i);
		probed += is;
		if (i < firsts) assert_true(is);
		if (i < firsts) continue;
		gap++;
		if (!is) continue;
		if (probed > firsts + 1 && gap < least) least = gap;
		if (probed > firsts + 1 && gap > most) most = gap;
		gap = 0;
	}
	assert_int_equal(json_array_size(get(o, "probes")), room < n ? room : n);
	assert_int_equal(probed, room < n ? room : n);
	if (most > least + 1)
		fail_msg("of %u, %u: from %u to %u apart", (unsigned)n, (unsigned)room, (unsigned)least, (unsigned)most);
	ts_page_free(page);
	close_both(&s);
}

static void probes_are_spread_evenly(void **state)
{
	(void)state;
	judge_spread(40, 40, false);
	judge_spread(40, 41, false);
	judge_spread(40, 7, false);
	judge_spread(41, 20, false);
	judge_spread(40, 30, true);
	judge_spread(40, 12, true);
	judge_spread(40, 3, true);
}

static void a_side_without_probe_says_why(void **state)
{
	(void)state;
	sides s;
	open_both(&s);
	flip(&s, TS_B_image_srgb, 3 * (4 * W + 10));
	s.b->has_params = false;
	ts_page *page = page_of(&s, 1, true);
	const json_t *probe = at(get(at(page->comparisons, 0), "probes"), 0);
	assert_true(has_key(get(probe, "reference"), "pixel"));
	assert_non_null(strstr(text_of(get(probe, "candidate"), "none"), scratch_path("b")));
	ts_page_free(page);
	close_both(&s);
}

/* ---- comparisons that show no pixels ---- */

static void comparisons_without_pixels_show_none(void **state)
{
	(void)state;
	for (u32 i = 0; i < 3; i++) {
		ts_page *page = new_page(5);
		ts_comparison *c = ts_comparison_make(0);
		const ts_relaxations none = {0};
		ts_trace *a, *b;
		json_t *said = json_pack("{s:s}", "first_divergence", "<somewhere>");
		require(ts_trace_open_folder(&a, scratch_path("a")));
		require(ts_trace_open_folder(&b, scratch_path("%s", i == 0 ? "small" : "b")));
		if (i == 1) b->item[TS_B_image_srgb].path = b->item[TS_B_image_radiance].path = NULL;
		require(ts_page_add_trace(page, a));
		if (i != 2) require(ts_page_add_trace(page, b));
		require(ts_page_add_comparison(page, c, a, b, &none, said));
		const json_t *o = at(page->comparisons, 0);
		assert_true(json_equal(get(o, "said"), said) && get(o, "said") != said);
		assert_int_equal(json_object_size(o), 1);
		assert_int_equal(json_array_size(page->pairs), 0);
		json_decref(said);
		ts_page_free(page);
		ts_comparison_free(c);
		ts_trace_close(a);
		ts_trace_close(b);
	}
}

static void two_images_are_compared_as_pictures(void **state)
{
	(void)state;
	static const u8 rgb[12];
	ts_page *page = new_page(5);
	json_t *said = json_pack("{s:s}", "verdict", "same");
	for (u32 i = 0; i < 3; i++) require(ts_page_add_picture(page, "p", "", rgb, 2, 2));
	require(ts_page_add_picture_comparison(page, said));
	const json_t *o = at(page->comparisons, 0);
	assert_true(number_of(o, "reference") == 1 && number_of(o, "image") == 2 && json_equal(get(o, "said"), said));
	assert_true(json_array_size(page->pairs) == 1 && number_of(at(page->pairs, 0), "reference") == 1);
	json_decref(said);
	ts_page_free(page);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_buffer_of_pixels_has_its_layer),
		cmocka_unit_test(a_buffer_without_pixels_has_no_layer),
		cmocka_unit_test(first_differences_are_probed_on_both_sides),
		cmocka_unit_test(parts_ask_at_the_eyes_pixel),
		cmocka_unit_test(probes_are_spread_evenly),
		cmocka_unit_test(a_side_without_probe_says_why),
		cmocka_unit_test(comparisons_without_pixels_show_none),
		cmocka_unit_test(two_images_are_compared_as_pictures),
	};
	return cmocka_run_group_tests(tests, begin, scratch_remove);
}
