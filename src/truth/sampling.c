/* Shares of a truth's rays, the loop over its pixels, and what is said of long work. */
#include "truth/sampling.h"
#include "kernels/base/num.h"
#include "model/core.h"

static const double soon = 0.5, lengthy = 10; /* seconds: measured before an estimate; least printed one */

ts_work ts_work_begin(const char *label, u64 rays)
{
	ts_progress(label, 0, 1);
	return (ts_work){.label = label, .rays = rays, .begin = ts_seconds()};
}

void ts_work_at(ts_work *work, u64 done, u64 all)
{
	double seconds = ts_seconds() - work->begin;
	ts_progress(work->label, done, all);
	if (work->reported || done == 0 || done >= all || seconds < soon) return;
	work->reported = true;
	double total = seconds * (double)all / (double)done;
	if (total < lengthy) return;
	if (work->rays > 0) {
		ts_say("%s: %llu rays, about %.0f s", work->label, (unsigned long long)work->rays, total);
	} else {
		ts_say("%s: about %.0f s", work->label, total);
	}
}

void ts_work_end(const ts_work *work) { ts_progress(work->label, 1, 1); }

enum { STREAM_ITEMS = 9, STREAM_PIXELS = 10 };                  /* of ts_random */
enum { CHUNK_RAYS = 1 << 18, LEAST_CHUNK = 256, CHUNK = 4096 }; /* between two reports of progress */

u64 ts_share_item(const ts_share *share, u64 j)
{
	if (share->asked == share->items) return j;
	u64 place = ts_random(share->pixel ^ ts_pcg((u32)j), STREAM_ITEMS, share->seed);
	return (j * share->items + (place * share->items >> 32)) / share->asked;
}

ts_sampling ts_sampling_of(const ts_params *params)
{
	u32 pixels = TS_PARAM(params, width) * TS_PARAM(params, height);
	return (ts_sampling){.rays = TS_PARAM(params, truth_rays), .pixels = pixels, .seed = TS_PARAM(params, seed)};
}

void ts_sampling_plan(ts_sampling *sampling, u64 pixels, u64 items, u64 each)
{
	u64 all = pixels * items * each, half = sampling->rays / 2;
	sampling->items = sampling->some = items;
	sampling->chance = TS_NONE;
	if (sampling->rays == 0 || all <= sampling->rays) return;
	u64 some = half / (pixels * each);
	sampling->some = some > 0 ? some : 1;
	sampling->chance = (u32)((half << 32) / all);
}

bool ts_sampling_is_part(const ts_sampling *sampling) { return sampling->some < sampling->items; }

bool ts_sampling_chooses(const ts_sampling *sampling, u32 pixel)
{
	return ts_random(pixel % sampling->pixels, STREAM_PIXELS, sampling->seed) < sampling->chance;
}

static u64 min(u64 a, u64 b) { return a < b ? a : b; }

static bool is_asked(const ts_truth_asked *asked, const ts_sampling *sampling, u64 i)
{
	u32 pixel = asked->pixel(asked->user, i);
	return pixel != TS_NONE && (!sampling->chosen || ts_sampling_chooses(sampling, pixel));
}

static u64 count(const ts_truth_asked *asked, const ts_sampling *sampling)
{
	u64 n = 0;
	for (u64 i = 0; i < asked->n; i++) n += is_asked(asked, sampling, i);
	return n;
}

/* Keeps those of [first, end) that are to be traced; returns their number, 0 where the work is cancelled. */
static u32 ask_group(const ts_truth_asked *asked, const ts_sampling *s, u64 first, u64 end, u64 share, ts_stop *stop)
{
	u64 place[TS_ASKED];
	ts_share shares[TS_ASKED];
	u32 n = 0;
	if (ts_stopped(stop)) return 0;
	for (u64 i = first; i < end; i++) {
		if (!is_asked(asked, s, i)) continue;
		place[n] = i;
		shares[n++] = (ts_share){s->items, share, asked->pixel(asked->user, i), s->seed};
	}
	if (asked->ask_all != NULL) {
		if (n > 0) asked->ask_all(asked->user, place, shares, n);
		return n;
	}
	for (u32 k = 0; k < n && !ts_stopped(stop); k++) asked->ask(asked->user, place[k], &shares[k]);
	return n;
}

void ts_truth_ask(const ts_truth_asked *asked, ts_sampling *sampling)
{
	ts_sampling whole = {.rays = 0}, *s = sampling != NULL ? sampling : &whole;
	if (!s->chosen) ts_sampling_plan(s, count(asked, s), asked->items, asked->each);
	u64 n = count(asked, s), share = s->chosen ? s->items : s->some, done = 0;
	u64 chunk = CHUNK_RAYS / (share * asked->each + 1);
	chunk = chunk < LEAST_CHUNK ? LEAST_CHUNK : min(chunk, CHUNK);
	ts_stop *stop = ts_stop_here();
	ts_work work = ts_work_begin(asked->label, n * share * asked->each);
	for (u64 first = 0; first < asked->n && !ts_cancelled(); first += chunk) {
		u64 end = min(first + chunk, asked->n);
#pragma omp parallel for num_threads((int)asked->threads) schedule(dynamic, 1) reduction(+ : done)
		for (u64 i = first; i < end; i += TS_ASKED) done += ask_group(asked, s, i, min(i + TS_ASKED, end), share, stop);
		ts_work_at(&work, done, n);
	}
	ts_work_end(&work);
}
