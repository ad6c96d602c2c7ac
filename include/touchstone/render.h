/* Rendering: runs a method of a paper over a scene and keeps every buffer of every stage.
 *
 *   ts_scene *scene; ts_params params; ts_render *render; ts_buffer_view image;
 *   ts_params_default(&params);
 *   if (ts_scene_open(&scene, "atrium", &params, NULL) == TS_OK &&
 *       ts_render_run(&render, scene, &params, "reflections", "epr", 2) == TS_OK &&
 *       ts_render_buffer(render, "image.srgb", &image) == TS_OK) {
 *           ... image.data: params.height * params.width * 3 bytes ...
 *   }
 *   ts_render_free(render);
 *   ts_scene_free(scene); */
#ifndef TOUCHSTONE_RENDER_H
#define TOUCHSTONE_RENDER_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/params.h>
#include <touchstone/scene.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct ts_render ts_render;

/* Runs `method` of `effect`, a row of `touchstone list methods`, on `threads` threads, 0 (which counts as 1) to 1024,
 * or as many of them as the process can have; threads never change a result. On success *render owns the buffers and
 * must be released with ts_render_free before the scene; on failure it is NULL. A process whose arithmetic breaks the
 * numeric contract is refused. The scene's mirrors are those of the parameters it was opened with; frame, size and
 * everything else are taken from params. */
TS_API ts_status ts_render_run(ts_render **render, const ts_scene *scene, const ts_params *params, const char *effect,
                               const char *method, uint32_t threads);

/* Releases a finished render; NULL is allowed. */
TS_API void ts_render_free(ts_render *render);

/* A buffer by its name in records.def. */
typedef struct {
	const char *name;    /* "stage.buffer" */
	const char *element; /* a scalar (f32, u8, u32, u64) or a record of records.def */
	size_t element_bytes;
	const void *data; /* C order; belongs to the render */
	uint32_t n_dims;
	uint64_t shape[4];
	const char *order; /* order class: sequence, set or multiset */
	const char *key;   /* of a set: the buffer that holds its keys; else "" */
} ts_buffer_view;

/* TS_ERROR if there is no such buffer, or this method did not make it. Methods that work in batches, of cubes or depth
 * maps, leave those buffers of the last batch. */
TS_API ts_status ts_render_buffer(const ts_render *render, const char *name, ts_buffer_view *view);

/* What was counted: "points", "shading operations", ... 0 if this method does not count that. */
TS_API int64_t ts_render_counter(const ts_render *render, const char *name);

#ifdef __cplusplus
}
#endif
#endif
