/* The composites that methods share against their formulas in double precision. */
#include "tests/vectors/composites.h"
#include "kernels/vectors/composites.h"

static judgement longest_edge(const u32 *in, const u32 *out)
{
	double length[3];
	for (u32 k = 0; k < 3; k++) length[k] = d3_distance(d3_row(in, 3 * k), d3_row(in, 3 * ((k + 1) % 3)));
	double most = fmax(fmax(length[0], length[1]), length[2]);
	u32 first = 0;
	while (length[first] < most) first++;
	bool apart = true;
	for (u32 k = 0; k < 3; k++) apart = apart && (k == first || length[k] == most || length[k] < most * (1 - 1e-6));
	bool near = is_near(ts_row_f32(out, 1), most, 3e-7 * most);
	return right_if(near && (apart ? out[0] == first : length[out[0]] >= most * (1 - 1e-6)));
}

/* As near as the closest point, and of the triangle. */
static judgement closest_on_triangle(const u32 *in, const u32 *out)
{
	double3 p = d3_row(in, 0), a = d3_row(in, 3), b = d3_row(in, 6), c = d3_row(in, 9), q = d3_row(out, 0);
	double fat = fatness(a, b, c), error = 2e-5 / fmax(fat, 0.02);
	if (fat < 0.02) return NOT_JUDGED;
	bool nearest = is_near(d3_distance(p, q), d3_distance(p, on_triangle(p, a, b, c)), error);
	return right_if(nearest && d3_distance(q, on_triangle(q, a, b, c)) <= error);
}

static judgement closest_on_border(const u32 *in, const u32 *out)
{
	double3 p = d3_row(in, 0), a = d3_row(in, 3), b = d3_row(in, 6), c = d3_row(in, 9), q = d3_row(out, 0);
	bool nearest = is_near(d3_distance(p, q), d3_distance(p, on_border(p, a, b, c)), PLACE_ERROR);
	return right_if(nearest && d3_distance(q, on_border(q, a, b, c)) <= PLACE_ERROR);
}

/* As far from all three corners. */
static judgement circumcentre(const u32 *in, const u32 *out)
{
	double3 a = d3_row(in, 0), b = d3_row(in, 3), c = d3_row(in, 6), q = d3_row(out, 0);
	if (fatness(a, b, c) == 0) return right_if(d3_distance(q, a) == 0);
	double r = d3_distance(q, a), error = PLACE_ERROR * (1 + r);
	if (fatness(a, b, c) < 0.02) return NOT_JUDGED;
	return right_if(is_near(d3_distance(q, b), r, error) && is_near(d3_distance(q, c), r, error));
}

/* In the plane, at the weights that the place has. */
static judgement hit(const u32 *in, const u32 *out)
{
	double3 o = d3_row(in, 0), d = d3_row(in, 3), a = d3_row(in, 6), b = d3_row(in, 9), c = d3_row(in, 12);
	double3 n = d3_unit(d3_row(in, 15)), at = d3_mad(o, d, ts_row_f32(out, 0));
	ts_v3 w = ts_row_v3(out, 1);
	bool shares = w.x >= 0 && w.y >= 0 && w.z >= 0 && is_near((double)w.x + w.y + w.z, 1, 2e-7);
	bool steep = fabs(d3_dot(n, d3_unit(d))) > 0.05;
	if (!shares) return WRONG;
	if (fatness(a, b, c) < 0.02 || !steep || d3_distance(at, o) > 200) return NOT_JUDGED;
	if (!is_near(d3_dot(n, d3_sub(at, a)), 0, PLACE_ERROR)) return WRONG;
	if (d3_distance(at, on_triangle(at, a, b, c)) > PLACE_ERROR) return NOT_JUDGED;
	return right_if(d3_distance(d3_blend(w, a, b, c), at) <= 50 * PLACE_ERROR);
}

static judgement footprint(const u32 *in, const u32 *out)
{
	double3 d = d3_row(in, 1), n = d3_row(in, 4);
	double lengths = d3_length(d) * d3_length(n), width = ts_row_f32(in, 0);
	double cosine = lengths > 0 ? fabs(d3_dot(d, n)) / lengths : 1;
	if (lengths > 0 && lengths < 1e-10) return NOT_JUDGED;
	return right_if(is_near(ts_row_f32(out, 0), width / sqrt(fmax(cosine, 1.0 / 64)), 2e-5 * width));
}

