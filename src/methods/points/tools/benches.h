/* The tables of `bench` that are of this family. */
#ifndef TS_POINTS_TOOLS_BENCHES_H
#define TS_POINTS_TOOLS_BENCHES_H
#include "../../../study/bench.h"
#include "../../../study/bench_paper.h"
#include "../../../study/claims.h"

/* As the iVIR paper has it, and a quarter of its image, faces and mirrors. */
#define TS_IVIR_DEFAULTS "density.rate=paper,points.snap=off"
#define TS_IVIR_FACE "128"
#define TS_IVIR_QUARTER "cube.max_px=" TS_IVIR_FACE ",reflectors.px=28.75"
#define TS_IVIR_QUARTER_NOTE "A quarter of 1920 x 1080, faces of 512 and mirrors of 115 pixels, for VIR's points."
#define TS_IVIR_NEAREST "a texel has the nearest of its points, not what is at its centre"
#define TS_IVIR_SMALL "points of pieces that are small enough to be culled count at their own place"
#define TS_VIR_NOTE "VIR is a reconstruction (METHODS 9)."
#define TS_OMNI_NOTE "Depth maps have 256 x 256 texels, the paper's 1024 x 1024."

/* The stages that make points, those that fill off-screen views, and both: what the iVIR paper's totals are of. */
#define TS_POINT_STAGES "visibility,offscreen.visibility,split,split.views,split.shadow,cull,align,points.count,points"
#define TS_VIEW_STAGES "splat,scatter,scatter.colour,environment_map,cube_face,depth_map,shadow_cube_size,shadow_splat"
#define TS_MAP_STAGES TS_POINT_STAGES "," TS_VIEW_STAGES

extern const ts_claim ts_points_claims[];
extern const ts_paper_table ts_ivir_1, ts_ivir_2, ts_ivir_3, ts_ivir_culling, ts_ivir_4, ts_ivir_5, ts_ivir_6;
extern const ts_paper_table ts_epr_1, ts_epr_2, ts_epr_3, ts_epr_5, ts_epr_costs, ts_epr_buffers;
ts_status ts_bench_sweep(const ts_job *job);

#endif
