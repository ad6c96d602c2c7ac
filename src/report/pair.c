/* Distances between two pictures of a page. */
#include <math.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "image/flip.h"
#include "report/page.h"

static bool has(const ts_page *page, size_t reference, size_t image)
{
	for (size_t i = 0; i < json_array_size(page->pairs); i++) {
		const json_t *pair = json_array_get(page->pairs, i);
		if (json_integer_value(json_object_get(pair, "reference")) == (json_int_t)reference &&
		    json_integer_value(json_object_get(pair, "image")) == (json_int_t)image) {
			return true;
		}
	}
	return false;
}

/* FLIP's errors as grey levels. */
static json_t *draw(const float *errors, u32 width, u32 height, const char *what)
{
	u8 *grey = ts_alloc(width, height, what);
	if (grey == NULL) return NULL;
	for (size_t i = 0; i < (size_t)width * height; i++) grey[i] = (u8)(255 * fminf(errors[i], 1) + 0.5f);
	json_t *png = ts_page_png(grey, width, height, 1, what);
	free(grey);
	return png;
}

ts_status ts_page_add_pair(ts_page *page, size_t reference, size_t image)
{
	const ts_page_picture *a = &page->picture[reference], *b = &page->picture[image];
	const u32 width = a->width, height = a->height;
	double mean;
	if (a->rgb == NULL || b->rgb == NULL || b->width != width || b->height != height || has(page, reference, image)) {
		return TS_OK;
	}
	float *errors = ts_alloc((size_t)width * height, sizeof *errors, "FLIP");
	if (errors == NULL) return TS_ERROR;
	ts_status status = ts_flip(errors, &mean, a->rgb, b->rgb, width, height, page->ppd);
	json_t *png = status == TS_OK ? draw(errors, width, height, b->name) : NULL;
	free(errors);
	if (png == NULL) return TS_ERROR;
	ts_metrics m = ts_metrics_compare(a->rgb, b->rgb, NULL, width, height);
	json_t *psnr = isfinite(m.psnr) ? json_real(m.psnr) : json_null();
	ts_page_append(page, page->pairs,
	               json_pack("{s:I, s:I, s:f, s:f, s:o, s:f, s:o}", "reference", (json_int_t)reference, "image",
	                         (json_int_t)image, "flip", mean, "rmse", m.rmse, "psnr", psnr, "ssim", m.ssim, "errors",
	                         png));
	return ts_page_check(page);
}

static bool are_of_a_frame(const ts_page_picture *a, const ts_page_picture *b)
{
	return a->rgb != NULL && b->rgb != NULL && a->folder == b->folder && strcmp(a->group, b->group) == 0;
}

/* A picture is judged by every truth of its frame, otherwise by the first picture. */
static ts_status pair_in_group(ts_page *page, size_t image)
{
	const ts_page_picture *p = page->picture;
	size_t first = image;
	bool truths = false;
	ts_status status = TS_OK;
	for (size_t i = page->n_pictures; i-- > 0;) {
		if (!are_of_a_frame(&p[i], &p[image])) continue;
		truths |= p[i].truth;
		if (i < first) first = i;
	}
	for (size_t i = 0; i < page->n_pictures && status == TS_OK && !p[image].truth; i++) {
		if (i == image || !are_of_a_frame(&p[i], &p[image])) continue;
		if (truths ? p[i].truth : i == first) status = ts_page_add_pair(page, i, image);
	}
	return status;
}

/* A folder's picture is paired with the first folder's of that name, any other with the page's first. */
static ts_status pair_with_first(ts_page *page, size_t image)
{
	const ts_page_picture *p = page->picture;
	if (p[image].folder == TS_NONE) return image > 0 ? ts_page_add_pair(page, 0, image) : TS_OK;
	for (size_t i = 0; i < image; i++) {
		bool same = strcmp(p[i].name, p[image].name) == 0 && strcmp(p[i].group, p[image].group) == 0;
		if (same && p[i].folder == 0) return ts_page_add_pair(page, i, image);
	}
	return TS_OK;
}

ts_status ts_page_add_pairs(ts_page *page)
{
	ts_status status = TS_OK;
	for (size_t i = 0; i < page->n_pictures && status == TS_OK; i++) {
		u32 folder = page->picture[i].folder;
		ts_progress("FLIP", i, page->n_pictures);
		if (folder != TS_NONE) status = pair_in_group(page, i);
		if (status == TS_OK && folder > 0) status = pair_with_first(page, i);
	}
	ts_progress("FLIP", 1, 1);
	return status;
}
