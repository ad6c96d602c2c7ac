/* Loops for vectors: compiled for each width that processors have, and the widest taken when the program starts. The bits
 * are the same, as nothing is contracted and no sum is reordered (CONTRACT rule 4). Not where threads are watched:
 * what chooses runs before the watcher. */
#ifndef TS_BACKENDS_C_WIDE_H
#define TS_BACKENDS_C_WIDE_H

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define TS_WIDE
#endif
#endif

#if !defined(TS_WIDE) && defined(__x86_64__) && defined(__ELF__)
#define TS_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#elif !defined(TS_WIDE)
#define TS_WIDE
#endif

#endif
