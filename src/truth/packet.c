/* Packets of rays find what each of their rays would find alone, in one traversal.
 *
 * Ties. Packets and single rays divide differently: of triangles whose distances are equal to a rounding either may be
 * the nearest. So an accepted hit ends the traversal not there but AS_FAR behind it, so that the filter sees all hits
 * as near as the nearest, and keeps the second nearest distance. Where that is within AS_FAR of the nearest the ray is
 * cast alone.
 *
 * Facing. Looking a triangle up waits for memory. The filter guesses facing by Embree's normal, notes the guess, and
 * prefetches the triangle. After the packet each guess is compared with the arithmetic of ts_k_is_facing. If all
 * guesses of a ray were right, it met the triangles that it would have met without guesses. If one was wrong, the
 * triangle is seen so nearly edge-on that Embree's rounding decides, and the ray is cast alone. */
#include <assert.h>
#include <math.h>
#include <string.h>
#include "backends/wide.h"
#include "truth/parts.h"

#define AS_FAR 0.0000152587890625f /* 2^-16: distances that differ by less count as equal */

enum { PACKET = TS_TRUTH_PACKET, MOST_GUESSES = 64 };

/* -1 or 0 for each lane. */
typedef struct {
	i32 asked[PACKET], faces[PACKET];
	const ts_truth_facet *facet;
} guess;

typedef struct {
	f32 nearest[PACKET], second[PACKET]; /* distances of accepted hits */
	i32 doubt[PACKET];                   /* -1: the ray must be cast alone */
	const ts_truth_query *queries;
	bool masks; /* some ray passes a reflector */
	u32 n_guesses;
	guess guesses[MOST_GUESSES];
} packet;

/* Stops lanes that met another primitive than the first. */
TS_WIDE(void, leave_others, (i32 *restrict valid, i32 *restrict doubt, const u32 *restrict met, u32 primitive),
        (valid, doubt, met, primitive))
{
	for (u32 i = 0; i < PACKET; i++) {
		i32 other = valid[i] & (met[i] != primitive ? -1 : 0);
		doubt[i] |= other;
		valid[i] &= ~other;
	}
}

/* The normal (b - a) x (c - a) and the ray's direction give the side of the triangle on which the ray begins. */
TS_WIDE(void, guess_facing,
        (i32 *restrict valid, guess *restrict g, const struct RTCRay16 *restrict ray,
         const struct RTCHit16 *restrict hit),
        (valid, g, ray, hit))
{
	for (u32 i = 0; i < PACKET; i++) {
		f32 slope = hit->Ng_x[i] * ray->dir_x[i] + hit->Ng_y[i] * ray->dir_y[i] + hit->Ng_z[i] * ray->dir_z[i];
		i32 faces = slope < 0.0f ? -1 : 0;
		g->asked[i] = valid[i];
		g->faces[i] = faces;
		valid[i] &= faces;
	}
}

/* Like ts_k_is_facing for a single-sided triangle. */
TS_WIDE(void, prove_facing, (i32 *restrict doubt, const guess *restrict g, const struct RTCRay16 *restrict ray),
        (doubt, g, ray))
{
	ts_v3 n = ts_load3(g->facet->normal), a = ts_load3(g->facet->corner);
	for (u32 i = 0; i < PACKET; i++) {
		ts_v3 eye = {ray->org_x[i], ray->org_y[i], ray->org_z[i]};
		i32 faces = ts_flush(ts_dot(n, ts_sub(eye, a))) > 0.0f ? -1 : 0;
		doubt[i] |= g->asked[i] & (g->faces[i] ^ faces);
	}
}

/* Accepts hits nearer than all before, and moves the ray's end to AS_FAR beyond them. */
TS_WIDE(void, accept_nearest, (i32 *restrict valid, f32 *restrict t, f32 *restrict nearest, f32 *restrict second),
        (valid, t, nearest, second))
{
	for (u32 i = 0; i < PACKET; i++) {
		f32 here = valid[i] != 0 ? t[i] : INFINITY, before = nearest[i];
		f32 farther = here > before ? here : before;
		second[i] = farther < second[i] ? farther : second[i];
		nearest[i] = here < before ? here : before;
		valid[i] = here < before ? -1 : 0;
		t[i] = here < before ? here + here * AS_FAR : t[i];
	}
}

