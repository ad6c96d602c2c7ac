/* The tables of `bench` that are of this family. */
#ifndef TS_POINTS_TOOLS_BENCHES_H
#define TS_POINTS_TOOLS_BENCHES_H
#include "../../../study/bench.h"
#include "../../../study/bench_paper.h"

/* As the iVIR paper has it. */
#define TS_IVIR_DEFAULTS "rate=paper,snap=off"
#define TS_OMNI_NOTE "Depth maps of 256 x 256 instead of the paper's 1024 x 1024, for VIR's points."

extern const ts_paper_table ts_ivir_1, ts_ivir_2, ts_ivir_3, ts_epr_1, ts_epr_2, ts_epr_3;
ts_status ts_bench_sweep(const ts_job *job);

#endif
