/* The pictures of a table's rows: of methods, of the truth, and of what tells methods from the first of them. */
#include <stdlib.h>
#include <touchstone/image.h>
#include "bench_paper.h"
#include "folder.h"

typedef struct {
	const ts_params *params;
	char row[160]; /* what names of files begin with */
} place;

static ts_status write_picture(const place *p, const char *kind, const char *name, const u8 *srgb)
{
	char file[256];
	snprintf(file, sizeof file, "%s-%s%s.png", p->row, kind, name);
	const char *path = ts_folder_file(file);
	if (path == NULL) return TS_ERROR;
	return ts_image_write_png(path, srgb, TS_PARAM(p->params, width), TS_PARAM(p->params, height), 3);
}

static ts_status write_difference(const place *p, const char *name, const ts_picture *image,
                                  const ts_picture *reference, u32 scale)
{
	u8 *grey = ts_picture_difference(image, reference, p->params, scale);
	ts_status status = grey != NULL ? write_picture(p, "difference-", name, grey) : TS_ERROR;
	free(grey);
	return status;
}

ts_status ts_paper_pictures(const ts_paper_table *table, const ts_bench_case *c, const ts_paper_line *line, u32 row)
{
	place p = {.params = &c->params};
	const ts_picture *first = &c->images[table->pictures->variant];
	u32 scale = ts_effect_find(table->effect)->difference_scale;
	ts_status status = TS_OK;
	int n = snprintf(p.row, sizeof p.row, "%u-%s", (unsigned)row, line->scene);
	if (table->objects_head != NULL) snprintf(p.row + n, sizeof p.row - (size_t)n, "-%u", (unsigned)line->objects);
	for (const ts_paper_picture *k = table->pictures; status == TS_OK && k->name != NULL; k++) {
		const ts_picture *image = &c->images[k->variant];
		if (image->srgb == NULL) continue;
		status = write_picture(&p, "", k->name, image->srgb);
		bool differs = image != first && first->srgb != NULL;
		if (status == TS_OK && differs) status = write_difference(&p, k->name, image, first, scale);
	}
	return status == TS_OK && c->truth.srgb != NULL ? write_picture(&p, "", c->truth.name, c->truth.srgb) : status;
}
