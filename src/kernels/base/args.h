/* Arguments of kernels, declared once: a struct's members as rows
 *
 *   #define TS_ROWS_ts_splat_args(ARG) \
 *       ARG(IN, ts_face, cubes, cube_size_face) \
 *       ARG(VALUE, u32, n_cubes, none)
 *   TS_ARGS(ts_splat_args);
 *
 * From the rows this file makes the struct, and backends/args.c the tables that backends and stages read. A row has a
 * role, a type, a name, and the buffer of records.def to which the member is bound unless a launch binds another; or
 * none.
 *
 *   IN     elements that are read
 *   OUT    elements that are written, and read only where the same launch wrote them
 *   MIN    the least of the values that items offer; all ones at first
 *   SUM    elements that items add to, set or mark; zero at first
 *   WORK   memory that a stage lends; WORK_IN: memory that is only read
 *   TALLY  a counter for the report; the last column is its index among the stage's tallies
 *   VALUE  a number, or a struct of numbers
 *   INNER  a struct of arguments
 *   ..._PARTS  may be larger than a device allocates at once: element i is ts_at(name, i)
 *   ..._OPT    NULL unless a launch asks for the member
 *
 * The macros take fixed numbers of arguments, since OpenCL C has no variadic macros. */
#ifndef TS_KERNELS_BASE_ARGS_H
#define TS_KERNELS_BASE_ARGS_H
#include "kernels/base/compat.h"

#ifndef TS_ARGS_ALSO /* what backends/args.c makes of the rows */
#define TS_ARGS_ALSO(type)
#endif
#define TS_ARGS(type) \
	typedef struct type { \
		TS_ROWS_##type(TS_MEMBER) \
	} type TS_ARGS_ALSO(type)
#define TS_MEMBER(role, type, name, from) TS_MEMBER_##role(type, name)
#define TS_MEMBER_IN(type, name) TS_GLOBAL const type *name;
#define TS_MEMBER_IN_OPT(type, name) TS_MEMBER_IN(type, name)
#define TS_MEMBER_IN_PARTS(type, name) TS_PARTED(const type, name);
#define TS_MEMBER_IN_PARTS_OPT(type, name) TS_MEMBER_IN_PARTS(type, name)
#define TS_MEMBER_OUT(type, name) TS_GLOBAL type *name;
#define TS_MEMBER_OUT_OPT(type, name) TS_MEMBER_OUT(type, name)
#define TS_MEMBER_OUT_PARTS(type, name) TS_PARTED(type, name);
#define TS_MEMBER_OUT_PARTS_OPT(type, name) TS_MEMBER_OUT_PARTS(type, name)
#define TS_MEMBER_MIN(type, name) TS_MEMBER_OUT(type, name)
#define TS_MEMBER_MIN_OPT(type, name) TS_MEMBER_OUT(type, name)
#define TS_MEMBER_MIN_PARTS(type, name) TS_MEMBER_OUT_PARTS(type, name)
#define TS_MEMBER_SUM(type, name) TS_MEMBER_OUT(type, name)
#define TS_MEMBER_SUM_OPT(type, name) TS_MEMBER_OUT(type, name)
#define TS_MEMBER_SUM_PARTS_OPT(type, name) TS_MEMBER_OUT_PARTS(type, name)
#define TS_MEMBER_WORK(type, name) TS_MEMBER_OUT(type, name)
#define TS_MEMBER_WORK_IN(type, name) TS_MEMBER_IN(type, name)
#define TS_MEMBER_TALLY(type, name) TS_MEMBER_OUT(type, name)
#define TS_MEMBER_TALLY_OPT(type, name) TS_MEMBER_OUT(type, name)
#define TS_MEMBER_VALUE(type, name) type name;
#define TS_MEMBER_INNER(type, name) type name;

#endif
