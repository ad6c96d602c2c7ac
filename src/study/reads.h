/* Who reads which parameter. */
#ifndef TS_STUDY_READS_H
#define TS_STUDY_READS_H
#include "../methods/pipeline.h"

/* A row of reads.def: a stage, a method by its effect, a size, a truth or a kind of scene reads the parameter.
 * Name NULL: one of that kind. */
bool ts_reads(const char *kind, const char *name, const char *param);
/* Scenes of some kind read it. */
bool ts_reads_scene(const char *param);
/* The method reads it, or a stage that it takes with these parameters, NULL: any stage, or the size of what that makes;
 * but for what the method sets itself. */
bool ts_reads_method(const ts_pipeline *method, const ts_params *params, const char *param);
/* What the method does to make the buffers, ended by TS_N_BUFFERS, reads it. */
bool ts_reads_making(const ts_pipeline *method, const ts_buffer_id *ids, const char *param);

#endif
