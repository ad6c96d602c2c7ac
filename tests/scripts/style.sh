#!/bin/bash
# The text of the sources keeps to the style; and the check sees what does not. Prints TAP.
set -u
if ! git rev-parse --git-dir > /dev/null 2>&1; then
	echo "1..0 # SKIP not a git checkout"
	exit
fi
. tests/cli/tap.bash
scripts/style-check | sed 's/^/# /'
verdict "${PIPESTATUS[0]}" 'the sources'
check=$(realpath scripts/style-check)
cd "$scratch" && git init -q . && mkdir -p src/model scripts tests || exit

# sees REASON FILE LINE: the file, which standard input holds, is refused for the reason on that line.
sees() {
	cat > "$2" && git add "$2"
	"$check" > said
	[ $? -eq 1 ] && [ "$(cat said)" = "$2:$3: $1" ]
	verdict $? "the check sees: $1"
	git rm -q --cached "$2" && rm "$2"
}
text() { head -c "$1" /dev/zero | tr '\0' a; }

sees 'trailing blanks' src/model/a.c 2 < <(printf 'int a;\nint b; \n')
sees 'trailing blanks' a.md 1 < <(printf 'text \n')
sees 'carriage return' a.py 1 < <(printf 'a = 1\r\n')
sees 'no newline at the end' a.sh 2 < <(printf 'true\nfalse')
sees 'a blank before a tab' src/model/a.h 1 < <(printf '\t \tint a;\n')
sees 'unfinished marker' src/model/a.c 1 < <(printf '/* %s */\n' TO''DO)
sees "a run's parameters are read only; its plan says what follows from them" src/model/a.c 1 \
	<<< 'run->params.width = 1;'
sees "a compiler's arithmetic is that of the Makefile's flags" src/model/a.c 1 <<< '#pragma GCC optimize "fast"'
sees 'a message of the library names members, not options of the command' src/model/a.c 1 <<< 'fail("see --size");'
for name in test_equal equal images_equal test_images_equal; do
	sees 'a test is named after its claim, in three words or more' tests/a.c 1 <<< "static void $name(void **state)"
done
sees '121 columns, at most 120' a.py 1 < <(printf 'a = "%s"\n' "$(text 115)")
sees '121 columns, at most 120' scripts/a 2 < <(printf '#!/bin/bash\n\ttrue %s\n' "$(text 112)")
sees '122 columns, at most 120' Makefile 1 < <(printf 'A = %s\n' "$(text 118)")
sees 'a function of 41 lines, at most 40' src/model/a.c 2 < <(printf 'int f(void)\n{\n'; yes '	;' |
	head -n 41; echo '}')
sees '601 lines, at most 600' src/model/a.h 1 < <(yes 'int a;' | head -n 601)
sees '1001 lines, at most 1000' a.sh 1 < <(yes true | head -n 1001)
printf 'f(\n\t"%s")\n' "$(text 130)" > a.py
printf '#!/bin/bash\n# %s\nverdict \\\n\t%s \\\n\t"a %s"\n' "$(text 20)" "$(text 130)" "$(text 130)" > a.sh
printf 'ROW(%s)\n' "$(text 130)" > a.def
git add .
"$check" > said
verdict $? 'a word or a string that stands alone, and a row of a table, may be longer'
finish
