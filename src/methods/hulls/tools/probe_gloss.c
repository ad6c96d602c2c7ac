/* A pixel's specular reflection: its surface, and the product of the light's lobes with the surface's, term by term. */
#include "methods/hulls/gloss.h"
#include "methods/hulls/tools/probe.h"

ts_status ts_probe_put_gloss(ts_probe *p, const ts_probe_seen *at, const ts_gpixel *pixel, json_t *o, ts_glossy *glossy)
{
	bool there;
	ts_gloss gloss, held;
	json_t *lobe = json_object();
	const ts_params *params = &p->trace->params;
	ts_k_gloss(&gloss, &p->scene, &at->view, at->key, (i32)at->x, (i32)at->y);
	*glossy = ts_k_glossy(pixel, &gloss, at->view.eye, TS_PARAM(params, hull_cosine),
	                      TS_PARAM(params, hull_integrals) == TS_INTEGRALS_PRINTED);
	ts_probe_put(p, o, "f0", ts_probe_v3_bits(glossy->f0));
	ts_probe_put(p, o, "alpha_squared", ts_probe_bits(gloss.alpha_squared));
	ts_probe_put(p, lobe, "mu", ts_probe_bits(glossy->lobe.mu));
	ts_probe_put(p, lobe, "lambda", ts_probe_bits(glossy->lobe.lambda));
	ts_probe_put(p, lobe, "phi", ts_probe_v3_bits(glossy->lobe.phi));
	ts_probe_put(p, o, "lobe", lobe);
	ts_status status = ts_probe_fetch_pixel(p, TS_B_gloss_pixel, at->x, at->row, 1, &held, &there);
	if (status == TS_OK && there) ts_probe_put_record_check(p, o, TS_B_gloss_pixel, &gloss, &held);
	return status;
}

ts_v3 ts_probe_put_reflected(ts_probe *p, json_t *o, const ts_glossy *glossy, const ts_sg *light)
{
	ts_sg both = ts_k_sg_product(light, &glossy->lobe);
	f32 cos_beta = ts_dot(glossy->n, both.phi);
	ts_v3 sent = ts_k_gloss_reflected(glossy, &both);
	ts_probe_put(p, o, "mu", ts_probe_bits(both.mu));
	ts_probe_put(p, o, "lambda", ts_probe_bits(both.lambda));
	ts_probe_put(p, o, "phi", ts_probe_v3_bits(both.phi));
	ts_probe_put(p, o, "A_h", ts_probe_bits(ts_k_sg_cosine(both.lambda, cos_beta, glossy->cosine, glossy->printed)));
	ts_probe_put(p, o, "V_F", ts_probe_v3_bits(ts_k_gloss_factor(glossy, both.phi)));
	return sent;
}