/* Turned about y by the ellipse's angle times its spin, or by the matrices; normals unit. */
static judgement pose(const u32 *in, const u32 *out)
{
	double3 p = d3_row(in, 38), n = d3_row(in, 41), place = p, normal = n, tangent = n;
	const u32 *linear = in + 12, *origin = in + 21, *normals = in + 24;
	if (in[37] != 0 && in[33] != 0) {
		double3 rows[3] = {d3_row(linear, 0), d3_row(linear, 3), d3_row(linear, 6)};
		double3 of[3] = {d3_row(normals, 0), d3_row(normals, 3), d3_row(normals, 6)};
		place = d3_mad((double3){d3_dot(rows[0], p), d3_dot(rows[1], p), d3_dot(rows[2], p)}, d3_row(origin, 0), 1);
		normal = (double3){d3_dot(of[0], n), d3_dot(of[1], n), d3_dot(of[2], n)};
		tangent = (double3){d3_dot(rows[0], n), d3_dot(rows[1], n), d3_dot(rows[2], n)};
		if (d3_length(normal) < 0.5 || d3_length(tangent) < 0.5) return NOT_JUDGED;
		normal = d3_unit(normal), tangent = d3_unit(tangent);
	} else if (in[3] != 0) {
		double turn = 2 * acos(-1), angle = ts_row_f32(in, 7) + in[36] % in[3] / (double)in[3];
		double spin = turn * angle * ts_row_f32(in, 11), c = cos(spin), s = sin(spin);
		double3 centre = d3_row(in, 4);
		centre.x += ts_row_f32(in, 8) * cos(turn * angle);
		centre.y += ts_row_f32(in, 10) * sin(2 * turn * angle);
		centre.z += ts_row_f32(in, 9) * sin(turn * angle);
		place = d3_mad(centre, (double3){c * p.x + s * p.z, p.y, c * p.z - s * p.x}, 1);
		normal = tangent = (double3){c * n.x + s * n.z, n.y, c * n.z - s * n.x};
	}
	bool placed = d3_distance(place, d3_row(out, 0)) < 2e-3;
	return right_if(placed && d3_distance(normal, d3_row(out, 3)) < 1e-4 &&
	                d3_distance(tangent, d3_row(out, 6)) < 1e-4);
}

/* The planes of rule 16 as functions that are not negative inside. */
static double plane(const u32 *in, u32 k, double3 p)
{
	double focal = ts_row_f32(in, 2), near = ts_row_f32(in, 3), room = 32767 - in[k < 3 ? 0 : 1] * 0.5;
	double deep = in[4] != 0 ? room : room * p.z, aside = focal * (k < 3 ? p.x : p.y);
	return k == 0 ? p.z - near : deep + (k % 2 == 1 ? aside : -aside);
}

/* How far inside the polygon of the weights a place of the triangle is. */
static double inside(const u32 *out, double3 w)
{
	double least = HUGE_VAL;
	for (u32 k = 0; k < out[0]; k++) {
		double3 from = d3_row(out, 1 + 6 * k + 3), to = d3_row(out, 1 + 6 * ((k + 1) % out[0]) + 3);
		double3 normal = d3_cross(d3_sub(to, from), d3_sub(w, from));
		least = fmin(least, normal.x + normal.y + normal.z);
	}
	return out[0] == 0 ? -HUGE_VAL : least;
}

/* Places of the triangle that lie clearly inside all planes are in the polygon, those clearly beyond one are not. */
static judgement clip(const u32 *in, const u32 *out)
{
	enum { STEPS = 8 };
	double3 corner[3] = {d3_row(in, 5), d3_row(in, 8), d3_row(in, 11)};
	u32 n_clear = 0;
	for (u32 i = 0; i <= STEPS; i++) {
		for (u32 j = 0; i + j <= STEPS; j++) {
			double3 w = {(double)i / STEPS, (double)j / STEPS, (double)(STEPS - i - j) / STEPS};
			double3 p = d3_add(d3_add(d3_scale(corner[0], w.x), d3_scale(corner[1], w.y)), d3_scale(corner[2], w.z));
			double least = HUGE_VAL, size = 0;
			for (u32 k = 0; k < 5; k++) {
				double most = 0;
				for (u32 c = 0; c < 3; c++) most = fmax(most, fabs(plane(in, k, corner[c])));
				least = fmin(least, plane(in, k, p) / (most + 1e-30));
			}
			size = inside(out, w);
			if (least > 1e-3 && size < -1e-3) return WRONG;
			if (least < -1e-3 && size > 1e-3) return WRONG;
			n_clear += fabs(least) > 1e-3;
		}
	}
	for (u32 k = 0; k < out[0]; k++) {
		ts_v3 w = ts_row_v3(out, 1 + 6 * k + 3);
		double reach = d3_length(corner[0]) + d3_length(corner[1]) + d3_length(corner[2]);
		double3 p = d3_blend(w, corner[0], corner[1], corner[2]);
		if (d3_distance(p, d3_row(out, 1 + 6 * k)) > 3e-6 * reach) return WRONG;
	}
	return n_clear > 10 ? RIGHT : NOT_JUDGED;
}

