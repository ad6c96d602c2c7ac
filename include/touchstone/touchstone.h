/* The public C API of touchstone, all of it.
 *
 * - What a function makes, its first argument behind the context receives: a handle, which the function of the same
 *   noun that ends in _free or _close releases; NULL on failure.
 * - A function that returns ts_status says by ts_error_message what failed. Where an argument that must point to
 *   something is NULL, that is such a failure.
 * - A struct that the caller fills in begins with its own size, `bytes`, so that a program that was built with an older
 *   header goes on: what it does not know is 0, and 0 is the default. A struct that the library hands out belongs to
 *   the library, and grows at its end.
 *   The metrics of image.h, which are values, stay as they are.
 * - The library prints nothing, ends nothing, and leaves the host's locale alone.
 * - A handle is used by one thread at a time, different handles by as many as there are. What a function takes by a
 *   pointer to const, a scene above all, several threads may share.
 * - After a fork only the process that had a context goes on with it: OpenMP has no threads in the other.
 *
 * Start at context.h, scene.h and trace.h; then compare.h. */
#ifndef TOUCHSTONE_TOUCHSTONE_H
#define TOUCHSTONE_TOUCHSTONE_H
#include <touchstone/compare.h>
#include <touchstone/context.h>
#include <touchstone/image.h>
#include <touchstone/params.h>
#include <touchstone/probe.h>
#include <touchstone/records.h>
#include <touchstone/scene.h>
#include <touchstone/status.h>
#include <touchstone/tables.h>
#include <touchstone/trace.h>
#include <touchstone/tree.h>
#include <touchstone/truth.h>
#include <touchstone/vectors.h>
#endif
