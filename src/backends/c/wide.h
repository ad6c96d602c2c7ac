/* Loops for vectors: compiled for each width that processors have, and the widest taken when the program starts. The bits
 * are the same, as nothing is contracted and no sum is reordered (CONTRACT rules 1 and 2). */
#ifndef TS_BACKENDS_C_WIDE_H
#define TS_BACKENDS_C_WIDE_H

#if defined(__x86_64__) && defined(__ELF__)
#define TS_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define TS_WIDE
#endif

#endif
