#!/bin/bash
# The build of config=tsan sees races: each atomic operation of the kernels, made plain in a copy of compat.h, is
# reported, and so is a loop that does not wait for the one before; as they are, nothing is. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export TSAN_OPTIONS=${TSAN_OPTIONS:-ignore_noninstrumented_modules=1:halt_on_error=1}
n=0

cat > "$folder/race.c" <<'C'
#include "compat.h"
enum { N = 64 };
int main(void)
{
	u64 least = N, bits = 0;
	u32 lowest = N, next = 0, seen[N];
	i64 sum = 0, turn = 0;
	u8 mark = 0;
	int first[N], second[N];
#pragma omp parallel num_threads(2)
	{
#pragma omp for schedule(static) WAIT
		for (int i = 0; i < N; i++) {
			first[i] = i;
			seen[i] = ts_peek_u32(&lowest);
			ts_min_u64(&least, (u64)(N - i));
			ts_min_u32(&lowest, (u32)(N - i));
			ts_or_u64(&bits, 1ull << i);
			ts_add_i64(&sum, i);
			ts_next_i64(&turn);
			ts_next_u32(&next);
			ts_mark_u8(&mark);
		}
#pragma omp for schedule(static)
		for (int i = 0; i < N; i++) second[i] = first[N - 1 - i];
	}
	return !(least == 1 && lowest == 1 && ~bits == 0 && sum == N * (N - 1) / 2 && turn == N && next == N && mark == 1 &&
	         second[0] == N - 1 && seen[0] > 0);
}
C

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

# plain NAME: a compat.h in which the atomic operations of that function, of one line or of several, are none.
plain() {
	local edit='s/__atomic_load_n(p, [A-Z_]*)/*p/
		s/__atomic_store_n(p, 1, [A-Z_]*)/*p = 1/
		s/__atomic_fetch_add(p, \([^,]*\), [A-Z_]*)/(*p += \1)/
		s/__atomic_fetch_or(p, \([^,]*\), [A-Z_]*)/*p |= \1/
		s/__atomic_compare_exchange_n([^)]*)/(*p = v, true)/'
	sed "/static.* $1(.*}\$/ { $edit
		}
		/static.* $1([^}]*\$/,/^}/ { $edit
		}" src/kernels/base/compat.h > "$folder/compat.h"
}

build() {
	$compile "$@" "$folder/race.c" -o "$folder/race"
}

# reported NAME FLAG...
reported() {
	local name=$1
	shift
	build "$@" && ! "$folder/race" > "$folder/out" 2>&1 && grep -q "WARNING: ThreadSanitizer: data race" "$folder/out"
	result $? "reported: $name"
}

compile=$(env -u MAKEFLAGS -u MAKELEVEL make -n V=1 JOBS=1 config=tsan BUILD=build/none \
	build/none/obj/src/model/error.c.o |
	sed -n 's/ -MMD.* -c src.*//p')
if ! echo 'int main(void) { return 0; }' | $compile -x c - -o "$folder/race" 2> /dev/null; then
	echo "1..0 # SKIP no compiler with ThreadSanitizer and OpenMP"
	exit
fi
cp src/kernels/base/compat.h "$folder"
build -DWAIT= && "$folder/race"
result $? "silent as it is"
reported "a loop that does not wait" -DWAIT=nowait
for name in ts_peek_u32 ts_min_u64 ts_min_u32 ts_or_u64 ts_add_i64 ts_next_i64 ts_next_u32 ts_mark_u8; do
	plain "$name"
	reported "$name without atomic operations" -DWAIT=
done
echo "1..$n"
