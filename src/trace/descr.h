/* The dtype of a buffer's elements, for the header of its .npy file. */
#ifndef TS_TRACE_DESCR_H
#define TS_TRACE_DESCR_H
#include "model/frame.h"
#include "output/npy.h"

enum { TS_NPY_DESCR = 2048 };

/* The dtype as numpy writes it: "'<u4'" or "[('centre', '<f4', (3,)), ('piece', '<u4'), ...]". */
void ts_npy_descr(char descr[TS_NPY_DESCR], ts_buffer_id id);

#endif
