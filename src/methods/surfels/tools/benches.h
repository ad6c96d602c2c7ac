/* The tables of `bench` that are of this family. */
#ifndef TS_METHODS_SURFELS_TOOLS_BENCHES_H
#define TS_METHODS_SURFELS_TOOLS_BENCHES_H
#include "study/bench.h"
#include "study/bench_paper.h"
#include "study/claims.h"
#include "study/speed.h"

extern const ts_speed_of ts_surfels_speed;
extern const ts_claim ts_surfels_claims[];
extern const ts_paper_table ts_nv40, ts_nv40_shading, ts_nv40_filter, ts_nv40_discs;
ts_status ts_bench_crumbs(const ts_job *job);

#endif
