#!/bin/bash
# What glTF 2.0 requires of a loader, row by row: the table of scene/gltf/spec/ and reference/GLTF.md. Prints TAP.
. "$(dirname "$0")/../cli/tap.bash"
build=${BUILD:-build/release}
case $build in
*asan | *ubsan | *tsan)
	echo "1..0 # SKIP Python would have to begin with the sanitizer's library"
	exit ;;
esac
python=/usr/bin/python3
export TOUCHSTONE_LIBRARY=$PWD/$build/libtouchstone.so PYTHONPATH=$PWD/$build/python PYTHONDONTWRITEBYTECODE=1
for module in cffi numpy; do
	$python -c "import $module" 2> "$scratch/stderr" || { echo "1..0 # SKIP no python3-$module" && exit; }
done
if [ ! -e "$TOUCHSTONE_LIBRARY" ] || [ ! -d "$PYTHONPATH" ]; then
	echo "1..0 # SKIP the package for Python is not built"
	exit
fi
$python tests/scene/gltf/spec/table.py