/* Rays that need more than MOST_GUESSES are cast alone. */
static void guess_and_fetch(packet *p, i32 *valid, const ts_truth_facet *facet, const struct RTCRay16 *ray,
                            const struct RTCHit16 *hit)
{
	if (p->n_guesses == MOST_GUESSES) {
		for (u32 i = 0; i < PACKET; i++) p->doubt[i] |= valid[i];
		return;
	}
	guess *g = &p->guesses[p->n_guesses++];
	g->facet = facet;
	__builtin_prefetch(facet);
	guess_facing(valid, g, ray, hit);
}

/* Applies masked reflectors and alpha. */
static void filter_rest(const packet *p, i32 *valid, const ts_truth_part *part, u32 primitive)
{
	const ts_truth_facet *facet = &part->facet[primitive];
	u32 triangle = part->triangle[primitive];
	for (u32 i = 0; i < PACKET; i++) {
		if (valid[i] == 0) continue;
		const ts_truth_query *query = &p->queries[i];
		bool passed = query->masked != TS_NONE && facet->reflector == query->masked;
		bool masked = (facet->kind & TS_MASKED) != 0 && !query->whole;
		if (passed || (masked && ts_truth_is_cut(part->truth, query, triangle, ts_load3(facet->normal)))) valid[i] = 0;
	}
}

/* Sets valid[i] to 0 for rays that do not accept the triangle. */
static void meet(packet *p, const ts_truth_part *part, i32 *valid, struct RTCRay16 *ray, const struct RTCHit16 *hit)
{
	u32 first = 0;
	while (first < PACKET - 1 && valid[first] == 0) first++;
	u32 primitive = hit->primID[first];
	u32 kind = part->kind != TS_MIXED ? part->kind : part->facet[primitive].kind;
	__builtin_prefetch(&part->triangle[primitive]);
	leave_others(valid, p->doubt, hit->primID, primitive);
	if ((kind & TS_DOUBLE_SIDED) == 0) guess_and_fetch(p, valid, &part->facet[primitive], ray, hit);
	bool rest = (kind & TS_MASKED) != 0 || ((kind & TS_OF_REFLECTOR) != 0 && p->masks);
	if (rest) filter_rest(p, valid, part, primitive);
	accept_nearest(valid, ray->tfar, p->nearest, p->second);
}

/* Fields that `meet` reads. */
static const u32 ray_fields[] = {offsetof(struct RTCRay, dir_x), offsetof(struct RTCRay, dir_y),
                                 offsetof(struct RTCRay, dir_z), offsetof(struct RTCRay, tfar)};
static const u32 hit_fields[] = {offsetof(struct RTCHit, Ng_x), offsetof(struct RTCHit, Ng_y),
                                 offsetof(struct RTCHit, Ng_z), offsetof(struct RTCHit, primID)};

/* Lane i of a packet of n: each field has n values, in the order of the single ray's or hit's fields. */
static char *lane(void *fields, u32 offset, u32 n, u32 i) { return (char *)fields + offset * n + i * sizeof(u32); }

/* Copies the fields that `meet` reads from lane i of n to lane `to` of 16. */
static void widen(void *wide, u32 to, void *narrow, u32 n, u32 i, const u32 fields[4])
{
	for (u32 k = 0; k < 4; k++) memcpy(lane(wide, fields[k], PACKET, to), lane(narrow, fields[k], n, i), sizeof(u32));
}

