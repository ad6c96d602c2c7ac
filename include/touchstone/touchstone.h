/* SPDX-License-Identifier: Apache-2.0 */
/* The public C API of touchstone, all of it.
 *
 * - A function that makes something returns a handle in its first argument behind the context; NULL on failure. The
 *   function of the same noun that ends in _free or _close releases the handle.
 * - A function that returns ts_status says by ts_error_message what failed. NULL for an argument that must point to
 *   something is such a failure.
 * - A struct that the caller fills in begins with its own size, `bytes`. So a program that was built with an older
 *   header still runs: members that its header lacks are 0, and 0 is the default. A struct that the library hands out
 *   belongs to the library, and grows at its end. The metrics of image.h are values and never grow.
 * - The library prints nothing, ends nothing, and leaves the host's locale and floating-point environment alone; traps
 *   that the host has set hold again, on each thread, when a function returns. Where memory ends, a call fails by
 *   TS_KIND_MEMORY, and works again when memory is back.
 * - But libraries below it end the process where memory ends, or wait for ever, and nobody can keep them from that:
 *   OpenMP's, which makes a team of threads, of one too where a stage has a fast path or a scene many triangles;
 *   tinygltf, for glTF; Embree and TBB, for truths and for the places of eyes, mirrors and lamps; and OpenImageIO, for
 *   EXR and JPEG. OpenEXR fails from then on where memory ended as it began. A host that must live on leaves such work
 *   to another process.
 * - Only one thread at a time may use a handle; different threads may use different handles. Several threads may share
 *   what a function takes by a pointer to const, a scene above all.
 * - After a fork only the parent may go on with its contexts: a function fails with those in the child, which may open
 *   its own. In the thread that forked it computes alone, if that thread had others: gcc's OpenMP has lost them. A host
 *   that uses OpenMP itself before it forks calls the library from a new thread of the child.
 *
 * Start at context.h, scene.h and trace.h; then compare.h. */
#ifndef TOUCHSTONE_TOUCHSTONE_H
#define TOUCHSTONE_TOUCHSTONE_H
#include <touchstone/bench.h>
#include <touchstone/compare.h>
#include <touchstone/context.h>
#include <touchstone/explain.h>
#include <touchstone/golden.h>
#include <touchstone/html.h>
#include <touchstone/image.h>
#include <touchstone/params.h>
#include <touchstone/probe.h>
#include <touchstone/records.h>
#include <touchstone/render.h>
#include <touchstone/scene.h>
#include <touchstone/status.h>
#include <touchstone/tables.h>
#include <touchstone/trace.h>
#include <touchstone/tree.h>
#include <touchstone/truth.h>
#include <touchstone/vectors.h>
#endif
