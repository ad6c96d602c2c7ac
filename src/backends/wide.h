/* Loops for vectors: compiled for each width that processors have, with all that they call, and the widest taken when
 * the program starts. The bits are the same, as nothing is contracted and no sum is reordered (CONTRACT rule 4). Not
 * where threads are watched: what chooses runs before the watcher. Clang makes their names global: no two share one. */
#ifndef TS_BACKENDS_C_WIDE_H
#define TS_BACKENDS_C_WIDE_H

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define TS_WIDE
#endif
#endif

#define TS_WIDTHS target_clones("avx512f", "avx2", "default")
#if !defined(TS_WIDE) && defined(__x86_64__) && defined(__ELF__)
#if defined(__clang__) /* which takes no other attribute beside it */
#define TS_WIDE __attribute__((TS_WIDTHS))
#else
#define TS_WIDE __attribute__((TS_WIDTHS, flatten))
#endif
#elif !defined(TS_WIDE)
#define TS_WIDE
#endif

#endif
