/* `digest [SCENE]`: SHA-256 of the file of every buffer of a run, as in a trace. Also in the static core binary, so it
 * opens built-in scenes only and needs neither glTF nor JSON. */
#include <stdio.h>
#include "cli/line/cli.h"
#include "scene/sources.h"
#include "study/asked/methods.h"
#include "trace/emitted/sums.h"

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

static ts_status digest_method(const ts_job *job, const ts_scene *scene, const ts_pipeline *method)
{
	ts_sums sums;
	if (ts_sums_of(&sums, method, scene, &job->params, &job->how) != TS_OK) return TS_ERROR;
	printf("# %s by %s\n", method->effect->name, method->name);
	ts_sums_print(&sums, method, stdout);
	return TS_OK;
}

ts_status ts_digest_command(ts_cli *cli)
{
	const ts_pipeline *methods[TS_MAX_METHODS];
	u32 n;
	ts_scene *scene;
	const char *effect = cli->job.effect != NULL ? cli->job.effect : ts_pipelines()[0]->effect->name;
	ts_status status = ts_methods_find(methods, &n, effect, cli->job.method);
	ts_effect_params(&cli->job, effect);
	if (status != TS_OK || (status = ts_selftest_require()) != TS_OK) return status;
	if (cli->flush_denormals && (status = flush_denormals(cli->job.how.threads)) != TS_OK) return status;
	status = ts_builtin_open(&scene, cli->n_arguments > 0 ? cli->arguments[0] : "atrium", &cli->job.params, NULL);
	for (u32 i = 0; i < n && status == TS_OK; i++) status = digest_method(&cli->job, scene, methods[i]);
	ts_scene_free(scene);
	return status;
}
