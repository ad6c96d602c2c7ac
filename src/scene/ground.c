/* A ground under a model without one: shadows need a receiver. */
#include "kernels/base/vec.h"
#include "scene/sources.h"
#include "scene/view.h"

#define WIDTH 2.5f /* half a side, in half diagonals of the scene's box */

void ts_ground_add(ts_build *build, const ts_info *info)
{
	ts_space box = ts_view_box(info);
	f32 reach = ts_length(box.half) * WIDTH, floor = info->box_min[1];
	ts_material material = ts_material_default();
	ts_build_select(build, 0);
	u32 corner[4], grey = ts_build_material(build, &material);
	for (u32 k = 0; k < 4; k++) {
		ts_vertex v = {.position = {box.middle.x + (k == 0 || k == 3 ? -reach : reach), floor,
		                            box.middle.z + (k < 2 ? reach : -reach)},
		               .normal = {0.0f, 1.0f, 0.0f},
		               .colour = {0.5f, 0.5f, 0.5f, 1.0f}};
		corner[k] = ts_build_vertex(build, &v);
	}
	ts_build_triangle(build, corner[0], corner[1], corner[2], grey);
	ts_build_triangle(build, corner[0], corner[2], corner[3], grey);
}
