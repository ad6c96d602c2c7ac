#!/bin/bash
# A screen of help is a set of tables that fit 80 columns: every option stands in one group, no text is a paragraph, and
# what the examples type is accepted.
. "$(dirname "$0")/tap.bash"

prints '^  render ' help
prints '--truth' help render
prints '--truth' render --help
prints 'see: list backends' help render

commands=$("$touchstone" help | sed -n 's/^  \([a-z][a-z]*\) .*/\1/p')
[ "$("$touchstone" help | sed -n '/^Commands:/,/^$/p' | wc -l)" -eq $(($(wc -w <<< "$commands") + 2)) ]
verdict $? 'help has one line a command'

# judged COMMAND: its screen is what is said above.
judged() {
	python3 - "$1" "$scratch/stdout" <<'PY'
import re, sys
command, path = sys.argv[1:]
text = open(path).read()
head, *parts = text.rstrip("\n").split("\n\n")
assert re.fullmatch(rf"touchstone {command} .*\[OPTION\]\.\.\.\n  \S.*", head), head
assert all(len(line) <= 80 and line == line.rstrip() for line in text.splitlines()), "80 columns, no blanks at an end"
titles = [part.split(":")[0] for part in parts]
assert titles[0] == "Arguments", titles
assert [title for title in titles if title != "Environment"][-2:] == ["Exit codes", "Examples"], titles
assert titles.count("Options") == 1, titles

def check(cell, row):
	assert 0 < len(cell) <= 3, f"{len(cell)} lines: {row}"

options, group = [], None
for part in parts:
	first, *lines = part.splitlines()
	rows = []
	for line in lines:
		if re.match(r"(?: ?|  )\S", line):
			rows.append([line])
		else:
			rows[-1].append(line)
	for row in rows:
		if first.startswith("Options:") and not row[0].startswith("  "):
			group = row[0]
			continue
		if not first.startswith("Options:"):
			check(row, row)
			continue
		assert group, row
		what = [line[first.index("what"):] for line in row]
		check(what, row)
		assert all(what), row
		options.append(re.match(r"  --([\w-]+)", row[0])[1])
assert len(options) == len(set(options)) > 3, sorted(options)
PY
}
for command in $commands; do
	run help "$command"
	[ "$status" -eq 0 ] && judged "$command"
	verdict $? "a table of at most 80 columns: help $command"
	grep '^  --' "$scratch/stdout" | sed 's/^  --\([a-z-]*\).*/\1/' >> "$scratch/taken"
	n=0
	while read -r line; do
		n=$((n + 1))
		eval "run ${line#touchstone } --help"
		[ "$status" -eq 0 ]
		verdict $? "an example is accepted: $line"
	done < <(sed -n '/^Examples:/,$s/^  \(touchstone .*\)/\1/p' "$scratch/stdout")
	[ "$n" -gt 0 ]
	verdict $? "help $command has examples"
done

# The commands take every option, and no other.
sed -n 's/^OPTION([A-Z_]*, [A-Z]*, "\([a-z-]*\)".*/\1/p' src/cli/line/options.def | sort > "$scratch/options"
[ -s "$scratch/options" ] && sort -u "$scratch/taken" | diff "$scratch/options" -
verdict $? 'every option is taken by a command'
sed -n 's/^HELP("\([a-z]*\)".*/\1/p' src/cli/line/help.def | sort -u | diff <(sort <<< "$commands"$'\ntouchstone') -
verdict $? 'every row of help.def is of a command, or of all'
for variable in $(grep -rhoE 'getenv\("\w+"' src --include='*.c' | cut -d'"' -f2 | sort -u); do
	for command in '' $commands; do "$touchstone" help $command; done | grep -q "^  $variable  "
	verdict $? "help names the variable $variable"
done
[ "$("$touchstone" help | sed -n '/^Environment:/,$p' | awk '{print length}' | sort -n | tail -n 1)" -le 80 ]
verdict $? 'help fits 80 columns'

# What `help render` says of effects and scenes is all of them.
names() {
	"$touchstone" list "$1" --json | python3 -c 'import json, sys
print(*{row[sys.argv[2]] for row in json.load(sys.stdin)[sys.argv[1]]})' "$1" "$2"
}
run help render
for name in $(names methods effect) $(names scenes name); do
	sed '/^Options:/,$d' "$scratch/stdout" | grep -qw -- "$name"
	verdict $? "help render says what $name is"
done

# default OPTION VALUE: what `help render` has in that column.
default() {
	[ "$(sed -n "s/^  --$1  *[^ ]*  *\([^ ]*\) .*/\1/p" "$scratch/stdout")" = "$2" ]
	verdict $? "the default of --$1 is $2"
}
# of PARAMETER: its default.
of() { "$touchstone" list params | sed -n "s/^$1  *\([^ ]*\) .*/\1/p"; }
default size "$(of width)x$(of height)"
default frame "$(of frame)"
default exposure "$(of image.exposure)"
default fov "$(of eye.fov)"
default reflectors "$(of reflectors.count)"
default from-mesh "$(of surfels.from_mesh)"

run list ''
lists=$(sed 's/.*there are //; s/,//g; s/ and / /' "$scratch/stderr")
run help list
for what in $lists; do
	sed -n '/^  WHAT/,/^$/p' "$scratch/stdout" | grep -qw "$what"
	verdict $? "help names the list $what"
done
finish
