/* The eye of this frame. */
#include "../scene/view.h"
#include "stages.h"

ts_status ts_stage_view(ts_run *run)
{
	ts_view *view = ts_frame_make1(&run->frame, TS_B_eye_view, 1);
	if (view == NULL) return TS_ERROR;
	ts_view_eye(view, ts_run_info(run), &run->params);
	return TS_OK;
}
