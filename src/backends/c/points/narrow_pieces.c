/* Narrow pieces: their edges as lines, row after row. */
#include "backends/c/points/narrow_pieces.h"
#include "backends/wide.h"

enum { PIECES = TS_NARROW_PIECES, NARROW = TS_NARROW };

/* Corners, and edges: inside where `at` is 0 or more, its value at the first sample of a row, and its steps to the
 * right and down. */
typedef struct {
	i32 q[6][PIECES];
	i32 at[3][PIECES], right[3][PIECES], down[3][PIECES];
	i32 across[PIECES], last[PIECES]; /* x1 - x0, y1 - y0 */
} edges;

static inline i32 least(i32 a, i32 b, i32 c) { return ts_min_i32(ts_min_i32(a, b), c); }
static inline i32 most(i32 a, i32 b, i32 c) { return ts_max_i32(ts_max_i32(a, b), c); }
static inline i32 size_of(i32 x) { return x < 0 ? -x : x; }

/* For a piece that is not narrow these may be anything. */
static inline i32 times(i32 a, i32 b) { return (i32)((u32)a * (u32)b); }
static inline i32 plus(i32 a, i32 b) { return (i32)((u32)a + (u32)b); }
static inline i32 minus(i32 a, i32 b) { return (i32)((u32)a - (u32)b); }

/* ts_k_lattice_cover, and ts_k_square_meets at the first sample of the box. */
TS_WIDE(void, find_borders, (edges *restrict e, ts_narrow_pieces *restrict to, i32 half_size), (e, to, half_size))
{
	for (u32 i = 0; i < PIECES; i++) {
		i32 x[] = {e->q[0][i], e->q[2][i], e->q[4][i]}, y[] = {e->q[1][i], e->q[3][i], e->q[5][i]};
		i32 x0 = (least(x[0], x[1], x[2]) - half_size + TS_SUB_FIRST) >> 8,
			y0 = (least(y[0], y[1], y[2]) - half_size + TS_SUB_FIRST) >> 8;
		i32 x1 = (most(x[0], x[1], x[2]) + half_size - TS_SUB_CENTRE) >> 8,
			y1 = (most(y[0], y[1], y[2]) + half_size - TS_SUB_CENTRE) >> 8;
		i32 turned = minus(times(x[1] - x[0], y[2] - y[0]), times(y[1] - y[0], x[2] - x[0])) >> 31;
		for (u32 k = 0; k < 3; k++) {
			u32 next = k == 2 ? 0 : k + 1;
			i32 dx = ((x[next] - x[k]) ^ turned) - turned, dy = ((y[next] - y[k]) ^ turned) - turned;
			i32 meets = times(dx, y0 * TS_SUB_PIXELS + TS_SUB_CENTRE - y[k]),
				reach = times(half_size, size_of(dx) + size_of(dy));
			e->at[k][i] = plus(minus(meets, times(dy, x0 * TS_SUB_PIXELS + TS_SUB_CENTRE - x[k])), reach);
			e->right[k][i] = times(-TS_SUB_PIXELS, dy);
			e->down[k][i] = times(TS_SUB_PIXELS, dx);
		}
		e->across[i] = x1 - x0;
		e->last[i] = y1 - y0;
		to->narrow[i] = (x1 - x0 < NARROW ? 1u : 0u) & (y1 - y0 < NARROW ? 1u : 0u);
		to->x0[i] = x0;
		to->y0[i] = y0;
		to->n[i] = 0;
	}
}

/* Also moves the edges down a row. */
TS_WIDE(void, find_row, (u32 *restrict row, u32 *restrict n, edges *restrict e, i32 y), (row, n, e, y))
{
	for (u32 i = 0; i < PIECES; i++) {
		i32 a = e->at[0][i], b = e->at[1][i], c = e->at[2][i];
		u32 bits = 0, count = 0;
		for (i32 x = 0; x < NARROW; x++) {
			u32 in = ~(u32)(a | b | c | minus(e->across[i], x) | minus(e->last[i], y)) >> 31;
			bits |= in << x;
			count += in;
			a = plus(a, e->right[0][i]);
			b = plus(b, e->right[1][i]);
			c = plus(c, e->right[2][i]);
		}
		row[i] = bits;
		n[i] += count;
		for (u32 k = 0; k < 3; k++) e->at[k][i] = plus(e->at[k][i], e->down[k][i]);
	}
}

void ts_narrow_find(ts_narrow_pieces *to, const ts_align *frames, u32 n, i32 half_size)
{
	edges e;
	for (u32 k = 0; k < 6; k++) {
		for (u32 i = 0; i < PIECES; i++) e.q[k][i] = i < n ? frames[i].q[k] : 0;
	}
	find_borders(&e, to, half_size);
	to->n_rows = 0;
	for (u32 i = 0; i < n; i++) {
		u32 rows = to->narrow[i] != 0 ? (u32)(e.last[i] + 1) : 0;
		if (rows > to->n_rows) to->n_rows = rows;
	}
	for (u32 y = 0; y < to->n_rows; y++) find_row(to->rows[y], to->n, &e, (i32)y);
}

#include "backends/selftest.h"
