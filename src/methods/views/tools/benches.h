/* The tables of `bench` that are of this family. */
#ifndef TS_METHODS_VIEWS_TOOLS_BENCHES_H
#define TS_METHODS_VIEWS_TOOLS_BENCHES_H
#include "study/bench.h"
#include "study/bench_paper.h"
#include "study/claims.h"
#include "study/speed.h"

extern const ts_speed_of ts_views_speed;
extern const ts_claim ts_views_claims[];
extern const ts_paper_table ts_mega_9, ts_mega_10, ts_mega_10_bounces, ts_mega_11, ts_mega_12, ts_mega_13, ts_mega_14,
	ts_mega_15, ts_mega_16, ts_mega_17, ts_mega_particles;

/* Share of the empty texels in the fused maps of leaves, %; NAN without maps (bench_mega.c). */
double ts_empty_share(const ts_run *run);

#endif
