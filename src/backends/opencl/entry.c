/* Entry points of kernels. A kernel of OpenCL 1.2 cannot be given a struct that holds pointers. It gets a twin of the
 * struct with an offset in place of each pointer, followed by the buffers, or by all parts of those in parts. */
#include <stdio.h>
#include <stdlib.h>
#include "backends/opencl/cl.h"
#include "output/file.h"

enum { LISTS = 16 };

typedef struct {
	FILE *out;
	u32 n_parts;
	const ts_arg_list *done[LISTS]; /* structs that have a twin */
	u32 n_done;
} text;

static bool is_done(const text *t, const ts_arg_list *list)
{
	for (u32 i = 0; i < t->n_done; i++) {
		if (t->done[i] == list) return true;
	}
	return false;
}

static void put_twin(text *t, const ts_arg_list *list)
{
	if (is_done(t, list)) return;
	for (u32 i = 0; i < list->n; i++) {
		if (list->rows[i].role == TS_ROLE_INNER) put_twin(t, list->rows[i].inner());
	}
	fprintf(t->out, "typedef struct {");
	for (u32 i = 0; i < list->n; i++) {
		const ts_arg *row = &list->rows[i];
		bool value = row->role == TS_ROLE_VALUE, inner = row->role == TS_ROLE_INNER;
		fprintf(t->out, " %s%s %s;", value || inner ? row->type : "u64", inner ? "_twin" : "", row->name);
	}
	fprintf(t->out, " } %s_twin;\n", list->type);
	t->done[t->n_done++] = list;
}

static u32 parts_of(const text *t, const ts_pointer *pointer) { return pointer->row->parted ? t->n_parts : 1; }

static void put_parameters(text *t, const ts_pointers *p)
{
	for (u32 i = 0; i < p->n; i++) {
		for (u32 k = 0; k < parts_of(t, &p->pointer[i]); k++) fprintf(t->out, ", __global uchar *b%u_%u", i, k);
	}
}

static void put_pointers(text *t, const ts_pointers *p)
{
	for (u32 i = 0; i < p->n; i++) {
		const ts_pointer *to = &p->pointer[i];
		const char *constant = to->row->constant ? "const " : "";
		if (parts_of(t, to) == 1) {
			fprintf(t->out, "\ta.%s = (__global %s%s *)(b%u_0 + v.%s);\n", to->name, constant, to->row->type, i,
			        to->name);
			continue;
		}
		for (u32 k = 0; k < t->n_parts; k++) {
			fprintf(t->out, "\ta.%s[%u] = (__global %s%s *)b%u_%u;\n", to->name, k, constant, to->row->type, i, k);
		}
	}
}

static void put_values(text *t, const ts_arg_list *list, const char *path)
{
	for (u32 i = 0; i < list->n; i++) {
		const ts_arg *row = &list->rows[i];
		if (row->role == TS_ROLE_VALUE) fprintf(t->out, "\ta.%s%s = v.%s%s;\n", path, row->name, path, row->name);
		if (row->role != TS_ROLE_INNER) continue;
		char inside[TS_POINTER_NAME];
		snprintf(inside, sizeof inside, "%s%s.", path, row->name);
		put_values(t, row->inner(), inside);
	}
}

static void put_entry(text *t, ts_kernel kernel)
{
	const ts_arg_list *list = ts_kernel_args(kernel);
	const ts_pointers *pointers = ts_kernel_pointers(kernel);
	const char *name = ts_kernel_name(kernel);
	put_twin(t, list);
	fprintf(t->out, "__kernel void %s(%s_twin v, u64 n", name, list->type);
	put_parameters(t, pointers);
	fprintf(t->out, ")\n{\n\tu64 i = get_global_id(0);\n\tif (i >= n) return;\n\t%s a;\n", list->type);
	put_pointers(t, pointers);
	put_values(t, list, "");
	fprintf(t->out, "\tts_k_%s_item(&a, i);\n}\n", name);
}

char *ts_cl_entries(const ts_cl *cl, u32 program)
{
	ts_file_text made;
	if (ts_file_text_begin(&made, "entries of kernels") != TS_OK) return NULL;
	text t = {.out = made.out, .n_parts = cl->part_bytes != 0 ? TS_PARTS : 1};
	for (u32 kernel = 0; kernel < TS_N_KERNELS; kernel++) {
		if (ts_cl_program_of[kernel] == program) put_entry(&t, (ts_kernel)kernel);
	}
	return ts_file_text_close(&made, "entries of kernels") == TS_OK ? made.text : NULL;
}
