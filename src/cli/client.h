/* Code of the commands that use the library by its public headers, like any other program. */
#ifndef TS_CLI_CLIENT_H
#define TS_CLI_CLIENT_H
#include <jansson.h>
#include <touchstone/touchstone.h>
#include "cli/line/cli.h"

/* The context of a command: the C backend on its threads. The command prints the library's lines and progress as its
 * own. Release by ts_context_close; NULL on failure. */
ts_status ts_client_open(ts_context **context, const ts_cli *cli);

/* A tree as JSON, and released; a new reference. NULL with the message set on failure, or of NULL. */
json_t *ts_client_json(ts_tree *tree);

/* Writes the page of --report, which `put` fills. */
ts_status ts_client_page(const ts_cli *cli, const char *json,
                         ts_status (*put)(ts_html *page, const char *json, const void *user), const void *user);

/* The relaxations as options of the library, without --ignore, and with the picture of --mask: 1 where it is not black.
 * options->mask points to *mask; release it by free(), also on failure. */
ts_status ts_client_options(ts_compare_options *options, u8 **mask, const ts_cli *cli);

#endif
