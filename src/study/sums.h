/* What the report of a frame says of a family: sums of bytes of its buffers, and a table of its own. */
#ifndef TS_STUDY_SUMS_H
#define TS_STUDY_SUMS_H
#include "study/measure.h"
#include "study/results/table.h"

/* A row of the table of memory. */
typedef struct {
	const char *name;
	u64 (*bytes)(const ts_measure *measure); /* 0: the method has none */
} ts_bytes_rule;

/* The runs of a frame, by all methods. */
typedef struct {
	const ts_measure *measures;
	u32 n_measures;
	const ts_scene *scene;
	const ts_params *params;
	u64 n_reflective; /* pixels */
} ts_measured_frame;

/* A table of figures, for an effect with mirrors. */
typedef struct {
	const char *key, *title;
	void (*put)(ts_table *table, const ts_measured_frame *of); /* rows of a name and a figure */
} ts_figures_rule;

/* Take the rules of all families: lists ended by NULL, each ended by a row without a function. They must stay. */
void ts_sums_bytes_use(const ts_bytes_rule *const *rules);
void ts_sums_figures_use(const ts_figures_rule *const *rules);

/* The lists that were taken. */
const ts_bytes_rule *const *ts_sums_bytes(void);
const ts_figures_rule *const *ts_sums_figures(void);

/* The measure of the first method that makes the buffer; NULL: there is none. */
const ts_measure *ts_sums_find(const ts_measured_frame *of, ts_buffer_id id);

#endif
