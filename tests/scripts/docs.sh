#!/bin/bash
# The published documents name only what exists and their tables are fresh; and the check sees what is not so.
# Prints TAP.
set -u
export TOUCHSTONE=${TOUCHSTONE:-build/touchstone}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

# The command's lists, once.
for list in stages buffers sizes params methods truths vectors benches; do
	"$TOUCHSTONE" list "$list" --json > "$folder/$list.json"
done
"$TOUCHSTONE" bench list --json > "$folder/list.json"
printf '#!/bin/sh\ncat "%s/$2.json"\n' "$folder" > "$folder/lists"
chmod +x "$folder/lists"
export TOUCHSTONE=$folder/lists

scripts/docs-check | sed 's/^/# /'
result "${PIPESTATUS[0]}" "the documents"

# plant REASON FILE SED-SCRIPT [PAGE]: damages a copy of the documents; PAGE is where that is said, else FILE.
plant() {
	sed -i "$3" "$folder/$2"
	reasons+=("$1") files+=("${4:-$2}")
}
# planted: one check names each damage; then the copies are whole again.
planted() {
	local i rc
	scripts/docs-check "$folder" > "$folder/out"
	rc=$?
	for i in "${!reasons[@]}"; do
		[ $rc -eq 1 ] && grep -q "${files[i]}:[0-9]*: .*${reasons[i]}" "$folder/out"
		result $? "the check sees: ${reasons[i]} (${files[i]})"
	done
	whole
}
whole() {
	reasons=() files=()
	cp -r reference/{CONTRACT,METHODS,TABLES,FIGURES,VERDICTS,PERFORMANCE,PICTURES,RENDERING}.md reference/methods \
		reference/{trace.schema,verdicts}.json README.md CONTRIBUTING.md "$folder/"
}
whole
plant "there is no ts_k_spalt_item" methods/points.md '/^### `eye`/s/$/ `ts_k_spalt_item`/'
plant "there is no file tests/kernels/nil.c" METHODS.md 's,tests/kernels/points/cull.c,tests/kernels/nil.c,'
plant "there is no stage, buffer or parameter splat.nil" methods/points.md 's/`splat.depth_index`/`splat.nil`/'
plant "visibility.test is one of" methods/points.md 's/`visibility.test=vertex`/`visibility.test=nil`/'
plant "no stage, parameter, field or kernel knows rho_scael" methods/points.md 's/`density.scale`/`rho_scael`/'
plant "parameter eye.fov is not described" methods/points.md 's,`eye.fov`/720,eye.fov/720,' METHODS.md
plant "epr: the sections are" methods/points.md 's/^### `cull`/### `align`/' METHODS.md
plant "columns, at most 120" METHODS.md '/^Whole pictures/s/.*/& &/'
plant "no kernel has the constant 0x1.94aa36p-4" CONTRACT.md 's/`0x1.0001p-16`/`0x1.94aa36p-4`/'
plant "ts_log2: its coefficients" CONTRACT.md 's/1.709a16p-3/1.8b4f7ap-3/'
plant "ts_sincos_turn: its coefficients" CONTRACT.md 's/s \* 0x1.921fb6p+2/s/'
plant "not numbered" CONTRACT.md 's/^\*\*12\. /**13. /'
plant "stale" VERDICTS.md '/^| SSAGH | figure 7 /s/holds/differs/'
plant "a cell of 1[0-9]* characters, at most 160: " VERDICTS.md \
	"/^| SSAGH | figure 6 /s/\$/ $(yes word | head -n 36 | tr '\n' ' ')|/"
plant "surfels by gouraud has no golden" PICTURES.md '/^| `gouraud`/d'
plant "effect particles has no pictures" PICTURES.md '/generated: pictures particles/d'
plant "there is no method megaview" RENDERING.md 's/^| `megaviews`/| `megaview`/'
plant "truth vpls is not in the table" RENDERING.md '/^| vpls |/d'
plant "effect omni-shadows is not shown" RENDERING.md 's/render omni-shadows/render shadows/'
plant "there is no table epr-4 of bench" RENDERING.md 's/bench epr-1 /bench epr-4 /'
plant "1[0-9]* words, at most 1000" README.md "\$a $(yes word | head -n 200 | tr '\n' ' ')"
plant "method vir is not named" README.md 's/, `vir`//'
plant "there is no table epr-4 of bench" README.md '/^## Start/s/$/ `touchstone bench epr-4`/'
plant "the methods are epr mvr " trace.schema.json 's/"epr", "mvr", /"mvr", /'
plant ".ci/run does not run make test-long" CONTRIBUTING.md 's/, the second, `make test-devices`/, `make test-long`&/'
plant ".ci/run runs make golden" CONTRIBUTING.md 's/, `make golden`//'
planted
plant "tests/kernels/points/cull.c has no nothing_stays" METHODS.md \
	's/ten_survivors_a_pixel_whatever_the_area/nothing_stays/'
