/* The format of an image file, by its first bytes. */
#ifndef TS_IMAGE_FORMAT_H
#define TS_IMAGE_FORMAT_H
#include <stdbool.h>
#include <stddef.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

enum { TS_IMAGE_HEAD = 16 }; /* bytes that identify a format */

/* OTHER: known formats that are not read. */
typedef enum { TS_IMAGE_UNKNOWN, TS_IMAGE_PNG, TS_IMAGE_JPEG, TS_IMAGE_EXR, TS_IMAGE_OTHER } ts_image_format;

/* The format of a file whose first n bytes are `head`: TS_IMAGE_HEAD or more, or the whole of a shorter file. *name
 * becomes the name of the format; `name` may be NULL. */
ts_image_format ts_image_format_find(const void *head, size_t n, const char **name);

/* The format of a file by its first bytes; refuses what ts_image_read does not read. */
ts_status ts_image_format_of(ts_image_format *format, const char *path);

/* Whether ts_image_decode decodes the format. */
static inline bool ts_image_format_is_decoded(ts_image_format format)
{
	return format == TS_IMAGE_PNG || format == TS_IMAGE_JPEG;
}

#ifdef __cplusplus
}
#endif
#endif
