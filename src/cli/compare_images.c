/* `compare` of two pictures. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <touchstone/image.h>
#include "cli/client.h"
#include "cli/compare.h"
#include "cli/reports/outcomes.h"
#include "image/format.h"
#include "image/frame.h"
#include "kernels/base/srgb.h"
#include "output/json/text.h"
#include "study/results/folder.h"

enum { LINE = 2048, SHOWN = 512 };

typedef struct {
	f32 *pixels;
	u32 width, height, channels;
	ts_image_frame frame;
	bool linear; /* radiance; otherwise sRGB codes, from 0 to 1 */
} picture;

typedef struct {
	const ts_cli *cli;
	picture p[2];
	ts_compare_options relaxed;
	u8 *mask;               /* the pixels of relaxed.mask */
	u8 *marks;              /* per pixel: 255 where a channel differs */
	u64 *first, n_first;    /* the first different values that are shown */
	u64 n_values, n_pixels; /* compared */
	u64 n_unlike, n_unlike_pixels;
	double squares, largest; /* of differences, relaxed ones too; infinite for a NaN */
	bool same;
} images;

static ts_status read_picture(picture *p, const char *path)
{
	ts_image_format format;
	if (ts_image_format_of(&format, path) != TS_OK) return TS_ERROR;
	p->linear = format == TS_IMAGE_EXR;
	return ts_image_read_framed(&p->pixels, &p->width, &p->height, &p->channels, &p->frame, path);
}

static ts_status check_sizes(const images *s)
{
	const picture *ref = &s->p[0], *cand = &s->p[1];
	const ts_compare_options *r = &s->relaxed;
	if (ref->width != cand->width || ref->height != cand->height || ref->channels != cand->channels) {
		return ts_fail("%s: %u x %u with %u channels; the reference has %u x %u with %u", s->cli->arguments[1],
		               (unsigned)cand->width, (unsigned)cand->height, (unsigned)cand->channels, (unsigned)ref->width,
		               (unsigned)ref->height, (unsigned)ref->channels);
	}
	if (r->mask == NULL || (r->mask_width == ref->width && r->mask_height == ref->height)) return TS_OK;
	return ts_fail("mask: %u x %u pixels; the images have %u x %u", (unsigned)r->mask_width, (unsigned)r->mask_height,
	               (unsigned)ref->width, (unsigned)ref->height);
}

/* The same part of the same picture, of numbers of the same kind. */
static ts_status check_frames(const images *s)
{
	const ts_image_frame *a = &s->p[0].frame, *b = &s->p[1].frame;
	const char *const *path = s->cli->arguments;
	for (u32 i = 0; i < 2; i++) {
		if (s->p[i].frame.parts > 1)
			return ts_fail("%s: %u parts; one picture a file would be right", path[i], (unsigned)s->p[i].frame.parts);
	}
	if (a->whole != b->whole)
		return ts_fail("%s: other channels of whole numbers than those of the reference", path[1]);
	if (s->p[0].linear != s->p[1].linear) return TS_OK;
	if (memcmp(a->window, b->window, sizeof a->window) != 0)
		return ts_fail("%s: begins at pixel %d,%d of the picture; the reference at %d,%d", path[1], b->window[0],
		               b->window[1], a->window[0], a->window[1]);
	if (memcmp(a->display, b->display, sizeof a->display) == 0) return TS_OK;
	return ts_fail("%s: part of a picture of %d,%d,%d,%d; the reference of %d,%d,%d,%d", path[1], b->display[0],
	               b->display[1], b->display[2], b->display[3], a->display[0], a->display[1], a->display[2],
	               a->display[3]);
}

static bool is_whole(const images *s, u64 value) { return s->p[0].frame.whole >> value % s->p[0].channels & 1; }

static u32 whole_of(f32 bits)
{
	u32 code;
	memcpy(&code, &bits, sizeof code);
	return code;
}

