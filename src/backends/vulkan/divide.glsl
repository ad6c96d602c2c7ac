// Quotients and roots. Vulkan lets devices compute both with errors of some ulp. Where the arithmetic vectors find that a
// device does, they are made of integers.
layout(constant_id = 2) const bool TS_BY_INTEGERS = false;
const uint TS_INFINITY = 0x7f800000u, TS_NAN = 0x7fc00000u;

// x > 0, finite, as m * 2^(exponent - 150), m from 2^23 up to 2^24.
uint ts_mantissa(uint x, out int exponent)
{
	uint m = x & 0x7fffffu;
	exponent = int(x >> 23);
	if (exponent != 0) return m | 0x800000u;
	int up = 23 - findMSB(m);
	exponent = 1 - up;
	return m << up;
}

// (q + r) * 2^(exponent - 151) to nearest, ties to even: q has 25 bits, r is below 1, and above 0 if there is more.
uint ts_rounded(uint q, bool more, int exponent)
{
	if (exponent > 254) return TS_INFINITY;
	int n = 1 + clamp(1 - exponent, 0, 25);
	uint kept = q >> n, rest = q & ((1u << n) - 1u), tie = 1u << (n - 1);
	bool up = rest > tie || (rest == tie && (more || (kept & 1u) != 0u));
	return kept + (up ? 1u : 0u) + (uint(max(exponent, 1) - 1) << 23);
}

uint ts_quotient_of(uint a, uint b)
{
	if (a > TS_INFINITY || b > TS_INFINITY || (a == b && (a == 0u || a == TS_INFINITY))) return TS_NAN;
	if (a == TS_INFINITY || b == 0u) return TS_INFINITY;
	if (a == 0u || b == TS_INFINITY) return 0u;
	int above, below;
	uint64_t m = uint64_t(ts_mantissa(a, above)) << 24;
	uint64_t by = uint64_t(ts_mantissa(b, below));
	if (m < by << 24) {
		m <<= 1;
		above--;
	}
	uint64_t q = m / by;
	return ts_rounded(uint(q), q * by != m, above - below + 127);
}

uint ts_root_of(uint x)
{
	if (x == 0u || x == TS_INFINITY) return x;
	if (x > TS_INFINITY) return TS_NAN;
	int exponent;
	uint64_t m = uint64_t(ts_mantissa(x, exponent)) << 25;
	if ((exponent & 1) == 0) {
		m <<= 1;
		exponent--;
	}
	uint64_t q = 0ul;
	for (uint64_t bit = 1ul << 24; bit != 0ul; bit >>= 1) {
		if ((q | bit) * (q | bit) <= m) q |= bit;
	}
	return ts_rounded(uint(q), q * q != m, (exponent + 127) / 2);
}

float ts_quotient(float a, float b)
{
	if (!TS_BY_INTEGERS) return a / b;
	uint above = floatBitsToUint(a), below = floatBitsToUint(b);
	uint sign = (above ^ below) & 0x80000000u;
	return uintBitsToFloat(ts_quotient_of(above & 0x7fffffffu, below & 0x7fffffffu) | sign);
}

float ts_sqrt(float x)
{
	if (!TS_BY_INTEGERS) return sqrt(x);
	uint bits = floatBitsToUint(x);
	return bits > 0x80000000u ? uintBitsToFloat(TS_NAN) : uintBitsToFloat(ts_root_of(bits & 0x7fffffffu) | (bits & 0x80000000u));
}
