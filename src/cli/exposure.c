/* --exposure auto: for a render, and for all its frames and combinations, from frame 0 by the first method. */
#include <stdlib.h>
#include "cli/render.h"

#define SHARE 0.95 /* of the pixels with a surface, this share is no brighter than */
#define SHOWN 0.8  /* this part of the brightest value that can be displayed */

static int by_value(const void *a, const void *b)
{
	f32 x = *(const f32 *)a, y = *(const f32 *)b;
	return (x > y) - (x < y);
}

/* Luminance (ITU-R BT.709) of the pixels that see a surface, in *n; TS_ERROR without memory. */
static ts_status take_luminance(f32 **luminance, size_t *n, const ts_picture *picture, const ts_params *params)
{
	size_t pixels = (size_t)TS_PARAM(params, width) * TS_PARAM(params, height);
	*n = 0;
	*luminance = ts_alloc(pixels, sizeof **luminance, "the luminance of a picture");
	for (size_t i = 0; i < pixels && *luminance != NULL; i++) {
		const f32 *rgb = picture->radiance + 3 * i;
		f32 light = 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
		if (picture->seen[i] != 0) (*luminance)[(*n)++] = light * picture->gain;
	}
	return *luminance != NULL ? TS_OK : TS_ERROR;
}

/* Three digits, so that the printed number is the one that is used. */
static ts_status set_exposure(ts_params *params, f32 bright)
{
	char text[32];
	double exposure = bright > 0 ? SHOWN / (double)bright : 1;
	exposure = exposure < 0.000977 ? 0.000977 : exposure > 1024 ? 1024 : exposure;
	snprintf(text, sizeof text, "%.3g", exposure);
	if (!(bright > 0)) ts_say("--exposure auto: frame 0 is black; the exposure stays 1");
	return ts_params_set(params, "image.exposure", text);
}

static ts_status choose(ts_render *render, void *user)
{
	ts_job *job = user;
	f32 *luminance = NULL;
	size_t n = 0;
	ts_status status = ts_render_open(render);
	render->n_methods = 1;
	if (status == TS_OK) status = ts_render_make(render);
	if (status == TS_OK) status = take_luminance(&luminance, &n, &render->pictures[0], &render->job->params);
	if (status == TS_OK && n > 0) qsort(luminance, n, sizeof *luminance, by_value);
	if (status == TS_OK) status = set_exposure(&job->params, n > 0 ? luminance[(size_t)((double)(n - 1) * SHARE)] : 0);
	free(luminance);
	return status;
}

ts_status ts_exposure_choose(ts_job *job)
{
	ts_job first = *job;
	TS_PARAM_SET(&first.params, frame, 0);
	TS_PARAM_SET(&first.params, image_exposure, 1.0f);
	first.truths = 0;
	first.output = (ts_output){.no_images = true};
	return ts_render_with(&first, choose, job);
}
