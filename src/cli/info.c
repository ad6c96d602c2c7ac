/* `info SCENE`: what was loaded, and which parts of the file were not understood. */
#include "cli/client.h"
#include "output/file.h"

static ts_status print(const ts_scene *scene, bool json)
{
	ts_file_text text;
	if (ts_file_text_begin(&text, "the description") != TS_OK) return TS_ERROR;
	ts_status status = ts_scene_print(scene, text.out, json);
	if (status == TS_OK) return ts_file_text_print(&text);
	ts_file_text_drop(&text);
	return status;
}

ts_status ts_info_command(ts_cli *cli)
{
	ts_context *context;
	ts_scene *scene = NULL;
	const ts_job *job = &cli->job;
	ts_status status = ts_client_open(&context, cli);
	if (status == TS_OK) status = ts_scene_open(context, &scene, cli->arguments[0], &job->params, &job->scene.options);
	if (status == TS_OK) status = print(scene, job->output.json);
	ts_scene_free(scene);
	ts_context_close(context);
	return status;
}