/* CONTRACT rule 38. */
static void display(picture *p, f32 exposure)
{
	for (size_t i = 0; p->linear && i < (size_t)p->width * p->height * p->channels; i++) {
		p->pixels[i] = (f32)ts_srgb_byte(p->pixels[i] * exposure) / 255.0f;
	}
}

static ts_status make_comparable(images *s)
{
	const char *const *path = s->cli->arguments;
	u32 linear = s->p[0].linear ? 0 : 1;
	if (!s->cli->given[TS_OPTION_EXPOSURE]) {
		if (s->p[0].linear == s->p[1].linear) return TS_OK;
		return ts_fail(
			"%s holds linear radiance, and %s sRGB codes; --exposure 1 compares them as a display shows them",
			path[linear], path[1 - linear]);
	}
	if (s->cli->job.exposed) return ts_fail("--exposure auto: needs a scene; give the factor of the rendered picture");
	if (!s->p[linear].linear)
		return ts_fail("--exposure: %s and %s both hold sRGB codes; leave it out", path[0], path[1]);
	if (s->p[linear].channels != 1 && s->p[linear].channels != 3) {
		return ts_fail("--exposure: %s has %u channels; expected 1 or 3, as alpha is not shown", path[linear],
		               (unsigned)s->p[linear].channels);
	}
	for (u32 i = 0; i < 2; i++) display(&s->p[i], TS_PARAM(&s->cli->job.params, image_exposure));
	return TS_OK;
}

static ts_status open_images(images *s)
{
	for (u32 i = 0; i < 2; i++) {
		if (read_picture(&s->p[i], s->cli->arguments[i]) != TS_OK) return TS_ERROR;
	}
	if (make_comparable(s) != TS_OK || ts_client_options(&s->relaxed, &s->mask, s->cli) != TS_OK) return TS_ERROR;
	if (check_sizes(s) != TS_OK || check_frames(s) != TS_OK) return TS_ERROR;
	s->marks = ts_alloc_zero(s->p[0].width, s->p[0].height, "a picture of differences");
	s->first = ts_alloc(s->cli->judging.first, sizeof *s->first, "first differences");
	return s->marks != NULL && s->first != NULL ? TS_OK : TS_ERROR;
}

static double distance(f32 ref, f32 cand)
{
	double apart = ref == cand ? 0 : fabs((double)ref - (double)cand);
	return isnan(apart) ? INFINITY : apart;
}

static void judge_pixel(images *s, u64 pixel)
{
	u32 channels = s->p[0].channels;
	for (u64 i = pixel * channels; i < (pixel + 1) * channels; i++) {
		f32 ref = s->p[0].pixels[i], cand = s->p[1].pixels[i];
		bool whole = is_whole(s, i), same = whole && whole_of(ref) == whole_of(cand);
		double apart = whole ? fabs((double)whole_of(ref) - (double)whole_of(cand)) : distance(ref, cand);
		s->squares += apart * apart;
		s->largest = fmax(s->largest, apart);
		if (same || (whole ? apart <= s->relaxed.abs : ts_float_passes(&s->relaxed, ref, cand))) continue;
		if (s->n_first < s->cli->judging.first) s->first[s->n_first++] = i;
		s->n_unlike++;
		s->marks[pixel] = 255;
	}
	s->n_pixels++;
	s->n_values += channels;
	s->n_unlike_pixels += s->marks[pixel] != 0;
}

static double rmse_of(const images *s) { return sqrt(s->squares / (double)s->n_values); }
static double percent_of(const images *s) { return 100.0 * (double)s->n_unlike_pixels / (double)s->n_pixels; }

/* All given tolerances hold; without any, nothing differs. */
static bool passes(const images *s)
{
	const bool *given = s->cli->given;
	const ts_tolerances *t = &s->cli->judging.tolerances;
	if (!given[TS_OPTION_PERCENT] && !given[TS_OPTION_HARDFAIL] && !given[TS_OPTION_RMSE]) {
		return s->n_unlike <= s->relaxed.allow;
	}
	return (!given[TS_OPTION_ALLOW] || s->n_unlike <= s->relaxed.allow) &&
	       (!given[TS_OPTION_PERCENT] || percent_of(s) <= t->percent) &&
	       (!given[TS_OPTION_HARDFAIL] || s->largest <= t->hardfail) &&
	       (!given[TS_OPTION_RMSE] || rmse_of(s) <= t->rmse);
}

