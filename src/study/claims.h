/* Claims: what the papers' tables, figures, algorithms and slides show, which table of `bench` tests it here. */
#ifndef TS_STUDY_CLAIMS_H
#define TS_STUDY_CLAIMS_H
#include "study/bench.h"

/* One of `bench` and `cannot` is NULL. */
typedef struct {
	const char *paper;  /* by its name in reference/PAPERS.md */
	const char *place;  /* "table 1", "figure 2"; of slides the title */
	const char *shows;  /* in a few words */
	const char *bench;  /* the name of the table that tests it */
	const char *rows;   /* the relations that count, by beginnings of their texts, separated by "|"; NULL: all */
	const char *cannot; /* why no table can test it */
} ts_claim;

#endif
