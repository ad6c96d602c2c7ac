/* The rules of families: ties, and margins against their thresholds. */
#include "compare/decided.h"
#include <assert.h>
#include "kernels/base/num.h"

static const ts_tie_rule *const *tie_lists;

void ts_tie_use(const ts_tie_rule *const *rules) { tie_lists = rules; }

const ts_tie_rule *ts_tie_find(ts_buffer_id buffer)
{
	assert(tie_lists != NULL);
	for (const ts_tie_rule *const *list = tie_lists; *list != NULL; list++) {
		for (const ts_tie_rule *rule = *list; rule->open != NULL; rule++) {
			if (rule->buffer == buffer) return rule;
		}
	}
	return NULL;
}

static const ts_margin_rule *const *lists;

void ts_decided_use(const ts_margin_rule *const *rules) { lists = rules; }

/* True if the method's runs have these margins; unknown for a single file. */
static bool is_measured(const ts_trace *reference, const ts_margin_rule *rule)
{
	if (reference->pipeline == NULL) return !rule->rare;
	return ts_pipeline_maker(reference->pipeline, rule->margin) != NULL;
}

static const ts_margin_rule *find(const ts_trace *reference, ts_buffer_id id)
{
	assert(lists != NULL);
	for (const ts_margin_rule *const *list = lists; *list != NULL; list++) {
		for (const ts_margin_rule *rule = *list; rule->of != 0; rule++) {
			if (rule->buffer == id && is_measured(reference, rule)) return rule;
		}
	}
	return NULL;
}

static size_t element_bytes(const ts_margin_rule *rule) { return ts_buffer_table[rule->margin].element_bytes; }

/* Elements of the margin per place. */
static u64 every(const ts_margin_rule *rule) { return element_bytes(rule) == sizeof(u64) ? 2 : 1; }

ts_status ts_decided_open(ts_decided *decided, const ts_trace *reference, ts_buffer_id id)
{
	const ts_margin_rule *rule = find(reference, id);
	*decided = (ts_decided){.rule = rule};
	if (rule == NULL) return TS_OK;
	const ts_trace_item *item = &reference->item[rule->margin], *of = &reference->item[id];
	if (item->path == NULL || item->npy.n * rule->of != of->npy.n * every(rule)) {
		return ts_fail("%s: decided: needs %s for each element of %s, which a reference with margins has",
		               reference->dir, ts_buffer_table[rule->margin].name, ts_buffer_table[id].name);
	}
	decided->reader = ts_trace_read(item, rule->margin);
	return decided->reader != NULL ? TS_OK : TS_ERROR;
}

void ts_decided_close(ts_decided *decided) { ts_reader_close(decided->reader); }

static bool is_decided(const ts_margin_rule *rule, const void *first, const void *second)
{
	u64 edge, depth;
	f32 number;
	if (element_bytes(rule) == sizeof(u8)) return *(const u8 *)first == 0;
	if (element_bytes(rule) == sizeof(f32)) {
		memcpy(&number, first, sizeof number);
		return !(number <= rule->steps); /* all ones: none */
	}
	memcpy(&edge, first, sizeof edge);
	memcpy(&depth, second, sizeof depth);
	return (edge == TS_EMPTY || ts_u2f((u32)edge) > rule->steps) &&
	       (depth == TS_EMPTY || ts_u2f((u32)depth) > rule->steps);
}

ts_status ts_decided_is(ts_decided *decided, u64 element, bool *is)
{
	*is = true;
	if (decided->reader == NULL) return TS_OK;
	const ts_margin_rule *rule = decided->rule;
	u64 held, n = every(rule), copy = 0;
	const void *first = ts_reader_at(decided->reader, element / rule->of * n, &held);
	if (first == NULL) return TS_ERROR;
	memcpy(&copy, first, element_bytes(rule));
	const void *second = n == 2 ? ts_reader_at(decided->reader, element / rule->of * 2 + 1, &held) : &copy;
	if (second == NULL) return TS_ERROR;
	*is = is_decided(rule, &copy, second);
	return TS_OK;
}
