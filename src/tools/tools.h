/* Connects the engines with the families' rows. */
#ifndef TS_TOOLS_TOOLS_H
#define TS_TOOLS_TOOLS_H

/* Hands each engine the rows of all families. To be called before any engine is used, from one thread; may be called
 * again. */
void ts_tools_begin(void);

#endif
