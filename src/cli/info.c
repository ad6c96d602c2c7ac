/* `info SCENE`: what was loaded, and what in the file was not understood. */
#include <stdio.h>
#include "../output/file.h"
#include "cli.h"

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
	ts_scene *scene;
	ts_status status = ts_scene_load(&scene, cli->arguments[0], &cli->job.params, &cli->job.scene);
	if (status == TS_OK) status = print(scene, cli->job.output.json);
	ts_scene_free(scene);
	return status;
}
