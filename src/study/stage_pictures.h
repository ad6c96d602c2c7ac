/* What is made for people and viewers of the outputs of stages: pictures in false colours, and copies of buffers in
 * other formats; never hashed, never compared. */
#ifndef TS_STUDY_STAGE_PICTURES_H
#define TS_STUDY_STAGE_PICTURES_H
#include "methods/stage.h"

enum { TS_MAX_STAGE_PICTURES = 8 };

typedef struct {
	char name[16];     /* "points", ... */
	char caption[128]; /* what the colours mean */
	u8 *rgb;
	u8 *mask; /* 1: the pixel has a false colour; others show the image in grey. NULL: all are coloured */
	u32 width, height;
	u32 zoom; /* with a mask: pixels across and down for one pixel of the image */
} ts_stage_picture;

typedef struct {
	ts_stage_picture picture[TS_MAX_STAGE_PICTURES];
	u32 n;
} ts_stage_pictures;

/* A buffer, and the function that takes its picture when the stage that wrote it has run. */
typedef struct {
	ts_buffer_id buffer;
	ts_status (*take)(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id buffer);
} ts_stage_picture_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `take`. They must stay. */
void ts_stage_pictures_use(const ts_stage_picture_rule *const *rules);

/* Adds a black picture, with an empty mask if `masked`; NULL without memory, or if there are too many pictures. */
ts_stage_picture *ts_stage_pictures_add(ts_stage_pictures *pictures, const char *name, u32 width, u32 height,
                                        bool masked);
/* The picture of that name; NULL: it was not taken. */
ts_stage_picture *ts_stage_pictures_find(ts_stage_pictures *pictures, const char *name);
/* Takes the pictures of the buffers that `stage` has just written. *pictures must be zero before the run. */
ts_status ts_stage_pictures_take(ts_stage_pictures *pictures, const ts_run *run, const ts_stage *stage);
/* Puts the image, of the eye's size, behind the pictures with a mask. */
void ts_stage_pictures_finish(ts_stage_pictures *pictures, const u8 *srgb);
void ts_stage_pictures_free(ts_stage_pictures *pictures);

/* Copies. */

/* A buffer, and the function that writes its copy into a folder of the output. */
typedef struct {
	ts_buffer_id buffer;
	ts_status (*write)(const ts_run *run, const char *folder);
} ts_viewer_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `write`. They must stay. */
void ts_viewer_use(const ts_viewer_rule *const *rules);
/* For rules: the path of a file in that folder, valid until the next call but one; NULL: failed. */
const char *ts_viewer_file(const char *folder, const char *name);

/* Writes the copies of the buffers that a stage has just made. */
ts_status ts_viewer_take(const ts_run *run, const ts_stage *stage, const char *folder);

#endif
