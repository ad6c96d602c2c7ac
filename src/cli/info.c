/* `info SCENE`: what was loaded, and what in the file was not understood. */
#include <stdio.h>
#include "cli.h"

ts_status ts_info_command(ts_cli *cli)
{
	ts_scene *scene;
	ts_status status = ts_scene_open(&scene, cli->arguments[0], &cli->job.params, &cli->job.scene);
	if (status == TS_OK) status = ts_scene_print(scene, stdout, cli->job.output.json);
	ts_scene_free(scene);
	return status;
}
