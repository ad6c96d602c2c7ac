/* A record of the partial file and folder that this process would leave behind if it was killed. */
#ifndef TS_OUTPUT_LEFT_H
#define TS_OUTPUT_LEFT_H
#include "model/core.h"

/* Moves the record to shared memory, where a parent sees the records of processes that it forks from now on. */
ts_status ts_left_share(void);
/* Notes the partial file that is being written; "": none. */
void ts_left_file(const char *partial);
/* Notes the final name of the folder that is being written, and how many folders above it were made for it; "":
 * none. */
void ts_left_folder(const char *dir, uint32_t n_parents);
/* Removes the file and folder that the record names, after the process has ended. */
void ts_left_clear(void);

#endif
