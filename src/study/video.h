/* Videos of frames that were written, by ffmpeg where it is installed. */
#ifndef TS_STUDY_VIDEO_H
#define TS_STUDY_VIDEO_H
#include "../model/core.h"

#define TS_VIDEO_RATE "30" /* frames a second */

/* Writes the video `name` of the PNG files of the folder of results that the pattern of a shell names, in their order:
 * H.264 in MP4. The same files give the same bytes. Where ffmpeg is not installed, or fails, *why says so and there is
 * no video; else it is "". Fails where a video cannot be kept. */
ts_status ts_video_write(char *why, size_t why_bytes, const char *name, const char *pattern);

#endif
