/* The page of a render, made of the folder that it wrote. */
#include "../image/flip.h"
#include "../report/report.h"
#include "render.h"

ts_status ts_render_page_check(const ts_job *job)
{
	const char *file = job->output.report, *dir = ts_render_output(job);
	size_t n = strlen(dir);
	if (job->output.no_images) return ts_fail("--report: --no-images writes no pictures; leave one of the two out");
	if (strncmp(file, dir, n) != 0 || (file[n] != '/' && dir[n - 1] != '/')) return TS_OK;
	return ts_fail("--report: %s lies in %s, which a later render replaces as a whole; name a file beside it", file,
	               dir);
}

ts_status ts_render_page(const ts_job *job)
{
	ts_page *page = ts_page_make(TS_FLIP_PPD, TS_PAGE_PROBES);
	ts_status status = page != NULL ? ts_page_add_folder(page, ts_render_output(job)) : TS_ERROR;
	if (status == TS_OK) status = ts_page_write(page, job->output.report);
	ts_page_free(page);
	return status;
}