static ts_status judge(images *s)
{
	const u8 *mask = s->relaxed.mask;
	for (u64 i = 0; i < (u64)s->p[0].width * s->p[0].height; i++) {
		if (mask == NULL || mask[i] != 0) judge_pixel(s, i);
	}
	if (s->n_pixels == 0) return ts_fail("%s: black everywhere: nothing to judge", s->cli->judging.mask);
	s->same = passes(s);
	return TS_OK;
}

/* Where and how a value differs. */
static void show(char text[SHOWN], const images *s, u64 value)
{
	char ref[TS_FLOAT_TEXT], cand[TS_FLOAT_TEXT];
	u64 pixel = value / s->p[0].channels;
	for (u32 k = 0; k < 2; k++) {
		f32 v = s->p[k].pixels[value];
		if (is_whole(s, value))
			snprintf(k == 0 ? ref : cand, TS_FLOAT_TEXT, "%u", (unsigned)whole_of(v));
		else
			ts_float_text(k == 0 ? ref : cand, v);
	}
	snprintf(text, SHOWN, "pixel (%" PRIu64 ", %" PRIu64 "), channel %" PRIu64 ": ref %s candidate %s",
	         pixel % s->p[0].width, pixel / s->p[0].width, value % s->p[0].channels, ref, cand);
}

static void sum_up(char text[LINE], const images *s)
{
	char relaxed[TS_RELAXED_TEXT];
	ts_relaxed_text(relaxed, s->cli);
	snprintf(text, LINE,
	         "%" PRIu64 " values, %" PRIu64 " different in %.4g %% of the pixels, largest difference %.9g, root mean "
	         "square %.9g%s%s",
	         s->n_values, s->n_unlike, percent_of(s), s->largest, rmse_of(s), relaxed[0] != 0 ? "; relaxed: " : "",
	         relaxed);
}

/* Line i of the report: the figures, then the first differences. False: there are no more. */
static bool line_of(char text[LINE], const images *s, u64 i)
{
	char first[SHOWN];
	if (i == 0) sum_up(text, s);
	if (i == 0 || i > s->n_first) return i == 0;
	show(first, s, s->first[i - 1]);
	if (i == 1) snprintf(text, LINE, "%s — first of %" PRIu64, first, s->n_unlike);
	if (i > 1) snprintf(text, LINE, "  %s", first);
	return true;
}

static json_t *number(double value) { return isfinite(value) ? json_real(value) : json_null(); }

static void put_values(ts_report *report, const images *s)
{
	char relaxed[TS_RELAXED_TEXT];
	ts_relaxed_text(relaxed, s->cli);
	ts_report_value(report, "reference", ts_text_json(s->cli->arguments[0]));
	ts_report_value(report, "candidate", ts_text_json(s->cli->arguments[1]));
	ts_report_value(report, "verdict", json_string(s->same ? "same" : "different"));
	ts_report_value(report, "relaxations", ts_text_json(relaxed));
	if (s->cli->given[TS_OPTION_EXPOSURE]) {
		ts_report_value(report, "exposure", json_real((double)TS_PARAM(&s->cli->job.params, image_exposure)));
	}
	ts_report_value(report, "values", json_integer((json_int_t)s->n_values));
	ts_report_value(report, "different", json_integer((json_int_t)s->n_unlike));
	ts_report_value(report, "pixels", json_integer((json_int_t)s->n_pixels));
	ts_report_value(report, "pixels_different", json_integer((json_int_t)s->n_unlike_pixels));
	ts_report_value(report, "largest", number(s->largest));
	ts_report_value(report, "root_mean_square", number(rmse_of(s)));
}

