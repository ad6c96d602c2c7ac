/* Text about a picture in its PNG or EXR file; the text never depends on the time or the machine. */
#ifndef TS_IMAGE_ABOUT_H
#define TS_IMAGE_ABOUT_H
#include <touchstone/image.h>
#include "model/param.h"

/* Texts as ts_image_write_png takes them: Software, touchstone:scene, touchstone:effect, touchstone:shows and
 * touchstone:params. */
typedef struct {
	ts_image_text texts[6];
	char shows[96], params[TS_N_PARAMS * 128];
} ts_about;

/* Fills *about. scene and effect belong to the caller and must outlive *about; shows (a method, a truth, a difference)
 * is copied. The text of params holds NAME=VALUE of each parameter whose value is not its default, separated by spaces.
 */
void ts_about_make(ts_about *about, const char *scene, const char *effect, const char *shows, const ts_params *params);

#endif
