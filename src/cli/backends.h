/* Opens what --backend and the options behind it name. */
#ifndef TS_CLI_BACKENDS_H
#define TS_CLI_BACKENDS_H
#include "../study/job.h"

/* Opens the job's backend into job->how, if it is not that in C; a device that breaks the numeric contract
 * is refused, unless it may. */
ts_status ts_backend_open(ts_job *job);

#endif