/* KHR_lights_punctual. */
static double arriving(const u32 *light, double3 p, double3 *way)
{
	double3 d = d3_sub(d3_row(light, 0), p), direction = d3_row(light, 4);
	double dd = d3_dot(d, d), range = ts_row_f32(light, 7);
	*way = light[3] == TS_LIGHT_KIND_DIRECTIONAL ? d3_scale(direction, -1) : dd > 0 ? d3_unit(d) : d;
	if (light[3] == TS_LIGHT_KIND_DIRECTIONAL) return 1;
	if (!(dd > 0)) return 0;
	double cone = -d3_dot(direction, *way) * ts_row_f32(light, 11) + ts_row_f32(light, 12);
	double spot = light[3] == TS_LIGHT_KIND_SPOT ? pow(fmin(fmax(cone, 0), 1), 2) : 1;
	double window = range > 0 ? fmin(fmax(1 - pow(dd / (range * range), 2), 0), 1) : 1;
	return window * spot / dd;
}

/* Cancellation: of a cone by its scale, of a range's end, of places near each other. */
static double arriving_error(const u32 *light, double3 p)
{
	double d = d3_distance(d3_row(light, 0), p), scale = ts_row_f32(light, 11);
	return (4e-6 + 1e-6 * scale) / (d * d);
}

static judgement light(const u32 *in, const u32 *out)
{
	double3 way, p = d3_row(in, 16);
	double arrives = arriving(in, p, &way), d = d3_distance(d3_row(in, 0), p);
	double error = in[3] == TS_LIGHT_KIND_DIRECTIONAL ? 0 : arriving_error(in, p);
	if (d > 0 && d < 0.01) return NOT_JUDGED;
	error = d == 0 ? 0 : error;
	return right_if(d3_distance(d3_row(out, 0), way) <= 3e-7 && is_near(ts_row_f32(out, 3), arrives, error));
}

/* glTF 2.0, appendix B, times n.l; and how much rounding of n.h moves it at most. */
static double3 reflected(double3 base, double metallic, double roughness, double3 n, double3 v, double3 l, double n_l,
                         double *error)
{
	double pi = acos(-1), a2 = fmax(pow(roughness, 4), 1.0 / 262144);
	double3 h = d3_length(d3_add(l, v)) > 1e-3 ? d3_unit(d3_add(l, v)) : (double3){0, 0, 0};
	double n_v = fmax(fabs(d3_dot(n, v)), 1.0 / 1024), n_h = fmin(fmax(d3_dot(n, h), 0), 1);
	double v_h = fmin(fmax(d3_dot(v, h), 0), 1), t = n_h * n_h * (a2 - 1) + 1, d = a2 / (pi * t * t);
	double g = n_l * sqrt(n_v * n_v * (1 - a2) + a2) + n_v * sqrt(n_l * n_l * (1 - a2) + a2);
	double visible = 0.5 / g, part[3], of[3] = {base.x, base.y, base.z};
	for (u32 k = 0; k < 3; k++) {
		double f0 = 0.04 * (1 - metallic) + of[k] * metallic, f = f0 + (1 - f0) * pow(1 - v_h, 5);
		part[k] = ((1 - f) * of[k] * (1 - metallic) / pi + f * d * visible) * n_l;
	}
	*error = 1e-5 * (1 + d * visible * n_l) + d * visible * n_l * (2e-6 / t);
	return (double3){part[0], part[1], part[2]};
}

static judgement brdf(const u32 *in, const u32 *out)
{
	double3 v = d3_row(in, 3), l = d3_row(in, 6), right;
	double error;
	if (d3_length(d3_add(l, v)) <= 1e-3) return NOT_JUDGED;
	right = reflected(d3_row(in, 10), ts_row_f32(in, 13), ts_row_f32(in, 14), d3_row(in, 0), v, l, ts_row_f32(in, 9),
	                  &error);
	return right_if(d3_distance(d3_row(out, 0), right) <= 2 * error);
}

