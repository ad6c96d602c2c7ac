/* The relaxations of a comparison as they were typed. */
#ifndef TS_CLI_RELAXED_H
#define TS_CLI_RELAXED_H
#include "client.h"

enum { TS_RELAXED_TEXT = 1100 };

/* All relaxations as they were typed, with control characters replaced by '?'. The text is part of the verdict; "" if
 * there are none. */
void ts_relaxed_text(char text[TS_RELAXED_TEXT], const ts_cli *cli);
/* The relaxations as options of the library, without --ignore, and with the picture of --mask: 1 where it is not black.
 * options->mask points to *mask; release it by free(), also on failure. */
ts_status ts_relaxed_options(ts_compare_options *options, u8 **mask, const ts_cli *cli);

#endif
