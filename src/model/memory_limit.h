/* What limits the memory of this process. */
#ifndef TS_MODEL_MEMORY_LIMIT_H
#define TS_MODEL_MEMORY_LIMIT_H
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Limits and what counts against them already, in bytes; a limit of UINT64_MAX is none. */
typedef struct {
	uint64_t machine, container;
	uint64_t space, mapped; /* RLIMIT_AS (ulimit -v), and what is mapped already */
	uint64_t data, written; /* RLIMIT_DATA (ulimit -d), and what counts against it already */
} ts_memory_grants;

/* The least of the limits, each less what counts against it; UINT64_MAX if there is no limit. */
uint64_t ts_memory_granted(const ts_memory_grants *grants);

/* The memory limit of this process's control groups, of version 2 (memory.max) and 1 (memory.limit_in_bytes), read from
 * the files below root/proc and root/sys. */
uint64_t ts_container_limit(const char *root);

#ifdef __cplusplus
}
#endif
#endif
