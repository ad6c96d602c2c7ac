/* Code of the commands that use the library by its public headers, like any other program. */
#ifndef TS_CLI_CLIENT_H
#define TS_CLI_CLIENT_H
#include <jansson.h>
#include "cli.h"
#include <touchstone/touchstone.h>

/* The context of a command: the C backend on its threads. The command prints the library's lines and progress as its
 * own. Release by ts_context_close; NULL on failure. */
ts_status ts_client_open(ts_context **context, const ts_cli *cli);

/* A tree as JSON, and released; a new reference. NULL with the message set on failure, or of NULL. */
json_t *ts_client_json(ts_tree *tree);

#endif
