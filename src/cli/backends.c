/* Opens the backend of a job. */
#include "cli/backends.h"
#include "vectors/vectors.h"

ts_status ts_backend_open(ts_job *job)
{
	const ts_backend_kind *kind = job->backend;
	if (kind->open == NULL) return TS_OK;
	double begin = ts_seconds();
	ts_status status = kind->open(&job->how.backend, &job->device);
	if (status == TS_OK) status = ts_vectors_verify(job->how.backend, job->device.inexact);
	job->open_s = ts_seconds() - begin;
	return status == TS_SKIPPED && job->require ? TS_ERROR : status;
}
