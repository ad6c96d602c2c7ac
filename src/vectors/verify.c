/* The arithmetic vectors on a backend. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "vectors/row.h"

/* Memory for one primitive: inputs, right outputs, the backend's outputs. */
typedef struct {
	_Alignas(8) u32 in[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];
	_Alignas(8) u32 out[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];
	_Alignas(8) u32 found[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];
} rows;

static ts_status compute(ts_backend *backend, rows *r, const ts_vector_place *at)
{
	const ts_vector *v = at->vector;
	ts_frame frame;
	memset(&frame, 0, sizeof frame);
	ts_vectors_args args = {r->in, r->found, at->primitive, ts_vector_in_words(v), ts_vector_out_words(v)};
	memset(r->found, 0, (size_t)TS_VECTOR_ITEMS * args.out_words * sizeof(u32));
	ts_frame_lend(&frame, TS_WORK_tallies, r->in, (u64)TS_VECTOR_ITEMS * args.in_words * sizeof(u32));
	ts_frame_lend(&frame, TS_WORK_other, r->found, (u64)TS_VECTOR_ITEMS * args.out_words * sizeof(u32));
	ts_status status = backend->launch(backend, &frame, at->launch, &args, TS_VECTOR_ITEMS);
	ts_status recalled = ts_frame_recall(&frame, TS_WORK_other);
	ts_frame_clear(&frame);
	return status == TS_OK ? recalled : status;
}

/* Other faults may occasionally look like a flush. */
static void learn(ts_measured *a, const ts_vector *v, const ts_vector_verdict *verdict)
{
	a->contracts |= verdict->n_explained[TS_FAULT_FMA] != 0;
	a->keeps_denormals &= verdict->n_wrong == 0 || verdict->n_wrong != verdict->n_explained[TS_FAULT_FLUSH];
	if (strcmp(v->name, "add") == 0) a->rounds_to_nearest = verdict->n_wrong == verdict->n_explained[TS_FAULT_FLUSH];
}

/* The contract also holds with denormals flushed: its kernels flush values that would show the difference (CONTRACT
 * rule 11). */
static bool is_right(const ts_vector_verdict *verdict)
{
	return verdict->n_wrong == verdict->n_explained[TS_FAULT_FLUSH];
}

/* "muladd (607 of 4096: fused multiply-add)" at the end of a list. */
static void name_it(char *text, size_t bytes, const ts_vector *v, const ts_vector_verdict *verdict)
{
	size_t used = strlen(text);
	bool known = verdict->fault != TS_N_FAULTS;
	snprintf(text + used, bytes - used, "%s%s (%" PRIu32 " of %d%s%s)", used != 0 ? ", " : "", v->name,
	         verdict->n_wrong, TS_VECTOR_ITEMS, known ? ": " : "",
	         known ? ts_vector_fault_table[verdict->fault].name : "");
}

static ts_status verify_once(ts_backend *backend, bool composed, rows *r, char *wrong, size_t bytes)
{
	wrong[0] = 0;
	backend->arithmetic = (ts_measured){.rounds_to_nearest = true, .keeps_denormals = true};
	for (u32 i = 0; i < ts_vectors_count(); i++) {
		ts_vector_place at = ts_vectors_place(i);
		const ts_vector *v = at.vector;
		if (at.composed != composed) continue;
		ts_vector_make(v, r->in, r->out);
		if (compute(backend, r, &at) != TS_OK) return TS_ERROR;
		ts_vector_verdict verdict = ts_vector_judge(v, r->in, r->out, r->found);
		learn(&backend->arithmetic, v, &verdict);
		if (is_right(&verdict)) continue;
		name_it(wrong, bytes, v, &verdict);
		backend->arithmetic.n_wrong++;
	}
	return backend->finish(backend);
}

static ts_status verify(ts_backend *backend, bool composed, rows *r, char *wrong, size_t bytes)
{
	ts_status status = verify_once(backend, composed, r, wrong, bytes);
	bool again = status == TS_OK && backend->arithmetic.n_wrong != 0 && backend->repair != NULL;
	return again && backend->repair(backend) ? verify_once(backend, composed, r, wrong, bytes) : status;
}

static ts_status verify_set(ts_backend *backend, bool composed, bool inexact)
{
	char wrong[512];
	rows *r = ts_alloc(1, sizeof *r, "arithmetic vectors");
	if (r == NULL) return TS_ERROR;
	ts_status status = verify(backend, composed, r, wrong, sizeof wrong);
	free(r);
	if (status != TS_OK || backend->arithmetic.n_wrong == 0 || inexact) return status;
	return ts_fail("backend %s: %s breaks the numeric contract, so nothing it computes can be relied on, in %" PRIu32
	               " primitives: %s; inexact runs it all the same",
	               backend->name, backend->device, backend->arithmetic.n_wrong, wrong);
}

ts_status ts_vectors_verify(ts_backend *backend, bool inexact) { return verify_set(backend, false, inexact); }

ts_status ts_vectors_verify_composites(ts_backend *backend) { return verify_set(backend, true, false); }
