/* Advice for pictures that show nothing. */
#include "cli/render.h"

enum { DARK = 8, BLACK_PERCENT = 95 };

/* Whether more than BLACK_PERCENT of the pixels have no channel above DARK. */
static bool is_black(const ts_picture *picture, u64 n)
{
	u64 n_dark = 0;
	for (u64 i = 0; i < n && picture->srgb != NULL; i++) {
		const u8 *p = picture->srgb + 3 * i;
		n_dark += p[0] <= DARK && p[1] <= DARK && p[2] <= DARK;
	}
	return n_dark * 100 > n * BLACK_PERCENT;
}

void ts_render_advise(const ts_render *render)
{
	const ts_params *p = &render->job->params;
	u64 n = (u64)TS_PARAM(p, width) * TS_PARAM(p, height);
	bool mirrors = ts_effect_find(render->effect)->mirrors && render->scene->info.n_reflectors > 0;
	if (mirrors && (render->mirrors == NULL || render->mirrors->n_reflective == 0))
		ts_say("no mirror is in the picture; try --mirror X,Y,Z,R, another --eye and --target, or --camera");
	for (u32 i = 0; i < render->n_methods; i++) {
		if (!is_black(&render->pictures[i], n)) continue;
		ts_say("%s: more than %d %% of the picture is black; try --lamp X,Y,Z, --eye and --target, or "
		       "--set image.exposure=8",
		       render->methods[i]->name, BLACK_PERCENT);
	}
}
