/* Which pictures of a page are judged against each other, in small pages of all kinds against the rule as written; and
 * how far apart two pictures are. */
#include <math.h>
#include "image/flip.h"
#include "kernels/base/num.h"
#include "tests/lcg.h"
#include "tests/report/pages.h"

static void add(ts_page *page, ts_page_picture p, const u8 *rgb)
{
	if (rgb != NULL) {
		p.rgb = malloc((size_t)p.width * p.height * 3);
		assert_non_null(p.rgb);
		memcpy(p.rgb, rgb, (size_t)p.width * p.height * 3);
	}
	assert_non_null(ts_page_take(page, &p, "", json_null()));
}

static bool is_paired(const ts_page *page, u32 reference, u32 image)
{
	u32 n = 0;
	for (size_t i = 0; i < json_array_size(page->pairs); i++) {
		const json_t *pair = at(page->pairs, i);
		n += number_of(pair, "reference") == reference && number_of(pair, "image") == image;
	}
	if (n > 1) fail_msg("%u is judged by %u %u times", (unsigned)image, (unsigned)reference, (unsigned)n);
	return n == 1;
}

/* ---- the rule ---- */

static bool same_frame(const ts_page_picture *a, const ts_page_picture *b)
{
	return a->folder == b->folder && strcmp(a->group, b->group) == 0 && a->rgb != NULL && b->rgb != NULL;
}

/* By its truths; where the frame has none, by the first picture that can be judged. */
static bool in_frame(const ts_page *page, u32 reference, u32 image)
{
	const ts_page_picture *p = page->picture;
	bool truths = false, earlier = false;
	if (p[image].folder == TS_NONE || p[image].truth || !same_frame(&p[reference], &p[image])) return false;
	for (u32 i = 0; i < page->n_pictures; i++) {
		truths = truths || (same_frame(&p[i], &p[image]) && p[i].truth);
		earlier = earlier || (i < reference && same_frame(&p[i], &p[image]));
	}
	return reference != image && (truths ? p[reference].truth : !earlier && reference < image);
}

/* By the picture of the first folder with the same name, the first if there are several. */
static bool across(const ts_page *page, u32 reference, u32 image)
{
	const ts_page_picture *p = page->picture;
	if (p[image].folder == TS_NONE) return reference == 0 && image > 0;
	if (p[image].folder == 0 || reference >= image) return false;
	for (u32 i = 0; i <= reference; i++) {
		bool same =
			p[i].folder == 0 && strcmp(p[i].name, p[image].name) == 0 && strcmp(p[i].group, p[image].group) == 0;
		if (same) return i == reference;
	}
	return false;
}

static bool is_right(const ts_page *page, u32 reference, u32 image)
{
	const ts_page_picture *a = &page->picture[reference], *b = &page->picture[image];
	if (a->rgb == NULL || b->rgb == NULL || a->width != b->width || a->height != b->height) return false;
	return in_frame(page, reference, image) || across(page, reference, image);
}

static void judge_page(const ts_page_picture *pictures, u32 n)
{
	static const u8 rgb[6];
	ts_page *page = new_page(0);
	for (u32 i = 0; i < n; i++) add(page, pictures[i], pictures[i].rgb != NULL ? rgb : NULL);
	require(ts_page_add_pairs(page));
	for (u32 i = 0; i < n; i++) {
		for (u32 k = 0; k < n; k++) {
			if (is_paired(page, i, k) == is_right(page, i, k)) continue;
			fail_msg("of %u pictures %u is %sjudged by %u", (unsigned)n, (unsigned)k,
			         is_right(page, i, k) ? "not " : "", (unsigned)i);
		}
	}
	ts_page_free(page);
}

/* ---- the tests ---- */

