/* The tables of `bench` that are of this family. */
#ifndef TS_METHODS_HULLS_TOOLS_BENCHES_H
#define TS_METHODS_HULLS_TOOLS_BENCHES_H
#include "study/bench.h"
#include "study/bench_paper.h"
#include "study/claims.h"

extern const ts_claim ts_hulls_claims[];
extern const ts_paper_table ts_ssagh_1, ts_ssagh_2, ts_ssagh_3, ts_ssagh_4, ts_ssagh_gloss, ts_ssagh_flicker;
ts_status ts_bench_segments(const ts_job *job);
ts_status ts_bench_borders(const ts_job *job);
ts_status ts_bench_curves(const ts_job *job);
ts_status ts_bench_logistic(const ts_job *job);
ts_status ts_bench_cosines(const ts_job *job);
/* For ssagh-7: the accuracy in single precision of the integrals as printed. */
void ts_bench_printed(ts_report *report);

#endif
