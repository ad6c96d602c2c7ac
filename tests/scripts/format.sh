#!/bin/bash
# The sources are as clang-format writes them; scripts/format-check sees one that is not, and --write changes it.
# Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

# writes NAME BEFORE AFTER: a source so becomes that, and is then as it should be.
writes() {
	printf '%b\n' "$2" > "$folder/a.c"
	printf '%b\n' "$3" > "$folder/b.c"
	scripts/format-check "$folder/a.c" > "$folder/out"
	[ $? -eq 1 ] && grep -q "a.c: .* become" "$folder/out" && scripts/format-check --write "$folder/a.c" &&
		cmp -s "$folder/a.c" "$folder/b.c" && scripts/format-check "$folder/a.c" > "$folder/out"
	result $? "$1"
}

# keeps NAME SOURCE
keeps() {
	printf '%b\n' "$2" > "$folder/a.c"
	scripts/format-check "$folder/a.c" > "$folder/out"
	result $? "kept: $1"
}

printf 'int a;\n' > "$folder/a.c"
if said=$(scripts/format-check "$folder/a.c"); [ $? -eq 77 ]; then
	echo "1..0 # skip $said"
	exit
fi
writes 'blanks become tabs' 'int f(void)\n{\n    return 1;\n}\nint g;' 'int f(void) { return 1; }\nint g;'
writes 'braces' 'int f(int a) {\n\tif (a)\n\t{\n\t\ta++;\n\t\ta *= 2;\n\t}\n\treturn a;\n}' \
	'int f(int a)\n{\n\tif (a) {\n\t\ta++;\n\t\ta *= 2;\n\t}\n\treturn a;\n}'
writes 'initialisers' 'int a[] = { 1, 2 };' 'int a[] = {1, 2};'
keeps 'comments' '/* A list of deviations:\n * - one;\n * - two,\n *   which goes on. */\nint a;'
keeps 'a table whose last row has a comma' 'static const int rows[][2] = {\n\t{1, 2},\n\t{3, 4},\n\t{0},\n};'
keeps 'what is marked' '/* clang-format off */\nint  a  =  1;\n/* clang-format on */'
keeps 'loops and conditions on a line' 'void f(int n)\n{\n\tfor (int i = 0; i < n; i++) g(i);\n\tif (n > 1) g(n);\n}'
scripts/format-check --write "$folder/none.c" 2> "$folder/out"
[ $? -ne 0 ]
result $? "a file that is not there is an error"
if git rev-parse --git-dir > /dev/null 2>&1; then
	scripts/format-check | sed 's/^/# /'
	result "${PIPESTATUS[0]}" "the sources are as clang-format writes them"
fi
echo "1..$n"
