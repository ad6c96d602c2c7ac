/* What a comparison need not find exact, as it was typed. */
#ifndef TS_CLI_RELAXED_H
#define TS_CLI_RELAXED_H
#include "cli.h"

enum { TS_RELAXED_TEXT = 1100 };

/* All relaxations, as they are typed, but control characters become '?': they are part of the verdict. "" if there are
 * none. */
void ts_relaxed_text(char text[TS_RELAXED_TEXT], const ts_cli *cli);
/* Reads the picture of --mask: 1 where it is not black; *mask by free(). Without --mask it is NULL. */
ts_status ts_relaxed_mask(u8 **mask, u32 *width, u32 *height, const ts_cli *cli);

#endif
