/* The command as a client of the library. */
#include "client.h"
#include <stdlib.h>

ts_status ts_client_open(ts_context **context, const ts_cli *cli)
{
	const bool quiet = cli->job.output.quiet;
	const ts_context_options options = {.bytes = sizeof options,
	                                    .threads = cli->job.how.threads,
	                                    .say = quiet ? NULL : ts_cli_say,
	                                    .progress = quiet ? NULL : ts_cli_progress};
	return ts_context_open(context, &options);
}

json_t *ts_client_json(ts_tree *tree)
{
	if (tree == NULL) return NULL;
	char *text = ts_tree_json(tree);
	ts_tree_free(tree); /* before there is another */
	json_t *json = text != NULL ? json_loads(text, JSON_DECODE_ANY, NULL) : NULL;
	free(text);
	if (json == NULL) ts_fail("an answer: out of memory");
	return json;
}
