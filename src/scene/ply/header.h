/* The header of a PLY file (Turk 1994): the properties of its points, the elements before them, and where the points
 * begin. */
#ifndef TS_SCENE_PLY_HEADER_H
#define TS_SCENE_PLY_HEADER_H
#include "scene/build.h"

/* Bounds of a header: elements up to the points, properties of all of these, lines, and bytes of a name. */
enum { TS_PLY_ELEMENTS = 64, TS_PLY_PROPERTIES = 1024, TS_PLY_LINES = 100000, TS_PLY_NAME = 64 };

typedef enum { TS_PLY_ASCII, TS_PLY_LITTLE, TS_PLY_BIG } ts_ply_format;
typedef enum {
	TS_PLY_I8,
	TS_PLY_U8,
	TS_PLY_I16,
	TS_PLY_U16,
	TS_PLY_I32,
	TS_PLY_U32,
	TS_PLY_I64,
	TS_PLY_U64,
	TS_PLY_F16, /* these and what follows are floats */
	TS_PLY_F32,
	TS_PLY_F64,
	TS_PLY_TYPES,
} ts_ply_type;

typedef struct {
	char name[TS_PLY_NAME];
	ts_ply_type type;
	bool is_list;
	ts_ply_type length; /* of a list the type of its length; otherwise as `type` */
} ts_ply_property;

typedef struct {
	char name[TS_PLY_NAME];
	u64 n;
	u32 first, n_properties; /* its part of the header's properties, in the file's order */
	size_t bytes;            /* the least that one element takes */
} ts_ply_element;

typedef struct {
	ts_ply_format format;
	u32 n_elements, n_properties;
	ts_ply_element element[TS_PLY_ELEMENTS]; /* up to the points, which are the last */
	ts_ply_property property[TS_PLY_PROPERTIES];
	size_t begin; /* of the first element in the file */
	bool more;    /* elements behind the points */
} ts_ply_header;

typedef struct {
	const char *name[4]; /* NULL behind the last; the first two are Turk's, or the writers' */
	u32 bytes;
	double least, most;
} ts_ply_kind;
extern const ts_ply_kind ts_ply_kinds[TS_PLY_TYPES];

/* Reads the header of the `n` bytes of a file. Fails the build, and returns false, unless there is an element "vertex"
 * of at least one point, and the file has bytes enough for it and the elements before it. */
bool ts_ply_header_read(ts_ply_header *header, ts_build *build, const char *path, const char *file, size_t n);

/* The element "vertex" of a header that was read: less than TS_NONE points. */
const ts_ply_element *ts_ply_header_points(const ts_ply_header *header);

#endif
