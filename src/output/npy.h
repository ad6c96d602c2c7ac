/* The .npy format, versions 1 to 3: what numpy.save writes and numpy.load reads. Headers only; the data behind a header
 * is the array's elements, little-endian, in C order. Files are untrusted: everything is checked, and no size of an
 * allocation comes from them. */
#ifndef TS_OUTPUT_NPY_H
#define TS_OUTPUT_NPY_H
#include "model/shape.h"

enum { TS_NPY_HEADER = 4096 };

/* Writes a version 1 header and returns its bytes, a multiple of 64. descr: the dtype of an element as numpy writes
 * it. */
size_t ts_npy_header(char header[TS_NPY_HEADER], const char *descr, u32 n_dims, const u64 *shape);

/* The content of a file's header. */
typedef struct {
	u32 n_dims;
	u64 shape[TS_MAX_DIMS];
	u64 n;       /* elements: product of the shape */
	u64 data_at; /* offset of the first element */
} ts_npy;

/* Reads the header of a file of file_bytes, of which `head` are the first head_bytes (all, or at least TS_NPY_HEADER).
 * The file must hold an array of dtype `descr`, of element_bytes an element, in C order, of 1 to TS_MAX_DIMS
 * dimensions, and nothing behind it. `path` is for messages. */
ts_status ts_npy_parse(ts_npy *npy, const char *path, const char *head, size_t head_bytes, u64 file_bytes,
                       const char *descr, size_t element_bytes);
/* Writes a file of a header and elements. */
ts_status ts_npy_write(const char *path, const char *header, size_t header_bytes, const void *data, size_t bytes);

#endif
