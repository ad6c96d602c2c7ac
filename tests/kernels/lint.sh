#!/bin/bash
# The kernels keep to the numeric contract, and the lint sees what does not. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

scripts/lint-kernels | sed 's/^/# /'
result "${PIPESTATUS[0]}" "src/kernels is clean"

# Plants, each a text of its own: numbered files, which one lint reads.
reasons=() texts=()
# sees REASON TEXT: of the other kernels, only those that call any are read, as the parser is slow.
sees() {
	local base=compat
	[[ ${2//ts_bad/} != *ts_* ]] || base=vec
	printf '%s\n' "#include \"$PWD/src/kernels/base/$base.h\" /* 0.1 and fma() may stand in a comment */" "$2" \
		> "$folder/${#texts[@]}.h"
	reasons+=("$1") texts+=("$2")
}

# A function of f32 a, b, c whose body that is.
sees_in() { sees "$1" "TS_FN f32 ts_bad(f32 a, f32 b, f32 c) { $2 }"; }
# The same of shared results and what they are made of.
sees_stored() { sees "$1" "TS_FN void ts_bad(TS_GLOBAL f32 *out, TS_GLOBAL i32 *n, f32 a) { $2 }"; }

sees_in "not exact" "return a * 0.1f;"
sees_in "not a float" "return a * 0.5;"
sees_in "not a float" "return 1e3;"
sees_in "not a float" "return 0.5L;"
sees_in "out of range" "return 1e39f;"
sees_in "hexadecimal" "return 0x1p3f;"
sees_in "fmaf() is not in the contract" "return fmaf(a, b, c);"
sees_in "fmaf() is not in the contract" "return (fmaf)(a, b, c);"
sees "fmaf() is not in the contract" "#define TS_BAD fmaf
TS_FN f32 ts_bad(f32 a, f32 b, f32 c) { return TS_BAD(a, b, c); }"
sees_in "__builtin_fmaf() is not in the contract" "return __builtin_fmaf(a, b, c);"
sees_in "mad() is not in the contract" "return mad(a, b, c);"
sees_in "dot() is not in the contract" "return dot(a, b);"
sees_in "sqrtf() is not in the contract" "return sqrtf(a);"
for function in tanh tanhf ldexp ldexpf log1p expm1f fdim rsqrt native_exp __builtin_ia32_rcpss __fmaf_rn; do
	sees_in "$function() is not in the contract" "return $function(a, 2);"
done
sees_in "double" "return (f32)((double)a * b);"
sees_in "double" "double d = a; return d;"
sees_in "not in the language" "_Float64 d = a; return d;"
sees_in "float. is no type" "float d = a; return d;"
sees_in "unsigned int. is no type" "unsigned int d = 1u; return (f32)d;"
sees_in "not in the language" "float3 d; return a;"
sees_in "not in the language" "__m128 d; return a;"
sees "no type" "typedef union { f32 f; u32 u; } ts_bad;"
sees_in "needs a proved range" "return (f32)(i32)a;"
sees_in "needs a proved range" "return (f32)(u64)(a * b);"
sees_in "f32 becomes i32" "i32 n = a; return (f32)n;"
sees_in "i32 becomes f32" "i32 n = ts_f2i(a); return n;"
sees_in "literal as a float" "return a * 2;"
sees_in "literal as a float" "f32 d = 2; return d;"
sees_in "literal as a float" "return ts_max(a, 0);"
sees_in "no remainder in GLSL" "i32 n = ts_f2i(a); return (f32)(n % 7);"
sees_in "no remainder in GLSL" "i64 n = 9; n %= 7; return (f32)n;"
sees "no integer is a pointer: write NULL" "TS_FN void ts_bad(TS_GLOBAL f32 *a) { TS_GLOBAL f32 *b = 0; b[0] = a[0]; }"
sees "no integer is a pointer: write NULL" "TS_FN bool ts_bad(TS_GLOBAL f32 *a) { a = 0u; return a == NULL; }"
sees_in "literal as a float" "ts_v3 d = {a, 2, b}; return d.x;"
sees_in "literal as a float" "f32 d[2][2] = {{a, b}, {2, c}}; return d[1][0];"
sees "literal as a float" "TS_CONSTANT f32 ts_bad[2] = {1.0f, 2};"
sees "needs a proved range" "TS_CONSTANT i32 ts_bad = (i32)1.5f;"
sees "fmaf() is not in the contract" "TS_CONSTANT f32 ts_bad = fmaf(1.0f, 2.0f, 3.0f);"
sees_in "u64 becomes u32" "u64 n = 1UL; u32 m = n; return (f32)m;"
sees_in "u32 + f32" "u32 n = 1u; return n + a;"
sees_in "no operation of floats" "return a % b;"
sees_in "+= of a float" "a += b; return a;"
sees_in "no operation of floats" "a++; return a;"
sees_in "a signed number is shifted" "i32 n = -1; return (f32)(n << 3);"
sees_in "no variable of a function is static" "static f32 d = 0.0f; return d;"
sees "outside functions" "static f32 ts_bad[2];"
sees_in "no function calls itself" "return ts_bad(a, b, c);"
sees_in "no pointer is to a function" "f32 (*f)(f32, f32) = ts_max; return a;"
sees_in "no string" "return a + \"b\"[0];"
sees_in "not declared" "return a * errno;"
sees_in "no goto" "if (a > b) goto end; end: return a;"
sees_in "a pointer is not cast" "return *(f32 *)&a + *(f32 *)(u32 *)&b;"
sees "pragma" "TS_FN f32 ts_bad(f32 a) {
#pragma STDC FP_CONTRACT ON
return a; }"
sees "the compiler.s" "_Pragma(\"STDC FP_CONTRACT ON\")"
sees "not in the language" "__attribute__((optimize(\"fast-math\"))) static f32 ts_bad(f32 a) { return a; }"
sees_in "not in the language" "__asm__(\"fsin\" : \"+t\"(a)); return a;"
sees_in "no Compound" "f32 d = ({ a * b; }); return d;"
sees "language or machine" "#ifdef __OPENCL_C_VERSION__
#endif"
sees "language or machine" "#if defined(__SSE2__)
#endif"
sees "language or machine" "#ifdef __SSE2__
TS_FN f32 ts_bad(f32 a) { return a * 0.5f; }
#endif"
sees "language or machine" "#if TS_PARTS > 1 && __GNUC__
#endif"
sees_in "one of f32 and i32\|one of i32 and f32" "i32 k = 1; return a > b ? k : a;"
sees_in "one of i32 and f32" "return a > b ? 1 : a;"
sees_in "f32 += \|i32 + f32" "i32 k = 1; k += a; return (f32)k;"
sees_in "a signed number is shifted" "i32 k = 1; k <<= 3; return (f32)k;"
sees_in "i64 becomes i32" "i64 l = 1; i32 k = 1; k += l; return (f32)k;"
sees_in "no truth value" "if (a) return b; return c;"
sees_in "no truth value" "return !a || b > c ? b : c;"
sees_in "takes 2 arguments" "return ts_max(a);"
sees_in "not in the language" "return *(1 + &a);"
sees_in "no pointer and no array" "return a[2];"
sees_in "braces" "f32 d = {a}; return d;"
sees_in "no NamedInitializer" "ts_v3 d = {.x = a}; return d.x;"
sees_in "known before" "f32 d[(i32)a]; return d[0];"
sees_in "no sizeof" "return (f32)sizeof(a);"
sees_in "a pointer is not cast" "return (f32)(u64)&a;"
sees_in "pointer to f32 becomes" "u32 *d = &a; return (f32)*d;"
sees_in "no pointer is to void" "void *d = &a; return b;"
sees_in "the compiler.s" "return __STDC_VERSION__ > 201112 ? a : b;"
sees "without its body" "f32 sinf(f32 x);
TS_FN f32 ts_bad(f32 a) { return sinf(a); }"
sees "without its body" "TS_FN f32 ts_b(f32 x);
TS_FN f32 ts_a(f32 x) { return ts_b(x); }
TS_FN f32 ts_b(f32 x) { return ts_a(x); }"
sees "only headers of kernels" "#include <math.h>"
sees "is the language.s" "#undef TS_GLOBAL"
sees "is the language.s" "#define ts_sqrt(x) (x)"
sees "another file" "#line 1 \"other.h\""
sees "not exact" "#define TS_L(x, y) x##y
TS_FN f32 ts_bad(f32 a) { return a * TS_L(.,1f); }"
sees_stored "one memory" "f32 *p = out; *p = a;"
sees_stored "one memory" "TS_GLOBAL f32 *p = &a; *out = *p;"
sees_stored "no such qualifier" "volatile f32 b = a; *out = b;"
sees "TS_GLOBAL stands before" "TS_FN void ts_bad(TS_GLOBAL f32 *out, TS_GLOBAL f32 a) { *out = a; }"
sees "stored whole\|passed ts_put" "typedef struct { f32 x; } ts_r;
TS_FN void ts_bad(TS_GLOBAL ts_r *out, f32 a) { ts_r r; r.x = a; *out = r; }"
sees "stored whole" "typedef struct { f32 x; } ts_r;
TS_FN void ts_bad(TS_GLOBAL ts_r *out, f32 a) { ts_r r = {a}; *out = r; }"
sees "passed ts_put" "typedef f32 ts_row[3];
TS_FN void ts_bad(TS_GLOBAL ts_row *out, f32 a) { out[0][1] = a; }"
sees_stored "has not passed ts_put" "*out = a;"
sees_stored "has not passed ts_put" "out[3] = ts_max(a, 0.0f);"
sees_stored "has not passed ts_put" "*out = *out + a;"
sees_stored "has not passed ts_put" "f32 b = ts_put(a); b = b * a; *out = b;"
sees_stored "has not passed ts_put" "f32 b = a > 0.0f ? ts_put(a) : a; *out = b;"
sees_stored "has not passed ts_put" "*out = ts_length(ts_v3_make(a, a, a));"
sees_stored "has not passed ts_put" "*out = -0.0f;"
sees_stored "has not passed ts_put" \
	"*out = 0.00000000000000000000000000000039443045261050590270586428264139311483660321755451150238513946533203125f;"
sees_stored "has not passed ts_put" "*out = ts_flush(a);"
sees_stored "bits of a float" "*n = (i32)ts_f2u(a * a);"
sees_stored "bits of a float" "u32 b = ts_f2u(a); *n = (i32)(b | 1u);"
sees "bits of a float" "TS_FN void ts_bad(TS_GLOBAL u64 *keys, f32 a) { ts_min_u64(&keys[0], (u64)ts_f2u(a) << 32); }"
sees "two effects" "TS_FN i64 ts_bad(TS_GLOBAL i64 *n) { return ts_next_i64(n) - ts_next_i64(n); }"
sees "two effects" "TS_FN i64 ts_bad_next(TS_GLOBAL i64 *n) { return ts_next_i64(n); }
TS_FN void ts_bad(TS_GLOBAL i64 *n, TS_GLOBAL i32 *out) { out[ts_bad_next(n)] = (i32)ts_bad_next(n); }"
sees "order of arrival: say above" "/* Appends. */
TS_FN void ts_bad(TS_GLOBAL i64 *n, TS_GLOBAL i32 *out) { out[ts_next_i64(n)] = 7; }"
sees "order of arrival: say above" \
	"TS_FN void ts_bad(TS_GLOBAL u32 *n, TS_GLOBAL i32 *out) { (void)ts_next_u32(n); u32 k = ts_next_u32(n + 1); out[k] = 7; }"
sees "pad of ts_r is not set" "typedef struct { f32 x[3]; u32 k, pad; } ts_r;
TS_FN void ts_bad(TS_GLOBAL ts_r *out, ts_v3 a) { ts_store3(out->x, a); out->k = 7u; }"
sees "pad1 of ts_r is not set" "typedef struct { u32 k, pad0, pad1; } ts_r;
TS_FN void ts_bad(TS_GLOBAL ts_r *out) { out[3].k = 7u; out[3].pad0 = 0u; }"
sees_in "u64 becomes f32" "u64 n = 1UL; return (f32)n;"
sees_stored "cut towards 0" "*n = *n / 2;"
sees_stored "cut towards 0" "i64 b = 3; *n = (i32)(b / 2);"
sees "a product of 32 bits is an index" \
	"TS_FN f32 ts_bad(TS_GLOBAL const f32 *in, u32 w, u32 y) { return in[(u64)(w * y)]; }"
sees_stored "f32 becomes i32" "*n = a;"
sees_in "d may be read before it is set" "f32 d; if (a > b) d = c; return d;"
sees_in "d may be read before it is set" "f32 d; if (a > b) d = c; else if (b > c) d = a; return d;"
sees_in "d may be read before it is set" "f32 d; d = d + a; return d;"
sees_in "d may be read before it is set" "f32 d; bool e = a > b && (d = c) > 0.0f; return e ? a : d;"
sees_in "d may be read before it is set" "f32 d; for (u32 i = 0u; i < ts_f2u(a); i++) d = b; return d;"
sees_in "d may be read before it is set" "f32 d; while (a > b) { if (b > c) break; d = a; a = a - b; } return d;"
sees_in "d may be read before it is set" \
	"f32 d; switch (ts_f2u(a)) { case 0u: d = a; break; case 1u: d = b; break; } return d;"
sees_in "d may be read before it is set" "f32 d; switch (ts_f2u(a)) { case 0u: d = a; default: break; } return d;"
sees_in "d may be read before it is set" "f32 d; f32 *e = a > b ? &c : &a; return ts_max(*e, d);"
sees_in "d may be read before it is set" "f32 d[2]; return d[ts_f2u(a)];"
sees_in "d.z may be read before it is set" "ts_v3 d; d.x = a; d.y = b; return ts_length(d);"
sees_in "d.y may be read before it is set" "ts_v3 d; d.x = a; if (a > b) d = ts_v3_make(a, b, c); return d.x + d.y;"
sees_stored "out is computed from itself" "*out = ts_put(*out + a);"
sees_stored "out is computed from itself" "f32 b = out[3]; b = b * a; out[3] = ts_put(b);"
sees_stored "out is computed from itself" "ts_store3(out, ts_add(ts_load3(out), ts_v3_make(a, a, a)));"
sees_stored "out is computed from itself" \
	"TS_GLOBAL f32 *b = out + 2; *b = a > 0.0f ? ts_put(ts_max(a, out[2] - a)) : 0.0f;"
sees "a->sum is computed from itself" "typedef struct { TS_GLOBAL f32 *sum; } ts_bad_args;
TS_FN void ts_bad(const ts_bad_args *a, u32 i, f32 b) {
	TS_GLOBAL f32 *c = &a->sum[i];
	a->sum[i] = ts_put(ts_mad(ts_v3_make(*c, b, b), ts_v3_make(b, b, b), b).x); }"
many=$(printf 'a = a * %s;\n' b c b c b c b c b c b)
sees_in "ts_bad() has 12 statements, and no title in it" "$many
return a;"
sees_in '"Of" begins no title' "
	/* Of the two the first. */
	return a;"
sees "0.3333333432674407958984375f is TS_THIRD" "TS_FN f32 ts_bad(ts_v3 a) {
	return ts_dot(a, a) * 0.3333333432674407958984375f; }"

cat > "$folder/good.h" << END
#include "$PWD/src/kernels/base/vec.h"
TS_CONSTANT f32 ts_table[2] = {0.25f, 3.0f};
enum { TS_N = 2 };
TS_FN f32 ts_good(TS_GLOBAL f32 *out, TS_GLOBAL const f32 *in, f32 a, u32 n)
{
	/* Store what may be stored (CONTRACT rule 12). */
	f32 b = a > 0.5f ? ts_put(a * 1e3f) : 0.0f;
	for (u32 i = 0u; i < n; i++) b = ts_min(b, in[i]);
	out[n] = b;
	out[n + 1u] = n > 7u ? -2.0f : (f32)(n << 3);
	out[n + 2u] = ts_put(ts_dot(ts_v3_make(a, a, a), ts_v3_make(b, b, b)) / 16777216.0f);
	out[n + 3u] = ts_table[n & 1u];
	out[(u64)n * (u64)n] = in[2u * n / 3u];
	f32 lesser = out[n + 4u];
	out[n + 4u] = ts_put(ts_min(lesser, b));
	(void)in;
	ts_v3 set;
	if (a > b) {
		set = ts_v3_make(a, b, a);
	} else {
		set.x = a;
		set.y = b;
		set.z = b;
	}
	f32 row[3], last;
	for (u32 k = 0u; k < 3u; k++) row[k] = last = a;
	switch (n) {
	case 0u: set.x = last; break;
	default: return row[2] + set.z;
	}
	return set.x;
}
typedef struct { u32 k, l, pad; } ts_record;
/* In the order of arrival, which a sort ends. */
TS_FN void ts_appended(TS_GLOBAL ts_record *out, TS_GLOBAL u32 *n)
{
	(void)ts_next_u32(n);
	out[ts_next_u32(n + 1)].k = 7u;
}
END
scripts/lint-kernels "$folder/good.h"
result $? "the lint lets pass what is allowed"

mapfile -t files < <(printf "$folder/%s.h\n" "${!texts[@]}")
scripts/lint-kernels --each "${files[@]}" "$folder/good.h" > "$folder/out"
[ $? -eq 1 ] && ! grep -q "good.h" "$folder/out"
result $? "and finds each fault in its own text"
declare -A said
while IFS= read -r line; do
	[[ $line =~ /([0-9]+)\.h:[2-9]: ]] && said[${BASH_REMATCH[1]}]+=$line$'\n'
done < "$folder/out"
for i in "${!texts[@]}"; do
	grep -q ": .*${reasons[i]}" <<< "${said[$i]-}"
	result $? "the lint sees: ${texts[i]//$'\n'/ }"
done
echo "1..$n"
