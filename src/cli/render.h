/* `render`: series, files and reports. */
#ifndef TS_CLI_RENDER_H
#define TS_CLI_RENDER_H
#include "cli/line/cli.h"
#include "study/render.h"

/* Sets the exposure so that 95 % of the pixels that see a surface in frame 0, by the first method, are at most 0.8
 * of the brightest that is displayed (exposure.c). */
ts_status ts_exposure_choose(ts_job *job);
/* Renders a series: of the job's frames, of the combinations of its sweep, or of both. */
ts_status ts_render_series(ts_cli *cli);
/* The factor of brightness of pictures of differences: 8, for indirect light 4, as in SSAGH's figure 8. */
int ts_render_difference_scale(const ts_render *render);
/* Writes all pictures by ts_folder_file. */
ts_status ts_render_write(ts_render *render);
/* Reports the tables, and the figures in them. */
void ts_render_report_head(const ts_render *render, ts_report *report);
void ts_render_report_body(const ts_render *render, ts_report *report);
/* The rows of the table of pictures for one frame. */
void ts_render_report_pictures(const ts_render *render, ts_table *table);
/* The page of --report. The check refuses it if there are no pictures, or it is in the folder that a later --force
 * replaces; the write makes it from the folder that was written. */
ts_status ts_render_page_check(const ts_job *job);
ts_status ts_render_page(const ts_cli *cli);
/* Prints a line if the picture shows none of the mirrors or is nearly black, with options to try. */
void ts_render_advise(const ts_render *render);

#endif
