/* Reflective pixels whose samples meet corners and edges of faces, with normals that are short or none. */
#ifndef TS_TESTS_KERNELS_POINTS_PIXELS_H
#define TS_TESTS_KERNELS_POINTS_PIXELS_H
#include "tests/kernels/points/mesh.h"

/* Whole numbers send samples through corners and edges; what is nearly nothing, and nothing. */
static inline ts_v3 extreme_vector(void)
{
	ts_v3 v = uniform3(-2, 2);
	switch (random_bits() % 6) {
	case 0: return ts_v3_make(ts_floor(v.x), ts_floor(v.y), ts_floor(v.z));
	case 1: return ts_scale(v, 1e-20f);
	case 2: return ts_v3_make(v.x, v.x, random_bits() % 2 == 0 ? v.x : -v.x);
	case 3: return random_bits() % 4 == 0 ? ts_v3_make(0, 0, 0) : v;
	default: return v;
	}
}

static inline void random_pixels(ts_pixel *pixels, u32 n, u32 n_cubes)
{
	for (u32 i = 0; i < n; i++) {
		bool still = random_bits() % 3 == 0; /* all samples go one way */
		f32 spread = still ? 0 : uniform_power(-10, 0);
		pixels[i] = (ts_pixel){.reflector = random_bits() % n_cubes};
		ts_store3(pixels[i].position, extreme_vector());
		ts_store3(pixels[i].normal, extreme_vector());
		ts_store3(pixels[i].position_dx, ts_scale(uniform3(-1, 1), spread));
		ts_store3(pixels[i].position_dy, ts_scale(uniform3(-1, 1), spread));
		ts_store3(pixels[i].normal_dx, ts_scale(uniform3(-1, 1), spread));
		ts_store3(pixels[i].normal_dy, ts_scale(uniform3(-1, 1), spread));
	}
}

#endif
