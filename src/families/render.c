/* The public face of a run. */
#include <touchstone/render.h>

#include <stdlib.h>
#include "../methods/pipeline.h"
#include "../model/renamed.h"
#include "families.h"

struct ts_render {
	ts_run run;
};

ts_status ts_render_run(ts_render **render, const ts_scene *scene, const ts_params *params, const char *effect,
                        const char *method, uint32_t threads)
{
	*render = NULL;
	if (ts_selftest_require() != TS_OK || ts_params_check(params) != TS_OK) return TS_ERROR;
	ts_families_begin();
	const ts_pipeline *pipeline = ts_pipeline_find(effect, method);
	if (pipeline == NULL) {
		return ts_fail("%s by %s: no such method; `touchstone list methods` names them", effect, method);
	}
	if (threads > TS_MOST_THREADS) {
		return ts_fail("%lu threads; 0 to %d are right", (unsigned long)threads, TS_MOST_THREADS);
	}
	ts_render *made = ts_alloc_zero(1, sizeof *made, "render");
	if (made == NULL) return TS_ERROR;
	ts_run_begin(&made->run, scene, params, ts_threads_ready(threads));
	if (ts_pipeline_run(pipeline, &made->run) != TS_OK) {
		ts_render_free(made);
		return TS_ERROR;
	}
	*render = made;
	return TS_OK;
}

void ts_render_free(ts_render *render)
{
	if (render == NULL) return;
	ts_run_end(&render->run);
	free(render);
}

ts_status ts_render_buffer(const ts_render *render, const char *name, ts_buffer_view *view)
{
	const char *now = ts_name_typed(TS_NAME_buffer, name);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_buffer_info *info = &ts_buffer_table[id];
		const ts_buffer *buffer = &render->run.frame.buffer[id];
		if (strcmp(info->name, now) != 0) continue;
		if (!buffer->made) return ts_fail("%s: this method does not make it", name);
		*view = (ts_buffer_view){info->name,     info->element, info->element_bytes, buffer->data,
		                         buffer->n_dims, {0},           info->order,         info->key};
		memcpy(view->shape, buffer->shape, sizeof view->shape);
		return TS_OK;
	}
	return ts_fail("%s: no such buffer; `touchstone list buffers` names them", name);
}

int64_t ts_render_counter(const ts_render *render, const char *name) { return ts_run_counter(&render->run, name); }
