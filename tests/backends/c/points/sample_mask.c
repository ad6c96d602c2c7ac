/* Masks of samples, found once a piece, cut what the kernel cuts: any texture, level, wrap and transform, alphas of
 * vertices, and materials without a texture. */
#include "backends/c/points/sample_mask.h"
#include "tests/kernels/points/mesh.h"

enum { N = 4000, MOST = 16, TEXELS = 2 * MOST * MOST, SAMPLES = 64, MASKED = 4 };

static void random_texture(mesh *m, u64 *texels)
{
	for (u32 i = 0; i < TEXELS; i++) texels[i] = (u64)random_bits() << 32;
	m->image = (ts_image){.width = 1 + random_bits() % MOST, .height = 1 + random_bits() % MOST};
	u32 longest = m->image.width > m->image.height ? m->image.width : m->image.height;
	m->image.n_levels = 1 + random_bits() % (32 - (u32)__builtin_clz(longest));
	m->slot = (ts_slot){.uv_set = random_bits() % 2, .wrap = {random_bits() % 3, random_bits() % 3}};
	for (u32 k = 0; k < 6; k++) m->slot.transform[k] = uniform(-2, 2);
}

/* One piece, with up to some 60 samples a side. */
static void random_piece(mesh *m)
{
	ts_v3 corner[3];
	f32 length;
	random_corners(corner, 6, 0.01f, 64);
	if (is_degenerate(corner)) corner[1] = ts_add(corner[0], ts_v3_make(1, 0, 0));
	if (is_degenerate(corner)) corner[2] = ts_add(corner[0], ts_v3_make(0, 1, 0));
	mesh_triangle(m, corner[0], corner[1], corner[2], MASKED, 0);
	for (u32 k = 0; k < 3; k++) {
		for (u32 i = 0; i < 4; i++) m->vertices[k].uv[i] = uniform(-2, 2);
		m->vertices[k].colour[3] = random_bits() % 2 == 0 ? 1 : uniform(0, 1);
	}
	ts_material *material = &m->materials[MASKED];
	material->base[3] = random_bits() % 2 == 0 ? 1 : uniform(0.5f, 1);
	material->alpha_cutoff = uniform(0, 1);
	if (random_bits() % 8 == 0) material->slot[0] = TS_NONE;
	ts_k_longest_edge(corner[0], corner[1], corner[2], &length);
	mesh_whole(m, uniform_power(0, 6) / length);
	mesh_align(m);
}

static void masks_of_samples_cut_as_the_kernel(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_cut = 0, n_kept = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		u64 texels[TEXELS];
		u32 start = n_random;
		mesh_begin(&m);
		random_texture(&m, texels);
		random_piece(&m);
		ts_arrays scene = mesh_arrays(&m);
		scene.texels = texels;
		ts_sample_mask mask = ts_sample_mask_of(&scene, m.frames, m.pieces->triangle);
		for (u32 k = 0; k < SAMPLES; k++) {
			i32 x = (i32)(random_bits() % 80) - 40, y = (i32)(random_bits() % 80) - 40;
			ts_v3 w = ts_k_lattice_weights(&scene, m.frames, 0, x, y);
			ts_v3 n = ts_k_corners(&scene, 0).n;
			bool cut = ts_k_is_cut(&scene, 0, w, n, 1.0f / m.frames->s);
			*(cut ? &n_cut : &n_kept) += 1;
			if (ts_sample_mask_cuts(&mask, x, y) != cut) fail_msg("random %u: sample %d, %d", start, x, y);
		}
		mesh_clear(&m);
	}
	assert_true(n_cut > 10 * N && n_kept > 10 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(masks_of_samples_cut_as_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
