/* The command as a client of the library. */
#include "cli/client.h"
#include <stdlib.h>
#include <string.h>
#include "model/json/read.h"

ts_status ts_client_open(ts_context **context, const ts_cli *cli)
{
	const bool quiet = cli->job.output.quiet;
	const ts_context_options options = {.bytes = sizeof options,
	                                    .threads = cli->job.how.threads,
	                                    .say = quiet ? NULL : ts_cli_say,
	                                    .progress = quiet ? NULL : ts_cli_progress};
	return ts_context_open(context, &options);
}

json_t *ts_client_json(ts_tree *tree)
{
	if (tree == NULL) return NULL;
	char *text = ts_tree_json(tree);
	ts_tree_free(tree); /* before the next is made */
	json_t *json = text != NULL ? ts_json_read(text, strlen(text), false, "an answer") : NULL;
	free(text);
	return json;
}

ts_status ts_client_page(const ts_cli *cli, const char *json,
                         ts_status (*put)(ts_html *page, const char *json, const void *user), const void *user)
{
	ts_context *context;
	ts_html *page = NULL;
	if (ts_client_open(&context, cli) != TS_OK) return TS_ERROR;
	ts_status status = ts_html_open(context, &page, NULL);
	if (status == TS_OK) status = put(page, json, user);
	if (status == TS_OK) status = ts_html_write(page, cli->job.output.report);
	ts_html_close(page);
	ts_context_close(context);
	return status;
}

static ts_status read_mask(u8 **to, u32 *width, u32 *height, const char *path)
{
	f32 *pixels;
	u32 channels;
	if (ts_image_read(&pixels, width, height, &channels, path) != TS_OK) return TS_ERROR;
	u8 *mask = *to = ts_alloc_zero((size_t)*width, *height, "a mask");
	const u32 colours = channels % 2 == 0 ? channels - 1 : channels; /* the last of two or four is alpha */
	for (size_t i = 0; mask != NULL && i < (size_t)*width * *height * channels; i++) {
		if (i % channels < colours && pixels[i] > 0.0f) mask[i / channels] = 1;
	}
	free(pixels);
	return mask != NULL ? TS_OK : TS_ERROR;
}

ts_status ts_client_options(ts_compare_options *o, u8 **mask, const ts_cli *cli)
{
	const ts_judging *judging = &cli->judging;
	const ts_relaxed *r = &judging->relaxations;
	*mask = NULL;
	*o = (ts_compare_options){.bytes = sizeof *o,
	                          .forced = judging->forced,
	                          .decided = r->decided,
	                          .ulp = r->ulp,
	                          .abs = r->abs,
	                          .rel = r->rel,
	                          .allow = r->allow,
	                          .first = judging->first};
	if (judging->mask == NULL) return TS_OK;
	ts_status status = read_mask(mask, &o->mask_width, &o->mask_height, judging->mask);
	o->mask = *mask;
	return status;
}
