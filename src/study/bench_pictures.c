/* Pictures of a row of a paper's table. */
#include <touchstone/image.h>
#include "bench_paper.h"
#include "folder.h"

static ts_status write_picture(const ts_picture *picture, const ts_bench_case *c, const ts_paper_line *line,
                               const char *method)
{
	char name[160];
	if (picture->srgb == NULL) return TS_OK;
	snprintf(name, sizeof name, "%s-%u-%s.png", line->scene, (unsigned)line->objects, method);
	const char *path = ts_folder_file(name);
	u32 width = TS_PARAM(&c->params, width), height = TS_PARAM(&c->params, height);
	return path != NULL ? ts_image_write_png(path, picture->srgb, width, height, 3) : TS_ERROR;
}

ts_status ts_paper_pictures(const ts_bench_case *c, const ts_paper_line *line)
{
	ts_status status = TS_OK;
	for (u32 v = 0; v < c->n_variants && status == TS_OK; v++)
		status = write_picture(&c->images[v], c, line, c->variants[v].method);
	return status == TS_OK ? write_picture(&c->truth, c, line, "truth") : status;
}
