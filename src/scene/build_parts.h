/* The inside of a build, for the files build*.c only. */
#ifndef TS_SCENE_BUILD_PARTS_H
#define TS_SCENE_BUILD_PARTS_H
#include "model/core.h"
#include "scene/build.h"

struct ts_build {
	ts_scene *scene;
	u32 object;  /* the current one, to which new vertices belong */
	bool placed; /* `place` has set box, hall and eye */
	ts_info place;
	u32 n_given; /* if placed: triangles before mirrors are added */
	struct {
		u32 object; /* the object of the motion */
		ts_motion *frames;
	} * motions;
	u32 n_motions, n_frames; /* of each motion */
	ts_vertex *own;          /* vertices of the objects that move, in object space, in the order of the others */
	u32 n_own;
	u64 n_outside; /* vertices and surfels with a colour outside 0 to 1 */
	ts_kind kind;  /* of failures that name no other; after the first, its kind */
	bool failed;
	ts_stop *stop; /* of the work that builds */
	char message[512];
	struct {
		size_t vertices, triangles, materials, slots, images, texels, lights, objects, surfels, cameras, nodes, notes;
		size_t motions, own;
	} capacity;
};

/* Makes room for `more` elements after the first n of an array of *capacity elements. Returns the array, moved or not.
 * On failure the array is as it was and the build has failed. */
void *ts_build_room(ts_build *build, void *array, u64 n, u64 more, size_t *capacity, size_t size, const char *what);

/* build_motion.c: sets the moving objects of the file, so far at frame 0, in motion. */
void ts_build_set_in_motion(ts_build *build);
void ts_build_motions_free(ts_build *build);

/* Room for one more record of a scene's array; false if the build has failed. */
#define TS_BUILD_ROOM(build, array, what) \
	((build)->scene->array = ts_build_room(build, (build)->scene->array, (build)->scene->n_##array, 1, \
	                                       &(build)->capacity.array, sizeof *(build)->scene->array, what), \
	 !(build)->failed)

/* Computes box, hall and, of a scene whose place was chosen, the eye. */
void ts_build_measure(ts_build *build);

/* Computes the hall from the box and the triangles of object 0. Out of memory the build fails. */
void ts_build_walls(ts_build *build);

#endif
