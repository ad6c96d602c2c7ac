/* The header of a PLY file (Turk 1994): what its points are made of and where they begin. */
#ifndef TS_SCENE_PLY_HEADER_H
#define TS_SCENE_PLY_HEADER_H
#include "../build.h"

enum { TS_PLY_PROPERTIES = 64, TS_PLY_NAME = 64 };

typedef enum { TS_PLY_ASCII, TS_PLY_LITTLE, TS_PLY_BIG } ts_ply_format;
typedef enum {
	TS_PLY_I8,
	TS_PLY_U8,
	TS_PLY_I16,
	TS_PLY_U16,
	TS_PLY_I32,
	TS_PLY_U32,
	TS_PLY_F32,
	TS_PLY_F64,
	TS_PLY_TYPES,
} ts_ply_type;

typedef struct {
	char name[TS_PLY_NAME];
	ts_ply_type type;
} ts_ply_property;

typedef struct {
	ts_ply_format format;
	u32 n; /* points */
	u32 n_properties;
	ts_ply_property property[TS_PLY_PROPERTIES]; /* of a point, in the file's order */
	size_t stride;                               /* bytes of a point; of ASCII the fewest that it can have */
	size_t begin;                                /* of the points in the file */
	bool more;                                   /* elements behind the points */
} ts_ply_header;

extern const u32 ts_ply_bytes[TS_PLY_TYPES];

/* Reads the header of the `n` bytes of a file. Fails the build, and returns false, unless the first element is
 * "vertex", has scalar properties only, and no more of them than the file has bytes for. */
bool ts_ply_header_read(ts_ply_header *header, ts_build *build, const char *path, const char *file, size_t n);

#endif
