/* The rows of all kernels' arguments. */
#include "backends/args.h"
#include <assert.h>
#include <pthread.h>
#include <stdio.h>

/* A role by its name: how its row declares a buffer, lent memory, a tally, a number or a struct, and whether it is
 * constant, in parts, optional. */
#define ROLE_IN(MAKE, T, N, F) MAKE##_BUFFER(IN, true, false, false, T, N, F)
#define ROLE_IN_OPT(MAKE, T, N, F) MAKE##_BUFFER(IN, true, false, true, T, N, F)
#define ROLE_IN_PARTS(MAKE, T, N, F) MAKE##_BUFFER(IN, true, true, false, T, N, F)
#define ROLE_IN_PARTS_OPT(MAKE, T, N, F) MAKE##_BUFFER(IN, true, true, true, T, N, F)
#define ROLE_OUT(MAKE, T, N, F) MAKE##_BUFFER(OUT, false, false, false, T, N, F)
#define ROLE_OUT_OPT(MAKE, T, N, F) MAKE##_BUFFER(OUT, false, false, true, T, N, F)
#define ROLE_OUT_PARTS(MAKE, T, N, F) MAKE##_BUFFER(OUT, false, true, false, T, N, F)
#define ROLE_OUT_PARTS_OPT(MAKE, T, N, F) MAKE##_BUFFER(OUT, false, true, true, T, N, F)
#define ROLE_MIN(MAKE, T, N, F) MAKE##_BUFFER(MIN, false, false, false, T, N, F)
#define ROLE_MIN_OPT(MAKE, T, N, F) MAKE##_BUFFER(MIN, false, false, true, T, N, F)
#define ROLE_MIN_PARTS(MAKE, T, N, F) MAKE##_BUFFER(MIN, false, true, false, T, N, F)
#define ROLE_SUM(MAKE, T, N, F) MAKE##_BUFFER(SUM, false, false, false, T, N, F)
#define ROLE_SUM_OPT(MAKE, T, N, F) MAKE##_BUFFER(SUM, false, false, true, T, N, F)
#define ROLE_SUM_PARTS_OPT(MAKE, T, N, F) MAKE##_BUFFER(SUM, false, true, true, T, N, F)
#define ROLE_WORK(MAKE, T, N, F) MAKE##_OTHER(WORK, false, false, T, N, TS_WORK_##F, NULL)
#define ROLE_WORK_IN(MAKE, T, N, F) MAKE##_OTHER(WORK, true, false, T, N, TS_WORK_##F, NULL)
#define ROLE_TALLY(MAKE, T, N, F) MAKE##_OTHER(TALLY, false, false, T, N, F, NULL)
#define ROLE_TALLY_OPT(MAKE, T, N, F) MAKE##_OTHER(TALLY, false, true, T, N, F, NULL)
#define ROLE_VALUE(MAKE, T, N, F) MAKE##_OTHER(VALUE, false, false, T, N, TS_B_##F, NULL)
#define ROLE_INNER(MAKE, T, N, F) MAKE##_OTHER(INNER, false, false, T, N, TS_B_##F, T##_list)

