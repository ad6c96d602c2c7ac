/* What a comparison need not find exact, as it was typed. */
#ifndef TS_CLI_RELAXED_H
#define TS_CLI_RELAXED_H
#include "client.h"

enum { TS_RELAXED_TEXT = 1100 };

/* All relaxations, as they are typed, but control characters become '?': they are part of the verdict. "" if there are
 * none. */
void ts_relaxed_text(char text[TS_RELAXED_TEXT], const ts_cli *cli);
/* The same as options of the library, but for --ignore, and with the picture of --mask: 1 where it is not black. The
 * mask, which options->mask points to, is released by free(), also on failure. */
ts_status ts_relaxed_options(ts_compare_options *options, u8 **mask, const ts_cli *cli);

#endif
