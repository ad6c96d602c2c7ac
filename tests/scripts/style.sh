#!/bin/bash
# The text of the sources keeps to the style; and tests are named after their claims. Prints TAP.
set -u
if ! git rev-parse --git-dir >/dev/null 2>&1; then
	echo "1..0 # SKIP not a git checkout"
	exit
fi
if scripts/style-check; then echo "ok 1 - style"; else echo "not ok 1 - style"; fi

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
mkdir "$out/scripts" "$out/tests"
cp scripts/style-check "$out/scripts"
git init -q "$out"

# judge NUMBER NAME LINE: what is said of the line of a test of this name.
judge() {
	printf 'static void %s(void **state)\n{\n\t(void)state;\n}\n' "$2" >"$out/tests/planted.c"
	git -C "$out" add tests
	if [ "$("$out/scripts/style-check" </dev/null)" = "$3" ]; then echo "ok $1 - $2"; else echo "not ok $1 - $2"; fi
}

short="tests/planted.c:1: a test is named after its claim, in three words or more"
judge 2 test_equal "$short"
judge 3 equal "$short"
judge 4 images_equal "$short"
judge 5 test_images_equal "$short"
judge 6 images_are_equal ""
echo "1..6"
