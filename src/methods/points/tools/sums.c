/* Memory and work of methods by points beside MVR's, as the paper counts them; and which pixels are mirrors'. */
#include "kernels/base/records.h"
#include "methods/points/tools/tools.h"
#include "methods/raster/raster.h"

enum { NOMINAL_POINT = 80, NOMINAL_CUBE = 6 * 512 * 512 * 8, NOMINAL_TEXELS = 6 * 512 * 512, SAMPLES = 25 };

static u64 bytes_points(const ts_measure *m) { return m->bytes[TS_B_points_key] + m->bytes[TS_B_points_record]; }
static u64 bytes_points_nominal(const ts_measure *m) { return m->elements[TS_B_points_record] * NOMINAL_POINT; }
static u64 bytes_cubes(const ts_measure *m)
{
	return 8 * (m->elements[TS_B_splat_depth_index] + m->elements[TS_B_splat_depth_colour] +
	            m->elements[TS_B_cube_face_depth_triangle]);
}
static u64 bytes_cubes_nominal(const ts_measure *m)
{
	return bytes_cubes(m) > 0 ? (u64)m->n_in_sight * NOMINAL_CUBE : 0;
}

const ts_bytes_rule ts_points_bytes[] = {
	{"points, 40 B each", bytes_points},
	{"points, nominal 80 B each", bytes_points_nominal},
	{"depth and index of all cubes", bytes_cubes},
	{"cubes, nominal 12.58 MB each (512 x 512)", bytes_cubes_nominal},
	{0},
};

/* The paper's measure of work: shading operations of MVR divided by those of EPR, counted and predicted. */
static void put_shading(ts_table *table, const ts_measured_frame *of)
{
	const ts_measure *epr = ts_sums_find(of, TS_B_lookup_point), *mvr = ts_sums_find(of, TS_B_cube_face_depth_triangle);
	const ts_measure *any = epr != NULL ? epr : &of->measures[0];
	ts_table_text(table, "reflective pixels in sight");
	ts_table_count(table, (i64)of->n_reflective);
	ts_table_text(table, "mirrors in sight");
	ts_table_count(table, any->n_in_sight);
	ts_table_text(table, "texels a side of their cubes, mean");
	ts_table_real(table, any->mean_diameter, 1);
	if (epr != NULL && mvr != NULL && ts_measure_shading(epr) > 0) {
		ts_table_text(table, "shading operations, MVR / EPR");
		ts_table_real(table, (double)ts_measure_shading(mvr) / (double)ts_measure_shading(epr), 2);
	}
	if (of->n_reflective > 0) {
		double texels = (double)NOMINAL_TEXELS * of->scene->info.n_reflectors;
		double looked = (double)SAMPLES * (double)of->n_reflective * ts_eye_samples(of->params);
		ts_table_text(table, "6 * 512^2 * mirrors / (25 * reflective pixels * eye.samples)");
		ts_table_real(table, texels / looked, 2);
	}
}

const ts_figures_rule ts_points_figures[] = {
	{"shading", "Shading", put_shading},
	{0},
};

static ts_status mark_mirrors(ts_picture *picture, const ts_run *run)
{
	if (!run->frame.buffer[TS_B_mirror_pixel_record].made) return TS_OK;
	const ts_pixel *pixels = ts_frame_data(&run->frame, TS_B_mirror_pixel_record);
	u64 n = (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height);
	picture->reflective = ts_alloc_zero(n, 1, "the reflective pixels");
	if (picture->reflective == NULL) return TS_ERROR;
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_mirror_pixel_record); i++) {
		u8 *mark = &picture->reflective[pixels[i].index % n];
		picture->n_reflective += *mark == 0;
		*mark = 1;
	}
	return TS_OK;
}

const ts_picture_mark ts_points_marks[] = {mark_mirrors, NULL};
