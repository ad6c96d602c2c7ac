/* Arithmetic vectors: inputs and outputs of every primitive that a port must compute with the same bits (CONTRACT rule
 * 32), and the check of a port's outputs for these inputs. A row holds the columns of one item as little-endian words
 * of 32 bits without padding, 64-bit values low word first: as a structured dtype of numpy. */
#ifndef TS_VECTORS_VECTORS_H
#define TS_VECTORS_VECTORS_H
#include <touchstone/vectors.h>
#include "backends/backend.h"
#include "kernels/base/compat.h"
#include "model/core.h"

enum { TS_VECTOR_ITEMS = 4096, TS_VECTOR_COLUMNS = 60, TS_VECTOR_WORDS = 128, TS_VECTOR_VARIANTS = 6 };
enum { TS_VECTOR_DESCR = 2048 };

/* Values of one argument. Floats: biased exponents from `low` to `high`, and zero; -0 and denormals only where low is
 * 0, infinity and NaN only where high is 255. Integers: from low to high. */
typedef struct {
	const char *name; /* NULL ends the columns */
	ts_vector_type type;
	u32 count; /* elements */
	i64 low, high;
	bool is_signed; /* floats */
} ts_vector_column;

/* Computes one item from its row. Results of 64 bits are aligned to 8 bytes. */
typedef void ts_vector_item(u32 *out, const u32 *in);

/* Usual faults of ports, in the order of ts_vector_fault_table. */
typedef enum {
	TS_FAULT_FMA,
	TS_FAULT_FLUSH,
	TS_FAULT_FLUSH_HALF,
	TS_FAULT_RECIPROCAL,
	TS_FAULT_ROOT,
	TS_FAULT_BUILTIN,
	TS_FAULT_REORDER,
	TS_FAULT_AWAY,
	TS_FAULT_TRUNCATE,
	TS_FAULT_TWICE,
	TS_FAULT_NARROW,
	TS_FAULT_FLOAT,
	TS_FAULT_DEPTH24,
	TS_FAULT_INCLUSIVE,
	TS_N_FAULTS,
} ts_vector_fault;

typedef struct {
	const char *name, *remedy;
} ts_vector_fault_info;
extern const ts_vector_fault_info ts_vector_fault_table[TS_N_FAULTS];

/* The same item computed with a fault. */
typedef struct {
	ts_vector_fault fault;
	ts_vector_item *item;
} ts_vector_variant;

typedef struct {
	const char *name;     /* NULL ends a table */
	ts_vector_item *item; /* of the kernels */
	const char *rule;     /* of CONTRACT, or the kernel that defines it */
	const char *doc;      /* one line */
	ts_vector_column in[TS_VECTOR_COLUMNS + 1];
	ts_vector_column out[TS_VECTOR_COLUMNS + 1];        /* one without a name: an array; with names: a record */
	ts_vector_variant variants[TS_VECTOR_VARIANTS + 1]; /* ended by one without an item */
	const f32 *edges;                                   /* values at which the primitive branches */
	u32 n_edges;
	/* Brings the arguments of a row into the relation that the primitive needs, with random bits; NULL: arguments are
	 * independent. Integers keep their ranges; floats are brought back into theirs. */
	void (*relate)(u32 *in, u32 random);
} ts_vector;

/* The primitives of one kernel, in the order of its list. */
typedef struct {
	const ts_launch *launch;
	bool composed; /* composites: functions made of primitives, which a backend need not compute before it runs */
	const ts_vector *const *tables; /* TS_TABLES: each ended by a row without a name */
} ts_vector_set;
#define TS_TABLES(...) ((const ts_vector *const[]){__VA_ARGS__, NULL})

/* Takes the sets of the families, which follow those that all methods share; the list, ended by NULL, must stay. */
void ts_vectors_use(const ts_vector_set *const *sets);

/* The number of primitives. They are in the order in which to port them: each relies on those before it. */
u32 ts_vectors_count(void);
const ts_vector *ts_vectors_at(u32 index);
/* The primitive of that name; NULL: there is none. */
const ts_vector *ts_vectors_find(const char *name);

/* The kernel that computes a primitive, and the primitive's index in the kernel's list. */
typedef struct {
	const ts_vector *vector; /* NULL: there is none of that index */
	const ts_launch *launch;
	u32 primitive;
	bool composed;
} ts_vector_place;
ts_vector_place ts_vectors_place(u32 index);

/* 32-bit words of a row of inputs, of a row of outputs, of one value. */
u32 ts_vector_in_words(const ts_vector *vector);
u32 ts_vector_out_words(const ts_vector *vector);
u32 ts_vector_type_words(ts_vector_type type);

/* The place in the outputs of an element, counted through all columns. */
typedef struct {
	const ts_vector_column *column;
	u32 element, word; /* of the column; of the row */
} ts_vector_spot;
ts_vector_spot ts_vector_out_spot(const ts_vector *vector, u32 element);

/* Whether the output is a record. */
bool ts_vector_gives_record(const ts_vector *vector);
/* The dtypes of the two files as numpy writes them. */
void ts_vector_in_descr(char descr[TS_VECTOR_DESCR], const ts_vector *vector);
void ts_vector_out_descr(char descr[TS_VECTOR_DESCR], const ts_vector *vector);
/* Writes the shape of the file of outputs: items, and elements of an item if there are several and the output is no
 * record. Returns the number of dimensions. */
u32 ts_vector_out_shape(u64 shape[TS_MAX_DIMS], const ts_vector *vector);

/* Fills TS_VECTOR_ITEMS rows of inputs and of outputs, always the same: special values first, then random ones over the
 * whole range, then rows for which each of the primitive's faults gives another result. No float of the outputs is
 * infinite or NaN. */
void ts_vector_make(const ts_vector *vector, u32 *in, u32 *out);

/* The judgement of a port's outputs. */
typedef struct {
	u32 n_wrong, first;           /* items; the first wrong one */
	u32 first_element;            /* wrong element of the first wrong item */
	i64 first_apart;              /* its distance from the right one: steps between floats, differences of integers */
	bool first_nan;               /* that element is a float and no number; its distance is 0 then */
	u32 n_explained[TS_N_FAULTS]; /* wrong items that the fault reproduces */
	ts_vector_fault fault;        /* the fault that reproduces most; TS_N_FAULTS: none reproduces any */
	ts_vector_fault first_fault;  /* reproduces the first: `fault` if that does; TS_N_FAULTS: none does */
} ts_vector_verdict;
ts_vector_verdict ts_vector_judge(const ts_vector *vector, const u32 *in, const u32 *out, const u32 *found);

/* Run every primitive, or every composite, on a backend, and keep the results in backend->arithmetic. A backend whose
 * bits differ is refused with a message that names the function, unless `inexact`; flushed denormals do not count as a
 * difference. Only the primitives are checked before a backend runs: composites are made of primitives, and a device
 * would have to build kernels of their own for them. */
ts_status ts_vectors_verify(ts_backend *backend, bool inexact);
ts_status ts_vectors_verify_composites(ts_backend *backend);

/* Steps between two floats in the order of all floats, in which -0 is one step below +0; a NaN has the place of its
 * bits. */
i64 ts_vector_ulps(u32 from, u32 to);

#endif
