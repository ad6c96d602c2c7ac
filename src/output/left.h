/* What this process writes at the moment, and would leave behind if it was killed. */
#ifndef TS_OUTPUT_LEFT_H
#define TS_OUTPUT_LEFT_H
#include "../model/core.h"

/* Keeps the record where the parent of processes that are forked from now on sees theirs. */
ts_status ts_left_share(void);
/* Notes the file that is written; "" none. */
void ts_left_file(const char *partial);
/* Notes the folder that is written, by its final name, and how many folders above it were made for it; "" none. */
void ts_left_folder(const char *dir, uint32_t n_parents);
/* Removes what a process that ended has left. */
void ts_left_clear(void);

#endif
