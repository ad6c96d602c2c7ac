/* Backends run a kernel over all its items. */
#ifndef TS_BACKENDS_BACKEND_H
#define TS_BACKENDS_BACKEND_H
#include "backends/args.h"
#include "model/frame.h"

/* An open backend. Its functions take effect in the order of their calls. A failure may be reported by a later call;
 * `finish` reports all failures. The frame owns contents: the pointers in `args` are those of ts_frame_handle. */
typedef struct ts_backend ts_backend;

/* The result of the arithmetic vectors on a backend. */
typedef struct {
	bool rounds_to_nearest, contracts, keeps_denormals;
	u32 n_wrong; /* primitives; 0: it keeps the numeric contract */
} ts_measured;

struct ts_backend {
	const char *name;             /* as in --backend */
	const char *device;           /* one line that names the hardware */
	const char *compiler, *flags; /* of the kernels */
	bool ends_loops;              /* ends loops after a number of iterations, like llvmpipe; items must stay below it */
	ts_measured arithmetic;
	/* Runs items [0, n) of the launch's kernel; args is its argument struct, whose pointers point to, or into, what
	 * the launch binds. The order of the items is not defined and never changes a result. */
	ts_status (*launch)(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n);
	/* Sets every byte of a buffer. */
	ts_status (*fill)(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u8 byte);
	/* Exclusive prefix sum in place, of all elements but the last, which becomes the total: 32-bit counts. *total is
	 * right even if it does not fit; the caller must refuse it then. */
	ts_status (*scan)(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u64 *total);
	/* Waits for all of it. */
	ts_status (*finish)(ts_backend *backend);
	/* Releases the backend. Frames that it worked on must be cleared before. */
	void (*close)(ts_backend *backend);
	/* Does at once what a traversal that begins with n pairs and launches the kernel over all its pairs does. source:
	 * arguments of the traversal, to whose tallies, if any, it adds TS_TALLIES_AT_ONCE numbers; args: those of the
	 * kernel, without the pairs. The order of results may be that of no launch. False: it cannot for these arguments,
	 * and nothing was done. NULL: it never can. */
	bool (*at_once)(ts_backend *backend, ts_kernel kernel, const void *source, const void *args, u64 n);
	/* From now on computes quotients and roots in another way, which is slower and exact. False: it does so already.
	 * NULL: there is no other way. */
	bool (*repair)(ts_backend *backend);
};

enum { TS_MAX_DEVICES = 32 };
#define TS_POCL "Portable Computing Language" /* a platform */

/* A device of a backend. */
typedef struct {
	char name[128], platform[128], driver[64];
	bool rounded;   /* divides and takes roots with correct rounding */
	bool denormals; /* keeps them; results are the same either way, since the contract flushes them */
	bool atomics;   /* of 64 bits */
	bool unified;   /* its memory is the host's */
	bool little_endian;
	u64 memory, most; /* bytes; of one buffer */
} ts_device;

typedef struct {
	u32 device;        /* index of `devices` */
	u32 work_group;    /* items; 0: the driver chooses */
	const char *build; /* more options for the driver's compiler, or a folder of kernels (--build); or "" */
	bool inexact;      /* also a device that cannot keep the contract */
	bool copies;       /* a memory of its own, even where the device has the host's */
	u64 part_bytes;    /* of parts of arrays that grow with points and cubes, a power of two; 0: only where needed */
} ts_backend_options;

typedef struct {
	const char *name; /* as in --backend */
	/* Describes *n devices, at most TS_MAX_DEVICES. TS_SKIPPED: there is none. TS_ERROR: a driver is there and fails.
	 * *n is 0 then. */
	ts_status (*devices)(ts_device devices[TS_MAX_DEVICES], u32 *n);
	/* Opens a device. TS_SKIPPED: there is no device. TS_ERROR: there is not this one, or it lacks what the contract
	 * needs and inexact is not set, or its compiler fails, whose output goes to standard error. *backend is NULL then.
	 * The function is NULL for the backend in C, which every run has. */
	ts_status (*open)(ts_backend **backend, const ts_backend_options *options);
} ts_backend_kind;
extern const ts_backend_kind ts_c_kind, ts_opencl_kind, ts_vulkan_kind, ts_cuda_kind;
/* The backends of the library, or of the core: the one in C first; ended by NULL. */
extern const ts_backend_kind *const ts_backend_kinds[];
/* Finds the backend of that name among `kinds`, ended by NULL. TS_ERROR: there is none; the message names all. */
ts_status ts_backend_find(const ts_backend_kind **kind, const ts_backend_kind *const *kinds, const char *name);

/* The backend in C: threads of OpenMP. */
typedef struct {
	ts_backend backend;
	u32 threads; /* never changes a result */
	bool no_fast_paths;
} ts_c_backend;
void ts_c_begin(ts_c_backend *backend, u32 threads);

/* Items [begin, end) of a kernel, in their order, without fast paths. */
void ts_c_items(ts_kernel kernel, const void *args, u64 begin, u64 end);
/* The C backend's loop over the items of a kernel, for arguments that are in no frame. */
void ts_c_launch(ts_kernel kernel, const void *args, u64 n, u32 threads);
/* Exclusive prefix sums: counts[0 .. n-1] become the sums before each, counts[n] the total, which is also returned. */
u64 ts_c_scan(u32 *counts, u64 n);

#endif
