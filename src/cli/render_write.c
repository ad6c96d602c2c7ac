/* The files of a render: every method, truth and difference as PNG and EXR, and the pictures of the stages. */
#include <stdlib.h>
#include "../study/folder.h"
#include "render.h"

static const char *file(const char *stem, const char *suffix)
{
	char name[96];
	snprintf(name, sizeof name, "%s.%s", stem, suffix);
	return ts_folder_file(name);
}

static ts_status write_pair(const char *stem, const u8 *srgb, const f32 *radiance, u32 width, u32 height)
{
	const char *png = file(stem, "png");
	ts_status status = png != NULL ? ts_image_write_png(png, srgb, width, height, 3) : TS_ERROR;
	const char *exr = status == TS_OK ? file(stem, "exr") : NULL;
	return exr != NULL ? ts_image_write_exr(exr, radiance, width, height, 3) : TS_ERROR;
}

static ts_status write_picture(const ts_picture *picture, const ts_params *params)
{
	return picture->srgb == NULL ? TS_OK
	                             : write_pair(picture->name, picture->srgb, picture->radiance, TS_PARAM(params, width),
	                                          TS_PARAM(params, height));
}

int ts_render_difference_scale(const ts_render *render)
{
	return (int)ts_effect_find(render->effect)->difference_scale;
}

/* PNG: the distance in grey levels, scaled; EXR: image - reference in radiance. */
static ts_status write_difference(const ts_pair *pair, const ts_params *params, int scale)
{
	char stem[64];
	size_t n = (size_t)TS_PARAM(params, width) * TS_PARAM(params, height) * 3;
	f32 *radiance = ts_alloc(n, sizeof *radiance, "a difference");
	u8 *grey = ts_alloc(n, 1, "a difference");
	ts_status status = radiance != NULL && grey != NULL ? TS_OK : TS_ERROR;
	for (size_t i = 0; i < n && status == TS_OK; i++) {
		int d = abs(pair->image->srgb[i] - pair->reference->srgb[i]) * scale;
		grey[i] = (u8)(d < 255 ? d : 255);
		radiance[i] = pair->image->radiance[i] - pair->reference->radiance[i];
	}
	snprintf(stem, sizeof stem, "difference-%s-%s", pair->image->name, pair->reference->name);
	if (status == TS_OK) status = write_pair(stem, grey, radiance, TS_PARAM(params, width), TS_PARAM(params, height));
	free(radiance);
	free(grey);
	return status;
}

static ts_status write_stages(const ts_stage_pictures *pictures, const char *method)
{
	ts_status status = TS_OK;
	for (u32 k = 0; k < pictures->n && status == TS_OK; k++) {
		const ts_stage_picture *p = &pictures->picture[k];
		char stem[64];
		snprintf(stem, sizeof stem, "%s-%s", method, p->name);
		const char *png = file(stem, "png");
		status = png != NULL ? ts_image_write_png(png, p->rgb, p->width, p->height, 3) : TS_ERROR;
	}
	return status;
}

ts_status ts_render_write(ts_render *render)
{
	const ts_params *params = &render->job->params;
	ts_status status = TS_OK;
	for (u32 i = 0; i < render->n_methods && status == TS_OK; i++) {
		ts_stage_pictures_finish(&render->stages[i], render->pictures[i].srgb);
		status = write_picture(&render->pictures[i], params);
		if (status == TS_OK) status = write_stages(&render->stages[i], render->methods[i]->name);
	}
	for (u32 t = 0; t < TS_MAX_TRUTHS && status == TS_OK; t++) status = write_picture(&render->truths[t], params);
	for (u32 i = 0; i < render->n_pairs && status == TS_OK; i++) {
		status = write_difference(&render->pairs[i], params, ts_render_difference_scale(render));
	}
	return status;
}
