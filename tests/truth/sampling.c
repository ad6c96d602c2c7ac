/* Of truths by some of their rays: what is asked; and what is said of long work, and that short work says nothing. */
#include "kernels/base/num.h"
#include "model/core.h"
#include "tests/model/test.h"
#include "truth/sampling.h"

/* One item of each of as many parts, as equal as may be; all in their order, if all are asked. */
static void each_part_gives_one_item(void **state)
{
	(void)state;
	for (u64 items = 1; items < 40; items++) {
		for (u64 asked = 1; asked <= items; asked++) {
			const ts_share share = {items, asked, (u32)(items * 41 + asked), 3};
			for (u64 j = 0; j < asked; j++) {
				u64 item = ts_share_item(&share, j);
				assert_true((item + 1) * asked > j * items && item * asked < (j + 1) * items);
				if (asked == items) assert_int_equal(item, j);
			}
		}
	}
}

/* Over pixels every item is asked as often as every other. */
static void every_item_is_asked_as_often(void **state)
{
	(void)state;
	enum { ITEMS = 10, ASKED = 4, PIXELS = 40000 };
	u32 count[ITEMS] = {0};
	for (u32 pixel = 0; pixel < PIXELS; pixel++) {
		const ts_share share = {ITEMS, ASKED, pixel, 0};
		for (u64 j = 0; j < ASKED; j++) count[ts_share_item(&share, j)]++;
	}
	for (u32 k = 0; k < ITEMS; k++) assert_true(abs((i32)count[k] - PIXELS * ASKED / ITEMS) < 500);
}

static void a_plan_shares_the_rays_among_pixels(void **state)
{
	(void)state;
	ts_sampling s = {.rays = 0};
	ts_sampling_plan(&s, 1000, 100, 2);
	assert_false(ts_sampling_is_part(&s));
	s.rays = 200000;
	ts_sampling_plan(&s, 1000, 100, 2);
	assert_false(ts_sampling_is_part(&s));
	s.rays = 100000;
	ts_sampling_plan(&s, 1000, 100, 2);
	assert_int_equal(s.some, 25);
	assert_int_equal(s.chance, 1u << 30);
	s.rays = 100;
	ts_sampling_plan(&s, 1000, 100, 2);
	assert_int_equal(s.some, 1);
}

/* A smaller chance chooses fewer of the same pixels, with all of their samples; other seeds choose others. */
static void a_smaller_chance_chooses_fewer_pixels(void **state)
{
	(void)state;
	enum { PIXELS = 100000 };
	const ts_sampling few = {.pixels = PIXELS, .chance = 1u << 28}, many = {.pixels = PIXELS, .chance = 1u << 30};
	const ts_sampling other = {.pixels = PIXELS, .seed = 1, .chance = 1u << 28};
	u32 n_few = 0, n_both = 0;
	for (u32 pixel = 0; pixel < PIXELS; pixel++) {
		bool is = ts_sampling_chooses(&few, pixel);
		n_few += is;
		n_both += is && ts_sampling_chooses(&other, pixel);
		if (is) assert_true(ts_sampling_chooses(&many, pixel));
		assert_int_equal(ts_sampling_chooses(&few, pixel + 3 * PIXELS), is);
	}
	assert_true(abs((i32)n_few - 6250) < 300 && n_both < 600);
}

typedef struct {
	u32 asked[1000];
} seen;

static u32 pixel_of(const void *user, u64 i)
{
	(void)user;
	return i % 3 != 0 ? (u32)i : TS_NONE;
}

static void ask(const void *user, u64 i, const ts_share *share)
{
	u32 *asked = (u32 *)(uintptr_t)((const seen *)user)->asked;
	assert_int_equal(share->pixel, i);
	asked[i] += (u32)share->asked;
}

