/* This build's description of itself. */
#include "trace/producer.h"
#include "kernels/base/compat.h"
#include "model/core.h"

json_t *ts_producer(const ts_run *run)
{
	const ts_backend *b = ts_run_backend(run);
	return json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s}", "name", "touchstone", "version", TS_VERSION, "commit",
	                 ts_commit(), "backend", b->name, "device", b->device, "compiler", b->compiler, "flags", b->flags);
}

static f32 load(u32 bits)
{
	volatile u32 v = bits;
	return ts_u2f(v);
}

static ts_measured of_this_process(void)
{
	f32 half_ulp = load(0x33800000u), one = load(0x3f800000u), least = load(0x00800000u);
	f32 up = load(0x3f800001u) + half_ulp, even = one + half_ulp;
	f32 product = load(0x3f800800u) * load(0x3f800800u);
	return (ts_measured){
		.rounds_to_nearest = ts_f2u(even) == 0x3f800000u && ts_f2u(up) == 0x3f800002u,
		.contracts = ts_f2u(product + load(0xbf801000u)) != 0u,
		.keeps_denormals = ts_f2u(least * load(0x3f000000u)) == 0x00400000u,
		.n_wrong = ts_selftest() != 0,
	};
}

json_t *ts_arithmetic(const ts_run *run)
{
	const ts_measured m = run->backend != NULL ? run->backend->arithmetic : of_this_process();
	return json_pack("{s:s, s:b, s:s, s:i}", "rounding", m.rounds_to_nearest ? "nearest even" : "other", "contraction",
	                 m.contracts, "denormals", m.keeps_denormals ? "kept" : "flushed", "selftest", (int)m.n_wrong);
}
