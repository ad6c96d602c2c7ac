/* T_epr of every piece. */
#include "kernels/points/align.h"
#include "methods/stages.h"

static const ts_launch launch = TS_LAUNCH(align, TS_ALL);

static ts_status align(ts_run *run)
{
	ts_align_args args;
	return TS_RUN(run, &launch, &args, ts_run_size(run, TS_DIM_pieces));
}

const ts_stage ts_stage_align = {
	.name = "align",
	.kind = "map",
	.paper = "EPR 3.2, eq. 1",
	.doc = "T_epr: every piece in its own plane",
	.run = align,
	.launches = TS_LAUNCHES(&launch),
};
