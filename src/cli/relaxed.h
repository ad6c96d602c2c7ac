/* The relaxations of a comparison as they were typed. */
#ifndef TS_CLI_RELAXED_H
#define TS_CLI_RELAXED_H
#include "cli/cli.h"

enum { TS_RELAXED_TEXT = 1100 };

/* All relaxations as they were typed, with control characters replaced by '?'. The text is part of the verdict; "" if
 * there are none. */
void ts_relaxed_text(char text[TS_RELAXED_TEXT], const ts_cli *cli);

#endif
