/* The tables of `bench` that are of this family. */
#ifndef TS_METHODS_POINTS_TOOLS_BENCHES_H
#define TS_METHODS_POINTS_TOOLS_BENCHES_H
#include "study/tables/text.h"

extern const ts_table_code ts_points_codes[];
ts_status ts_bench_sweep(const ts_job *job);

#endif
