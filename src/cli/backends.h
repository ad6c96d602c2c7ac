/* What --backend and the options behind it name. */
#ifndef TS_CLI_BACKENDS_H
#define TS_CLI_BACKENDS_H
#include "../stages/stage.h"

/* Each program's own, the reference first, ended by NULL. */
extern const ts_backend_kind *const ts_backend_kinds[];

typedef struct ts_cli ts_cli;

/* Opens what --backend and its options say into cli->how, if it is not the reference; a device that breaks the numeric
 * contract is refused, unless it may. */
ts_status ts_backend_open(ts_cli *cli);
/* The backend of that name; TS_ERROR, with a message that names those there are. */
ts_status ts_backend_find(const ts_backend_kind **kind, const char *name);

#endif
