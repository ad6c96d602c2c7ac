/* `compare REFERENCE CANDIDATE`: two traces, two buffers or two images. */
#include "compare.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <touchstone/image.h>
#include "../replay/forced.h"
#include "compare_images.h"
#include "compare_known.h"
#include "compare_shard.h"

/* What is compared. */
typedef enum { TRACES, BUFFERS, IMAGES, N_KINDS } kind;
static const char *const kind_names[] = {"traces", "buffers", "images"};

static bool ends_in(const char *path, const char *suffix)
{
	size_t n = strlen(path), m = strlen(suffix);
	return n > m && strcmp(path + n - m, suffix) == 0;
}

static kind kind_of(const char *path)
{
	static const char *const images[] = {".png", ".exr", ".jpg", ".jpeg"};
	for (u32 i = 0; i < sizeof images / sizeof *images; i++) {
		if (ends_in(path, images[i])) return IMAGES;
	}
	return ends_in(path, ".npy") || ends_in(path, ".npy.zst") ? BUFFERS : TRACES;
}

/* No option is passed over in silence. */
static ts_status check_options(const ts_cli *cli, kind is)
{
	static const struct {
		u32 option;
		bool takes[N_KINDS];
	} limited[] = {
		{TS_OPTION_FORCED, {[TRACES] = true}},
		{TS_OPTION_DECIDED, {[TRACES] = true}},
		{TS_OPTION_LAYOUT, {[TRACES] = true}},
		{TS_OPTION_ORDER, {[TRACES] = true}},
		{TS_OPTION_BASELINE, {[TRACES] = true}},
		{TS_OPTION_SKIP, {[TRACES] = true}},
		{TS_OPTION_SHARD, {[TRACES] = true}},
		{TS_OPTION_PERCENT, {[IMAGES] = true}},
		{TS_OPTION_HARDFAIL, {[IMAGES] = true}},
		{TS_OPTION_RMSE, {[IMAGES] = true}},
		{TS_OPTION_EXPOSURE, {[IMAGES] = true}},
		{TS_OPTION_IGNORE, {[TRACES] = true, [BUFFERS] = true}},
		{TS_OPTION_REPORT, {[TRACES] = true, [IMAGES] = true}},
	};
	for (u32 i = 0; i < sizeof limited / sizeof *limited; i++) {
		u32 option = limited[i].option;
		if (!cli->given[option] || limited[i].takes[is]) continue;
		const char *images = limited[i].takes[TRACES] ? "traces and images" : "images";
		const char *traces = limited[i].takes[BUFFERS] ? "traces and buffers" : "traces";
		const char *right = limited[i].takes[IMAGES] ? images : traces;
		return ts_fail("--%s: means something for %s only; %s is one of two %s: leave the option out",
		               ts_option_table[option].name, right, cli->arguments[0], kind_names[is]);
	}
	if (cli->given[TS_OPTION_ORDER] && cli->judging.layout == NULL) {
		return ts_fail("--order: only with --layout; a trace.json has its own");
	}
	return ts_judging_check(cli);
}

typedef struct {
	const ts_cli *cli;
	ts_trace *reference, *candidate;
	ts_comparison *comparison;
	ts_relaxations relaxations;
	bool own[TS_N_BUFFERS]; /* of this shard */
	ts_compare_lists lists;
	ts_outcomes outcomes;
} sides;

static ts_status open_sides(sides *s, kind is)
{
	const char *ref = s->cli->arguments[0], *cand = s->cli->arguments[1], *layout = s->cli->judging.layout;
	if (is == BUFFERS) {
		ts_buffer_id a, b;
		if (ts_trace_open_file(&s->reference, ref, &a) != TS_OK) return TS_ERROR;
		if (ts_trace_open_file(&s->candidate, cand, &b) != TS_OK) return TS_ERROR;
		if (s->cli->judging.mask != NULL && !ts_shape_is_image(ts_buffer_shape(a))) {
			return ts_fail("--mask: means something for pixels only; %s holds %s: leave the option out", ref,
			               ts_buffer_table[a].name);
		}
		if (a == b) return TS_OK;
		return ts_fail("%s: holds %s, and the reference %s", cand, ts_buffer_table[b].name, ts_buffer_table[a].name);
	}
	if (ts_trace_open_folder(&s->reference, ref) != TS_OK) return TS_ERROR;
	if (layout == NULL) return ts_trace_open_folder(&s->candidate, cand);
	return ts_trace_open_layout(&s->candidate, cand, layout, s->cli->job.how.arrival, s->reference);
}

ts_status ts_compare_mask(ts_relaxations *relaxations, const ts_cli *cli)
{
	f32 *pixels;
	u32 width, height, channels;
	if (cli->judging.mask == NULL) return TS_OK;
	if (ts_image_read(&pixels, &width, &height, &channels, cli->judging.mask) != TS_OK) return TS_ERROR;
	u8 *mask = ts_alloc_zero((size_t)width, height, "a mask");
	const u32 colours = channels % 2 == 0 ? channels - 1 : channels; /* the last of two or four is alpha */
	for (size_t i = 0; mask != NULL && i < (size_t)width * height * channels; i++) {
		if (i % channels < colours && pixels[i] > 0.0f) mask[i / channels] = 1;
	}
	free(pixels);
	relaxations->mask = mask;
	relaxations->mask_width = width;
	relaxations->mask_height = height;
	return mask != NULL ? TS_OK : TS_ERROR;
}

