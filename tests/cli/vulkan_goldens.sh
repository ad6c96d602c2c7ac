#!/bin/bash
# Every golden case on Vulkan: the digests of C; where llvmpipe's limit of loops ends one, with one line, and without
# the limit. Minutes, most of which compile kernels.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/vulkan.bash"
need_device vulkan
make_lift
n=$(grep -c '^[a-z]' reference/goldens/cases.txt)
"$touchstone" golden check --backend vulkan > "$scratch/all" 2> "$scratch/stderr"
grep -v '^same' "$scratch/all" | sed 's/^/# /'
mapfile -t cut < <(sed -nE 's/^unusable +([^ ]+) .* the driver ended a loop of .*/\1/p' "$scratch/all")
[ "$(grep -c '^same ' "$scratch/all")" -eq $((n - ${#cut[@]})) ] && [ "$n" -gt 0 ]
verdict $? "$((n - ${#cut[@]})) of $n golden cases, within the limit of loops"
listed=$(sed -n '/Cut are/,/llvmpipe.c/p' reference/DEVICES.md | grep -o '`[a-z]*-[a-z-]*`' | tr -d '`' | sort)
[ "$listed" = "$(printf '%s\n' "${cut[@]}" | sort)" ]
verdict $? 'and DEVICES lists the others'
for case in "${cut[@]}"; do
	lifted golden check "$case" --backend vulkan
	grep -q '^1 passed, 0 failed' "$scratch/stdout"
	verdict $? "$case, which exceeds the limit, without it"
done
finish
