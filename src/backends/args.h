/* Arguments of kernels and bindings of launches: two declarations from which the filling of arguments, the reads and
 * writes of stages, and the arguments on devices are derived. */
#ifndef TS_BACKENDS_ARGS_H
#define TS_BACKENDS_ARGS_H
#include "model/frame.h"

#define KERNEL(name, args) TS_KERNEL_##name,
typedef enum {
#include "backends/kernels.def"
	TS_N_KERNELS,
} ts_kernel;

/* Roles; see kernels/base/args.h. */
typedef enum {
	TS_ROLE_IN,
	TS_ROLE_OUT,
	TS_ROLE_MIN,
	TS_ROLE_SUM,
	TS_ROLE_WORK,
	TS_ROLE_TALLY,
	TS_ROLE_VALUE,
	TS_ROLE_INNER,
} ts_role;

typedef struct ts_arg_list ts_arg_list;

/* One row of arguments. */
typedef struct {
	ts_role role;
	bool constant, parted, optional;
	const char *type, *name;
	size_t offset;
	u32 from;                          /* a buffer; for WORK a TS_WORK_*, for TALLY an index */
	const ts_arg_list *(*inner)(void); /* for INNER */
} ts_arg;

/* The rows of one struct. */
struct ts_arg_list {
	const char *type;
	size_t bytes;
	u32 n;
	const ts_arg *rows;
};

const ts_arg_list *ts_kernel_args(ts_kernel kernel);
const char *ts_kernel_name(ts_kernel kernel);

/* A pointer among a kernel's arguments, those of structs inside among them: "scene.vertices". */
enum { TS_POINTERS = 40, TS_POINTER_NAME = 48 };
typedef struct {
	char name[TS_POINTER_NAME];
	const ts_arg *row;
	size_t offset;
} ts_pointer;

typedef struct {
	u32 n;
	ts_pointer pointer[TS_POINTERS];
} ts_pointers;
const ts_pointers *ts_kernel_pointers(ts_kernel kernel);
/* Whether kernels take the buffer in parts. */
bool ts_may_be_parted(ts_buffer_id id);

/* Bindings of a launch that differ from the rows. The name of a struct of arguments stands for all its members. */
typedef enum { TS_BINDS_END, TS_BINDS_NOT, TS_BINDS_TOO, TS_BINDS_TO } ts_bind_how;
typedef struct {
	ts_bind_how how;
	const char *name;
	ts_role role;
	u32 to;
} ts_bind;

enum { TS_BINDS = 20 };

/* A kernel as a stage launches it. */
typedef struct {
	ts_kernel kernel;
	ts_bind bind[TS_BINDS]; /* ended by TS_BINDS_END */
} ts_launch;

/* static const ts_launch tie = TS_LAUNCH(splat, TS_BUT(offset), TS_IN(texels, splat_depth_index), TS_WITH(tie)); */
/* clang-format off */
#define TS_LAUNCH(kernel, ...) {TS_KERNEL_##kernel, {__VA_ARGS__}}
#define TS_ALL {TS_BINDS_END, NULL, TS_ROLE_IN, 0}
#define TS_BUT(name) {TS_BINDS_NOT, #name, TS_ROLE_IN, 0}
#define TS_WITH(name) {TS_BINDS_TOO, #name, TS_ROLE_IN, 0}
#define TS_IN(name, buffer) {TS_BINDS_TO, #name, TS_ROLE_IN, TS_B_##buffer}
#define TS_OUT(name, buffer) {TS_BINDS_TO, #name, TS_ROLE_OUT, TS_B_##buffer}
#define TS_MIN(name, buffer) {TS_BINDS_TO, #name, TS_ROLE_MIN, TS_B_##buffer}
#define TS_WORK(name, memory) {TS_BINDS_TO, #name, TS_ROLE_WORK, TS_WORK_##memory}
/* clang-format on */

/* What a launch binds a pointer to. */
typedef struct {
	bool bound;
	ts_role role;
	u32 to; /* as `from` of ts_arg */
} ts_bound;
ts_bound ts_launch_bound(const ts_launch *launch, const ts_pointer *pointer);
/* Whether a binding may use the name: it is that of a pointer, or of a struct with pointers. */
bool ts_launch_knows(const ts_launch *launch, const char *name);

#endif
