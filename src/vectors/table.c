/* All primitives as one list, and properties of their columns. The rows stand beside the functions they name, those of
 * families in methods/<family>/vectors.c. */
#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include "vectors/row.h"

static const ts_launch launch = TS_LAUNCH(vectors, TS_ALL), launch_composites = TS_LAUNCH(composites, TS_ALL);

/* clang-format off */
static const ts_vector_set primitives = {
	&launch, false,
	TS_TABLES(ts_vectors_arithmetic, ts_vectors_number, ts_vectors_vector, ts_vectors_raster, ts_vectors_cube,
	ts_vectors_memory, ts_vectors_texture),
};
static const ts_vector_set composites = {&launch_composites, true,
	TS_TABLES(ts_composites_geometry, ts_composites_shade, ts_composites_lattice)};
/* clang-format on */

/* Primitives that all methods share. */
static const ts_vector_set *const shared[] = {&primitives, &composites, NULL};

static const ts_vector_set *const none = NULL;
static const ts_vector_set *const *families = &none;

void ts_vectors_use(const ts_vector_set *const *sets) { families = sets; }

/* clang-format off */
const ts_vector_fault_info ts_vector_fault_table[TS_N_FAULTS] = {
	[TS_FAULT_FMA] = { "fused multiply-add", "turn contraction off: -ffp-contract=off, -fmad=false, precise" },
	[TS_FAULT_FLUSH] = { "flush to zero", "keep denormals if the device can; put hides it in what is stored" },
	[TS_FAULT_FLUSH_HALF] = { "flushed halves", "keep halves below 2^-14: they are multiples of 2^-24" },
	[TS_FAULT_RECIPROCAL] = { "reciprocal division",
	  "divide: -prec-div=true, or the repaired division of CONTRACT rule 4" },
	[TS_FAULT_ROOT] = { "reciprocal square root",
	  "take the root: -prec-sqrt=true, or the repaired one of CONTRACT rule 4" },
	[TS_FAULT_BUILTIN] = { "built-in function", "port the text of the kernel instead" },
	[TS_FAULT_REORDER] = { "re-association", "keep the order that is written: no fast or unsafe math" },
	[TS_FAULT_AWAY] = { "ties away from zero", "round ties to even" },
	[TS_FAULT_TRUNCATE] = { "truncation", "round to the nearest where it says so, down where it says floor" },
	[TS_FAULT_TWICE] = { "rounding twice", "convert in one step, not through another float" },
	[TS_FAULT_NARROW] = { "32-bit integers", "compute in 64 bits" },
	[TS_FAULT_FLOAT] = { "integers in float", "compute in 64-bit integers" },
	[TS_FAULT_DEPTH24] = { "24-bit depth", "keep all 32 bits of the depth" },
	[TS_FAULT_INCLUSIVE] = { "inclusive edges", "count what lies on an edge for top and left edges only" },
};
/* clang-format on */

static u32 count(const ts_vector_set *set)
{
	u32 n = 0;
	for (const ts_vector *const *table = set->tables; *table != NULL; table++) {
		for (const ts_vector *v = *table; v->name != NULL; v++) n++;
	}
	return n;
}

static u32 count_all(const ts_vector_set *const *sets)
{
	u32 n = 0;
	for (; *sets != NULL; sets++) n += count(*sets);
	return n;
}

u32 ts_vectors_count(void) { return count_all(shared) + count_all(families); }

static const ts_vector *vector_of(const ts_vector_set *set, u32 index)
{
	for (const ts_vector *const *table = set->tables; *table != NULL; table++) {
		for (const ts_vector *v = *table; v->name != NULL; v++) {
			if (index-- == 0) return v;
		}
	}
	return NULL;
}

