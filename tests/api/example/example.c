/* Judges a port's stage in memory: renders a square of the caller's own, plants a wrong bit in what a port is said to
 * have made of stage `eye`, and finds it, alone and given the port's own inputs. Writes the picture to ARGUMENT. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <touchstone/touchstone.h>

static void check(ts_status status)
{
	if (status != TS_ERROR) return;
	fprintf(stderr, "%s\n", ts_error_message());
	exit(2);
}

static const ts_vertex corners[4] = {{.position = {-1, 0, 1}, .normal = {0, 1, 0}, .colour = {1, 1, 1, 1}},
                                     {.position = {1, 0, 1}, .normal = {0, 1, 0}, .colour = {1, 1, 1, 1}},
                                     {.position = {1, 0, -1}, .normal = {0, 1, 0}, .colour = {1, 1, 1, 1}},
                                     {.position = {-1, 0, -1}, .normal = {0, 1, 0}, .colour = {1, 1, 1, 1}}};
static const ts_triangle halves[2] = {{.vertex = {0, 1, 2}, .material = TS_NO_INDEX},
                                      {.vertex = {0, 2, 3}, .material = TS_NO_INDEX}};

int main(int n_words, char **word)
{
	ts_context *context;
	ts_params *params;
	ts_scene *scene;
	ts_trace *reference, *port;
	ts_verdicts *alone, *given;
	const ts_scene_arrays arrays = {
		.bytes = sizeof arrays, .vertices = corners, .n_vertices = 4, .triangles = halves, .n_triangles = 2};
	check(ts_context_open(&context, NULL));
	check(ts_params_make(&params));
	check(ts_params_set(params, "width", "96"));
	check(ts_params_set(params, "height", "54"));
	check(ts_scene_make(context, &scene, &arrays, params, NULL));
	check(ts_trace_run(context, &reference, scene, params, "reflections", "epr", NULL));
	const ts_buffer_view *image = ts_trace_buffer(reference, "image.srgb");
	if (n_words > 1) check(ts_image_write_png(word[1], image->data, 96, 54, 3, NULL));

	const ts_buffer_view *keys = ts_trace_buffer(reference, "eye.depth_triangle");
	uint64_t *theirs = malloc(54 * 96 * sizeof *theirs);
	if (theirs == NULL) return 2;
	memcpy(theirs, keys->data, 54 * 96 * sizeof *theirs);
	theirs[27 * 96 + 48] ^= 1ull << 32;
	check(ts_trace_candidate(context, &port, reference, 0));
	check(ts_trace_put(port, keys->name, keys->n_dims, keys->shape, theirs, 54 * 96 * sizeof *theirs));
	check(ts_compare(context, &alone, reference, port, NULL));
	check(ts_replay(context, &given, "eye", reference, port, NULL));
	puts(ts_verdicts_first(alone)->line);
	puts(ts_verdicts_first(given)->line);

	ts_verdicts_free(given);
	ts_verdicts_free(alone);
	ts_trace_close(port);
	ts_trace_close(reference);
	ts_scene_free(scene);
	ts_params_free(params);
	ts_context_close(context);
	free(theirs);
	return 0;
}
