/* Functions of this folder's files: for tools.c, and the tables of bench. */
#ifndef TS_METHODS_VIEWS_TOOLS_TOOLS_H
#define TS_METHODS_VIEWS_TOOLS_TOOLS_H
#include "kernels/base/vec.h"
#include "replay/check.h"
#include "study/stage_pictures.h"
#include "study/tables/text.h"
#include "trace/where.h"
#include "truth/sampling.h"
#include "truth/texels.h"

typedef struct ts_vpl_gather_args ts_vpl_gather_args;

extern const ts_check_rule ts_views_checks[];

/* Truths of many lights (truth_vpls.c). All virtual point lights of params.vpl_paths, each with its distance bounded as
 * in vpl_gather, if nothing stands between pixel and light; surfaces within a leaf's diagonal of the light do not
 * count, since the methods skip them too. Runs the stages that make the lights. Reads gbuffer.pixel; makes
 * indirect.irradiance in run->frame, from which stage `image.indirect` makes the picture. Fails without memory. */
ts_status ts_truth_vpls(ts_truth *truth, ts_run *run, ts_sampling *sampling);

/* Truth of all params.particle_count glowing particles. Runs the stages before the particles of `effect`, in a run that
 * has just begun. */
ts_status ts_truth_particles_begin(ts_run *run, const char *effect);
/* Reads gbuffer.pixel; makes indirect.irradiance. */
ts_status ts_truth_glow(ts_truth *truth, ts_run *run, ts_sampling *sampling);

/* Maps of virtual point lights and particles after stage vpl_gather, whose buffers are there (truth_maps.c), of up to
 * 1024 lights at equal steps: rays through the middles of texels, from a leaf's diagonal away from the light on.
 * Depths, moved to the light, are right within three leaves' sides. For each light 64 random pixels that would receive
 * its light are tested with the parameters of shadows, whether these are on or off. Fails if a buffer is missing. */
ts_status ts_truth_maps(ts_texel_counts *counts, ts_truth *truth, const ts_run *run, ts_buffer_id id);

/* Reasons of truth_wrong.def. */
typedef enum {
#define WRONG(id, ...) TS_WRONG_##id,
#include "methods/views/tools/truth_wrong.def"
#undef WRONG
	TS_N_WRONG
} ts_wrong;

_Static_assert((u32)TS_N_WRONG <= (u32)TS_MOST_REASONS, "room for all");

extern const char *const ts_wrong_names[]; /* their counters, ended by NULL (truth_wrong.c) */

/* The reason for the wrong answer `lit` of a view's map about the place p with the normal n. Surfaces within `reach` of
 * a light block nothing; leaves whose middles are within `apart` radii of that of the view's leaf are not in maps. */
ts_wrong ts_truth_wrong(const ts_truth *truth, const ts_vpl_gather_args *of, u32 view, ts_v3 p, ts_v3 n, f32 reach,
                        f32 apart, bool lit);

/* Places of pairs of nodes (where.c). */
extern const ts_where_rule ts_views_places[];

/* Pictures of the maps of views (pictures.c). */
extern const ts_stage_picture_rule ts_views_pictures[];

/* Tables of bench. */

extern const ts_table_code ts_views_codes[];

#endif
