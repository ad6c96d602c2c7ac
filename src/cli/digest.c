/* `digest [SCENE]`: SHA-256 of every buffer of a run, in pipeline order. Also in the static core binary, so it opens
 * built-in scenes itself and needs neither glTF nor JSON. */
#include <stdio.h>
#include "../core/digest.h"
#include "../scene/sources.h"
#include "cli.h"
#include "methods.h"

#if defined(__SSE__)
#include <xmmintrin.h>
/* FTZ is bit 15, DAZ bit 6. */
static void flush_this_thread(void) { _mm_setcsr(_mm_getcsr() | 0x8040); }
enum { CAN_FLUSH = 1 };
#elif defined(__aarch64__)
/* FPCR.FZ is bit 24. */
static void flush_this_thread(void)
{
	u64 fpcr;
	__asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
	__asm__ volatile("msr fpcr, %0" : : "r"(fpcr | (1ul << 24)));
}
enum { CAN_FLUSH = 1 };
#else
static void flush_this_thread(void) {}
enum { CAN_FLUSH = 0 };
#endif

static ts_status flush_denormals(u32 threads)
{
	if (!CAN_FLUSH) return ts_fail("digest: --flush-denormals is known on x86 and aarch64 only");
	flush_this_thread();
#pragma omp parallel num_threads((int)threads)
	flush_this_thread();
	return TS_OK;
}

static ts_status open_builtin(ts_scene **scene, const char *spec, const ts_params *params)
{
	*scene = NULL;
	if (!ts_builtin_is(spec)) {
		return ts_fail("digest: \"%s\" is no built-in scene; there are atrium, gallery and dining", spec);
	}
	ts_build *build = ts_build_new(spec);
	if (build == NULL) return TS_ERROR;
	ts_builtin_make(build, spec, params->seed);
	ts_reflectors_add(build, params, NULL);
	return ts_build_finish(build, params, NULL, scene);
}

static ts_status add_stage(const ts_run *run, const ts_stage *stage, void *user)
{
	return ts_frame_digest_add(user, &run->frame, stage->writes, sizeof stage->writes / sizeof stage->writes[0]);
}

static ts_status digest_method(const ts_cli *cli, const ts_scene *scene, const ts_pipeline *method)
{
	static const ts_buffer_id scene_buffers[] = { TS_B_scene_vertex, TS_B_scene_triangle, TS_B_scene_material,
		TS_B_scene_slot, TS_B_scene_image, TS_B_scene_texel, TS_B_scene_light, TS_B_scene_object, TS_B_scene_info,
		TS_N_BUFFERS };
	ts_run run;
	ts_frame_digest digests = { .n = 0 };
	ts_run_begin(&run, scene, &cli->params, cli->threads);
	run.reference = ts_cli_given(cli, TS_OPT_REFERENCE);
	run.hook = add_stage;
	run.hook_user = &digests;
	ts_status status = ts_frame_digest_add(&digests, &run.frame, scene_buffers, TS_N_BUFFERS);
	if (status == TS_OK) status = ts_pipeline_run(method, &run);
	if (status == TS_OK) ts_frame_digest_print(&digests, stdout);
	ts_frame_digest_clear(&digests);
	ts_run_end(&run);
	return status;
}

ts_status ts_digest_command(ts_cli *cli)
{
	const ts_pipeline *methods[TS_MAX_METHODS];
	u32 n;
	ts_scene *scene;
	ts_status status = ts_methods_find(methods, &n, "reflections", cli->method);
	if (status != TS_OK || (status = ts_selftest_require()) != TS_OK) return status;
	if (ts_cli_given(cli, TS_OPT_FLUSH_DENORMALS) && (status = flush_denormals(cli->threads)) != TS_OK) return status;
	status = open_builtin(&scene, cli->n_arguments > 0 ? cli->arguments[0] : "atrium", &cli->params);
	for (u32 i = 0; i < n && status == TS_OK; i++) status = digest_method(cli, scene, methods[i]);
	ts_scene_free(scene);
	return status;
}