static void report_images(ts_report *report, const void *user)
{
	const images *s = user;
	char text[LINE], shown[SHOWN];
	json_t *first = json_array();
	for (u64 i = 0; line_of(text, s, i); i++) ts_report_line(report, "%s", text);
	put_values(report, s);
	for (u64 i = 0; i < s->n_first; i++) {
		u64 pixel = s->first[i] / s->p[0].channels;
		show(shown, s, s->first[i]);
		json_t *value =
			json_pack("{s:s, s:I, s:I, s:I}", "line", shown, "x", (json_int_t)(pixel % s->p[0].width), "y",
		              (json_int_t)(pixel / s->p[0].width), "channel", (json_int_t)(s->first[i] % s->p[0].channels));
		report->failed |= json_array_append_new(first, value) != 0;
	}
	ts_report_value(report, "first", first);
}

/* White where the images differ, so that it masks everything else. */
static ts_status draw(const void *user)
{
	const images *s = user;
	const char *path = s->n_unlike > 0 ? ts_folder_file("difference.png") : NULL;
	if (path == NULL) return s->n_unlike > 0 ? TS_ERROR : TS_OK;
	return ts_image_write_png(path, s->marks, s->p[0].width, s->p[0].height, 1, NULL);
}

/* As a display shows it; one or two channels are grey, and the last of two or four is alpha. */
static ts_status show_picture(ts_html *page, const picture *p, const char *path)
{
	const u32 colours = p->channels < 3 ? 1 : 3;
	const size_t n = (size_t)p->width * p->height;
	u8 *rgb = ts_alloc(n, 3, path);
	if (rgb == NULL) return TS_ERROR;
	for (size_t i = 0; i < n * 3; i++) {
		f32 v = p->pixels[i / 3 * p->channels + (colours == 3 ? i % 3 : 0)];
		rgb[i] = (u8)(p->linear ? (f32)ts_srgb_byte(v) : v * 255.0f + 0.5f);
	}
	ts_status status = ts_html_add_picture(page, path, path, rgb, p->width, p->height);
	free(rgb);
	return status;
}

static ts_status put_images(ts_html *page, const char *json, const void *user)
{
	const images *s = user;
	for (u32 i = 0; i < 2; i++) {
		if (show_picture(page, &s->p[i], s->cli->arguments[i]) != TS_OK) return TS_ERROR;
	}
	return ts_html_add_pair(page, json);
}

static ts_status show_images(const ts_cli *cli, const char *json, const void *user)
{
	return ts_client_page(cli, json, put_images, user);
}

static ts_status report_outcomes(ts_cli *cli, const images *s)
{
	ts_outcomes outcomes;
	char text[LINE], relaxed[TS_RELAXED_TEXT];
	const ts_status found = s->same ? TS_OK : TS_DIFFERENT;
	const ts_outcomes_output output = {"compare",     &outcomes, relaxed, NULL,        found,
	                                   report_images, false,     draw,    show_images, s};
	ts_relaxed_text(relaxed, cli);
	ts_status status = ts_outcomes_begin(&outcomes, "image", "touchstone.images");
	if (status == TS_OK) {
		ts_outcomes_add(&outcomes, cli->arguments[1], s->same ? "same" : "different", s->same ? TS_PASSED : TS_FAILED,
		                "", ts_seconds() - cli->began);
		for (u64 i = 0; line_of(text, s, i); i++) ts_outcomes_line(&outcomes, text);
		status = ts_outcomes_report(cli, &output, true);
	}
	ts_outcomes_end(&outcomes);
	return status;
}

ts_status ts_compare_images(ts_cli *cli)
{
	images s = {.cli = cli};
	ts_status status = open_images(&s);
	if (status == TS_OK) status = judge(&s);
	if (status == TS_OK) status = report_outcomes(cli, &s);
	free(s.p[0].pixels);
	free(s.p[1].pixels);
	free(s.mask);
	free(s.marks);
	free(s.first);
	return status == TS_OK && !s.same ? TS_DIFFERENT : status;
}
