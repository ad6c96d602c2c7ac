/* Verdicts of comparisons and replays as structs. */
#ifndef TS_API_VERDICTS_H
#define TS_API_VERDICTS_H
#include <jansson.h>
#include <touchstone/compare.h>
#include "api/api.h"
#include "replay/judge.h"

typedef struct ts_verdict_details ts_verdict_details;

struct ts_verdicts {
	ts_comparison *comparison;
	ts_verdict_info info[TS_N_BUFFERS];
	ts_verdict_details *details[TS_N_BUFFERS];     /* of each buffer; NULL: it does not differ */
	char *file[TS_N_BUFFERS], *text[TS_N_BUFFERS]; /* of each replay; NULL: none */
	u32 n;
	const ts_divergence *first; /* NULL: nothing differs */
	json_t *tree;
};

/* The relaxations of a caller's options. */
ts_status ts_api_relax(ts_relaxations *relaxations, const ts_compare_options *options);

/* An empty list of verdicts, with room for `most` differences per buffer; NULL with the message set on failure. Release
 * by ts_verdicts_free. */
ts_verdicts *ts_verdicts_make(u32 most);
/* Adds the verdict on a buffer. Its strings belong to the comparison, which must not change any more. */
ts_status ts_verdicts_add(ts_verdicts *verdicts, const ts_trace *reference, ts_buffer_id id);
/* Adds to the last verdict the facts that only a replay gives. */
ts_status ts_verdicts_add_replay(ts_verdicts *verdicts, const ts_judged *judged);
/* Ends the list with the facts of the verdicts' tree. */
ts_status ts_verdicts_end(ts_verdicts *verdicts, const ts_trace *reference, const ts_trace *candidate);

#endif
