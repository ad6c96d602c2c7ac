/* A child process, the worker, does the work of a command. Whatever ends the worker, the command ends properly: with
 * the worker's exit code; by the signal that somebody sent; or, if a library or the machine ended the worker, with exit
 * code 2 and one line. Nothing half-written is left. */
#ifndef TS_CLI_WORKER_H
#define TS_CLI_WORKER_H
#include "../model/core.h"

/* Runs work(user) in a worker of at most `seconds` and `mib` of address space (0: no limit) and returns its exit code.
 * Where there can be no second process, the work is done by this one. */
int ts_worker_run(int (*work)(void *user), void *user, uint32_t seconds, uint32_t mib);

#endif
