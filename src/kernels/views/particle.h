/* Glowing particles (MegaViews section 5.2; METHODS 12): lights without a direction, at random in the inner part of the
 * hall. Each moves on its own ellipse about the hall's middle, one turn in the frames of a turn of the eye; every
 * second particle moves the other way. Together they send the flux of an irradiance of `particle.glow` on the hall's
 * walls, floor and ceiling. */
#ifndef TS_KERNELS_VIEWS_PARTICLE_H
#define TS_KERNELS_VIEWS_PARTICLE_H
#include "kernels/base/args.h"
#include "kernels/base/records.h"
#include "kernels/base/vec.h"

#define TS_STREAM_PARTICLE 8u
#define TS_PARTICLE_REACH 0.75f /* of half the hall */
#define TS_N_GLOWS 4u

#define TS_ROWS_ts_particle_args(ARG) \
	ARG(OUT, ts_vpl, lights, vpl_light) \
	ARG(VALUE, ts_v3, middle, none) \
	ARG(VALUE, ts_v3, extent, none) /* of the hall; half of it to each side */ \
	ARG(VALUE, f32, turns, none)    /* since frame 0, in [0,1) */ \
	ARG(VALUE, f32, glow, none) \
	ARG(VALUE, u32, n, none) \
	ARG(VALUE, u32, seed, none)
TS_ARGS(ts_particle_args);

/* Colours, each as strong as white; their mean is white. */
TS_CONSTANT f32 ts_particle_glow[4][3] = {
	{1.75f, 1.0f, 0.25f},
	{0.25f, 1.0f, 1.75f},
	{1.5f, 0.25f, 1.25f},
	{0.5f, 1.75f, 0.75f},
};

/* Random number `which` of a particle. */
TS_FN u32 ts_k_particle_random(const ts_particle_args *args, u32 particle, u32 which)
{
	return ts_random(particle ^ ts_pcg(which), TS_STREAM_PARTICLE, args->seed);
}

/* The place of a particle at frame 0: uniform in an upright elliptic cylinder. */
TS_FN ts_v3 ts_k_particle_place(const ts_particle_args *args, u32 particle)
{
	f32 phase = ts_uniform(ts_k_particle_random(args, particle, 0u));
	f32 size = TS_PARTICLE_REACH * ts_sqrt(ts_uniform(ts_k_particle_random(args, particle, 1u)));
	f32 twice = 2.0f * ts_uniform(ts_k_particle_random(args, particle, 2u));
	f32 up = TS_PARTICLE_REACH * (twice - 1.0f);
	f32 angle = (particle & 1u) == 0u ? phase + args->turns : phase - args->turns;
	ts_v3 way = ts_v3_make(size * ts_cos_turn(angle), up, size * ts_sin_turn(angle));
	return ts_add(args->middle, ts_mul(args->extent, way));
}

/* The flux of a particle, in its colour: its share of the glow times the area of the hall's box. */
TS_FN ts_v3 ts_k_particle_flux(const ts_particle_args *args, u32 particle)
{
	ts_v3 h = args->extent;
	f32 xy = h.x * h.y;
	f32 yz = h.y * h.z;
	f32 zx = h.z * h.x;
	f32 area = 8.0f * ((xy + yz) + zx);
	f32 share = ts_flush(args->glow * area / (f32)args->n);
	u32 kind = ts_k_particle_random(args, particle, 3u) % TS_N_GLOWS;
	ts_v3 colour = ts_v3_make(ts_particle_glow[kind][0], ts_particle_glow[kind][1], ts_particle_glow[kind][2]);
	return ts_scale(colour, share);
}

/* map over particles */
TS_FN void ts_k_particle_item(const ts_particle_args *args, u64 i)
{
	TS_GLOBAL ts_vpl *light = &args->lights[i];
	ts_store3(light->position, ts_k_particle_place(args, (u32)i));
	ts_store3(light->normal, ts_v3_make(0.0f, 0.0f, 0.0f));
	ts_store3(light->flux, ts_k_particle_flux(args, (u32)i));
	light->bounce = 0u;
	light->pad0 = 0u;
	light->pad1 = 0u;
}

#endif
