/* Text from files, on its way out as JSON. For a terminal there is ts_line_clean. */
#ifndef TS_SCENE_PRINT_H
#define TS_SCENE_PRINT_H
#include <jansson.h>
#ifdef __cplusplus
extern "C" {
#endif

/* A JSON string of any bytes: as they are if they are UTF-8, else those above 127 as \xHH. NULL when out of memory. */
json_t *ts_text_json(const char *text);

#ifdef __cplusplus
}
#endif
#endif
