/* The files of a render: every method, truth and difference as PNG and EXR, and the pictures of the stages. */
#include "cli/render.h"
#include "image/about.h"
#include "study/results/folder.h"

static const char *file(const ts_render *render, const char *stem, const char *suffix)
{
	char name[TS_FOLDER_PATH];
	snprintf(name, sizeof name, "%s%s.%s", render->folder, stem, suffix);
	return ts_folder_file(name);
}

static void describe(ts_about *about, const ts_render *render, const char *stem)
{
	ts_about_make(about, render->scene->name, render->effect, stem, &render->job->params);
}

static ts_status write_png(const ts_render *render, const char *stem, const u8 *rgb, u32 width, u32 height)
{
	ts_about about;
	const char *png = file(render, stem, "png");
	describe(&about, render, stem);
	return png != NULL ? ts_image_write_png(png, rgb, width, height, 3, about.texts) : TS_ERROR;
}

/* Writes a picture of the eye's size. */
static ts_status write_pair(const ts_render *render, const char *stem, const u8 *srgb, const f32 *radiance)
{
	ts_about about;
	u32 width = TS_PARAM(&render->job->params, width), height = TS_PARAM(&render->job->params, height);
	if (write_png(render, stem, srgb, width, height) != TS_OK) return TS_ERROR;
	const char *exr = file(render, stem, "exr");
	describe(&about, render, stem);
	return exr != NULL ? ts_image_write_exr(exr, radiance, width, height, 3, about.texts) : TS_ERROR;
}

int ts_render_difference_scale(const ts_render *render)
{
	return (int)ts_effect_find(render->effect)->difference_scale;
}

/* PNG: the distance in grey levels, scaled; EXR: image - reference in radiance. */
static ts_status write_difference(const ts_render *render, const ts_pair *pair)
{
	char stem[64];
	const ts_params *params = &render->job->params;
	ts_picture difference;
	ts_status status = ts_picture_difference(&difference, pair->image, pair->reference, params,
	                                         (u32)ts_render_difference_scale(render));
	snprintf(stem, sizeof stem, "difference-%s-%s", pair->image->name, pair->reference->name);
	if (status == TS_OK) status = write_pair(render, stem, difference.srgb, difference.radiance);
	ts_picture_free(&difference);
	return status;
}

static ts_status write_stages(const ts_render *render, u32 method)
{
	const ts_stage_pictures *pictures = &render->stages[method];
	ts_status status = TS_OK;
	for (u32 k = 0; k < pictures->n && status == TS_OK; k++) {
		const ts_stage_picture *p = &pictures->picture[k];
		char stem[64];
		snprintf(stem, sizeof stem, "%s-%s", render->methods[method]->name, p->name);
		status = write_png(render, stem, p->rgb, p->width, p->height);
	}
	return status;
}

ts_status ts_render_write(ts_render *render)
{
	ts_status status = TS_OK;
	for (u32 i = 0; i < TS_MAX_SHOWN && status == TS_OK; i++) {
		const ts_picture *picture = ts_render_shown(render, i);
		if (picture != NULL) status = write_pair(render, picture->name, picture->srgb, picture->radiance);
	}
	for (u32 i = 0; i < render->n_methods && status == TS_OK; i++) {
		ts_stage_pictures_finish(&render->stages[i], render->pictures[i].srgb);
		status = write_stages(render, i);
	}
	for (u32 i = 0; i < render->n_pairs && status == TS_OK; i++) status = write_difference(render, &render->pairs[i]);
	return status;
}
