#!/bin/bash
# Every golden case has the digests of C by the PTX, run instruction by instruction, and on Vulkan: where llvmpipe's
# limit of loops ends one, with one line, and without the limit. Minutes, most of which compile kernels.
. "$(dirname "$0")/tap.bash"
n=$(grep -c '^[a-z]' reference/goldens/cases.txt)
# check BACKEND: what golden check says, in $scratch/all; what is not the same is told.
check() {
	"$touchstone" golden check --backend "$1" > "$scratch/all" 2> "$scratch/stderr"
	grep -v '^same' "$scratch/all" | sed 's/^/# /'
}

. "$(dirname "$0")/device.bash"
stand_in_cuda
check cuda
tail -n 1 "$scratch/all" | grep -q "^$n passed, 0 failed, 0 skipped"
verdict $? 'every golden case by the PTX'

. "$(dirname "$0")/vulkan.bash"
need_device vulkan
make_lift
check vulkan
mapfile -t cut < <(sed -nE 's/^unusable +([^ ]+) .* the driver ended a loop of .*/\1/p' "$scratch/all")
[ "$(grep -c '^same ' "$scratch/all")" -eq $((n - ${#cut[@]})) ] && [ "$n" -gt 0 ]
verdict $? "$((n - ${#cut[@]})) of $n golden cases, within the limit of loops"
listed=$(sed -n '/cases that are cut are/,/llvmpipe.c/p' reference/DEVICES.md | grep -o '`[a-z]*-[a-z-]*`' |
	tr -d '`' | sort)
[ "$listed" = "$(printf '%s\n' "${cut[@]}" | sort)" ]
verdict $? 'and DEVICES lists the others'
for case in "${cut[@]}"; do
	lifted golden check "$case" --backend vulkan
	grep -q '^1 passed, 0 failed' "$scratch/stdout"
	verdict $? "$case, which exceeds the limit, without it"
done
finish