ts_vector_place ts_vectors_place(u32 index)
{
	u32 n_shared = count_all(shared);
	const ts_vector_set *const *set = index < n_shared ? shared : families;
	index -= index < n_shared ? 0 : n_shared;
	for (; *set != NULL && index >= count(*set); set++) index -= count(*set);
	if (*set == NULL) return (ts_vector_place){0};
	return (ts_vector_place){vector_of(*set, index), (*set)->launch, index, (*set)->composed};
}

const ts_vector *ts_vectors_at(u32 index) { return ts_vectors_place(index).vector; }

static const ts_vector *find(const ts_vector_set *const *sets, const char *name)
{
	for (; *sets != NULL; sets++) {
		for (const ts_vector *const *table = (*sets)->tables; *table != NULL; table++) {
			for (const ts_vector *v = *table; v->name != NULL; v++) {
				if (strcmp(v->name, name) == 0) return v;
			}
		}
	}
	return NULL;
}

const ts_vector *ts_vectors_find(const char *name)
{
	const ts_vector *v = find(shared, name);
	return v != NULL ? v : find(families, name);
}

u32 ts_vector_type_words(ts_vector_type type) { return type == TS_VECTOR_I64 || type == TS_VECTOR_U64 ? 2 : 1; }

static u32 words_of(const ts_vector_column *columns)
{
	u32 n = 0;
	for (const ts_vector_column *c = columns; c->name != NULL; c++) n += c->count * ts_vector_type_words(c->type);
	assert(n <= TS_VECTOR_WORDS);
	return n;
}

u32 ts_vector_in_words(const ts_vector *vector) { return words_of(vector->in); }

u32 ts_vector_out_words(const ts_vector *vector) { return words_of(vector->out); }

ts_vector_spot ts_vector_out_spot(const ts_vector *vector, u32 element)
{
	ts_vector_spot r = {vector->out, element, 0};
	for (; r.element >= r.column->count; r.column++) {
		r.element -= r.column->count;
		r.word += r.column->count * ts_vector_type_words(r.column->type);
	}
	r.word += r.element * ts_vector_type_words(r.column->type);
	return r;
}

bool ts_vector_gives_record(const ts_vector *vector) { return vector->out[0].name[0] != 0; }

static const char *type_descr(ts_vector_type type)
{
	static const char *const descr[] = {
		[TS_VECTOR_F32] = "<f4", [TS_VECTOR_I32] = "<i4", [TS_VECTOR_U32] = "<u4",
		[TS_VECTOR_I64] = "<i8", [TS_VECTOR_U64] = "<u8",
	};
	return descr[type];
}

static void descr_of(char descr[TS_VECTOR_DESCR], const ts_vector_column *columns)
{
	size_t used = 0;
	for (const ts_vector_column *c = columns; c->name != NULL; c++) {
		char count[24] = "";
		if (c->count > 1) snprintf(count, sizeof count, ", (%" PRIu32 ",)", c->count);
		used += (size_t)snprintf(descr + used, TS_VECTOR_DESCR - used, "%s('%s', '%s'%s)", used == 0 ? "[" : ", ",
		                         c->name, type_descr(c->type), count);
	}
	assert(used < TS_VECTOR_DESCR - 1);
	snprintf(descr + used, TS_VECTOR_DESCR - used, "]");
}

void ts_vector_in_descr(char descr[TS_VECTOR_DESCR], const ts_vector *vector) { descr_of(descr, vector->in); }

void ts_vector_out_descr(char descr[TS_VECTOR_DESCR], const ts_vector *vector)
{
	if (ts_vector_gives_record(vector)) {
		descr_of(descr, vector->out);
	} else {
		snprintf(descr, TS_VECTOR_DESCR, "'%s'", type_descr(vector->out[0].type));
	}
}

u32 ts_vector_out_shape(u64 shape[TS_MAX_DIMS], const ts_vector *vector)
{
	shape[0] = TS_VECTOR_ITEMS;
	shape[1] = vector->out[0].count;
	return !ts_vector_gives_record(vector) && vector->out[0].count > 1 ? 2 : 1;
}
