/* Which kernels have a fast path, and for which arguments. */
#include "fast.h"

typedef bool path(const void *args, u64 n, u32 threads);

/* Points that stand by piece, and nothing to mark. */
static bool splat(const void *args, u64 n, u32 threads)
{
	const ts_splat_args *a = args;
	(void)n;
	if (a->offset == NULL || a->mark != 0) return false;
	ts_c_splat_fast(a, threads);
	return true;
}

static bool scatter(const void *args, u64 n, u32 threads)
{
	const ts_scatter_args *a = args;
	return a->depths != NULL && ts_c_scatter_fast(a, n, true, threads);
}

static bool scatter_pieces(const void *args, u64 n, u32 threads)
{
	const ts_scatter_args *a = args;
	return a->depths != NULL && ts_c_scatter_fast(a, n, false, threads);
}

static bool shade(const void *args, u64 n, u32 threads)
{
	const ts_lookup_args *a = args;
	if (a->adaptive != 0) return false;
	ts_c_shade_fast(a, n, threads);
	return true;
}

/* The same rate of all views, and not by what clipping leaves. */
static bool split_count(const void *args, u64 n, u32 threads)
{
	const ts_density_args *a = args;
	bool has = a->views != NULL && a->shadow == TS_SHADOW_IS_NONE && a->rate >= TS_RATE_IS_PAPER;
	for (u32 v = 0; has && v < a->n_views; v++) has = a->views[v].orthographic == 0;
	return has && ts_c_density_fast(a, n, threads);
}

static bool hull(const void *args, u64 n, u32 threads)
{
	const ts_hull_args *a = args;
	if (a->cosine != TS_COSINE_IS_OURS || a->printed || a->by_moments) return false;
	ts_c_hull_fast(a, n, threads);
	return true;
}

static bool surfel_setup(const void *args, u64 n, u32 threads) { return ts_c_surfel_setup_fast(args, n, threads); }

static bool surfel_depth(const void *args, u64 n, u32 threads) { return ts_c_surfel_depth_fast(args, n, threads); }

static bool blend(const void *args, u64 n, u32 threads) { return ts_c_blend_fast(args, n, threads); }

static bool surfel_mean(const void *args, u64 n, u32 threads)
{
	ts_c_surfel_mean_fast(args, n, threads);
	return true;
}

static bool deferred(const void *args, u64 n, u32 threads)
{
	ts_c_deferred_fast(args, n, threads);
	return true;
}

static path *const paths[TS_N_KERNELS] = {
	[TS_KERNEL_splat] = splat,
	[TS_KERNEL_scatter] = scatter,
	[TS_KERNEL_scatter_pieces] = scatter_pieces,
	[TS_KERNEL_shade] = shade,
	[TS_KERNEL_split_count] = split_count,
	[TS_KERNEL_hull] = hull,
	[TS_KERNEL_surfel_setup] = surfel_setup,
	[TS_KERNEL_surfel_depth] = surfel_depth,
	[TS_KERNEL_blend] = blend,
	[TS_KERNEL_surfel_mean] = surfel_mean,
	[TS_KERNEL_deferred] = deferred,
};

bool ts_c_fast(ts_kernel kernel, const void *args, u64 n, u32 threads)
{
	return paths[kernel] != NULL && paths[kernel](args, n, threads);
}
