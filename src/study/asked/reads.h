/* Who reads which parameter. */
#ifndef TS_STUDY_ASKED_READS_H
#define TS_STUDY_ASKED_READS_H
#include "methods/pipeline.h"

/* Whether reads.def has such a row: a stage, a method by its effect, a size, a truth or a kind of scene reads the
 * parameter. Name NULL: any of that kind. */
bool ts_reads(const char *kind, const char *name, const char *param);
/* Whether some kind of scene reads the parameter. */
bool ts_reads_scene(const char *param);
/* Whether the method reads the parameter, or a stage that the method runs with these parameters (NULL: any of its
 * stages), or the size of a buffer of such a stage. Parameters that the method sets itself do not count. */
bool ts_reads_method(const ts_pipeline *method, const ts_params *params, const char *param);
/* As ts_reads_method, of any of its stages, for the name of a method. */
bool ts_reads_named(const char *effect, const char *method, const char *param);
/* Whether the method reads the parameter to make the buffers `ids`, ended by TS_N_BUFFERS. */
bool ts_reads_making(const ts_pipeline *method, const ts_buffer_id *ids, const char *param);

#endif
