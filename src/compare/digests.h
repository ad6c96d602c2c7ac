/* Buffers whose files were left out, judged by the digests that trace.json says. */
#ifndef TS_COMPARE_DIGESTS_H
#define TS_COMPARE_DIGESTS_H
#include "compare/compare.h"

/* Whether the trace has the buffer's file, or at least its digest. */
bool ts_digest_known(const ts_trace_item *item);
/* Judges a buffer that one side or both know by its digest alone. */
ts_status ts_compare_digests(ts_verdict *verdict, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                             const ts_relaxations *relaxations);

#endif
