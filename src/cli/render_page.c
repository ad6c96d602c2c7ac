/* The page of a render, made from the output folder. */
#include "cli/client.h"
#include "cli/render.h"

ts_status ts_render_page_check(const ts_job *job)
{
	const char *file = job->output.report, *dir = ts_render_output(job);
	size_t n = strlen(dir);
	if (job->output.no_images) return ts_fail("--report: --no-images writes no pictures; leave one of the two out");
	if (strncmp(file, dir, n) != 0 || (file[n] != '/' && dir[n - 1] != '/')) return TS_OK;
	return ts_fail("--report: %s lies in %s, which a later render replaces as a whole; name a file beside it", file,
	               dir);
}

ts_status ts_render_page(const ts_cli *cli)
{
	ts_context *context;
	ts_html *page = NULL;
	ts_status status = ts_client_open(&context, cli);
	if (status == TS_OK) status = ts_html_open(context, &page, NULL);
	if (status == TS_OK) status = ts_html_add_folder(page, ts_render_output(&cli->job));
	if (status == TS_OK) status = ts_html_write(page, cli->job.output.report);
	ts_html_close(page);
	ts_context_close(context);
	return status;
}
