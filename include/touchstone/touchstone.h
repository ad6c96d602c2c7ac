/* The public C API of touchstone, all of it. */
#ifndef TOUCHSTONE_TOUCHSTONE_H
#define TOUCHSTONE_TOUCHSTONE_H
#include <touchstone/image.h>
#include <touchstone/params.h>
#include <touchstone/render.h>
#include <touchstone/scene.h>
#include <touchstone/status.h>
#endif
