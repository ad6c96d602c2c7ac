/* Shards of a series. */
#include "merge.h"
ts_status ts_merge_series(ts_cli *cli, const ts_parts *parts)
{
	(void)cli;
	(void)parts;
	return ts_fail("not yet");
}
