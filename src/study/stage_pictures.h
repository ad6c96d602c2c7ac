/* Pictures of what the stages made, in false colours. */
#ifndef TS_CLI_STAGE_PICTURES_H
#define TS_CLI_STAGE_PICTURES_H
#include "../methods/stage.h"

enum { TS_MAX_STAGE_PICTURES = 8 };

typedef struct {
	char name[16];     /* "points", ... */
	char caption[128]; /* what the colours mean */
	u8 *rgb;
	u8 *mask; /* pixels that say something; NULL: all. The others become the image in grey */
	u32 width, height;
	u32 zoom; /* with a mask: pixels a pixel of the image, across and down */
} ts_stage_picture;

typedef struct {
	ts_stage_picture picture[TS_MAX_STAGE_PICTURES];
	u32 n;
} ts_stage_pictures;

/* What a picture can be taken of, when the stage that wrote the buffer has run. */
typedef struct {
	ts_buffer_id buffer;
	ts_status (*take)(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id buffer);
} ts_stage_picture_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `take`. They must stay. */
void ts_stage_pictures_use(const ts_stage_picture_rule *const *rules);

/* A black picture, with a mask that nothing is in yet if `masked`; NULL without memory, or if there are too many. */
ts_stage_picture *ts_stage_pictures_add(ts_stage_pictures *pictures, const char *name, u32 width, u32 height,
                                        bool masked);
/* NULL: it was not taken. */
ts_stage_picture *ts_stage_pictures_find(ts_stage_pictures *pictures, const char *name);
/* Takes the pictures that can be made of what `stage` has just written. Zero-initialise before the run. */
ts_status ts_stage_pictures_take(ts_stage_pictures *pictures, const ts_run *run, const ts_stage *stage);
/* Puts the image, of the eye's size, behind the pictures with a mask. */
void ts_stage_pictures_finish(ts_stage_pictures *pictures, const u8 *srgb);
void ts_stage_pictures_free(ts_stage_pictures *pictures);

#endif
