/* Contact sheets: what stands where, and means of what is below a pixel. */
#include "study/contact.h"
#include "tests/model/test.h"

static const u8 *cell(const ts_contact *c, u32 column, u32 row, u32 x, u32 y)
{
	size_t left = 4 + column * (size_t)(c->cell_width + 4) + x, top = 4 + row * (size_t)(c->cell_height + 4) + y;
	return c->rgb + (top * c->width + left) * 3;
}

/* Pictures that are not wider than a cell are copied; what nothing was put on stays dark. */
static void small_pictures_are_copied(void **state)
{
	(void)state;
	enum { W = 5, H = 3 };
	u8 picture[W * H * 3];
	ts_contact contact;
	for (size_t i = 0; i < sizeof picture; i++) picture[i] = (u8)(40 + 3 * i);
	assert_int_equal(ts_contact_begin(&contact, 3, 2, W, H), TS_OK);
	assert_int_equal(contact.width, 3 * (W + 4) + 4);
	assert_int_equal(contact.height, 2 * (H + 4) + 4);
	ts_contact_put(&contact, 2, 1, picture, W, H);
	u64 n_dark = 0;
	for (size_t i = 0; i < (size_t)contact.width * contact.height * 3; i++) n_dark += contact.rgb[i] == 32;
	assert_int_equal(n_dark, (u64)contact.width * contact.height * 3 - sizeof picture);
	for (u32 y = 0; y < H; y++) assert_memory_equal(cell(&contact, 2, 1, 0, y), picture + (size_t)y * W * 3, W * 3);
	ts_contact_free(&contact);
}

/* A wide picture: the mean of each pixel's block, whatever the sizes; a narrow one is repeated. */
static void wide_pictures_become_means_of_blocks(void **state)
{
	(void)state;
	enum { W = 1000, H = 777 };
	u8 *picture = malloc((size_t)W * H * 3);
	ts_contact contact;
	assert_int_equal(ts_contact_begin(&contact, 1, 1, W, H), TS_OK);
	assert_int_equal(contact.cell_width, 240);
	assert_int_equal(contact.cell_height, 186);
	for (size_t i = 0; i < (size_t)W * H * 3; i++) picture[i] = (u8)(i * 2654435761u >> 24);
	ts_contact_put(&contact, 0, 0, picture, W, H);
	for (u32 x = 0; x < 240; x += 13) {
		u32 y = x % 186, n = 0;
		double sum = 0;
		for (u32 j = y * H / 186; j < (y + 1) * H / 186; j++) {
			for (u32 i = x * W / 240; i < (x + 1) * W / 240; i++, n++) sum += picture[((size_t)j * W + i) * 3 + 1];
		}
		assert_true(n >= 16);
		assert_in_range(cell(&contact, 0, 0, x, y)[1], (u64)(sum / n - 0.51), (u64)(sum / n + 0.51));
	}
	const u8 one[3] = {7, 8, 9};
	ts_contact_put(&contact, 0, 0, one, 1, 1);
	assert_memory_equal(cell(&contact, 0, 0, 239, 185), one, 3);
	assert_memory_equal(cell(&contact, 0, 0, 0, 0), one, 3);
	ts_contact_free(&contact);
	free(picture);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(small_pictures_are_copied),
		cmocka_unit_test(wide_pictures_become_means_of_blocks),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
