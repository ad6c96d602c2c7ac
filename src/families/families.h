/* The families of methods, and their rows for the engines. */
#ifndef TS_FAMILIES_FAMILIES_H
#define TS_FAMILIES_FAMILIES_H

/* Hands the engines their rows; every program calls it first. */
void ts_families_begin(void);

#endif
