/* Classic multi-view rendering of cube-mapped reflections: the baseline of EPR section 4.2 (SPEC 1.7).
 *
 * For every reflector the whole scene is rasterized into the six faces of its cube, every texel is shaded, a mip chain is
 * made, and the eye's reflective pixels look it up.
 *
 * Deviations: deferred shading by the same kernels as EPR's, so that only the method differs; one reflector at a time, so
 * that memory does not grow with their number. One bounce, whatever the parameter says. */
#include "pipelines.h"

#include "../stages/stages.h"

static const char *const eye[] = {"view", "pose", "resize", "eye", "pixel", NULL};
static const char *const cube[] = {
	"face",       /* geometry into six faces */
	"illuminate", /* shading of every texel; mip-mapping */
	"mirror",     /* the eye's look-ups */
	NULL,
};
static const char *const picture[] = {"image", NULL};

ts_status ts_mvr_run(ts_run *run)
{
	if (run->params.mvr_faces == TS_MVR_FACES_FIXED) {
		run->fixed_face = run->params.face_px != 0 ? run->params.face_px : run->params.face_max;
		run->all_cubes = true;
	}
	if (ts_run_stages(run, eye) != TS_OK) return TS_ERROR;
	u32 n = run->scene->n_reflectors;
	run->n_reflectors = n != 0 ? 1 : 0;
	for (u32 r = 0; r == 0 || r < n; r++) {
		run->first_reflector = r;
		ts_progress("mvr: reflectors", r, n);
		if (ts_run_stages(run, cube) != TS_OK) return TS_ERROR;
	}
	ts_progress("mvr: reflectors", n, n);
	return ts_run_stages(run, picture);
}

u64 ts_mvr_estimate(const ts_scene *scene, const ts_params *params)
{
	u64 face = params->face_px != 0 ? params->face_px : params->face_max;
	return ts_common_estimate(scene, params) + 6 * face * face * (sizeof(u64) + 4 * sizeof(f32) * 4 / 3);
}
