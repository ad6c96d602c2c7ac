/* Pictures of the eye's size: of runs, and of the truths. */
#ifndef TS_STUDY_PICTURE_H
#define TS_STUDY_PICTURE_H
#include <touchstone/image.h>
#include "methods/stage.h"
#include "study/asked/truths.h"

/* Pixels of a picture with shadows: those in sight, and of these those lit by all samples of all lights, by some, by
 * none. */
typedef struct {
	u64 seen, full, part, none;
} ts_lit;

/* An image as radiance and as displayed, of the eye's size. */
typedef struct {
	char name[24]; /* "epr", "truth-a", ... */
	f32 *radiance;
	u8 *srgb;
	u8 *seen;       /* 1: the eye sees a surface, 0: the sky; NULL: not known */
	u8 *reflective; /* 1: the surface is a mirror's; NULL: not marked */
	u64 n_reflective;
	const u8 *before;       /* srgb of the frame before, of a sequence; not owned; NULL: there is none */
	u8 *near, *elsewhere;   /* 1: a surface near a triangle of light, or not (near_light.c); NULL: there are none */
	f32 gain;               /* factor of display values beside the exposure, but for the sky */
	double seconds;         /* to make the picture */
	ts_truth_cost cost;     /* of a truth by rays: number and time of the rays; no rays: not known */
	double shading;         /* seconds of a truth beside the rays */
	u64 n_hits, n_missed;   /* of a truth that counts them: first rays with a hit; the method's empty look-ups there */
	ts_lit lit;             /* of shadows */
	u64 n_lamps, n_samples; /* lights, and samples of all lights */
	ts_sampling sampling;   /* of a truth */
	u8 *chosen, *all_srgb;  /* of a truth made in part: 1 at chosen pixels; image of these, by all rays; else NULL */
	f32 *all_radiance;
} ts_picture;

/* A family's marks of pixels, and its counts of them, by buffers that the run made. */
typedef ts_status (*ts_picture_mark)(ts_picture *picture, const ts_run *run);
/* Takes the marks of all families: lists ended by NULL, each ended by NULL. They must stay. */
void ts_picture_marks_use(const ts_picture_mark *const *marks);

/* Copies image.radiance and image.srgb of the run, marks the pixels that see a surface, and what families mark.
 * Released by ts_picture_free, also on failure. */
ts_status ts_picture_take(ts_picture *picture, const char *name, const ts_run *run);
/* Makes a picture of radiance; takes `radiance` over. */
ts_status ts_picture_make(ts_picture *picture, const char *name, f32 *radiance, const ts_params *params);
void ts_picture_free(ts_picture *picture);
/* The change since the frame before (ts_metrics_flicker), where `mask` is not 0; NaN: there is no frame before. */
double ts_picture_change(const ts_picture *picture, const u8 *mask, const ts_params *params);

/* How far two pictures are apart, where `mask` is not 0: an estimate, where one is a truth in part. */
ts_metrics ts_picture_metrics(const ts_picture *reference, const ts_picture *image, const u8 *mask,
                              const ts_params *params);
/* The same in radiance, over the chosen pixels of an estimate. A relative RMSE depends on a few very bright pixels,
 * which a draw may miss, so it is not estimated. Fails without memory. */
ts_status ts_picture_light(ts_light_metrics *light, const ts_picture *reference, const ts_picture *image,
                           const u8 *mask, const ts_params *params);
/* The pixels that give the estimate, of two pictures the fewer; NULL: none is a truth in part. */
const u8 *ts_picture_chosen(const ts_picture *a, const ts_picture *b);
/* Makes a difference: of what is displayed the distance in grey levels, times `scale`; of radiance image - reference.
 * Released by ts_picture_free, also on failure. */
ts_status ts_picture_difference(ts_picture *difference, const ts_picture *image, const ts_picture *reference,
                                const ts_params *params, u32 scale);

/* Writes "truth-NAME", by the row's name. */
void ts_picture_truth_name(char *name, size_t bytes, const ts_truth_kind *kind);

/* Makes a truth by its `trace`, in a run of a method that it starts from; afterwards the run's image is the truth's. */
ts_status ts_picture_truth(ts_picture *picture, const ts_truth_kind *kind, ts_run *run);
/* Makes the truths of `truths` (bits of rows of ts_truths) that have the same `begin` as that row, in one run of their
 * own; writes pictures[row] of each. */
ts_status ts_picture_truths_begun(ts_picture pictures[], u32 truths, const ts_truth_kind *first, const char *effect,
                                  const ts_scene *scene, const ts_params *params, u32 threads);
/* Makes a truth by its `radiance`. */
ts_status ts_picture_truth_alone(ts_picture *picture, const ts_truth_kind *kind, const ts_scene *scene,
                                 const ts_params *params, u32 threads);

#endif
