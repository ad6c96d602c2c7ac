/* `compare REFERENCE CANDIDATE`: two traces, two buffers or two images. */
#include "compare.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <touchstone/image.h>
#include "../replay/forced.h"
#include "compare_images.h"
#include "../study/folder.h"

static bool ends_in(const char *path, const char *suffix)
{
	size_t n = strlen(path), m = strlen(suffix);
	return n > m && strcmp(path + n - m, suffix) == 0;
}

typedef struct {
	ts_trace *reference, *candidate;
	u8 *mask;
	ts_relaxations relaxations;
} sides;

static ts_status open_sides(sides *s, const ts_cli *cli)
{
	const char *ref = cli->arguments[0], *cand = cli->arguments[1];
	if (cli->given[TS_OPTION_ORDER] && cli->judging.layout == NULL) {
		return ts_fail("--order: only with --layout; a trace.json has its own");
	}
	if (ends_in(ref, ".npy")) {
		ts_buffer_id a, b;
		if (ts_trace_open_file(&s->reference, ref, &a) != TS_OK) return TS_ERROR;
		if (ts_trace_open_file(&s->candidate, cand, &b) != TS_OK) return TS_ERROR;
		if (a == b) return TS_OK;
		return ts_fail("%s: holds %s, and the reference %s", cand, ts_buffer_table[b].name, ts_buffer_table[a].name);
	}
	if (ts_trace_open(&s->reference, ref) != TS_OK) return TS_ERROR;
	const char *layout = cli->judging.layout;
	if (layout == NULL) return ts_trace_open(&s->candidate, cand);
	return ts_trace_open_layout(&s->candidate, cand, layout, cli->job.how.arrival, s->reference);
}

/* 1 where the picture is not black. */
static ts_status read_mask(sides *s, const char *path)
{
	f32 *pixels;
	u32 width, height, channels;
	if (path == NULL) return TS_OK;
	if (ts_image_read(&pixels, &width, &height, &channels, path) != TS_OK) return TS_ERROR;
	s->mask = ts_alloc_zero((size_t)width, height, "a mask");
	for (size_t i = 0; s->mask != NULL && i < (size_t)width * height * channels; i++) {
		if (pixels[i] > 0.0f) s->mask[i / channels] = 1;
	}
	free(pixels);
	s->relaxations.mask = s->mask;
	s->relaxations.mask_width = width;
	s->relaxations.mask_height = height;
	return s->mask != NULL ? TS_OK : TS_ERROR;
}

/* A picture of the pixels where a buffer of rows and columns differs: white. */
static ts_status draw_marks(const sides *s, ts_buffer_id id)
{
	const ts_npy *npy = &s->reference->item[id].npy;
	u64 pixels = npy->shape[0] * npy->shape[1], every = npy->n / pixels;
	const ts_order same = {.given = false};
	char name[96];
	ts_verdict v = {.marks = ts_alloc_zero((size_t)npy->n, 1, "a picture of differences")};
	if (v.marks == NULL) return TS_ERROR;
	ts_status status = ts_compare_buffer(&v, id, s->reference, s->candidate, &same, &s->relaxations);
	for (u64 i = 0; i < npy->n; i++) {
		u8 mark = v.marks[i] != 0 ? 255 : 0;
		if (i % every == 0) v.marks[i / every] = mark;
		v.marks[i / every] |= mark;
	}
	snprintf(name, sizeof name, "%s.png", ts_buffer_table[id].name);
	const char *path = status == TS_OK ? ts_folder_file(name) : NULL;
	status = path != NULL ? ts_image_write_png(path, v.marks, (u32)npy->shape[1], (u32)npy->shape[0], 1) : TS_ERROR;
	free(v.marks);
	return status;
}

static ts_status draw_all(const sides *s, const ts_comparison *c, ts_report *report)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool pixels = ts_shape_is_image(ts_buffer_shape(id));
		if (!pixels || c->verdict[id].judgement != TS_UNLIKE || s->reference->item[id].npy.n == 0) continue;
		if (draw_marks(s, (ts_buffer_id)id) != TS_OK) return TS_ERROR;
	}
	ts_report_value(report, "program", json_string(ts_program));
	return ts_results_report(report) == TS_OK ? ts_folder_commit() : TS_ERROR;
}

static ts_status tell(const sides *s, const ts_comparison *c, const ts_cli *cli)
{
	ts_report report;
	ts_report_begin(&report, cli->job.output.json);
	ts_compare_report(&report, c, s->reference, s->candidate, &cli->judging);
	ts_status status = ts_report_check(&report);
	if (status == TS_OK && cli->judging.junit != NULL) status = ts_compare_junit(c, s->reference, cli->judging.junit);
	if (status == TS_OK && cli->job.output.dir != NULL) {
		status = ts_results_begin(cli->job.output.dir, cli->job.output.force);
		if (status == TS_OK) status = draw_all(s, c, &report);
		if (status != TS_OK) ts_folder_discard();
	}
	if (status == TS_OK && cli->judging.tap) {
		ts_compare_tap(c, s->reference, stdout);
		ts_report_discard(&report);
		return TS_OK;
	}
	if (status == TS_OK) return ts_report_end(&report);
	ts_report_discard(&report);
	return status;
}

static ts_status judge(const sides *s, ts_comparison *c, const ts_cli *cli)
{
	if (!cli->judging.forced) return ts_compare(c, s->reference, s->candidate, &s->relaxations);
	if (ts_selftest_require() != TS_OK) return TS_ERROR;
	return ts_compare_forced(c, s->reference, s->candidate, &s->relaxations, cli->job.how.threads);
}

ts_status ts_compare_command(ts_cli *cli)
{
	const char *ref = cli->arguments[0];
	if (ends_in(ref, ".png") || ends_in(ref, ".exr")) return ts_compare_images(cli);
	sides s = {.relaxations = cli->judging.relaxations};
	ts_comparison *c = ts_comparison_make(cli->judging.first);
	ts_status status = c != NULL ? open_sides(&s, cli) : TS_ERROR;
	if (status == TS_OK) status = read_mask(&s, cli->judging.mask);
	if (status == TS_OK) status = judge(&s, c, cli);
	if (status != TS_ERROR && tell(&s, c, cli) != TS_OK) status = TS_ERROR;
	ts_trace_close(s.reference);
	ts_trace_close(s.candidate);
	free(s.mask);
	ts_comparison_free(c);
	return status;
}
