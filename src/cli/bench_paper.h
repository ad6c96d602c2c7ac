/* What the EPR paper's tables 1 and 2 print. */
#ifndef TS_CLI_BENCH_PAPER_H
#define TS_CLI_BENCH_PAPER_H
#include "../kernels/compat.h"

typedef struct {
	const char *name;           /* of the paper's scene */
	const char *builtin;        /* our scene of its kind */
	const char *file;           /* what the name of a file of it begins with */
	u32 objects;
	double diameter, epr_ops, mvr_ops, ratio;   /* table 1: pixels, operations */
	double triangles;           /* from here on table 2 */
	double speedup;             /* over MVR */
	double rmse_difference;     /* EPR less MVR, percent of 255 */
	double point_ms, view_ms, deferred_ms, deferred2_ms, total_ms, mvr_ms;
	double points;
} ts_paper_row;

/* The row of a scene (a built-in's name, with or without ":...", or a path) and a number of mirrors; NULL if the paper
 * has none. */
const ts_paper_row *ts_paper_find(const char *scene, u32 objects);

#endif
