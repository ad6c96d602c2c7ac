/* `compare REFERENCE CANDIDATE`: two traces, two buffers or two images. */
#include "compare.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <touchstone/image.h>
#include "../replay/forced.h"
#include "compare_images.h"

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
	return ends_in(path, ".npy") ? BUFFERS : TRACES;
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
		{TS_OPTION_PERCENT, {[IMAGES] = true}},
		{TS_OPTION_HARDFAIL, {[IMAGES] = true}},
		{TS_OPTION_RMSE, {[IMAGES] = true}},
		{TS_OPTION_EXPOSURE, {[IMAGES] = true}},
		{TS_OPTION_IGNORE, {[TRACES] = true, [BUFFERS] = true}},
	};
	for (u32 i = 0; i < sizeof limited / sizeof *limited; i++) {
		u32 option = limited[i].option;
		if (!cli->given[option] || limited[i].takes[is]) continue;
		const char *right = limited[i].takes[IMAGES]    ? "images"
		                    : limited[i].takes[BUFFERS] ? "traces and buffers"
		                                                : "traces";
		return ts_fail("--%s: means something for %s only; %s is one of two %s: leave the option out",
		               ts_option_table[option].name, right, cli->arguments[0], kind_names[is]);
	}
	if (cli->given[TS_OPTION_ORDER] && cli->judging.layout == NULL) {
		return ts_fail("--order: only with --layout; a trace.json has its own");
	}
	if (cli->judging.tap && cli->job.output.json) return ts_fail("--tap, --json: both print; choose one");
	if (cli->job.output.force && cli->job.output.dir == NULL) return ts_fail("--force: only with -o DIR");
	return TS_OK;
}

typedef struct {
	const ts_cli *cli;
	ts_trace *reference, *candidate;
	ts_comparison *comparison;
	ts_relaxations relaxations;
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

static void report_all(ts_report *report, const void *user)
{
	const sides *s = user;
	ts_compare_report(report, s->comparison, s->reference, s->candidate, s->cli);
}

static void put_junit(ts_junit *junit, const void *user)
{
	const sides *s = user;
	ts_compare_junit(junit, s->comparison, s->reference);
}

static void print_tap(FILE *out, const void *user)
{
	const sides *s = user;
	ts_compare_tap(s->comparison, s->reference, out);
}

static ts_status judge(const sides *s)
{
	if (!s->cli->judging.forced) return ts_compare_traces(s->comparison, s->reference, s->candidate, &s->relaxations);
	if (ts_selftest_require() != TS_OK) return TS_ERROR;
	return ts_compare_forced(s->comparison, s->reference, s->candidate, &s->relaxations, s->cli->job.how.threads);
}

ts_status ts_compare_command(ts_cli *cli)
{
	static const ts_compare_forms forms = {report_all, put_junit, print_tap, draw_all};
	kind is = kind_of(cli->arguments[0]);
	if (check_options(cli, is) != TS_OK) return TS_ERROR;
	if (is == IMAGES) return ts_compare_images(cli);
	sides s = {.cli = cli, .relaxations = cli->judging.relaxations};
	s.comparison = ts_comparison_make(cli->judging.first);
	ts_status status = s.comparison != NULL ? open_sides(&s, is) : TS_ERROR;
	if (status == TS_OK) status = ts_compare_mask(&s.relaxations, cli);
	if (status == TS_OK) status = judge(&s);
	if (status != TS_ERROR && ts_compare_tell(cli, &forms, &s) != TS_OK) status = TS_ERROR;
	ts_trace_close(s.reference);
	ts_trace_close(s.candidate);
	free((void *)s.relaxations.mask);
	ts_comparison_free(s.comparison);
	return status;
}
