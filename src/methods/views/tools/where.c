/* Places of pairs of nodes. */
#include <stdio.h>
#include "kernels/views/traverse.h"
#include "methods/views/tools/tools.h"

static void where_key(char *text, u64 pair)
{
	snprintf(text, TS_WHERE_TEXT, "pair (node %u, node of views %u)", (unsigned)ts_k_pair_node(pair),
	         (unsigned)ts_k_pair_views(pair));
}

static bool where_pair(char *text, const ts_trace *reference, ts_buffer_id id, u64 index)
{
	u64 pair;
	if (!ts_where_fetch(reference, id, index, &pair)) return false;
	where_key(text, pair);
	return true;
}

const ts_where_rule ts_views_places[] = {
	{TS_DIM_rendered_pairs, where_pair, where_key},
	{.where = NULL},
};