static void only_asked_items_and_pixels_are_traced(void **state)
{
	(void)state;
	seen s = {{0}}, all = {{0}};
	ts_truth_asked asked = {
		.label = "test", .n = 1000, .items = 64, .each = 1, .pixel = pixel_of, .ask = ask, .user = &s, .threads = 2};
	ts_sampling sampling = {.rays = 666 * 16, .pixels = 1000};
	ts_truth_ask(&asked, &sampling);
	sampling.chosen = true;
	asked.user = &all;
	ts_truth_ask(&asked, &sampling);
	for (u32 i = 0; i < 1000; i++) {
		bool chosen = i % 3 != 0 && ts_sampling_chooses(&sampling, i);
		assert_int_equal(s.asked[i], i % 3 != 0 ? 8 : 0);
		assert_int_equal(all.asked[i], chosen ? 64 : 0);
	}
	asked.user = &s;
	ts_truth_ask(&asked, NULL);
	for (u32 i = 0; i < 1000; i++) assert_int_equal(s.asked[i], i % 3 != 0 ? 72 : 0);
}

static u32 every_pixel(const void *user, u64 i)
{
	(void)user;
	return (u32)i;
}

static void ask_nothing(const void *user, u64 i, const ts_share *share)
{
	(void)user;
	(void)i;
	(void)share;
}

/* The most pixels between two signs of progress, and how many signs there were on the way. */
typedef struct {
	u64 last, most, n;
} signs;

static void sign(void *user, const char *label, uint64_t done, uint64_t total)
{
	signs *s = user;
	assert_string_equal(label, "test");
	if (total == 1) return; /* begin and end */
	assert_true(total == 10000 && done > s->last);
	s->most = done - s->last > s->most ? done - s->last : s->most;
	s->last = done;
	s->n++;
}

/* Signs come after as many pixels as have a quarter of a million rays, but 256 to 4096 pixels. */
static void rays_set_the_pace_of_progress(void **state)
{
	(void)state;
	static const struct {
		u64 items, each, most, n;
	} cases[] = {{64, 64, 256, 40}, {64, 1, 4032, 3}, {16, 16, 1020, 10}, {1, 0, 4096, 3}, {1 << 20, 1, 256, 40}};
	for (u32 k = 0; k < sizeof cases / sizeof *cases; k++) {
		signs s = {0, 0, 0};
		ts_truth_asked asked = {.label = "test",
		                        .n = 10000,
		                        .items = cases[k].items,
		                        .each = cases[k].each,
		                        .pixel = every_pixel,
		                        .ask = ask_nothing,
		                        .threads = 1};
		const ts_listener before = ts_listen(&(ts_listener){.progress = sign, .user = &s});
		ts_truth_ask(&asked, NULL);
		ts_listen(&before);
		assert_int_equal(s.most, cases[k].most);
		assert_int_equal(s.n, cases[k].n);
		assert_int_equal(s.last, 10000);
	}
}

static char said[256];
static int lines;

static void line(void *user, const char *text)
{
	(void)user;
	lines++;
	strncpy(said, text, sizeof said - 1);
}

/* As if it had begun a second ago. */
static ts_work a_second_old(u64 rays)
{
	ts_work work = ts_work_begin("test", rays);
	work.begin -= 1;
	return work;
}

static void long_work_is_told_once(void **state)
{
	(void)state;
	ts_listen(&(ts_listener){.line = line});
	ts_work work = a_second_old(5000);
	lines = 0;
	ts_work_at(&work, 0, 100);
	assert_int_equal(lines, 0);
	ts_work_at(&work, 5, 100);
	ts_work_at(&work, 6, 100);
	assert_int_equal(lines, 1);
	assert_non_null(strstr(said, "test: 5000 rays, about 2"));
	work = a_second_old(0);
	ts_work_at(&work, 1, 100);
	assert_non_null(strstr(said, "test: about 1"));
}

static void short_work_says_nothing(void **state)
{
	(void)state;
	ts_listen(&(ts_listener){.line = line});
	lines = 0;
	ts_work work = a_second_old(5000), young = ts_work_begin("test", 5000);
	ts_work_at(&work, 50, 100);
	ts_work_at(&young, 1, 1000000);
	ts_work_end(&work);
	assert_int_equal(lines, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_part_gives_one_item),
		cmocka_unit_test(every_item_is_asked_as_often),
		cmocka_unit_test(a_plan_shares_the_rays_among_pixels),
		cmocka_unit_test(a_smaller_chance_chooses_fewer_pixels),
		cmocka_unit_test(only_asked_items_and_pixels_are_traced),
		cmocka_unit_test(rays_set_the_pace_of_progress),
		cmocka_unit_test(long_work_is_told_once),
		cmocka_unit_test(short_work_says_nothing),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
