/* Opens the backend that --backend and its options name. */
#ifndef TS_CLI_BACKENDS_H
#define TS_CLI_BACKENDS_H
#include "study/job.h"

/* Opens the job's backend into job->how, unless it is that in C. A device that breaks the numeric contract is refused,
 * except with --inexact. */
ts_status ts_backend_open(ts_job *job);

#endif
