/* What the header of an EXR file says of its size (OpenEXR File Layout). */
#ifndef TS_IMAGE_EXR_H
#define TS_IMAGE_EXR_H
#include <stddef.h>
#include <stdint.h>

/* The pixels of all parts of a file of n bytes; UINT64_MAX: more chunks than the bytes can list. A header that cannot
 * be followed ends what is counted: its library refuses it. */
uint64_t ts_exr_pixels(const uint8_t *file, size_t n);

#endif
