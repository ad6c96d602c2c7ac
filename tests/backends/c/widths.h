/* The vector widths of the fast paths (src/backends/wide.h): a test takes them one after the other, as machines have
 * them that lack the wider ones. */
#ifndef TS_TESTS_BACKENDS_WIDTHS_H
#define TS_TESTS_BACKENDS_WIDTHS_H

#if defined(__x86_64__)
/* What __builtin_cpu_supports reads, of libgcc and of clang's runtime. */
extern struct {
	unsigned vendor, type, subtype, features;
} __cpu_model;
enum { WIDTHS = 3 };

/* Leaves the machine the first k + 1 of SSE2, AVX2 and AVX-512. Returns what widths_restore takes. */
static inline unsigned widths_take(unsigned k)
{
	enum { AVX2 = 10, AVX512F = 15 };
	unsigned all = __cpu_model.features;
	if (k < 2) __cpu_model.features &= ~(1u << AVX512F);
	if (k < 1) __cpu_model.features &= ~(1u << AVX2);
	return all;
}

static inline void widths_restore(unsigned all) { __cpu_model.features = all; }
#else
enum { WIDTHS = 1 };

static inline unsigned widths_take(unsigned k) { return k; }
static inline void widths_restore(unsigned all) { (void)all; }
#endif

#endif