plant "stale" methods/points.md 's/^- \*\*Kind:\*\* scatter/- **Kind:** map/'
plant "stale" CONTRACT.md '/^| `brdf` |/d'
planted
plant "stale" methods/views.md '/generated: stage view_map.margin/,/end -->/s/^- \*\*Out:\*\* .*/- **Out:** nothing/'
planted
plant "stale" TABLES.md '/^| `seed` |/d'
planted
plant "stale" METHODS.md '/^## 5\. /s/$/ and more/'
planted
plant "stale" methods/points.md '/^  - \[eye.view\]/s/\[eye.view\](#eyeview), //'
planted

# The template of a stage.
plant "pose: its heading is not followed by its generated block" methods/points.md '/generated: stage pose /d'
plant "cull: its parts are Edge cases;" methods/points.md '/^### `cull`$/,/^### /s/^\*\*Formula\.\*\* //'
plant "cull: there is text before its first part" methods/points.md ''
plant "align: its parts are Remarks" methods/points.md '/^### `align`$/,/^### /s/^\*\*Formula\.\*\*/**Remarks.**/'
plant "visibility: its parts are Formula, Departures, Edge cases" methods/points.md \
	'/^### `visibility`$/,/^### /{s/^\*\*Edge cases\.\*\*/**X.**/; s/^\*\*Departures\.\*\*/**Edge cases.**/; s/^\*\*X\.\*\*/**Departures.**/}'
plant "visibility: a departure is" methods/points.md ''
plant "splat: a departure is .*found - .Paper:. " methods/points.md '/^### `splat`$/,/^### /s/\*Here:\*/Here:/'
plant "splat.tie: Edge cases is empty" methods/points.md '/^### `lookup`$/i **Edge cases.**\n'
plant "stage shade.third is not described" methods/points.md 's/^### `shade.third`/### About `shade.third`/' METHODS.md
plant "there is no stage shade.fourth" methods/points.md 's/^### `shade.second`/### `shade.fourth`/'
plant "mirror is described twice" methods/points.md 's/^### `illuminate`/### `mirror`/'
plant "two headings have the anchor mirror" methods/points.md ''
plant "\"Errors of hulls\" names no stage" methods/hulls.md '$a ### Errors of hulls'
plant "section \"More hulls\" has no number" methods/hulls.md '$a ## More hulls'
plant "hull.margin is described on two pages" methods/shadows.md '$a ### `hull.margin`' METHODS.md
plant "the sections of all pages are not numbered" methods/surfels.md 's/^## 16\./## 19./' METHODS.md
planted
plant "stale" METHODS.md '/^| \[`hull`\](methods/s/| 3 |/| 2 |/'
planted
plant "stale" METHODS.md 's,\[pose\](methods/points.md#pose),[pose](methods/views.md#pose),'
planted

rm -r "$folder"/*.md "$folder"/methods
cp reference/VERDICTS.md "$folder/"
sed -i "s/not in general: one Gaussian errs more/one Gaussian errs more/" "$folder/verdicts.json"
scripts/docs-check "$folder" > "$folder/out"
grep -q "SSAGH, figure 3: a reason has no class" "$folder/out"
result $? "the check sees: a reason that no class explains"
sed -i "s/: one Gaussian errs more/: not in general&/" "$folder/verdicts.json"
cp reference/CONTRACT.md reference/METHODS.md reference/FIGURES.md "$folder/"
sed -i 's/"EPR 3.3"/"NIL 3.3"/' "$folder/stages.json"
scripts/docs-check "$folder" > "$folder/out"
grep -q "points.count: its paper, NIL 3.3" "$folder/out"
result $? "the check sees: a paper that is none"
sed -i 's/"NIL 3.3"/"EPR 3.3"/' "$folder/stages.json"

sed '/^| `seed` |/d' reference/TABLES.md > "$folder/TABLES.md"
sed '/methods\/hulls.md#corner)/d' reference/METHODS.md > "$folder/METHODS.md"
scripts/docs-check --write "$folder" > /dev/null && cmp -s reference/METHODS.md "$folder/METHODS.md" &&
	cmp -s reference/TABLES.md "$folder/TABLES.md"
result $? "--write makes the tables again"
echo "1..$n"
