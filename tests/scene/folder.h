/* The folder of scenes that tests read: $TS_SCENES, or the project's own. */
#ifndef TS_TESTS_SCENE_FOLDER_H
#define TS_TESTS_SCENE_FOLDER_H
#include <stdlib.h>

static inline const char *scenes_folder(void)
{
	const char *folder = getenv("TS_SCENES");
	return folder != NULL ? folder : "scenes";
}

#endif
