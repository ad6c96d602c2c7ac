/* Fast path of the kernel that writes pieces, with the same bits: a triangle that is not split is its own piece. */
#include "backends/fast.h"
#include "kernels/points/split.h"

enum { TRIANGLES_A_CHUNK = 1024 };

/* A single piece is the triangle, and not too large, unless nothing may be split. */
static void split(const ts_density_args *args, u32 triangle)
{
	u32 n = args->offset[triangle + 1] - args->offset[triangle];
	if (n == 1 && args->split != 0) {
		ts_corners t = ts_k_corners(&args->scene, triangle);
		ts_part part = {{t.a, t.b, t.c}, 1};
		ts_k_piece_write(args, args->offset[triangle], triangle, &part, args->whole[triangle]);
	} else if (n > 0) {
		ts_k_split(args, triangle, true);
	}
}

bool ts_c_fast_split(const void *of, u64 n, u32 threads)
{
	const ts_density_args *args = of;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, TRIANGLES_A_CHUNK) num_threads(threads)
	for (i64 i = 0; i < (i64)n; i++) {
		if (ts_stopped(stop)) continue;
		split(args, (u32)i);
	}
	return true;
}

#include "backends/selftest.h"