static judgement shade(const u32 *in, const u32 *out)
{
	const u32 *lamp = in + 23;
	double3 n = d3_row(in, 3), v = d3_row(in, 19), base = d3_row(in, 9), way, lit = {0, 0, 0}, right;
	double facing = d3_dot(d3_row(in, 6), v), error = 0, metallic = ts_row_f32(in, 15);
	if ((in[18] & TS_UNLIT) != 0) return right_if(d3_distance(d3_row(out, 0), base) == 0);
	if ((in[18] & TS_DOUBLE_SIDED) != 0 && fabs(facing) < 1e-6) return NOT_JUDGED;
	if ((in[18] & TS_DOUBLE_SIDED) != 0 && facing < 0) n = d3_scale(n, -1);
	double arrives = arriving(lamp, d3_row(in, 0), &way), n_l = d3_dot(n, way), d;
	d = d3_distance(d3_row(lamp, 0), d3_row(in, 0));
	if (d < 0.01 || fabs(n_l) < 1e-6 || d3_length(d3_add(way, v)) <= 1e-3) return NOT_JUDGED;
	if (n_l > 0) lit = reflected(base, metallic, ts_row_f32(in, 16), n, v, way, n_l, &error);
	double3 intensity = d3_row(lamp, 8);
	double slack = lamp[3] == TS_LIGHT_KIND_DIRECTIONAL ? 0 : arriving_error(lamp, d3_row(in, 0));
	error = d3_length(intensity) * (2 * arrives * error + slack * d3_length(lit)) + 1e-6;
	right = d3_mad(d3_row(in, 12), base, (double)ts_row_f32(in, 22) * ts_row_f32(in, 17) * (1 - metallic));
	lit = (double3){lit.x * intensity.x, lit.y * intensity.y, lit.z * intensity.z};
	right = d3_mad(right, lit, arrives);
	return right_if(d3_distance(d3_row(out, 0), right) <= error + 1e-6 * d3_length(right));
}

/* Place, face and colours; of surfaces without a normal map the normal, with one its length. */
static judgement surface(const u32 *in, const u32 *out)
{
	const u32 *corner[3] = {in + 64, in + 84, in + 104}, *material = in + 28;
	ts_v3 w = ts_row_v3(in, 124);
	double3 p[3], n[3], colour[3];
	for (u32 k = 0; k < 3; k++)
		p[k] = d3_row(corner[k], 0), n[k] = d3_row(corner[k], 4), colour[k] = d3_row(corner[k], 16);
	double3 face = d3_unit(d3_cross(d3_sub(p[1], p[0]), d3_sub(p[2], p[0])));
	double3 normal = d3_blend(w, n[0], n[1], n[2]), tint = d3_blend(w, colour[0], colour[1], colour[2]);
	if (d3_distance(d3_row(out, 0), d3_blend(w, p[0], p[1], p[2])) > 2e-5) return WRONG;
	if (fatness(p[0], p[1], p[2]) > 0.02 && d3_distance(d3_row(out, 6), face) > 1e-4) return WRONG;
	if (!is_near(d3_length(d3_row(out, 3)), 1, 1e-6)) return WRONG;
	if (material[14] == TS_NONE && d3_length(normal) > 0.01 && d3_distance(d3_row(out, 3), d3_unit(normal)) > 1e-4)
		return WRONG;
	double3 base = d3_row(material, 0), right = {base.x * tint.x, base.y * tint.y, base.z * tint.z};
	if (material[12] == TS_NONE && d3_distance(d3_row(out, 9), right) > 1e-6) return WRONG;
	bool mirror = in[54] != TS_NONE;
	if (mirror && (ts_row_f32(out, 15) != 0 || ts_row_f32(out, 16) != 1)) return WRONG;
	return material[12] == TS_NONE || material[14] == TS_NONE ? RIGHT : NOT_JUDGED;
}

