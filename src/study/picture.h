/* Pictures of the eye's size: of runs, and of the truths. */
#ifndef TS_CLI_PICTURE_H
#define TS_CLI_PICTURE_H
#include "../methods/stage.h"
#include "../truth/table.h"

/* Pixels of a picture with shadows: in sight; lit by all samples of all lights, by some, by none. */
typedef struct {
	u64 seen, full, part, none;
} ts_lit;

/* An image as radiance and as displayed, of the eye's size. */
typedef struct {
	char name[24]; /* "epr", "truth-a", ... */
	f32 *radiance;
	u8 *srgb;
	u8 *seen;       /* 1: the eye sees a surface, 0: the sky; NULL: not known */
	u8 *reflective; /* 1: of a mirror; NULL: no mirrors were looked for */
	u64 n_reflective;
	const u8 *before;       /* srgb of the frame before, of a sequence; not owned; NULL: there is none */
	u8 *near, *elsewhere;   /* 1: a surface near a triangle of light, or not (near_light.h); NULL: there are none */
	f32 gain;               /* of its display values beside the exposure, but for the sky */
	double seconds;         /* that it took */
	ts_truth_cost cost;     /* of a truth by rays: those, and how long threads cast them at once; no rays: not known */
	double shading;         /* beside, of the same */
	u64 n_hits, n_missed;   /* of a truth that counts them: first rays that hit something, and look-ups empty there */
	ts_lit lit;             /* of shadows */
	u64 n_lamps, n_samples; /* lights, and samples of all of them */
	ts_sampling sampling;   /* of a truth */
	u8 *chosen, *all_srgb;  /* of a part of one: 1: a chosen pixel, where these are what all rays say; else NULL */
	f32 *all_radiance;
} ts_picture;

/* Copies image.radiance and image.srgb of the run, marks the pixels that see a surface and those near light, and counts
 * those that are lit. Released by ts_picture_free, also on failure. */
ts_status ts_picture_take(ts_picture *picture, const char *name, const ts_run *run);
/* Makes a picture of radiance, which it takes over. */
ts_status ts_picture_make(ts_picture *picture, const char *name, f32 *radiance, const ts_params *params);
void ts_picture_free(ts_picture *picture);
/* How much it changed since the frame before (ts_metrics_flicker), where `mask` is not 0; NaN: there is none. */
double ts_picture_change(const ts_picture *picture, const u8 *mask, const ts_params *params);

/* The distance of the two in grey levels, scaled, width x height x 3; by free(). NULL without memory. */
u8 *ts_picture_difference(const ts_picture *image, const ts_picture *reference, const ts_params *params, u32 scale);

/* "truth-a", of the row's name. */
void ts_picture_truth_name(char *name, size_t bytes, const ts_truth_kind *kind);

/* A truth that `trace` makes, in a run of a method that it starts from; afterwards the run's image is the truth's. */
ts_status ts_picture_truth(ts_picture *picture, const ts_truth_kind *kind, ts_run *run);
/* The truths of `truths` (bits of rows of ts_truths) that start as that row does, in one run of their own; into
 * pictures at their rows. */
ts_status ts_picture_truths_begun(ts_picture pictures[], u32 truths, const ts_truth_kind *first, const char *effect,
                                  const ts_scene *scene, const ts_params *params, u32 threads);
/* A truth that `radiance` makes. */
ts_status ts_picture_truth_alone(ts_picture *picture, const ts_truth_kind *kind, const ts_scene *scene,
                                 const ts_params *params, u32 threads);

#endif
