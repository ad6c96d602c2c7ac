/* The composites that all methods share (composites.def). */
#ifndef TS_KERNELS_COMPOSITES_H
#define TS_KERNELS_COMPOSITES_H
#include "composites_geometry.h"
#include "composites_lattice.h"
#include "composites_shade.h"

#define VECTOR(name) TS_COMPOSITE_##name,
typedef enum {
#include "composites.def"
	TS_N_COMPOSITES,
} ts_composite;
#undef VECTOR

/* map over rows */
TS_FN void ts_k_composites_item(const ts_vectors_args *args, u64 i)
{
	TS_GLOBAL const u32 *in = args->in + i * args->in_words;
	TS_GLOBAL u32 *out = args->out + i * args->out_words;
#define VECTOR(name) \
	case TS_COMPOSITE_##name: ts_k_vector_##name(out, in); break;
	switch (args->primitive) {
#include "composites.def"
	}
#undef VECTOR
}

#endif
