/* The atomic limit of a machine: the kernel bench_min on a buffer like cube_face.depth_triangle. */
#include "kernels/base/bench.h"
#include "study/bench.h"

enum { OFFERS = 1 << 23 }; /* per launch, at least */

static const ts_launch bench_min = TS_LAUNCH(bench_min, TS_ALL);

static ts_status fill(ts_backend *backend, ts_frame *frame, u64 n)
{
	if (ts_frame_make1(frame, TS_B_cube_face_depth_triangle, n) == NULL) return TS_ERROR;
	ts_status status = backend->fill(backend, frame, TS_B_cube_face_depth_triangle, 0xff);
	return status == TS_OK ? backend->finish(backend) : status;
}

/* Launches follow each other without a wait, so that a device is never idle between them. */
static ts_status offer(ts_backend *backend, ts_frame *frame, u32 n, u32 launches)
{
	ts_bench_min_args args = {.texels = ts_frame_handle(frame, TS_B_cube_face_depth_triangle), .n_texels = n};
	ts_status status = TS_OK;
	for (args.distance = launches; status == TS_OK && args.distance-- > 0;) {
		status = backend->launch(backend, frame, &bench_min, &args, n);
	}
	return status == TS_OK ? backend->finish(backend) : status;
}

ts_status ts_bench_atomics(double *a_second, const ts_how *how, u64 bytes)
{
	u32 n = (u32)(bytes / sizeof(u64)), launches = n < OFFERS ? OFFERS / n : 1;
	ts_c_backend c;
	ts_frame frame = {.bytes = 0};
	ts_c_begin(&c, how->threads);
	ts_backend *backend = how->backend != NULL ? how->backend : &c.backend;
	ts_status status = fill(backend, &frame, n);
	double begin = ts_seconds();
	if (status == TS_OK) status = offer(backend, &frame, n, launches);
	*a_second = (double)n * launches / (ts_seconds() - begin);
	ts_frame_clear(&frame);
	return status;
}