static ts_status draw_all(const void *user)
{
	const sides *s = user;
	return ts_compare_draw(s->comparison, s->reference, s->candidate, &s->relaxations);
}

static ts_status show_all(ts_page *page, const json_t *said, const void *user)
{
	const sides *s = user;
	if (ts_page_add_trace(page, s->reference) != TS_OK || ts_page_add_trace(page, s->candidate) != TS_OK)
		return TS_ERROR;
	return ts_page_add_comparison(page, s->comparison, s->reference, s->candidate, &s->relaxations, said);
}

static void report_all(ts_report *report, const void *user)
{
	const sides *s = user;
	ts_compare_report(report, s->comparison, s->reference, s->candidate, s->cli);
	ts_compare_report_known(report, &s->lists, s->comparison);
	bool failed = ts_outcomes_count(&s->outcomes, TS_FAILED) > 0;
	ts_report_value(report, "verdict", json_string(failed ? "different" : "same"));
	ts_report_value(report, "stages", json_incref(s->outcomes.rows));
}

static ts_status judge_own(const sides *s)
{
	if (!s->cli->judging.forced) return ts_compare_traces(s->comparison, s->reference, s->candidate, &s->relaxations);
	if (ts_selftest_require() != TS_OK) return TS_ERROR;
	return ts_compare_forced(s->comparison, s->reference, s->candidate, &s->relaxations, s->cli->job.how.threads);
}

static ts_status judge(sides *s)
{
	ts_shard shard = s->cli->job.shard;
	if (s->lists.ignore != NULL) s->relaxations.ignore = s->lists.ignore;
	if (shard.of > 0) {
		if (ts_compare_own(s->own, s->reference, s->candidate, &s->relaxations, shard) != TS_OK) return TS_ERROR;
		s->relaxations.only = s->own;
	}
	s->lists.only = s->relaxations.only;
	ts_status status = judge_own(s);
	if (status != TS_DIFFERENT || shard.of == 0 || s->comparison->forced) return status;
	return ts_compare_aside(s->comparison, s->reference, s->candidate, &s->relaxations) == TS_OK ? status : TS_ERROR;
}

static ts_status tell(ts_cli *cli, sides *s)
{
	ts_status status;
	char class_name[64];
	snprintf(class_name, sizeof class_name, "touchstone.%s", s->reference->pipeline->name);
	char relaxed[TS_RELAXED_TEXT];
	ts_telling telling = {"compare", &s->outcomes, relaxed, NULL, TS_OK, report_all, false, draw_all, show_all, s};
	ts_compare_relaxed(relaxed, cli);
	if (ts_outcomes_begin(&s->outcomes, "stage", class_name) != TS_OK) return TS_ERROR;
	ts_compare_outcomes(&s->outcomes, s->comparison, s->reference, &s->lists);
	telling.status = status = ts_outcomes_count(&s->outcomes, TS_FAILED) > 0 ? TS_DIFFERENT : TS_OK;
	if (cli->job.shard.of > 0) {
		telling.cases = ts_compare_cases(s->reference->pipeline);
		if (telling.cases == NULL) return TS_ERROR;
		const size_t n = json_array_size(telling.cases);
		if (cli->job.shard.index > n) ts_shard_say_empty(cli->job.shard, n);
	}
	if (ts_tell(cli, &telling, true) != TS_OK) status = TS_ERROR;
	json_decref(telling.cases);
	return status;
}

ts_status ts_compare_command(ts_cli *cli)
{
	kind is = kind_of(cli->arguments[0]);
	if (check_options(cli, is) != TS_OK) return TS_ERROR;
	if (is == IMAGES) return ts_compare_images(cli);
	sides s = {.cli = cli, .relaxations = cli->judging.relaxations};
	s.comparison = ts_comparison_make(cli->judging.first);
	ts_status status = s.comparison != NULL ? open_sides(&s, is) : TS_ERROR;
	if (status == TS_OK) status = ts_compare_mask(&s.relaxations, cli);
	if (status == TS_OK) status = ts_compare_lists_read(&s.lists, cli, s.reference->pipeline);
	if (status == TS_OK) status = judge(&s);
	if (status != TS_ERROR) status = tell(cli, &s);
	ts_outcomes_end(&s.outcomes);
	ts_compare_lists_free(&s.lists);
	ts_trace_close(s.reference);
	ts_trace_close(s.candidate);
	free((void *)s.relaxations.mask);
	ts_comparison_free(s.comparison);
	return status;
}

void ts_compare_failed(const ts_cli *cli) { ts_tell_failed(cli, "compare"); }
