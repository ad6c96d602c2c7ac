/* `compare` of two pictures. */
#include "compare_images.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "../trace/field.h"
#include "../compare/relax.h"
#include "../study/table.h"

typedef struct {
	f32 *pixels;
	u32 width, height, channels;
} picture;

static ts_status read_pictures(picture p[2], const ts_cli *cli)
{
	for (u32 i = 0; i < 2; i++) {
		const char *path = cli->arguments[i];
		if (ts_image_read(&p[i].pixels, &p[i].width, &p[i].height, &p[i].channels, path) != TS_OK) return TS_ERROR;
	}
	if (p[0].width == p[1].width && p[0].height == p[1].height && p[0].channels == p[1].channels) return TS_OK;
	return ts_fail("%s: %u x %u with %u channels; the reference has %u x %u with %u", cli->arguments[1],
	               (unsigned)p[1].width, (unsigned)p[1].height, (unsigned)p[1].channels, (unsigned)p[0].width,
	               (unsigned)p[0].height, (unsigned)p[0].channels);
}

static void tell_first(ts_report *report, const picture *p, u64 first, u64 n_unlike)
{
	static const ts_field value = {.name = "", .kind = 'f', .count = 1, .bytes = 4};
	char ref[TS_VALUE_TEXT], cand[TS_VALUE_TEXT];
	u64 pixel = first / p[0].channels;
	ts_field_show(ref, &value, ts_f2u(p[0].pixels[first]));
	ts_field_show(cand, &value, ts_f2u(p[1].pixels[first]));
	ts_report_line(report,
	               "pixel (%" PRIu64 ", %" PRIu64 "), channel %" PRIu64 ": ref %s candidate %s — first of %" PRIu64,
	               pixel % p[0].width, pixel / p[0].width, first % p[0].channels, ref, cand, n_unlike);
	ts_report_value(report, "x", json_integer((json_int_t)(pixel % p[0].width)));
	ts_report_value(report, "y", json_integer((json_int_t)(pixel / p[0].width)));
}

ts_status ts_compare_images(const ts_cli *cli)
{
	picture p[2] = {{.pixels = NULL}, {.pixels = NULL}};
	const ts_relaxations *relaxations = &cli->judging.relaxations;
	ts_status status = read_pictures(p, cli);
	u64 n = (u64)p[0].width * p[0].height * p[0].channels, first = 0, n_unlike = 0;
	double squares = 0;
	for (u64 i = 0; status == TS_OK && i < n; i++) {
		double apart = (double)p[0].pixels[i] - (double)p[1].pixels[i];
		squares += apart * apart;
		if (ts_relax_close(relaxations, ts_f2u(p[0].pixels[i]), ts_f2u(p[1].pixels[i]))) continue;
		if (n_unlike++ == 0) first = i;
	}
	if (status == TS_OK) {
		ts_report report;
		ts_report_begin(&report, cli->job.output.json);
		ts_report_line(&report, "%" PRIu64 " values, %" PRIu64 " different, root mean square %.9g", n, n_unlike,
		               n > 0 ? sqrt(squares / (double)n) : 0);
		ts_report_value(&report, "values", json_integer((json_int_t)n));
		ts_report_value(&report, "different", json_integer((json_int_t)n_unlike));
		if (n_unlike > 0) tell_first(&report, p, first, n_unlike);
		status = ts_report_end(&report);
	}
	free(p[0].pixels);
	free(p[1].pixels);
	return status != TS_OK ? status : n_unlike > relaxations->allow ? TS_DIFFERENT : TS_OK;
}
