/* Node transforms: glTF 2.0 section 3.5.3 (local = translation rotation scale, world = parent local), normals by the
 * inverse transpose. Elements pass ts_san after every product, so no chain of nodes leaves the contract's range. */
#include "scene/place.h"
#include "kernels/base/vec.h"
#include "scene/surfel.h"

#define ELEMENT_LIMIT 16777216.0f

static ts_v3 row(const f32 *m, int i) { return ts_load3(m + 3 * i); }
static ts_v3 column(const f32 *m, int i) { return ts_v3_make(m[i], m[3 + i], m[6 + i]); }
static ts_v3 apply(const f32 *m, ts_v3 a)
{
	return ts_v3_make(ts_dot(row(m, 0), a), ts_dot(row(m, 1), a), ts_dot(row(m, 2), a));
}

static f32 greatest(const f32 *m)
{
	f32 most = 0.0f;
	for (int i = 0; i < 9; i++) most = ts_max(most, ts_abs(m[i]));
	return most;
}

/* Prepares normals: cofactor rows are cross products of the other two rows. */
static void finish(ts_place *place)
{
	f32 *c = place->cofactor;
	for (int i = 0; i < 9; i++) place->linear[i] = ts_san(place->linear[i]);
	for (int i = 0; i < 3; i++) place->origin[i] = ts_san(place->origin[i]);
	place->side = 0.0f;
	memset(c, 0, sizeof place->cofactor);
	if (!ts_place_is_sane(place)) return;
	for (int i = 0; i < 3; i++)
		ts_store3(c + 3 * i, ts_cross(row(place->linear, (i + 1) % 3), row(place->linear, (i + 2) % 3)));
	f32 most = greatest(c);
	if (most == 0.0f) return;
	for (int i = 0; i < 9; i++) c[i] = ts_put(c[i] / most);
	f32 determinant = ts_flush(ts_dot(row(place->linear, 0), row(c, 0)));
	place->side = determinant > 0.0f ? 1.0f : determinant < 0.0f ? -1.0f : 0.0f;
}

ts_place ts_place_identity(void)
{
	ts_place place = {.linear = {1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f}};
	finish(&place);
	return place;
}

/* 1 - 2 (a a + b b) */
static f32 diagonal(f32 a, f32 b)
{
	f32 aa = a * a;
	f32 bb = b * b;
	f32 sum = aa + bb;
	f32 twice = sum * 2.0f;
	return 1.0f - twice;
}

/* 2 (a b + c d) */
static f32 mixed(f32 a, f32 b, f32 c, f32 d)
{
	f32 ab = a * b;
	f32 cd = c * d;
	f32 sum = ab + cd;
	return sum * 2.0f;
}

ts_place ts_place_from_trs(const f32 translation[3], const f32 rotation[4], const f32 scale[3])
{
	ts_place place = {.origin = {translation[0], translation[1], translation[2]}};
	f32 square = ts_dot(ts_load3(rotation), ts_load3(rotation));
	f32 ww = rotation[3] * rotation[3];
	f32 length = ts_sqrt(ts_flush(square + ww));
	f32 divisor = length > 0.0f ? length : 1.0f;
	f32 x = ts_put(rotation[0] / divisor), y = ts_put(rotation[1] / divisor);
	f32 z = ts_put(rotation[2] / divisor), w = ts_put(rotation[3] / divisor);
	f32 r[9] = {diagonal(y, z),     mixed(x, y, -z, w), mixed(x, z, y, w), mixed(x, y, z, w), diagonal(x, z),
	            mixed(y, z, -x, w), mixed(x, z, -y, w), mixed(y, z, x, w), diagonal(x, y)};
	for (int i = 0; i < 9; i++) place.linear[i] = r[i] * scale[i % 3];
	finish(&place);
	return place;
}

ts_place ts_place_from_matrix(const f32 matrix[16])
{
	ts_place place;
	for (int i = 0; i < 9; i++) place.linear[i] = matrix[4 * (i % 3) + i / 3];
	memcpy(place.origin, matrix + 12, sizeof place.origin);
	finish(&place);
	return place;
}

ts_place ts_place_compose(const ts_place *parent, const ts_place *local)
{
	ts_place place;
	for (int i = 0; i < 9; i++) place.linear[i] = ts_dot(row(parent->linear, i / 3), column(local->linear, i % 3));
	ts_store3(place.origin, ts_add(apply(parent->linear, ts_load3(local->origin)), ts_load3(parent->origin)));
	finish(&place);
	return place;
}

bool ts_place_is_sane(const ts_place *place)
{
	f32 most = greatest(place->linear);
	for (int i = 0; i < 3; i++) most = ts_max(most, ts_abs(place->origin[i]));
	return most <= ELEMENT_LIMIT;
}

static ts_v3 point(const ts_place *place, const f32 *p)
{
	return ts_add(apply(place->linear, ts_load3(p)), ts_load3(place->origin));
}

ts_vertex ts_place_vertex(const ts_place *place, const ts_vertex *vertex)
{
	ts_vertex v = *vertex;
	ts_v3 normal = ts_normalize(ts_load3(vertex->normal));
	ts_v3 tangent = ts_normalize(ts_load3(vertex->tangent));
	ts_store3(v.position, point(place, vertex->position));
	ts_store3(v.normal, ts_normalize(ts_scale(apply(place->cofactor, normal), place->side)));
	ts_store3(v.tangent, ts_normalize(apply(place->linear, tangent)));
	v.tangent[3] = place->side < 0.0f ? ts_put(-vertex->tangent[3]) : vertex->tangent[3];
	return v;
}

bool ts_place_surfel(const ts_place *place, const ts_surfel *from, ts_surfel *to)
{
	*to = *from;
	ts_store3(to->centre, point(place, from->centre));
	ts_store3(to->u, apply(place->linear, ts_load3(from->u)));
	ts_store3(to->v, apply(place->linear, ts_load3(from->v)));
	ts_surfel_straighten(to);
	if (place->side < 0.0f) ts_surfel_turn(to);
	return place->side != 0.0f;
}

ts_motion ts_place_motion(const ts_place *place)
{
	ts_motion motion = {.moves = place->side < 0.0f ? 2 : 1};
	memcpy(motion.linear, place->linear, sizeof motion.linear);
	memcpy(motion.origin, place->origin, sizeof motion.origin);
	for (int i = 0; i < 9; i++) motion.normal[i] = ts_put(place->cofactor[i] * place->side);
	return motion;
}

void ts_place_aim(const ts_place *place, f32 position[3], f32 direction[3])
{
	ts_store3(position, ts_load3(place->origin));
	ts_store3(direction, ts_neg(ts_normalize(column(place->linear, 2))));
}

bool ts_place_camera(const ts_place *place, ts_camera *camera)
{
	ts_v3 back = ts_normalize(column(place->linear, 2));
	ts_v3 right = ts_normalize(ts_cross(ts_normalize(column(place->linear, 1)), back));
	ts_v3 up = ts_cross(back, right);
	ts_store3(camera->eye, ts_load3(place->origin));
	ts_store3(camera->right, right);
	ts_store3(camera->up, up);
	ts_store3(camera->back, back);
	return ts_dot(up, up) > 0.5f;
}
