/* What kernels take as rows: they cover the structs, and launches bind what they say and nothing else. */
#include "backends/args.h"
#include "backends/kernels.h"
#include "tests/model/test.h"

static size_t bytes_of(const ts_arg *row, size_t next) { return next - row->offset; }

/* Rows stand in the order of the members, without a gap that alignment does not ask for. */
static void rows_cover_the_arguments_without_a_gap(void **state)
{
	(void)state;
	for (u32 kernel = 0; kernel < TS_N_KERNELS; kernel++) {
		const ts_arg_list *list = ts_kernel_args((ts_kernel)kernel);
		assert_true(list->n > 0 && list->rows[0].offset == 0);
		for (u32 i = 0; i < list->n; i++) {
			const ts_arg *row = &list->rows[i];
			size_t bytes = bytes_of(row, i + 1 < list->n ? list->rows[i + 1].offset : list->bytes);
			bool pointer = row->role != TS_ROLE_VALUE && row->role != TS_ROLE_INNER;
			if (pointer) assert_true(bytes == sizeof(void *));
			if (row->role == TS_ROLE_INNER) assert_true((bytes + 7) / 8 == (row->inner()->bytes + 7) / 8);
			assert_true(bytes > 0);
		}
	}
}

static void pointers_have_names_of_their_own(void **state)
{
	(void)state;
	assert_string_equal(ts_kernel_name(TS_KERNEL_splat), "splat");
	const ts_pointers *p = ts_kernel_pointers(TS_KERNEL_shadow_test_margin);
	bool inner = false;
	for (u32 i = 0; i < p->n; i++) {
		for (u32 k = i + 1; k < p->n; k++) assert_string_not_equal(p->pointer[i].name, p->pointer[k].name);
		inner |= strcmp(p->pointer[i].name, "of.scene.vertices") == 0 &&
		         p->pointer[i].offset == offsetof(ts_shadow_test_margin_args, of.scene.vertices);
	}
	assert_true(inner);
}

static ts_bound bound(const ts_launch *launch, const char *name)
{
	const ts_pointers *p = ts_kernel_pointers(launch->kernel);
	for (u32 i = 0; i < p->n; i++) {
		if (strcmp(p->pointer[i].name, name) == 0) return ts_launch_bound(launch, &p->pointer[i]);
	}
	fail_msg("no %s", name);
	return (ts_bound){false, TS_ROLE_IN, 0};
}

static void launches_bind_what_they_say(void **state)
{
	(void)state;
	static const ts_launch plain = TS_LAUNCH(splat, TS_ALL);
	static const ts_launch ties = TS_LAUNCH(splat, TS_IN(texels, splat_depth_index), TS_WITH(tie), TS_BUT(bits));
	ts_bound b = bound(&plain, "texels");
	assert_true(b.bound && b.role == TS_ROLE_MIN && b.to == TS_B_splat_depth_index);
	assert_false(bound(&plain, "tie").bound);
	assert_false(bound(&plain, "from.offset").bound);
	b = bound(&plain, "n_writes");
	assert_true(b.bound && b.role == TS_ROLE_TALLY && b.to == 1);
	b = bound(&ties, "texels");
	assert_true(b.bound && b.role == TS_ROLE_IN && b.to == TS_B_splat_depth_index);
	b = bound(&ties, "tie");
	assert_true(b.bound && b.role == TS_ROLE_SUM && b.to == TS_B_splat_tie);
	assert_false(bound(&ties, "bits").bound);
}

/* The name of a struct stands for all in it, and for nothing that only begins like it. */
static void a_structs_name_binds_all_in_it(void **state)
{
	(void)state;
	static const ts_launch half = TS_LAUNCH(lookup, TS_BUT(from.scene));
	static const ts_launch part = TS_LAUNCH(lookup, TS_BUT(from.scene.v));
	assert_false(bound(&half, "from.scene.vertices").bound);
	assert_false(bound(&half, "from.scene.objects").bound);
	assert_true(bound(&half, "cubes").bound);
	assert_true(bound(&part, "from.scene.vertices").bound);
	assert_true(ts_launch_knows(&half, "from.scene") && ts_launch_knows(&half, "from.scene.texels"));
	assert_false(ts_launch_knows(&part, "from.scene.v"));
	assert_false(ts_launch_knows(&part, "n_samples"));
}

static void arrays_of_scatters_may_be_parted(void **state)
{
	(void)state;
	assert_true(ts_may_be_parted(TS_B_splat_depth_index) && ts_may_be_parted(TS_B_points_key));
	assert_false(ts_may_be_parted(TS_B_eye_view) || ts_may_be_parted(TS_B_mirror_pixel_record));
}

int main(void)
{
	const struct CMUnitTest args[] = {
		cmocka_unit_test(rows_cover_the_arguments_without_a_gap),
		cmocka_unit_test(pointers_have_names_of_their_own),
		cmocka_unit_test(launches_bind_what_they_say),
		cmocka_unit_test(a_structs_name_binds_all_in_it),
		cmocka_unit_test(arrays_of_scatters_may_be_parted),
	};
	return cmocka_run_group_tests(args, NULL, NULL);
}
