/* Fast path of the shade kernel, with the same bits: samples next to each other see the same points, so each thread
 * remembers what it shaded last. Shading operations are counted as the method asks for them, remembered or not. */
#include "../../../kernels/points/lookup.h"
#include "../../fast.h"

enum { SLOTS = 4096, ENTRIES_A_CHUNK = 1024 };

/* What a point looks like from a cube's centre. */
typedef struct {
	u32 point, cube;
	ts_v3 radiance;
} seen;

static void forget(seen *memory)
{
	for (u32 i = 0; i < SLOTS; i++) memory[i].point = TS_NONE;
}

static ts_v3 recall(const ts_lookup_args *args, seen *memory, u64 sample, u32 cube, ts_v3 centre)
{
	u32 point = args->found[sample];
	if (point == TS_NONE || ts_k_is_followed(args, sample)) return ts_k_sample_radiance(args, sample, centre);
	seen *slot = &memory[(point ^ (cube << 7)) % SLOTS];
	if (slot->point != point || slot->cube != cube) {
		*slot = (seen){point, cube, ts_k_sample_radiance(args, sample, centre)};
	}
	return slot->radiance;
}

static void shade_entry(const ts_lookup_args *args, seen *memory, u64 entry)
{
	u32 cube = ts_k_cube_read(args, entry);
	ts_v3 centre = ts_load3(args->cubes[cube].centre);
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	for (u32 k = 0; k < args->n_samples; k++) {
		sum = ts_add(sum, recall(args, memory, entry * args->n_samples + k, cube, centre));
	}
	f32 count = (f32)args->n_samples;
	ts_k_shade_put(args, entry, ts_v3_make(sum.x / count, sum.y / count, sum.z / count), args->n_samples);
}

bool ts_c_fast_shade(const void *of, u64 n, u32 threads)
{
	const ts_lookup_args *args = of;
	if (args->adaptive != 0) return false;
#pragma omp parallel num_threads(threads)
	{
		seen memory[SLOTS];
		forget(memory);
#pragma omp for schedule(dynamic, ENTRIES_A_CHUNK)
		for (i64 i = 0; i < (i64)n; i++) shade_entry(args, memory, (u64)i);
	}
	return true;
}
