/* What backends of devices share. */
#include "backends/devices/device.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include "backends/fast.h"
#include "backends/kernels.h"

_Static_assert(sizeof(void *) == 8, "what a device knows takes the place of pointers");

enum { SCAN_CHUNK = 2048 };

ts_buffer *ts_device_buffer(ts_frame *frame, const ts_launch *launch, const ts_pointer *pointer, const void *args,
                            u64 *offset)
{
	const u8 *at;
	memcpy(&at, (const u8 *)args + pointer->offset, sizeof at);
	*offset = 0;
	if (at == NULL) return NULL;
	const ts_bound bound = ts_launch_bound(launch, pointer);
	if (!bound.bound) return NULL;
	ts_buffer *buffer = bound.role == TS_ROLE_WORK    ? &frame->lent[bound.to]
	                    : bound.role == TS_ROLE_TALLY ? &frame->lent[TS_WORK_tallies]
	                                                  : &frame->buffer[bound.to];
	const u8 *begin = buffer->data;
	assert(at >= begin && (at < begin + buffer->bytes || at == begin));
	*offset = (u64)(at - begin);
	return buffer;
}

ts_access ts_device_access(const ts_launch *launch, const ts_pointer *pointer)
{
	bool reads = pointer->row->constant || ts_launch_bound(launch, pointer).role == TS_ROLE_IN;
	return reads ? TS_READS : TS_WRITES;
}

static u64 largest_power(u64 most)
{
	u64 power = 1;
	while (power <= most / 2) power *= 2;
	return power;
}

u64 ts_device_parts_of(const ts_store *store, u64 part_bytes, const ts_buffer *buffer)
{
	return buffer->bytes <= store->about->most || part_bytes != 0 ? part_bytes : largest_power(store->about->most);
}

u64 ts_device_parts(const ts_store *store, u64 part_bytes, ts_frame *frame, const ts_launch *launch, const void *args)
{
	const ts_pointers *pointers = ts_kernel_pointers(launch->kernel);
	for (u32 i = 0; i < pointers->n; i++) {
		const ts_pointer *pointer = &pointers->pointer[i];
		u64 offset;
		ts_buffer *buffer = pointer->row->parted ? ts_device_buffer(frame, launch, pointer, args, &offset) : NULL;
		if (buffer != NULL) part_bytes = ts_device_parts_of(store, part_bytes, buffer);
	}
	return part_bytes;
}

/* The offset of the argument that holds the number of items sharing an item's rows; 0: the kernel has no bands. */
static size_t others_at(ts_kernel kernel)
{
	static const size_t at[TS_N_KERNELS] = {
#define BANDS(kernel, arguments, others) [TS_KERNEL_##kernel] = offsetof(arguments, others),
#include "backends/kernels.def"
	};
	return at[kernel];
}

/* The kernel with an item for each piece that can take a launch's place, and where the arguments say so. */
typedef struct {
	bool is;
	ts_kernel by;
	size_t from, unless, n;
} by_pieces;

static const by_pieces pieces_of[TS_N_KERNELS] = {
#define PIECES(kernel, by, arguments, from, unless, n) \
	[TS_KERNEL_##kernel] = {true, TS_KERNEL_##by, offsetof(arguments, from), offsetof(arguments, unless), \
	                        offsetof(arguments, n)},
#include "backends/kernels.def"
};

static u32 number_at(const void *args, size_t offset)
{
	u32 number;
	memcpy(&number, (const u8 *)args + offset, sizeof number);
	return number;
}

static bool is_by_pieces(ts_kernel kernel, const void *args)
{
	const by_pieces *pieces = &pieces_of[kernel];
	const void *from;
	if (!pieces->is) return false;
	memcpy(&from, (const u8 *)args + pieces->from, sizeof from);
	return from != NULL && number_at(args, pieces->unless) == 0;
}

/* Few items, which may be large, get many bands; many items get few. */
static u32 bands_of(u64 n)
{
	const u64 items = 1 << 20, most = 256, bands = items / n;
	return bands < 1 ? 1 : (u32)(bands < most ? bands : most);
}

static ts_status launch_bands(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n,
                              ts_enqueue *enqueue)
{
	u8 banded[TS_ARGUMENTS];
	size_t bytes = ts_kernel_args(launch->kernel)->bytes;
	const u32 bands = bands_of(n), others = bands - 1;
	assert(bytes <= sizeof banded);
	memcpy(banded, args, bytes);
	memcpy(banded + others_at(launch->kernel), &others, sizeof others);
	return enqueue(backend, frame, launch, banded, n * bands);
}

ts_status ts_device_launch(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n,
                           ts_enqueue *enqueue)
{
	ts_launch taken = *launch;
	if (!backend->ends_loops && is_by_pieces(launch->kernel, args) && !ts_fast_edited(launch->kernel)) {
		taken.kernel = pieces_of[launch->kernel].by;
		n = number_at(args, pieces_of[launch->kernel].n);
	}
	frame->residence = &ts_store_residence;
	if (n == 0) return TS_OK;
	if (backend->ends_loops && others_at(taken.kernel) != 0) {
		return launch_bands(backend, frame, &taken, args, n, enqueue);
	}
	return enqueue(backend, frame, &taken, args, n);
}

static ts_status scan_in(ts_backend *backend, ts_frame *frame, ts_buffer_id id, ts_scan_args *args)
{
	ts_launch step = {TS_KERNEL_scan_sum, {{TS_BINDS_TO, "counts", TS_ROLE_OUT, id}}};
	ts_frame_lend(frame, TS_WORK_other, args->sums, (args->n_chunks + 1) * sizeof *args->sums);
	ts_status status = backend->launch(backend, frame, &step, args, args->n_chunks);
	step.kernel = TS_KERNEL_scan_chunks;
	if (status == TS_OK) status = backend->launch(backend, frame, &step, args, 1);
	step.kernel = TS_KERNEL_scan;
	if (status == TS_OK) status = backend->launch(backend, frame, &step, args, args->n_chunks);
	ts_status recalled = ts_frame_recall(frame, TS_WORK_other);
	return status == TS_OK ? recalled : status;
}

ts_status ts_device_scan(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u64 *total)
{
	u64 n = ts_frame_n(frame, id) - 1;
	ts_scan_args args = {.counts = ts_frame_handle(frame, id),
	                     .n = n,
	                     .n_chunks = (n + SCAN_CHUNK - 1) / SCAN_CHUNK,
	                     .chunk = SCAN_CHUNK};
	args.sums = ts_alloc(args.n_chunks + 1, sizeof *args.sums, "prefix sums");
	if (args.sums == NULL) return TS_ERROR;
	ts_status status = scan_in(backend, frame, id, &args);
	if (status == TS_OK) *total = args.sums[args.n_chunks];
	free(args.sums);
	return status;
}