#define ROW(role, T, N, F) ROLE_##role(ROW, T, N, F)
#define ROW_BUFFER(role, constant, parted, optional, T, N, F) \
	{TS_ROLE_##role, constant, parted, optional, #T, #N, offsetof(self, N), TS_B_##F, NULL},
#define ROW_OTHER(role, constant, optional, T, N, from, inner) \
	{TS_ROLE_##role, constant, false, optional, #T, #N, offsetof(self, N), from, inner},

/* Elements of buffers; sums of either sign are stored as unsigned numbers. */
typedef struct ts_nothing ts_element_of_none;
#define BUFFER(id, name, element, shape, order, key, doc) typedef element ts_element_of_##id;
#include <touchstone/records.def>

#define FITS(role, T, N, F) ROLE_##role(FITS, T, N, F)
#define FITS_BUFFER(role, constant, parted, optional, T, N, F) \
	_Static_assert(_Generic(((self *)0)->N, const ts_element_of_##F *: true, ts_element_of_##F *: true, \
	                        const i64 *: sizeof(T) == 8, i64 *: sizeof(T) == 8, default: TS_B_##F == TS_B_none), \
	               #N " and " #F " have elements of two types");
#define FITS_OTHER(role, constant, optional, T, N, from, inner)

#define TS_ARGS_ALSO(type) \
	; \
	static const ts_arg_list *type##_list(void) \
	{ \
		typedef type self; \
		TS_ROWS_##type(FITS) static const ts_arg rows[] = {TS_ROWS_##type(ROW)}; \
		static const ts_arg_list list = {#type, sizeof(self), sizeof rows / sizeof *rows, rows}; \
		return &list; \
	} \
	typedef type type##_listed
#include "backends/kernels.h"

const ts_arg_list *ts_kernel_args(ts_kernel kernel)
{
	static const ts_arg_list *(*const lists[])(void) = {
#define KERNEL(name, args) args##_list,
#include "backends/kernels.def"
	};
	assert(kernel < TS_N_KERNELS);
	return lists[kernel]();
}

const char *ts_kernel_name(ts_kernel kernel)
{
	static const char *const names[] = {
#define KERNEL(name, args) #name,
#include "backends/kernels.def"
	};
	assert(kernel < TS_N_KERNELS);
	return names[kernel];
}

static void add(ts_pointers *p, const ts_arg_list *list, const char *path, size_t offset)
{
	for (const ts_arg *row = list->rows; row < list->rows + list->n; row++) {
		char name[TS_POINTER_NAME];
		if (row->role == TS_ROLE_VALUE) continue;
		int length = snprintf(name, sizeof name, "%s%s", path, row->name);
		assert(length + 1 < (int)sizeof name && p->n < TS_POINTERS);
		if (row->role != TS_ROLE_INNER) {
			p->pointer[p->n] = (ts_pointer){.row = row, .offset = offset + row->offset};
			memcpy(p->pointer[p->n++].name, name, sizeof name);
		} else {
			strcat(name, ".");
			add(p, row->inner(), name, offset + row->offset);
		}
	}
}

static ts_pointers pointers[TS_N_KERNELS];
static bool parted[TS_N_BUFFERS];

static void fill(void)
{
	for (u32 kernel = 0; kernel < TS_N_KERNELS; kernel++) {
		ts_pointers *p = &pointers[kernel];
		add(p, ts_kernel_args((ts_kernel)kernel), "", 0);
		for (u32 i = 0; i < p->n; i++) {
			if (p->pointer[i].row->parted) parted[p->pointer[i].row->from] = true;
		}
	}
}

static void require(void)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, fill);
}

const ts_pointers *ts_kernel_pointers(ts_kernel kernel)
{
	require();
	return &pointers[kernel];
}

bool ts_may_be_parted(ts_buffer_id id)
{
	require();
	return parted[id];
}

/* "of.scene" names itself and "of.scene.vertices". */
static bool names(const char *name, const char *pointer)
{
	size_t length = strlen(name);
	return strncmp(name, pointer, length) == 0 && (pointer[length] == 0 || pointer[length] == '.');
}

ts_bound ts_launch_bound(const ts_launch *launch, const ts_pointer *pointer)
{
	const ts_arg *row = pointer->row;
	ts_bound bound = {!row->optional, row->role, row->from};
	for (const ts_bind *b = launch->bind; b->how != TS_BINDS_END; b++) {
		if (!names(b->name, pointer->name)) continue;
		bound.bound = b->how != TS_BINDS_NOT;
		if (b->how == TS_BINDS_TO) bound = (ts_bound){true, b->role, b->to};
	}
	return bound;
}

bool ts_launch_knows(const ts_launch *launch, const char *name)
{
	const ts_pointers *p = ts_kernel_pointers(launch->kernel);
	for (u32 i = 0; i < p->n; i++) {
		if (names(name, p->pointer[i].name)) return true;
	}
	return false;
}
