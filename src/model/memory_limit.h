/* What limits the memory of this process. */
#ifndef TS_MODEL_MEMORY_LIMIT_H
#define TS_MODEL_MEMORY_LIMIT_H
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

/* In bytes; UINT64_MAX is no limit. */
typedef struct {
	uint64_t machine, container;
	uint64_t space, mapped; /* RLIMIT_AS (ulimit -v), and what is mapped already */
	uint64_t data, written; /* RLIMIT_DATA (ulimit -d), and what counts against it already */
} ts_memory_grants;

/* The least of them, less what is taken: UINT64_MAX if nothing is limited. */
uint64_t ts_memory_granted(const ts_memory_grants *grants);

/* What the control groups of this process grant, of version 2 (memory.max) and 1 (memory.limit_in_bytes), by the files
 * below root/proc and root/sys. */
uint64_t ts_container_limit(const char *root);

#ifdef __cplusplus
}
#endif
#endif
