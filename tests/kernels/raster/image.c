/* The picture: display values, background, and mirrors that show what was reflected. */
#include "kernels/raster/image.h"
#include "tests/kernels/points/mesh.h"
#include "tests/srgb.h"

enum { W = 16, H = 8 };

typedef struct {
	mesh mesh;
	u64 depth_triangle[W * H];
	u32 offset[W * H + 1];
	f32 reflected[W * H * 3], radiance[W * H * 3];
	u8 srgb[W * H * 3];
	ts_image_args args;
} picture;

/* A picture of nothing. */
static void picture_begin(picture *p)
{
	memset(p, 0, sizeof *p);
	mesh_begin(&p->mesh);
	p->mesh.view.width = W;
	p->mesh.view.height = H;
	p->mesh.view.focal = 8;
	memset(p->depth_triangle, 0xff, sizeof p->depth_triangle);
	p->args = (ts_image_args){.scene = mesh_arrays(&p->mesh),
	                          .view = &p->mesh.view,
	                          .depth_triangle = p->depth_triangle,
	                          .offset = p->offset,
	                          .reflected = p->reflected,
	                          .radiance = p->radiance,
	                          .srgb = p->srgb,
	                          .exposure = 1};
}

static void picture_make(picture *p)
{
	p->args.scene = mesh_arrays(&p->mesh);
	for (u32 i = 0; i < W * H; i++) ts_k_image_item(&p->args, i);
}

static double curve(double l) { return 255 * fmin(fmax(srgb_encoded(l), 0), 1); }

/* Display values never fall, reach both ends, and are the curve's to half a step. */
static void display_values_follow_the_curve(void **state)
{
	(void)state;
	u32 before = 0;
	for (u32 i = 0; i <= 1200000; i++) {
		f32 l = (f32)i * 1e-6f;
		u32 byte = ts_srgb_byte(l);
		assert_true(byte >= before && byte <= 255);
		assert_true(fabs(byte - curve((double)l)) <= 0.5001);
		before = byte;
	}
	assert_int_equal(before, 255);
	assert_int_equal(ts_srgb_byte(-1), 0);
	assert_int_equal(ts_srgb_byte(ts_u2f(0x7fc00000)), 0);
	assert_int_equal(ts_srgb_byte(ts_u2f(0x7f800000)), 255);
}

static void pixels_of_nothing_show_the_background(void **state)
{
	(void)state;
	picture p;
	picture_begin(&p);
	picture_make(&p);
	for (u32 i = 0; i < W * H; i++) {
		assert_true(p.radiance[i * 3] == 0.2f && p.radiance[i * 3 + 1] == 0.3f && p.radiance[i * 3 + 2] == 0.5f);
		for (u32 c = 0; c < 3; c++)
			assert_true(fabs(p.srgb[i * 3 + c] - curve((double)p.radiance[i * 3 + c])) <= 0.5001);
	}
}

/* Reflective pixels take theirs of the queue, in order; the others stay. */
static void mirrors_take_their_colours_in_order(void **state)
{
	(void)state;
	n_random = 0;
	picture p;
	picture_begin(&p);
	for (u32 i = 0; i < W * H * 3; i++) p.reflected[i] = uniform(0, 2);
	bool mirror[W * H];
	for (u32 i = 0; i < W * H; i++) {
		mirror[i] = random_bits() % 3 == 0;
		p.offset[i + 1] = p.offset[i] + mirror[i];
	}
	picture_make(&p);
	u32 n = 0;
	for (u32 i = 0; i < W * H; i++) {
		if (!mirror[i])
			assert_true(p.radiance[i * 3] == 0.2f);
		else
			assert_memory_equal(p.radiance + i * 3, p.reflected + 3 * n++, 3 * sizeof(f32));
	}
	assert_int_equal(n, p.offset[W * H]);
}

/* A wall without light of its own shows ambient times colour, without lights unlit shows its colour. */
static void a_wall_shows_its_ambient_light(void **state)
{
	(void)state;
	for (u32 unlit = 0; unlit < 2; unlit++) {
		picture p;
		picture_begin(&p);
		mesh_triangle(&p.mesh, ts_v3_make(-90, -90, -4), ts_v3_make(90, -90, -4), ts_v3_make(0, 90, -4), 0, 0);
		ts_material *m = &p.mesh.materials[0];
		m->base[0] = 0.5f;
		m->base[1] = 0.25f;
		m->base[2] = 1;
		m->metallic = 0.5f;
		m->emissive[1] = 0.125f;
		m->flags = unlit != 0 ? TS_UNLIT : 0;
		for (u32 i = 0; i < W * H; i++) p.depth_triangle[i] = (u64)ts_f2u(4) << 32;
		picture_make(&p);
		for (u32 i = 0; i < W * H; i++) {
			for (u32 c = 0; c < 3; c++) {
				double expected = unlit != 0 ? m->base[c] : (double)m->emissive[c] + m->base[c] * 0.5;
				assert_true(fabs(p.radiance[i * 3 + c] - expected) <= 1e-6);
			}
		}
	}
}

/* Exposure scales what is displayed, not the radiance. */
static void exposure_scales_only_what_is_displayed(void **state)
{
	(void)state;
	n_random = 0;
	picture p, q;
	picture_begin(&p);
	picture_begin(&q);
	for (u32 i = 0; i <= W * H; i++) p.offset[i] = q.offset[i] = i;
	for (u32 i = 0; i < W * H * 3; i++) {
		p.reflected[i] = uniform_power(-12, 1);
		q.reflected[i] = p.reflected[i] * 4;
	}
	p.args.exposure = 4;
	picture_make(&p);
	picture_make(&q);
	assert_memory_equal(p.srgb, q.srgb, sizeof p.srgb);
	assert_memory_equal(p.radiance, p.reflected, sizeof p.radiance);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(display_values_follow_the_curve),
		cmocka_unit_test(pixels_of_nothing_show_the_background),
		cmocka_unit_test(mirrors_take_their_colours_in_order),
		cmocka_unit_test(a_wall_shows_its_ambient_light),
		cmocka_unit_test(exposure_scales_only_what_is_displayed),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
