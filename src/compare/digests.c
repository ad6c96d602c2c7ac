/* Digests in place of files. */
#include "compare/digests.h"
#include <stdio.h>

bool ts_digest_known(const ts_trace_item *item) { return item->path != NULL || item->sha256[0] != 0; }

static bool is_exact(const ts_relaxations *r)
{
	return r->ulp == 0 && r->abs == 0 && r->rel == 0 && !r->decided && r->allow == 0 && r->ignore == NULL &&
	       r->mask == NULL;
}

ts_status ts_compare_digests(ts_verdict *v, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                             const ts_relaxations *relaxations)
{
	const ts_trace_item *sides[2] = {&reference->item[id], &candidate->item[id]};
	char hex[2][TS_DIGEST_BYTES];
	for (u32 s = 0; s < 2; s++) {
		if (ts_trace_sha256(hex[s], sides[s], id) != TS_OK) return TS_ERROR;
	}
	*v = (ts_verdict){.judgement = TS_SAME, .n_ref = sides[0]->npy.n, .n_cand = sides[1]->npy.n, .by_digest = true};
	if (strcmp(hex[0], hex[1]) == 0) return TS_OK;
	const char *left = sides[1]->path == NULL ? candidate->dir : reference->dir;
	if (sides[0]->path == NULL && sides[1]->path == NULL) left = "each side";
	const char *why = candidate->arrival ? "points in the order of their arrival" : "a relaxed comparison";
	v->judgement = !candidate->arrival && is_exact(relaxations) ? TS_UNLIKE : TS_UNABLE;
	if (v->judgement == TS_UNABLE) {
		snprintf(v->why, sizeof v->why, "%s needs its file, which %.400s leaves out", why, left);
	} else {
		snprintf(v->why, sizeof v->why, "SHA-256 ref %.16s... candidate %.16s..., as %.400s leaves its file out",
		         hex[0], hex[1], left);
	}
	return TS_OK;
}
