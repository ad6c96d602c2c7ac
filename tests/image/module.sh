#!/bin/bash
# OpenImageIO is loaded with the first image: a command without its module works until then, and says what it lacks.
. "$(dirname "$0")/../cli/tap.bash"
cp "$touchstone" "$scratch/alone"
touchstone=$scratch/alone
small=(reflections atrium:triangles=10000 --size 64x36 --reflectors 1)

! ldd "$touchstone" | grep -q OpenImageIO
verdict $? 'the command does not load OpenImageIO'
run render "${small[@]}" --trace --no-images -o "$scratch/trace"
verdict "$status" 'a trace without the module'
run compare "$scratch"/trace/trace-{epr,epr}
verdict "$status" 'a comparison without the module'
run render "${small[@]}" -o "$scratch/image"
[ "$status" -eq 2 ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] && [ ! -e "$scratch/image" ] &&
	grep -q 'images need a module that did not load: libtouchstone-image.so: cannot open' "$scratch/stderr"
verdict $? 'no image without the module'

finish
