/* Surfels as user geometry of Embree. */
#include "methods/surfels/tools/discs.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include "truth/tree.h"

struct ts_discs {
	const ts_surfel *surfels;
	ts_tree tree;
};

/* A ray's request: Embree passes on the address of `base`. */
typedef struct {
	ts_tree_context base;
	const ts_disc_ray *ray;
	void (*take)(void *user, const ts_disc_met *met);
	void *user;
	ts_disc_met nearest;
	double far;
} request;

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* False if the ray misses the surfel, or meets its back. */
static bool meets(const ts_surfel *surfel, const ts_disc_ray *ray, ts_disc_met *met)
{
	double u[3], v[3], to[3];
	for (u32 k = 0; k < 3; k++) {
		u[k] = (double)surfel->u[k];
		v[k] = (double)surfel->v[k];
		to[k] = (double)surfel->centre[k] - ray->origin[k];
	}
	const double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
	double facing = dot(ray->direction, n);
	if (!(facing < 0.0)) return false;
	met->t = dot(to, n) / facing;
	for (u32 k = 0; k < 3; k++) to[k] = met->t * ray->direction[k] - to[k];
	double a = dot(to, u) / dot(u, u), b = dot(to, v) / dot(v, v);
	met->r2 = a * a + b * b;
	return met->r2 <= 1.0 && met->t >= ray->near;
}

/* Not less than x. */
static f32 above(double x) { return nextafterf((f32)x, INFINITY); }

static void keep_nearest(request *asked, const ts_disc_met *met)
{
	const ts_disc_met *old = &asked->nearest;
	if (met->t < old->t || (met->t == old->t && met->surfel < old->surfel)) asked->nearest = *met;
}

static void intersect(const struct RTCIntersectFunctionNArguments *arguments)
{
	assert(arguments->N == 1);
	const ts_discs *discs = arguments->geometryUserPtr;
	request *asked = (request *)(void *)arguments->context;
	struct RTCRayHit *found = (struct RTCRayHit *)(void *)arguments->rayhit;
	ts_disc_met met = {.surfel = arguments->primID};
	if (arguments->valid[0] == 0 || !meets(&discs->surfels[met.surfel], asked->ray, &met) || met.t > asked->far) return;
	if (asked->take != NULL) {
		asked->take(asked->user, &met);
		return;
	}
	keep_nearest(asked, &met);
	found->ray.tfar = fminf(found->ray.tfar, above(met.t));
	found->hit.geomID = arguments->geomID;
	found->hit.primID = arguments->primID;
}

/* The box of the ellipse, enlarged by 2^-22 of the coordinates for Embree's rounding. */
static void bounds(const struct RTCBoundsFunctionArguments *arguments)
{
	const ts_discs *discs = arguments->geometryUserPtr;
	const ts_surfel *s = &discs->surfels[arguments->primID];
	f32 low[3], high[3];
	for (u32 k = 0; k < 3; k++) {
		double c = (double)s->centre[k], half = hypot((double)s->u[k], (double)s->v[k]);
		double room = (fabs(c) + half) * 0x1p-22;
		low[k] = (f32)(c - half - room);
		high[k] = (f32)(c + half + room);
	}
	*arguments->bounds_o = (struct RTCBounds){.lower_x = low[0],
	                                          .lower_y = low[1],
	                                          .lower_z = low[2],
	                                          .upper_x = high[0],
	                                          .upper_y = high[1],
	                                          .upper_z = high[2]};
}

static ts_status attach(ts_discs *discs, u32 n)
{
	RTCGeometry geometry = ts_rtc.NewGeometry(discs->tree.device, RTC_GEOMETRY_TYPE_USER);
	if (geometry == NULL) return ts_tree_fail(&discs->tree, "making a geometry");
	ts_rtc.SetGeometryUserPrimitiveCount(geometry, n);
	ts_rtc.SetGeometryUserData(geometry, discs);
	ts_rtc.SetGeometryBoundsFunction(geometry, bounds, NULL);
	ts_rtc.SetGeometryIntersectFunction(geometry, intersect);
	ts_rtc.CommitGeometry(geometry);
	ts_rtc.AttachGeometry(discs->tree.scene, geometry);
	ts_rtc.ReleaseGeometry(geometry);
	return ts_tree_check(&discs->tree, "taking the surfels");
}

ts_status ts_discs_new(ts_discs **discs, const ts_surfel *surfels, u32 n, u32 threads)
{
	*discs = NULL;
	ts_discs *made = ts_alloc_zero(1, sizeof *made, "truth");
	if (made == NULL) return TS_ERROR;
	made->surfels = surfels;
	if (ts_tree_begin(&made->tree, threads) || attach(made, n) || ts_tree_build(&made->tree)) {
		ts_discs_free(made);
		return TS_ERROR;
	}
	*discs = made;
	return TS_OK;
}

void ts_discs_free(ts_discs *discs)
{
	if (discs == NULL) return;
	ts_tree_end(&discs->tree);
	free(discs);
}

/* In single precision boxes may seem nearer than they are; their contents are judged in double. */
static void cast(const ts_discs *discs, request *asked)
{
	const double *o = asked->ray->origin, *d = asked->ray->direction;
	struct RTCRayHit ray = {
		.ray = {.org_x = (f32)o[0],
	            .org_y = (f32)o[1],
	            .org_z = (f32)o[2],
	            .dir_x = (f32)d[0],
	            .dir_y = (f32)d[1],
	            .dir_z = (f32)d[2],
	            .tfar = asked->far < (double)FLT_MAX ? above(asked->far) : INFINITY,
	            .mask = 0xffffffffu},
		.hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .primID = RTC_INVALID_GEOMETRY_ID},
	};
	ts_tree_cast(&discs->tree, &ray, &asked->base);
}

ts_disc_met ts_discs_nearest(const ts_discs *discs, const ts_disc_ray *ray)
{
	request asked = {.ray = ray, .far = INFINITY, .nearest = {.surfel = TS_NONE, .t = INFINITY}};
	cast(discs, &asked);
	return asked.nearest;
}

void ts_discs_each(const ts_discs *discs, const ts_disc_ray *ray, double far,
                   void (*take)(void *user, const ts_disc_met *met), void *user)
{
	request asked = {.ray = ray, .take = take, .user = user, .far = far};
	cast(discs, &asked);
}
