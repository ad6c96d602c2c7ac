/* What a comparison says, in each of its forms. */
#ifndef TS_CLI_COMPARE_H
#define TS_CLI_COMPARE_H
#include "../compare/line.h"
#include "cli.h"
#include "../study/table.h"
#include "tell.h"

enum { TS_RELAXED_TEXT = 1100 };

/* Lines of the differences behind the first, as far as they are listed. */
void ts_compare_more(ts_report *report, ts_buffer_id id, const ts_verdict *verdict, const char *indent);

/* All relaxations, as they are typed, but control characters become '?': they are part of the verdict. "" if there are
 * none. */
void ts_compare_relaxed(char text[TS_RELAXED_TEXT], const ts_cli *cli);
/* Reads the mask of cli: 1 where the picture is not black. relaxations->mask by free(). Without --mask does nothing. */
ts_status ts_compare_mask(ts_relaxations *relaxations, const ts_cli *cli);
/* A row a buffer, the verdict, the line of the first divergence, and where stages were given the candidate's inputs all
 * that differ; as text and as JSON. */
void ts_compare_report(ts_report *report, const ts_comparison *comparison, const ts_trace *reference,
                       const ts_trace *candidate, const ts_cli *cli);
/* Part of it as text: the verdicts of the stages, if they were given the candidate's inputs. */
void ts_compare_stages(ts_report *report, const ts_comparison *comparison, const ts_trace *reference);
/* A uniquely named case a stage: it passes if all that differs is known, and fails if that differs no more. */
typedef struct ts_compare_lists ts_compare_lists;
void ts_compare_outcomes(ts_outcomes *outcomes, const ts_comparison *comparison, const ts_trace *reference,
                         const ts_compare_lists *lists);

/* Writes BUFFER.png into the folder of -o for each buffer of rows and columns that is unlike, and for each cube where a
 * buffer of texels is unlike BUFFER-cube-R.png: the faces +X, -X, +Y, -Y, +Z, -Z side by side, levels of a mip map one
 * below the other. White is what differs. Cubes are drawn only where the reference has cube_size.face. */
ts_status ts_compare_draw(const ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                          const ts_relaxations *relaxations);

#endif
