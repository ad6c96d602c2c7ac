/* One channel of a hull's light: the lobe between the corners, and its integral with the cosine, term by term. */
#include "methods/hulls/tools/probe.h"

/* Eqs 15 to 18. Returns A_h from the terms that were put. */
static f32 put_ours(ts_probe *p, json_t *o, f32 lambda, f32 cos_beta, u32 printed)
{
	f32 t = ts_k_sg_t(lambda), s = ts_k_sg_s(t, cos_beta), c = ts_k_sg_c(s, cos_beta);
	f32 upper = ts_k_sg_upper(lambda, printed), lower = ts_k_sg_lower(lambda, printed);
	ts_probe_put(p, o, "t", ts_probe_real(t));
	ts_probe_put(p, o, "s", ts_probe_real(s));
	ts_probe_put(p, o, "c", ts_probe_bits(c));
	ts_probe_put(p, o, "A_u", ts_probe_bits(upper));
	ts_probe_put(p, o, "A_b", ts_probe_bits(lower));
	f32 up = c * upper;
	f32 low = (1.0f - c) * lower;
	return up + low;
}

/* Eq 7. */
static f32 put_constant(ts_probe *p, json_t *o, f32 lambda, f32 cos_beta)
{
	f32 sphere = ts_k_sg_integral(lambda);
	ts_probe_put(p, o, "A", ts_probe_bits(sphere));
	return ts_max(0.0f, cos_beta) * sphere;
}

json_t *ts_probe_lobe(ts_probe *p, const ts_hull_args *args, const ts_sg *g, ts_v3 n, u32 channel)
{
	static const char *const names[] = {"red", "green", "blue"};
	json_t *o = json_object();
	f32 cos_beta = ts_clamp(ts_dot(n, g->phi), -1.0f, 1.0f);
	f32 integral = ts_k_sg_cosine(g->lambda, cos_beta, args->cosine, args->printed), terms = integral;
	ts_probe_put(p, o, "channel", json_string(names[channel]));
	ts_probe_put(p, o, "mu", ts_probe_bits(g->mu));
	ts_probe_put(p, o, "lambda", ts_probe_bits(g->lambda));
	ts_probe_put(p, o, "phi", ts_probe_v3_bits(g->phi));
	ts_probe_put(p, o, "cos_beta", ts_probe_bits(cos_beta));
	if (args->cosine == TS_COSINE_OURS) terms = put_ours(p, o, g->lambda, cos_beta, args->printed);
	if (args->cosine == TS_COSINE_CONSTANT) terms = put_constant(p, o, g->lambda, cos_beta);
	ts_probe_put(p, o, "A_h", ts_probe_bits(integral));
	ts_probe_put_sum(p, o, ts_v3_make(terms, 0.0f, 0.0f), ts_v3_make(integral, 0.0f, 0.0f));
	ts_probe_put(p, o, "irradiance", ts_probe_bits(ts_k_lobe_irradiance(args, g, n)));
	return o;
}