static judgement shadow_bias(const u32 *in, const u32 *out)
{
	double3 right = d3_row(in, 4), up = d3_row(in, 8), back = d3_row(in, 12), n = d3_row(in, 22);
	double3 way = d3_sub(d3_row(in, 0), d3_row(in, 19));
	double focal = ts_row_f32(in, 3), z = ts_row_f32(in, 25), d = fmax(d3_length(way), z);
	double across = hypot(d3_dot(right, n), d3_dot(up, n)), width = in[16] != 0 ? 1 / focal : z / focal;
	double facing = fabs(in[16] != 0 ? d3_dot(back, n) : d3_dot(way, n) / d), slope = across / fmax(facing, 1.0 / 64);
	double bias = width * (ts_row_f32(in, 17) + ts_row_f32(in, 18) * (in[16] != 0 ? slope : slope * z / d));
	double error = 1e-4 * bias + 1e-4 * width * ts_row_f32(in, 18);
	return right_if(is_near(ts_row_f32(out, 0), bias, error));
}

/* Axes at right angles, the longest edge along u; distances in the lattice are those in space, s times. */
static judgement align(const u32 *in, const u32 *out)
{
	double3 a = d3_row(in, 0), b = d3_row(in, 4), c = d3_row(in, 8), u = d3_row(out, 4), v = d3_row(out, 8);
	double3 corner[3] = {a, b, c}, middle = d3_scale(d3_add(d3_add(a, b), c), 1.0 / 3);
	double s = ts_row_f32(in, 12);
	if (ts_row_f32(out, 3) != ts_row_f32(in, 12) || d3_distance(d3_row(out, 0), middle) > 2e-5) return WRONG;
	if (fatness(a, b, c) < 0.02) return NOT_JUDGED;
	if (!is_near(d3_dot(u, v), 0, 1e-4) || !is_near(d3_length(u), 1, 1e-6) || !is_near(d3_length(v), 1, 1e-6))
		return WRONG;
	for (u32 k = 0; k < 3; k++) {
		double x = ts_row_i32(out, 12 + 2 * k) / 256.0, y = ts_row_i32(out, 13 + 2 * k) / 256.0;
		double far = fmin(hypot(x - 0.5, y - 0.5), 32000);
		if (far < 32000 && !is_near(far, s * d3_distance(corner[k], middle), 1.0 / 256 + 1e-4 * far + 2e-5 * s))
			return WRONG;
	}
	return RIGHT;
}

/* Areas of what the sample parts the triangle into, negative ones left out. */
static judgement lattice_weights(const u32 *in, const u32 *out)
{
	double x = ts_row_i32(in, 6) + 0.5, y = ts_row_i32(in, 7) + 0.5, at[3][2], area[3], sum = 0, size = 0;
	for (u32 k = 0; k < 3; k++) {
		at[k][0] = ts_row_f32(in, 2 * k) - x;
		at[k][1] = ts_row_f32(in, 2 * k + 1) - y;
		size = fmax(size, hypot(at[k][0], at[k][1]));
	}
	for (u32 k = 0; k < 3; k++) {
		double *b = at[(k + 1) % 3], *c = at[(k + 2) % 3];
		area[k] = fmax(b[0] * c[1] - b[1] * c[0], 0);
		sum += area[k];
	}
	if (sum > 0 && sum < 1e-4 * size * size) return NOT_JUDGED;
	for (u32 k = 0; k < 3; k++) {
		double right = sum > 0 ? area[k] / sum : 1.0 / 3, error = sum > 0 ? 2e-6 * size * size / sum : 1e-7;
		if (!is_near(ts_row_f32(out, k), right, error)) return WRONG;
	}
	return RIGHT;
}

/* On the lattice; with snap no farther from there than the piece is, and on it. */
static judgement sample_centre(const u32 *in, const u32 *out)
{
	const u32 *frame = in + 12;
	double3 a = d3_row(in, 0), b = d3_row(in, 4), c = d3_row(in, 8), q = d3_row(out, 0);
	double s = ts_row_f32(frame, 3), x = ts_row_i32(in, 33) / s, y = ts_row_i32(in, 34) / s;
	double3 p = d3_mad(d3_mad(d3_row(frame, 0), d3_row(frame, 4), x), d3_row(frame, 8), y);
	double error = PLACE_ERROR + 2e-6 * d3_length(p), r = d3_distance(on_triangle(p, a, b, c), p);
	if (in[32] == 0) return right_if(d3_distance(q, p) <= error);
	if (fatness(a, b, c) < 0.02) return NOT_JUDGED;
	return right_if(d3_distance(q, p) <= r + 4 * error && d3_distance(q, on_triangle(q, a, b, c)) <= 4 * error);
}

static void composites_match_double_precision(void **state)
{
	(void)state;
	static const composite composites[] = {TS_LIST_composites(COMPOSITE)};
	judge_all(composites, TS_N_composites);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(composites_match_double_precision)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
