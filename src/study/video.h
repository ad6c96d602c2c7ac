/* Makes videos of written frames by ffmpeg, where it is installed. */
#ifndef TS_STUDY_VIDEO_H
#define TS_STUDY_VIDEO_H
#include "model/core.h"

#define TS_VIDEO_RATE "30" /* frames a second */

/* Writes the video `name` (H.264 in MP4) of those PNG files of the folder of results that a shell pattern matches, in
 * their order. The same files give the same bytes. Where ffmpeg is not installed or fails, `why` says so and there is
 * no video; otherwise `why` is "". Fails where the video cannot be stored. */
ts_status ts_video_write(char *why, size_t why_bytes, const char *name, const char *pattern);

#endif
