/* The reference backend: a threaded loop over the items of a kernel. The Makefile gives TS_FLAGS. */
#include <stdatomic.h>
#include "backends/fast.h"
#include "model/core.h"
#include "model/order.h"

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

#define KERNEL(name, args_type) kernel_items ts_c_items_##name;
#include "backends/kernels.def"

#define KERNEL(name, args_type) ts_c_items_##name,
static kernel_items *const kernels[TS_N_KERNELS] = {
#include "backends/kernels.def"
};

#define EDITED(kernel)
#define AT_ONCE(kernel)
#define FAST(kernel) [TS_KERNEL_##kernel] = ts_c_fast_##kernel,
static ts_fast_path *const paths[TS_N_KERNELS] = {
#include "fast.inc"
};
#undef FAST
#undef AT_ONCE

#define FAST(kernel)
#define AT_ONCE(kernel) [TS_KERNEL_##kernel] = ts_c_at_once_##kernel,
static ts_at_once *const shortcuts[TS_N_KERNELS] = {
#include "fast.inc"
};
#undef AT_ONCE
#undef EDITED
#undef FAST

enum { CHUNKS_A_THREAD = 64, LEAST_ITEMS = 16, ITEMS_TO_ASK = 8 };

void ts_c_items(ts_kernel kernel, const void *args, u64 begin, u64 end) { kernels[kernel](args, begin, end); }

/* Without a team of threads, which would take memory, and end the process where there is none. */
static void launch_alone(kernel_items *items, const void *args, u64 n, u64 size, ts_stop *stop)
{
	for (u64 begin = 0; begin < n && !ts_stopped(stop); begin += size) {
		items(args, begin, begin + size < n ? begin + size : n);
	}
}

void ts_c_launch(ts_kernel kernel, const void *args, u64 n, u32 threads)
{
	kernel_items *items = kernels[kernel];
	ts_stop *stop = ts_stop_here();
	u64 size = n / ((u64)threads * CHUNKS_A_THREAD);
	size = size < LEAST_ITEMS ? LEAST_ITEMS : size;
	const u64 piece = stop != NULL ? ITEMS_TO_ASK : size;
	i64 chunks = (i64)((n + size - 1) / size);
	if (threads == 1 || chunks <= 1) {
		launch_alone(items, args, n, size, stop);
		return;
	}
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (i64 chunk = 0; chunk < chunks; chunk++) {
		u64 begin = (u64)chunk * size, end = begin + size < n ? begin + size : n;
		for (u64 i = begin; i < end && !ts_stopped(stop); i += piece) items(args, i, i + piece < end ? i + piece : end);
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

static ts_status launch(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	(void)frame;
	const ts_c_backend *c = (const ts_c_backend *)backend;
	ts_fast_path *fast = c->no_fast_paths ? NULL : paths[launch->kernel];
	if (!c->no_fast_paths) ts_fast_edited(launch->kernel);
	if (fast == NULL || !fast(args, n, c->threads)) ts_c_launch(launch->kernel, args, n, c->threads);
	return ts_go_on();
}

static bool at_once(ts_backend *backend, ts_kernel kernel, const void *source, const void *args, u64 n)
{
	const ts_c_backend *c = (const ts_c_backend *)backend;
	ts_at_once *shortcut = c->no_fast_paths ? NULL : shortcuts[kernel];
	if (!c->no_fast_paths) ts_fast_edited(kernel);
	return shortcut != NULL && shortcut(source, args, n, c->threads);
}

static ts_status fill(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u8 byte)
{
	enum { PART = 1 << 20 };
	const ts_c_backend *c = (const ts_c_backend *)backend;
	u8 *data = ts_frame_handle(frame, id);
	i64 bytes = (i64)frame->buffer[id].bytes;
	ts_memory_large_pages(data, (size_t)bytes);
	if (c->threads == 1) {
		memset(data, byte, (size_t)bytes);
		return TS_OK;
	}
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
		.backend = {.name = "c",
	                .device = DEVICE,
	                .compiler = __VERSION__,
	                .flags = TS_FLAGS,
	                .launch = launch,
	                .fill = fill,
	                .scan = scan,
	                .finish = finish,
	                .close = end,
	                .at_once = at_once},
		.threads = threads != 0 ? threads : 1,
	};
}

static ts_status devices(ts_device list[TS_MAX_DEVICES], u32 *n)
{
	*n = 1;
	list[0] = (ts_device){.name = DEVICE,
	                      .rounded = true,
	                      .denormals = true,
	                      .atomics = true,
	                      .unified = true,
	                      .little_endian = TS_LITTLE_ENDIAN,
	                      .memory = ts_memory_total(),
	                      .most = ts_memory_limit()};
	return TS_OK;
}

const ts_backend_kind ts_c_kind = {"c", devices, NULL};

#include "backends/selftest.h"
