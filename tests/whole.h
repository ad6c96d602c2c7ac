/* How much of what is slow by nature a test does: little, or with TS_WHOLE in its environment all. */
#ifndef TS_TESTS_WHOLE_H
#define TS_TESTS_WHOLE_H
#include <stdint.h>
#include <stdlib.h>

static inline uint32_t whole_or(uint32_t whole, uint32_t brief) { return getenv("TS_WHOLE") != NULL ? whole : brief; }

#endif
