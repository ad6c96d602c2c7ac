#!/bin/bash
# The pages of `make docs`: all documents, headers and commands are there, every link and anchor leads somewhere, and
# none to the network; scripts/links-check sees what does not. Prints TAP.
. "$(dirname "$0")/../cli/tap.bash"

mkdir "$scratch/bin"
for tool in env python3 bash; do ln -s "$(command -v $tool)" "$scratch/bin/$tool"; done
PATH=$scratch/bin scripts/site "$scratch" "$scratch/none" > "$scratch/stdout" 2> "$scratch/stderr"
[ $? -eq 2 ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] &&
	grep -q '^site: pandoc is not installed: ' "$scratch/stderr" &&
	[ ! -e "$scratch/none" ]
verdict $? 'without pandoc one line says so, and nothing is written'
command -v pandoc > /dev/null || {
	echo "ok $((tests += 1)) - the pages # SKIP no pandoc; scripts/install-deps --matrix installs it"
	finish
}

site=$scratch/site
scripts/manual "$touchstone" "$scratch/manual" && scripts/site "$scratch/manual" "$site"
verdict $? 'the pages are written'
[ -d "$site" ] || finish
for source in README.md CONTRIBUTING.md CHANGELOG.md SECURITY.md reference/*.md reference/methods/*.md \
	include/touchstone/*.h; do
	page=${source%.*}.html
	[ -s "$site/${page/#README/index}" ] || echo "# no page of $source"
done > "$scratch/missing"
for command in $("$touchstone" help | sed -n 's/^  \([a-z][a-z]*\) .*/\1/p'); do
	[ -s "$site/manual/touchstone-$command.html" ] || echo "# no page of $command"
done >> "$scratch/missing"
cat "$scratch/missing"
[ ! -s "$scratch/missing" ]
verdict $? 'each document, header and command has a page'
scripts/links-check "$site" | sed 's/^/# /'
verdict "${PIPESTATUS[0]}" 'every link and anchor leads to something in the folder'
missing=$(grep -ohE '^TS_API .*\b(ts_\w+)\(' include/touchstone/*.h | grep -oE 'ts_\w+\($' | tr -d '(' |
	while read -r name; do
	grep -qE "<h2 id=\"[^\"]*\b$name\b" "$site"/include/touchstone/*.html || echo "$name"
done)
[ -z "$missing" ]
verdict $? "each public function has a section $missing"
for list in params stages buffers; do
	"$touchstone" list $list --json | grep -oE '^ *"name": "[^"]*"' | cut -d'"' -f4 |
		tee -a "$scratch/names" > "$scratch/some"
	[ -s "$scratch/some" ]
	verdict $? "there are $list"
done
grep -ohE '^TS_API .*\b(ts_\w+)\(' include/touchstone/*.h | grep -oE 'ts_\w+\($' | tr -d '(' >> "$scratch/names"
missing=$(while read -r name; do
	grep -qE "<a href=[^>]*#[^>]*><code>$name</code></a>" "$site/terms.html" &&
		grep -q "^\[\"$name\", " "$site/terms.js" || echo "$name"
done < "$scratch/names")
[ -z "$missing" ]
verdict $? "each parameter, stage, buffer and public function is in the index and the search $missing"
cp -r "$site" "$scratch/terms" &&
	sed -nE 's|^\["(.*)", "(.*)", "(.*)"\],$|<a href="\3">\1</a>|p' "$site/terms.js" > "$scratch/terms/terms.js.html" &&
	[ "$(grep -c . "$scratch/terms/terms.js.html")" -eq $(($(grep -c . "$site/terms.js") - 2)) ] &&
	scripts/links-check "$scratch/terms"
verdict $? 'each row of the search leads to something'
if command -v chromium chromium-browser google-chrome > "$scratch/stdout"; then
	python3 - "$site" <<'PY'
import sys
sys.path.insert(0, "tests/cli")
from browser import Browser
with Browser(1180, 820) as page:
	page.open(sys.argv[1] + "/reference/METHODS.html")
	page.run("field.focus(), document.execCommand('insertText', false, 'eye.fov')")
	page.wait("list.querySelector('a') !== null")
	page.press("ArrowDown")
	assert page.run("document.activeElement.textContent") == "eye.fov parameter"
	page.press("ArrowUp")
	page.press("Enter")
	page.wait("location.hash === '#parameter-eye.fov'")
	assert not page.faults and all(url.startswith("file:") for url in page.requests), (page.faults, page.requests)
PY
	verdict $? 'in a browser the search finds a parameter, by the keyboard alone and without a network'
else
	echo "ok $((tests += 1)) - the search in a browser # SKIP no chromium"
fi
scripts/site "$scratch/manual" "$scratch/again" && diff -r "$site" "$scratch/again" > "$scratch/stdout"
verdict $? 'two runs write the same bytes'

# sees REASON SED-SCRIPT PAGE: the check names the damage that the script does to a copy.
sees() {
	rm -rf "$scratch/copy"
	cp -r "$site" "$scratch/copy"
	sed -i "$2" "$scratch/copy/$3"
	scripts/links-check "$scratch/copy" > "$scratch/stdout"
	[ $? -eq 1 ] && [ "$(wc -l < "$scratch/stdout")" -eq 1 ] && grep -q "$3: .*$1" "$scratch/stdout"
	verdict $? "the check sees: $1"
}
sees 'there is no such anchor' 's/href="#1-conventions"/href="#nil"/' reference/METHODS.html
sees 'there is no such file' '/<main>/s/$/<a href="reference\/NIL.html">/' index.html
sees 'there is no such file' '/<main>/s/$/<img src="nil.png">/' index.html
sees 'leads out of the folder' '/<main>/s/$/<img src="https:\/\/example.org\/a.png">/' index.html
sees 'leads out of the folder' '/<main>/s/$/<a href="\/etc\/passwd">/' CHANGELOG.html
sees 'refers to something' '1s/$/ @import "a";/' style.css

# A document that refers to what does not exist ends the run, and what was there stays.
mkdir "$scratch/tree"
cp -r README.md CONTRIBUTING.md CHANGELOG.md SECURITY.md include reference scenes scripts "$scratch/tree"
echo '[nil](reference/NIL.md)' >> "$scratch/tree/README.md"
mkdir "$scratch/tree/out" && touch "$scratch/tree/out/before"
(cd "$scratch/tree" && scripts/site "$scratch/manual" out) > "$scratch/stdout" 2> "$scratch/stderr"
[ $? -eq 2 ] && [ "$(cat "$scratch/stderr")" = 'site: README.md: reference/NIL.md: there is no such file' ] &&
	[ "$(ls "$scratch/tree/out")" = before ] && [ -z "$(ls -d "$scratch/tree"/out.* 2> /dev/null)" ]
verdict $? 'a link to nothing ends the run in one line, and the pages that were there stay'
finish
