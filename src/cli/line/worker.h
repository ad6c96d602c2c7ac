/* A child process, the worker, does the work of a command. Whatever ends the worker, the command ends properly: with
 * the worker's exit code; by the signal that somebody sent; or, if a library or the machine ended the worker, with exit
 * code 2 and one line. Nothing half-written is left. */
#ifndef TS_CLI_LINE_WORKER_H
#define TS_CLI_LINE_WORKER_H
#include "model/core.h"

/* The steps of a work, in memory of ts_worker_memory. A worker that is lost on a step is followed by one that goes on:
 * it finds `n`, and `why` of the step behind them. */
typedef struct {
	volatile uint32_t n;   /* steps that are done */
	volatile bool at_work; /* on the next */
	volatile double began; /* that step, or when the last one was done */
	char why[192];         /* why a worker was lost on the next step, and after how many seconds; "": none was */
	double lost_s;
} ts_steps;

/* Zeros that this process and its workers share; NULL on failure. */
void *ts_worker_memory(size_t bytes);

/* Runs work(user) in a worker of at most `mib` of address space and `seconds`, with steps of so many for each (0: no
 * limit), and returns its exit code. steps: of the work; NULL: it has none. Where there can be no second process, the
 * work is done by this one. */
int ts_worker_run(int (*work)(void *user), void *user, ts_steps *steps, uint32_t seconds, uint32_t mib);

#endif