/* Pages of up to five pictures, drawn from all that matters to the rule. */
static void pairs_follow_the_rule_as_written(void **state)
{
	(void)state;
	u32 seed = 5;
	for (u32 round = 0; round < 1500; round++) {
		ts_page_picture p[5];
		u32 n = 1 + round % 5;
		for (u32 i = 0; i < n; i++) {
			u32 r = lcg_next(&seed) >> 16;
			static const u32 folders[] = {0, 0, 1, 2, TS_NONE};
			p[i] = (ts_page_picture){.name = (char *)(r & 1 ? "a" : "b"), .group = (char *)(r & 2 ? "" : "g")};
			p[i].truth = (r & 12) == 0;
			p[i].rgb = (r & 48) == 0 ? NULL : (u8 *)p;
			p[i].width = 1 + ((r >> 6 & 7) == 0);
			p[i].height = 1 + ((r >> 6 & 7) == 1);
			p[i].folder = folders[(r >> 9) % 5];
		}
		judge_page(p, n);
	}
}

static void each_pair_is_judged_once(void **state)
{
	(void)state;
	static const u8 rgb[12];
	ts_page *page = new_page(0);
	for (u32 i = 0; i < 3; i++)
		add(page, (ts_page_picture){.name = (char *)"", .group = (char *)"", .width = 2, .height = 2}, rgb);
	static const u8 asked[][2] = {{0, 1}, {0, 2}, {1, 2}, {0, 1}, {2, 1}, {1, 2}, {1, 0}};
	for (u32 i = 0; i < sizeof asked / sizeof *asked; i++) require(ts_page_add_pair(page, asked[i][0], asked[i][1]));
	assert_int_equal(json_array_size(page->pairs), 5);
	for (u32 i = 0; i < sizeof asked / sizeof *asked; i++) assert_true(is_paired(page, asked[i][0], asked[i][1]));
	ts_page_free(page);
}

static const json_t *pair_of(ts_page *page, const u8 *a, const u8 *b, u32 width, u32 height)
{
	ts_page_picture p = {.name = (char *)"", .group = (char *)"", .width = width, .height = height};
	u32 n = (u32)page->n_pictures;
	add(page, p, a);
	add(page, p, b);
	require(ts_page_add_pair(page, n, n + 1));
	return at(page->pairs, json_array_size(page->pairs) - 1);
}

static double real_of(const json_t *pair, const char *key) { return json_real_value(get(pair, key)); }

enum { W = 24, H = 16 };

/* Equal pictures are 0 apart; black and white are as far apart as can be; and the metrics are those of the library. */
static void pairs_have_the_figures_of_metrics(void **state)
{
	(void)state;
	u8 black[W * H * 3] = {0}, white[W * H * 3], noise[W * H * 3], none[W * H] = {0}, grey[W * H];
	float errors[W * H];
	double mean;
	memset(white, 255, sizeof white);
	for (u32 i = 0; i < sizeof noise; i++) noise[i] = (u8)(i * 2654435769u >> 24);
	ts_page *page = new_page(0);
	const json_t *same = pair_of(page, noise, noise, W, H);
	assert_true(real_of(same, "flip") == 0 && real_of(same, "rmse") == 0 && json_is_null(get(same, "psnr")));
	assert_true(fabs(real_of(same, "ssim") - 1) < 1e-12);
	assert_shows(get(same, "errors"), none, W, H, 1);
	const json_t *far = pair_of(page, black, white, W, H);
	assert_true(real_of(far, "rmse") == 255 && real_of(far, "psnr") == 0 && real_of(far, "flip") > 0.9);
	const json_t *some = pair_of(page, black, noise, W, H);
	ts_metrics m = ts_metrics_compare(black, noise, NULL, W, H);
	assert_true(real_of(some, "rmse") == m.rmse && real_of(some, "psnr") == m.psnr && real_of(some, "ssim") == m.ssim);
	require(ts_flip(errors, &mean, black, noise, W, H, page->ppd));
	assert_true(real_of(some, "flip") == mean);
	for (u32 i = 0; i < W * H; i++) grey[i] = (u8)lround(255 * errors[i]);
	assert_shows(get(some, "errors"), grey, W, H, 1);
	ts_page_free(page);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(pairs_follow_the_rule_as_written),
	                                   cmocka_unit_test(each_pair_is_judged_once),
	                                   cmocka_unit_test(pairs_have_the_figures_of_metrics)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
