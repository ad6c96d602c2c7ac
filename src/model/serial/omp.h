/* The OpenMP functions that touchstone calls, for builds without OpenMP: one thread. */
#ifndef TS_MODEL_SERIAL_OMP_H
#define TS_MODEL_SERIAL_OMP_H

static inline int omp_get_thread_num(void) { return 0; }
static inline int omp_get_num_procs(void) { return 1; }
static inline int omp_get_num_threads(void) { return 1; }
static inline void omp_set_dynamic(int dynamic) { (void)dynamic; }

#endif
