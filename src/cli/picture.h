/* Pictures of the eye's size: of runs, and of the truths. */
#ifndef TS_CLI_PICTURE_H
#define TS_CLI_PICTURE_H
#include "../stages/stage.h"

enum { TS_TRUTH_C_FACTOR = 4 };

/* Pixels of a picture with shadows: in sight; lit by all samples of all lights, by some, by none. */
typedef struct { u64 seen, full, part, none; } ts_lit;

/* An image as radiance and as displayed, of the eye's size. */
typedef struct {
	char name[24];   /* "epr", "truth-a", ... */
	f32 *radiance;
	u8 *srgb;
	u8 *seen;        /* 1: the eye sees a surface, 0: the sky; NULL: not known */
	double seconds;  /* that it took */
	u64 n_hits, n_missed; /* of truth A: its rays that hit something, and EPR's look-ups that are empty there */
	ts_lit lit;      /* of shadows */
	u64 n_lamps, n_samples; /* lights, and samples of all of them */
} ts_picture;

/* Copies image.radiance and image.srgb of the run, marks what is seen, and counts what is lit. Released by
 * ts_picture_free, also on failure. */
ts_status ts_picture_take(ts_picture *picture, const char *name, const ts_run *run);
/* Makes a picture of radiance, which it takes over. */
ts_status ts_picture_make(ts_picture *picture, const char *name, f32 *radiance, const ts_params *params);
void ts_picture_free(ts_picture *picture);

/* Truths A, B (TS_TRUTH_* of cli.h) of an EPR run, into *picture; afterwards the run's image is the truth's. */
ts_status ts_picture_truth(ts_picture *picture, u32 truth, ts_run *run);
/* Truth C. */
ts_status ts_picture_truth_c(ts_picture *picture, const ts_scene *scene, const ts_params *params, u32 threads);

/* A truth of surfels, TS_AT_DISCS or TS_AT_SURFACE. */
ts_status ts_picture_truth_surfels(ts_picture *picture, u32 at, const ts_scene *scene, const ts_params *params,
                                   u32 threads);

/* Truths of shadows or of indirect light, those of `truths` (TS_TRUTH_*), in a run of their own; into
 * pictures[TS_AT_*]. */
ts_status ts_picture_truth_traced(ts_picture pictures[], u32 truths, const char *effect, const ts_scene *scene,
                                  const ts_params *params, u32 threads);

#endif
