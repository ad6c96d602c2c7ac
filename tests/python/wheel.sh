#!/bin/bash
# The wheel of `make wheel`: the same bytes each time, and in an environment of its own, without network, it renders and
# compares, and names what is missing. Prints TAP.
. "$(dirname "$0")/../cli/tap.bash"
case ${BUILD:-} in
*asan | *ubsan | *tsan)
	echo "1..0 # SKIP Python would have to begin with the sanitizer's library"
	exit ;;
esac
for module in cffi numpy pip venv; do
	/usr/bin/python3 -c "import $module" 2> "$scratch/stderr" || { echo "1..0 # SKIP no python3-$module" && exit; }
done
grep -q -e -Werror "${BUILD:-build/release}/flags" && export WERROR=1
unset PYTHONPATH TOUCHSTONE_LIBRARY
export PYTHONDONTWRITEBYTECODE=1

# wheel NAME COMMAND...: a wheel made by the command.
wheel() {
	local name=$1
	shift
	made=$("$@" make -s wheel | tail -n 1) && cp "$made" "$scratch/$name"
}
(umask 077 && wheel first env TZ=Asia/Tokyo) && wheel second env LC_ALL=C && cmp "$scratch/first" "$scratch/second"
verdict $? 'the same bytes each time'

wheel=$(realpath "$made") && cd "$scratch" && /usr/bin/python3 -m venv --without-pip --system-site-packages own &&
	own/bin/python -m pip install --no-index --disable-pip-version-check -q "$wheel" > said 2>&1
verdict $? 'pip installs it without network'
sed 's/^/# /' said
inside=$(echo own/lib/python3*/site-packages/touchstone)

cat > picture.py << 'END'
import touchstone
parameters = {"width": 64, "height": 36, "reflectors.count": 2, "cube.max_px": 16}
context = touchstone.Context()
scene = context.open_scene("atrium:triangles=10000:texels=32", parameters)
reference = context.run(scene, "reflections", "mvr", parameters)
port = reference.candidate()
port["image.srgb"] = ~reference["image.srgb"]
print(context.compare(reference, port, stages="image", ignore="image.radiance").first.line)
touchstone.write_png("picture.png", port["image.srgb"])
print(touchstone.read_image("picture.png").shape)
touchstone.write_exr("picture.exr", reference["image.radiance"])
print("an EXR")
END
own/bin/python picture.py > printed && [ "$(wc -l < printed)" -eq 3 ] &&
	grep -q 'buffer image.srgb, pixel (0, 0)' printed &&
	grep -qFx '(36, 64, 3)' printed
verdict $? 'a picture and a comparison'
sed 's/^/# /' printed

mv "$inside/libtouchstone-image.so" images && own/bin/python picture.py > printed 2> said
[ $? -eq 1 ] && [ "$(wc -l < printed)" -eq 2 ] && tail -n 1 said | grep -q '^touchstone.Error: .*libtouchstone-image.so'
verdict $? 'without the module of images one line says so, and the rest works'
mv images "$inside/libtouchstone-image.so"
needed=$(sed -n 's/^Requires-External: \(.*jansson.*\)/\1/p' "$inside"-*/METADATA)
sed -i "s/${needed//./\\.}/${needed/jansson/missing}/" "$inside"/libtouchstone.so.* &&
	own/bin/python picture.py > printed 2> said
[ $? -eq 1 ] && tail -n 1 said |
	grep -q \
		"^ImportError: touchstone: .*${needed/jansson/missing}: cannot open .*TOUCHSTONE_LIBRARY can name the library$"
verdict $? 'without a library of the system one line names it'
tail -n 1 said | sed 's/^/# /'
finish
