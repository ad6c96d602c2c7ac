#!/bin/bash
# Every golden case on Vulkan, without llvmpipe's limit of loops: the digests of C. Minutes, most of which compile kernels.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/vulkan.bash"
need_device
make_lift
MESA_SHADER_CACHE_DIR=$caches/mesa LD_PRELOAD=$lift "$touchstone" golden check --backend vulkan > "$scratch/stdout" 2>&1
grep -v '^same' "$scratch/stdout" | sed 's/^/# /'
tail -n 1 "$scratch/stdout" | grep -q "^$(grep -c '^[a-z]' reference/cases.txt) passed, 0 failed, 0 skipped"
verdict $? 'every golden case'
finish
