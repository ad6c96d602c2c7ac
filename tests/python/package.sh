#!/bin/bash
# The package for Python: its tests, and the notebook's code as a user would run it. Prints TAP.
. "$(dirname "$0")/../cli/tap.bash"
build=${BUILD:-build/release}
case $build in
*asan | *ubsan | *tsan)
	echo "1..0 # SKIP Python would have to begin with the sanitizer's library"
	exit ;;
esac
python=/usr/bin/python3
export TOUCHSTONE_LIBRARY=$PWD/$build/libtouchstone.so PYTHONPATH=$PWD/$build/python PYTHONDONTWRITEBYTECODE=1
for module in cffi numpy pytest; do
	$python -c "import $module" 2> "$scratch/stderr" || { echo "1..0 # SKIP no python3-$module" && exit; }
done

run render reflections atrium:triangles=10000:texels=32 --method epr --size 64x36 --reflectors 2 --set cube.max_px=16 \
	--trace -o "$scratch/out"
verdict "$status" 'a trace to read'
run render reflections atrium:triangles=10000:texels=32 --method epr,mvr --size 64x36 --reflectors 2 \
	--set cube.max_px=16 --compress --no-images -o "$scratch/packed"
verdict "$status" 'and one with shared and compressed files'
run render reflections atrium:triangles=10000:texels=32 --method epr --size 64x36 --reflectors 2 --set cube.max_px=16 \
	--trace --crop 10,5,20,10 -o "$scratch/crop"
verdict "$status" 'and one of a part of the picture'
export CROPPED=$scratch/crop/trace-epr
TRACED=$scratch/out/trace-epr PACKED=$scratch/packed/trace-epr $python -m pytest -q -p no:cacheprovider tests/python \
	> "$scratch/tests" 2>&1
good=$?
sed 's/^/# /' "$scratch/tests"
verdict $good 'tests of the package'

cat > "$scratch/notebook.py" << 'END'
import json, sys
for cell in json.load(open(sys.argv[1]))["cells"]:
	if cell["cell_type"] == "code":
		exec("".join(cell["source"]), globals())
END
$python "$scratch/notebook.py" tests/api/example/example.ipynb > "$scratch/notebook" &&
	grep -q "given the candidate's inputs" "$scratch/notebook"
verdict $? 'the notebook finds what it plants'
python3 - "$scratch/notebook" << 'END'
import sys
errors = [float(word) for line in open(sys.argv[1]) if line.startswith("errors ") for word in line.split()[1:]]
assert len(errors) == 3 and errors[0] > errors[-1] > 0, errors
END
verdict $? 'its sweep has less error by more points'
soname=$(readelf -d "$build/libtouchstone.so" | sed -n 's/.*soname: \[\(.*\)\]/\1/p')
ln -s "$PWD/$build/libtouchstone.so" "$scratch/$soname" && ln -s "$PWD/$build/libtouchstone-image.so" "$scratch" &&
	${CC:-gcc} -std=c11 -Iinclude tests/api/example/measure.c -L"$scratch" -l":$soname" -Wl,-rpath,"$scratch" \
		-o "$scratch/measure" && "$scratch/measure" > "$scratch/c" &&
	$python tests/api/example/measure.py > "$scratch/python" &&
	diff <(grep -v ms "$scratch/c") <(grep -v ms "$scratch/python") && [ "$(grep -c '[1-9]' "$scratch/c")" -eq 4 ]
verdict $? 'C and Python measure the same'
TOUCHSTONE_LIBRARY=/nowhere.so $python -c 'import touchstone' 2>&1 | grep -q 'TOUCHSTONE_LIBRARY can name the library'
verdict $? 'without the library one line says so'
finish