/* Where Embree splits packets into narrower ones, lanes return to their places. */
static void meet_narrow(packet *p, const struct RTCFilterFunctionNArguments *a)
{
	struct RTCRay16 ray;
	struct RTCHit16 hit;
	i32 valid[PACKET] = {0};
	u32 id[PACKET], n = a->N;
	memset(&ray, 0, sizeof ray);
	memset(&hit, 0, sizeof hit);
	for (u32 i = 0; i < n; i++) {
		if (a->valid[i] == 0) continue;
		memcpy(&id[i], lane(a->ray, offsetof(struct RTCRay, id), n, i), sizeof id[i]);
		assert(id[i] < PACKET);
		widen(&ray, id[i], a->ray, n, i, ray_fields);
		widen(&hit, id[i], a->hit, n, i, hit_fields);
		valid[id[i]] = -1;
	}
	meet(p, a->geometryUserPtr, valid, &ray, &hit);
	for (u32 i = 0; i < n; i++) {
		if (a->valid[i] == 0) continue;
		a->valid[i] = valid[id[i]];
		memcpy(lane(a->ray, offsetof(struct RTCRay, tfar), n, i), &ray.tfar[id[i]], sizeof(f32));
	}
}

static void filter(const struct RTCFilterFunctionNArguments *arguments)
{
	const ts_truth_request *asked = (const ts_truth_request *)(const void *)arguments->context;
	if (arguments->N == PACKET) {
		meet(asked->packet, arguments->geometryUserPtr, arguments->valid, (void *)arguments->ray,
		     (const void *)arguments->hit);
	} else {
		meet_narrow(asked->packet, arguments);
	}
}

/* Sets ray i of a packet; one without a direction is not valid. */
static int aim(struct RTCRayHit16 *rays, u32 i, const ts_truth_query *query)
{
	rays->ray.org_x[i] = query->origin.x;
	rays->ray.org_y[i] = query->origin.y;
	rays->ray.org_z[i] = query->origin.z;
	rays->ray.tnear[i] = query->near;
	rays->ray.dir_x[i] = query->direction.x;
	rays->ray.dir_y[i] = query->direction.y;
	rays->ray.dir_z[i] = query->direction.z;
	rays->ray.time[i] = 0;
	rays->ray.tfar[i] = INFINITY;
	rays->ray.mask[i] = 0xffffffffu;
	rays->ray.id[i] = i;
	rays->ray.flags[i] = 0;
	rays->hit.geomID[i] = rays->hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
	return ts_dot(query->direction, query->direction) == 0.0f ? 0 : -1;
}

static void begin(packet *p, const ts_truth_query *queries, u32 n)
{
	p->queries = queries;
	p->masks = false;
	p->n_guesses = 0;
	for (u32 i = 0; i < PACKET; i++) p->nearest[i] = p->second[i] = INFINITY;
	for (u32 i = 0; i < PACKET; i++) p->doubt[i] = 0;
	for (u32 i = 0; i < n; i++) p->masks |= queries[i].masked != TS_NONE;
}

static bool is_tie(const packet *p, u32 i)
{
	f32 t = p->nearest[i];
	return t < INFINITY && p->second[i] <= t + t * AS_FAR;
}

static u32 triangle_of(const ts_truth *truth, u32 part, u32 primitive)
{
	if (part == RTC_INVALID_GEOMETRY_ID) return TS_NONE;
	assert(part < truth->n_parts && primitive < truth->parts[part].n);
	return truth->parts[part].triangle[primitive];
}

void ts_truth_find_all(u32 *triangle, const ts_truth *truth, const ts_truth_query *queries, u32 n)
{
	struct RTCRayHit16 rays __attribute__((aligned(64))) = {.ray = {.tnear = {0}}};
	int valid[PACKET] __attribute__((aligned(64))) = {0};
	packet p;
	ts_truth_request asked = {.queries = queries, .packet = &p};
	begin(&p, queries, n);
	for (u32 i = 0; i < n; i++) valid[i] = aim(&rays, i, &queries[i]);
	ts_tree_cast_16(&truth->tree, valid, &rays, &asked.base, filter);
	for (u32 k = 0; k < p.n_guesses; k++) prove_facing(p.doubt, &p.guesses[k], &rays.ray);
	for (u32 i = 0; i < n; i++) {
		bool alone = p.doubt[i] != 0 || is_tie(&p, i);
		triangle[i] =
			alone ? ts_truth_find(truth, &queries[i]) : triangle_of(truth, rays.hit.geomID[i], rays.hit.primID[i]);
	}
}
