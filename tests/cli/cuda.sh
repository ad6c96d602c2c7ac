#!/bin/bash
# The CUDA backend from the command line: its PTX, run instruction by instruction, gives the bits of C; and so does a
# GPU, if there is one. What it refuses, how it ends where there is no device, and where the driver fails.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/device.bash"
stand_in_cuda
small=(dining:triangles=10000:texels=32 --size 48x32 --reflectors 2 --set reflectors.px=16 --set cube.max_px=16)
on=(--backend cuda)

without_device() { CUDA_VISIBLE_DEVICES= run "$@"; }

ends_without_device cuda 'no CUDA device; NVIDIA'
TS_CUDA_OLD=1 run digest "${on[@]}"
ends 2 'PTX as C has compute capability 6.0; the kernels need 7.0' 'a device before Volta is refused'
refuses 'device 7: there are 1 devices, from 0' digest "${on[@]}" --device 7
refuses 'work group of 1025: .* at most 1024 items at once' digest "${on[@]}" --work-group 1025

same_digests 'the digests of C, by PTX run as C' run "${small[@]}" --method epr,mvr
with_gpu() { LD_LIBRARY_PATH=$without_driver run "$@"; }
if LD_LIBRARY_PATH=$without_driver "$touchstone" list backends | grep -q '^cuda '; then
	same_digests 'the digests of C, by a GPU' with_gpu "${small[@]}" --method epr,mvr
elif [[ ${TS_REQUIRE:-} == *cuda* ]]; then
	verdict 1 'a GPU of NVIDIA, which TS_REQUIRE asks for'
else
	tests=$((tests + 1))
	echo "ok $tests - the digests of C, by a GPU # SKIP none here"
fi

same_traces run
grep -q '"flags": "group=64"' "$scratch/canonical/trace-epr/trace.json"
verdict $? 'and how it is run'

# Kernels of a folder: what was compiled otherwise, the vectors see.
mkdir "$scratch/ptx"
refuses 'ptx/vectors.ptx: No such file' digest "${on[@]}" --build "$scratch/ptx"
if command -v clang > /dev/null; then
	scripts/ptx "$scratch/fused.ptx" -ffp-contract=fast &&
		scripts/cuda-program "$scratch/ptx" "$scratch/fused.ptx" > /dev/null
	refuses 'breaks the numeric contract' digest "${on[@]}" --build "$scratch/ptx"
	rm "$scratch"/ptx/*
fi
cp "${touchstone%/*}"/gen/ptx/{vectors,points_vectors,hulls_vectors}.ptx "$scratch/ptx"
refuses 'stage pose: build: .*pose.ptx: No such file' digest "${on[@]}" --build "$scratch/ptx"
echo 'void' > "$scratch/ptx/vectors.ptx"
run digest "${on[@]}" --build "$scratch/ptx"
[ "$status" -eq 2 ] && grep -q 'ptxas: this is not' "$scratch/stderr" && tail -n 1 "$scratch/stderr" |
	grep -q 'cuda: vectors: '
verdict $? 'what the compiler of the driver says is shown'

# Each call of the driver that may fail, the first few times, and kernels: one line, nothing left,
# and no bits that are wrong.
fails() { # CALL RESULT TIMES
	local bad=0 n=0 last=1
	while [ "$last" -ne 0 ] && [ "$n" -lt "$3" ]; do
		n=$((n + 1))
		TS_CUDA_FAIL=$1:$n:$2 run digest "${small[@]}" --method epr,mvr "${on[@]}"
		last=$status
		if [ "$status" -eq 0 ]; then
			cmp -s "$scratch/stdout" "$scratch/expected" || bad=1
		else
			[ "$status" -eq 2 ] && [ "$(grep -c 'backend cuda' "$scratch/stderr")" -eq 1 ] &&
				[ "$(wc -l < "$scratch/stderr")" -eq 1 ] || bad=1
		fi
		[ "$bad" -eq 0 ] || { sed "s/^/# $1 $n: /" "$scratch/stderr"; break; }
	done
	verdict "$bad" "$1 fails, $n times tried"
}
for call in cuInit cuDeviceGetCount cuDeviceGet cuDevicePrimaryCtxRetain cuModuleLoadDataEx cuModuleGetFunction; do
	fails "$call" 2 4
done
for call in cuCtxSetCurrent cuMemAlloc_v2 cuMemcpyHtoD_v2 cuMemcpyDtoH_v2 cuMemsetD8_v2 cuLaunchKernel \
	cuCtxSynchronize; do
	fails "$call" 2 9
done
fails kernel 700 9

finish
