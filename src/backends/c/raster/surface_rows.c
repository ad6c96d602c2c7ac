/* Rows of pixels by threads: see surface_rows.h. */
#include "backends/c/raster/surface_rows.h"
#include <omp.h>
#include <stdlib.h>
#include "model/core.h"

enum { ROWS = 4 };

bool ts_see_rows(const ts_surface_rows *rows, u32 threads)
{
	i64 n = (i64)rows->n, width = (i64)rows->width;
	ts_row_worker *workers = ts_alloc(threads, sizeof *workers, "surfaces of pixels");
	if (workers == NULL) return false;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel num_threads(threads)
	{
		ts_row_worker *w = &workers[omp_get_thread_num()];
		w->user = rows->user;
		w->fragments.n = 0;
		ts_surface_bins_begin(&w->bins, rows->scene, rows->done, rows->user);
#pragma omp for schedule(dynamic, ROWS)
		for (i64 first = 0; first < n; first += width) {
			if (ts_stopped(stop)) continue;
			rows->see(w, (u64)first, (u64)(n - first < width ? n - first : width));
		}
		ts_surface_bins_flush(&w->bins);
	}
	free(workers);
	return true;
}

#include "backends/selftest.h"
