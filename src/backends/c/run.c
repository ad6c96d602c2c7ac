/* The reference backend: a threaded loop over the items of a kernel. The Makefile gives TS_FLAGS. */
#include "../backend.h"

#ifndef TS_FLAGS
#define TS_FLAGS "unknown"
#endif

#if defined(__x86_64__)
#define DEVICE "x86-64"
#elif defined(__aarch64__)
#define DEVICE "aarch64"
#else
#define DEVICE "another processor"
#endif

typedef void kernel_items(const void *args, u64 begin, u64 end);

/* A kernel is one piece of code: compilers that weigh all kernels together inline less with each that is added. */
#if defined(__GNUC__)
#define WHOLE __attribute__((flatten))
#else
#define WHOLE
#endif

#define KERNEL(name, args_type) \
	WHOLE static void name##_items(const void *args, u64 begin, u64 end) \
	{ \
		const args_type a = *(const args_type *)args; \
		for (u64 i = begin; i < end; i++) ts_k_##name##_item(&a, i); \
	}
#include "../kernels.def"
#undef KERNEL

#define KERNEL(name, args_type) name##_items,
static kernel_items *const kernels[TS_N_KERNELS] = {
#include "../kernels.def"
};
#undef KERNEL

enum { CHUNKS_A_THREAD = 64, LEAST_ITEMS = 16 };

void ts_c_launch(ts_kernel kernel, const void *args, u64 n, u32 threads)
{
	kernel_items *items = kernels[kernel];
	u64 size = n / ((u64)threads * CHUNKS_A_THREAD);
	size = size < LEAST_ITEMS ? LEAST_ITEMS : size;
	i64 chunks = (i64)((n + size - 1) / size);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (chunks > 1)
	for (i64 chunk = 0; chunk < chunks; chunk++) {
		u64 begin = (u64)chunk * size;
		items(args, begin, begin + size < n ? begin + size : n);
	}
}

u64 ts_c_scan(u32 *counts, u64 n)
{
	u64 sum = 0;
	for (u64 i = 0; i < n; i++) {
		u32 count = counts[i];
		counts[i] = (u32)sum;
		sum += count;
	}
	counts[n] = (u32)sum;
	return sum;
}

/* The same rate of all views, and not by what clipping leaves. */
static bool has_fast_density(const ts_density_args *args)
{
	bool has = args->views != NULL && args->shadow == TS_SHADOW_IS_NONE && args->rate >= TS_RATE_IS_PAPER;
	for (u32 v = 0; has && v < args->n_views; v++) has = args->views[v].orthographic == 0;
	return has;
}

/* False where there is no fast path, or none for these arguments: then nothing was done. */
static bool launch_fast(ts_kernel kernel, const void *args, u64 n, u32 threads)
{
	const ts_splat_args *splat = args;
	const ts_lookup_args *lookup = args;
	const ts_scatter_args *scatter = args;
	const ts_hull_args *hull = args;
	switch (kernel) {
	case TS_KERNEL_splat:
		if (splat->offset == NULL || splat->mark != 0) return false;
		ts_c_splat_fast(splat, threads);
		return true;
	case TS_KERNEL_scatter:
	case TS_KERNEL_scatter_pieces:
		return scatter->depths != NULL && ts_c_scatter_fast(scatter, n, kernel == TS_KERNEL_scatter, threads);
	case TS_KERNEL_shade:
		if (lookup->adaptive != 0) return false;
		ts_c_shade_fast(lookup, n, threads);
		return true;
	case TS_KERNEL_split_count: return has_fast_density(args) && ts_c_density_fast(args, n, threads);
	case TS_KERNEL_hull:
		if (hull->cosine != TS_COSINE_IS_OURS || hull->printed || hull->by_moments) return false;
		ts_c_hull_fast(hull, n, threads);
		return true;
	case TS_KERNEL_surfel_setup: return ts_c_surfel_setup_fast(args, n, threads);
	case TS_KERNEL_surfel_depth: return ts_c_surfel_depth_fast(args, n, threads);
	case TS_KERNEL_blend: return ts_c_blend_fast(args, n, threads);
	case TS_KERNEL_surfel_mean: ts_c_surfel_mean_fast(args, n, threads); return true;
	case TS_KERNEL_deferred: ts_c_deferred_fast(args, n, threads); return true;
	default: return false;
	}
}

static ts_status launch(ts_backend *backend, ts_frame *frame, ts_kernel kernel, const void *args, u64 n)
{
	(void)frame;
	const ts_c_backend *c = (const ts_c_backend *)backend;
	if (c->reference || !launch_fast(kernel, args, n, c->threads)) ts_c_launch(kernel, args, n, c->threads);
	return TS_OK;
}

static ts_status fill(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u8 byte)
{
	enum { PART = 1 << 20 };
	const ts_c_backend *c = (const ts_c_backend *)backend;
	u8 *data = ts_frame_handle(frame, id);
	i64 bytes = (i64)frame->buffer[id].bytes;
#pragma omp parallel for schedule(static) num_threads(c->threads)
	for (i64 i = 0; i < bytes; i += PART) memset(data + i, byte, (size_t)(bytes - i < PART ? bytes - i : PART));
	return TS_OK;
}

static ts_status scan(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u64 *total)
{
	(void)backend;
	*total = ts_c_scan(ts_frame_handle(frame, id), ts_frame_n(frame, id) - 1);
	return TS_OK;
}

static ts_status finish(ts_backend *backend)
{
	(void)backend;
	return TS_OK;
}

static void end(ts_backend *backend) { (void)backend; }

void ts_c_begin(ts_c_backend *backend, u32 threads)
{
	*backend = (ts_c_backend){
		.backend = {"c", DEVICE, __VERSION__, TS_FLAGS, {0}, launch, fill, scan, finish, end},
		.threads = threads != 0 ? threads : 1,
	};
}

static u32 devices(ts_device list[TS_MAX_DEVICES])
{
	list[0] = (ts_device){.name = DEVICE, .rounded = true, .denormals = true, .atomics = true, .unified = true,
	                      .little_endian = true, .memory = ts_memory_total(), .most = ts_memory_limit()};
	return 1;
}

const ts_backend_kind ts_c_kind = {"c", devices, NULL};
