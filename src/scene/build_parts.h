/* The inside of a build, for the files build*.c only. */
#ifndef TS_SCENE_BUILD_PARTS_H
#define TS_SCENE_BUILD_PARTS_H
#include "build.h"

struct ts_build {
	ts_scene *scene;
	u32 object;  /* that new vertices belong to */
	bool placed; /* box, hall and eye are those of `place` */
	ts_info place;
	struct {
		u32 object; /* that it moves */
		ts_motion *frames;
	} * motions;
	u32 n_motions, n_frames; /* of each motion */
	ts_vertex *own;          /* vertices of the objects that move, in object space, in the order of the others */
	u32 n_own;
	bool failed;
	char message[512];
	struct {
		size_t vertices, triangles, materials, slots, images, texels, lights, objects, surfels, cameras, nodes, notes;
		size_t motions, own;
	} capacity;
};

/* Makes room for `more` elements after the first n of an array of *capacity elements. Returns the array, moved or not.
 * On failure the array is as it was and the build has failed. */
void *ts_build_room(ts_build *build, void *array, u64 n, u64 more, size_t *capacity, size_t size, const char *what);

/* The moving objects of the file, which stood at frame 0, go their ways: build_motion.c. */
void ts_build_set_in_motion(ts_build *build);
void ts_build_motions_free(ts_build *build);

/* Room for one more record of a scene's array; false if the build has failed. */
#define TS_BUILD_ROOM(build, array, what) \
	((build)->scene->array = ts_build_room(build, (build)->scene->array, (build)->scene->n_##array, 1, \
	                                       &(build)->capacity.array, sizeof *(build)->scene->array, what), \
	 !(build)->failed)

/* The box of the triangles of object 0 and the centres of the surfels; where there is neither, of all objects that
 * stand still. Triangles whose corners do not exist are passed over. */
void ts_build_box(ts_scene *scene);

/* Box, hall and, of a scene whose place was chosen, eye. */
void ts_build_measure(ts_build *build);

/* The hall, from the box and the triangles of object 0. Fails without memory. */
void ts_build_walls(ts_build *build);

#endif
