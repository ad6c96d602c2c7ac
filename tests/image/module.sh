#!/bin/bash
# OpenImageIO is loaded with the first image that is no PNG: a command without its module works until then, and says
# what it lacks.
. "$(dirname "$0")/../cli/tap.bash"
cp "$touchstone" "$scratch/alone"
touchstone=$scratch/alone
small=(reflections atrium:triangles=10000:texels=32 --size 64x36 --reflectors 1)

! ldd "$touchstone" | grep -q OpenImageIO
verdict $? 'the command does not load OpenImageIO'
run render "${small[@]}" --trace --no-images -o "$scratch/trace"
verdict "$status" 'a trace without the module'
run compare "$scratch"/trace/trace-{epr,epr}
verdict "$status" 'a comparison without the module'
run render "${small[@]}" -o "$scratch/image"
[ "$status" -eq 2 ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] && [ ! -e "$scratch/image" ] &&
	grep -q 'images need a module .*the package touchstone-image: libtouchstone-image.so: cannot open' "$scratch/stderr"
verdict $? 'no image without the module'

run golden check small-epr
[ "$status" -eq 0 ] && grep -q '^same  *small-epr$' "$scratch/stdout"
verdict $? 'a golden and its preview without the module'
png=reference/goldens/small-epr/preview.png
run compare "$png" "$png" -o "$scratch/same"
[ "$status" -eq 0 ]
verdict $? 'a comparison of PNG files without the module'

case ${BUILD:-} in
*asan | *tsan)
	echo \
		"ok $((tests += 1)) - a program of the shared library # SKIP it would have to begin with the sanitizer's library"
	finish ;;
esac

# The module keeps messages of its own, whatever the program exports: here, the shared library.
cat > "$scratch/program.c" <<'END'
#include <stdio.h>
#include <touchstone/touchstone.h>
int main(int n_words, char **word)
{
	float *pixels;
	uint32_t w, h, n;
	ts_status status = ts_image_read(&pixels, &w, &h, &n, word[n_words - 1]);
	puts(ts_error_message());
	return (int)status;
}
END
library=$(dirname "$(realpath "${BUILD:-build/release}/libtouchstone.so")")
soname=$(readelf -d "$library/libtouchstone.so" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
ln -s "$library/libtouchstone.so" "$scratch/$soname"
ln -s "$library/libtouchstone-image.so" "$scratch/libtouchstone-image.so"
gcc -Iinclude "$scratch/program.c" "$library/libtouchstone.so" -Wl,-rpath,"$scratch" -o "$scratch/program" &&
	printf '\166\057\061\001' > "$scratch/cut.exr" &&
	"$scratch/program" "$scratch/cut.exr" > "$scratch/stdout" 2> "$scratch/stderr"
[ $? -eq 2 ] && grep -q '/cut.exr: ' "$scratch/stdout"
verdict $? 'a program of the shared library reads what the module says'

finish
