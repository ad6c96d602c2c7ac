/* What the families bring, in their order. */
#include "families.h"
#include "../vectors/vectors.h"

/* VECTORS(name): ts_<name>_vectors, the primitives of a family that has some. */
#define FAMILY(name) FAMILY_FILE(methods/name/vectors.def)
#define VECTORS(name) extern const ts_vector_set ts_##name##_vectors;
#include "../families.def"
#undef VECTORS

#define VECTORS(name) &ts_##name##_vectors,
static const ts_vector_set *const vectors[] = {
#include "../families.def"
	NULL,
};
#undef VECTORS
#undef FAMILY

void ts_families_begin(void) { ts_vectors_use(vectors); }
