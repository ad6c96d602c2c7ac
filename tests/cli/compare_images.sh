#!/bin/bash
# `compare` of two images: what differs, in each form; the options that it takes and refuses; display values against
# radiance; tolerances. JUnit of what could not be made: junit.sh.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/images.bash"
cd "$scratch" || exit 2
writes_two

# ends STATUS NAME ARGUMENT...: the comparison ends so.
ends() {
	local expected=$1 name=$2
	shift 2
	run compare "$@"
	[ "$status" -eq "$expected" ]
	verdict $? "$name: ${*:3}"
}
writes mask.png <<'PY'
pixels[12] = [0, 0, 0]
PY

writes black.png <<< 'pixels = [[0, 0, 0]] * 40'
writes opaque.png <<< 'pixels = [[0, 0, 0, 255]] * 40'

# 3 values of 2 of the 40 pixels, by 10, 20 and 20 of 255: the root of the mean of squares is 0.01074.
ends 1 'all figures' a.png b.png
grep -qE \
	'^120 values, 3 different in 5 % of the pixels, largest difference 0\.07843[0-9]*, root mean square 0\.01073[0-9]*$' \
	stdout &&
	grep -qE '^pixel \(2, 1\), channel 1: ref 0.50196[0-9]* = .* candidate 0.54117[0-9]* = .* — first of 3$' stdout
verdict $? 'figures and the first difference'
ends 1 'all differences' a.png b.png --first 9
[ "$(grep -c '^  pixel (' stdout)" -eq 2 ]
verdict $? '--first lists them all'
ends 0 'nothing differs' a.png a.png --percent 0 --hardfail 0 --rmse 0

# Each tolerance on both sides of its bound; all that are typed must hold.
for stands in '--percent 5' '--hardfail 0.0785' '--rmse 0.01074' '--allow 3' '--abs 0.0785' \
	'--abs 0.04 --percent 5 --allow 2' '--percent 5 --hardfail 0.0785 --rmse 0.01074 --allow 3'; do
	# shellcheck disable=SC2086
	ends 0 'stands' a.png b.png $stands
done
for falls in '--percent 4.99' '--hardfail 0.0784' '--rmse 0.01073' '--allow 2' '--abs 0.0784' \
	'--abs 0.04 --percent 4.9' \
	'--abs 0.04 --allow 1' '--percent 100 --hardfail 1 --rmse 1 --allow 2' '--percent 5 --hardfail 0.0784' \
	'--percent 5 --rmse 0.01073'; do
	# shellcheck disable=SC2086
	ends 1 'does not stand' a.png b.png $falls
done
run compare a.png b.png --percent 5 --rmse 0.5 --abs 0.25 --json --junit j.xml
python3 -c '
import json
report = json.load(open("stdout"))
assert report["relaxations"] == "--abs 0.25 --percent 5 --rmse 0.5" and report["verdict"] == "same"
assert report["different"] == 0 and report["pixels"] == 40 and abs(report["largest"] - 20 / 255) < 1e-7' &&
	grep -q '<property name="relaxations" value="--abs 0.25 --percent 5 --rmse 0.5"/>' j.xml
verdict $? 'the relaxations are part of the reports'
suits 1 0 0 0 'JUnit of images that pass'
run compare a.png b.png --hardfail 0 --tap
[ "$status" -eq 1 ] && grep -qx '# relaxed: --hardfail 0' stdout && grep -q '^not ok 1 - .*\.png$' stdout &&
	grep -qx '1..1' stdout
verdict $? 'and of TAP'
for wrong in '--percent x' '--rmse -1' '--hardfail nan' '--percent'; do
	# shellcheck disable=SC2086
	refuses "${wrong% *}" compare a.png b.png $wrong
done

# Masks, pictures, JUnit.
ends 1 'behind a mask' a.png b.png --mask mask.png
grep -q '^117 values, 1 different in 2.564 % ' stdout && grep -q '; relaxed: --mask mask.png$' stdout &&
	grep -q '^pixel (0, 3)' stdout
verdict $? 'the mask leaves a pixel out'
run compare a.png b.png -o out --junit j.xml
[ "$status" -eq 1 ] && [ "$(ls out)" = $'difference.png\nreport.json' ]
verdict $? '-o draws what differs'
suits 1 1 0 0 'JUnit of a failure'
grep -q '<failure message="120 values, 3 different .*" type="different">' j.xml && grep -q '^pixel (2, 1)' j.xml
verdict $? 'with message, type and lines'
ends 1 'the picture is a mask of all but that' a.png b.png --mask out/difference.png
grep -q '^6 values, 3 different in 100 % ' stdout
verdict $? 'white where they differ'
run compare a.png a.png -o same
[ "$status" -eq 0 ] && [ "$(ls same)" = report.json ]
verdict $? 'nothing is drawn of what is the same'
run compare a.png a.png -o out --force
[ "$status" -eq 0 ] && [ "$(ls out)" = report.json ]
verdict $? '--force replaces it'

cp mask.png $'m\nok 2 - m.png'
run compare a.png b.png --mask $'m\nok 2 - m.png' --tap
[ "$status" -eq 1 ] && [ "$(grep -c '^ok' stdout)" -eq 0 ] && grep -qx '# relaxed: --mask m?ok 2 - m.png' stdout
verdict $? 'the name of a mask is no line of TAP'

# Every option works or is refused, by images, buffers and traces.
run "${frame[@]:0:${#frame[@]}-1}" --method epr --trace-only scene,eye,image -o r
verdict "$status" 'pictures, buffers and a trace'
# useless TRACES_OR_WHAT KIND REFERENCE OPTION...: each option is refused for files of that kind.
useless() {
	local right=$1 kind=$2 file=$3 option
	shift 3
	for option; do
		# shellcheck disable=SC2086
		refuses \
			"^touchstone: ${option%% *}: means something for $right only; $file is one of two $kind: leave the option out$" \
			compare "$file" "$file" $option
	done
}
buffer=$(ls r/trace-epr/*image.srgb.npy)
useless traces images a.png --forced --decided '--layout a=b' '--order arrival'
useless 'traces and buffers' images a.png '--ignore image.srgb'
useless traces buffers "$buffer" --forced --decided '--layout a=b' '--order arrival'
useless images buffers "$buffer" '--percent 1' '--hardfail 1' '--rmse 1' '--exposure 1'
useless images traces r/trace-epr '--percent 1' '--hardfail 1' '--rmse 1' '--exposure 1'
for pair in a.png "$buffer" r/trace-epr; do
	refuses '^touchstone: --tap, --json: both print; choose one$' compare "$pair" "$pair" --tap --json
	refuses '^touchstone: --force: only with -o DIR$' compare "$pair" "$pair" --force
done
refuses '^touchstone: mask: 96 x 54 pixels; the images have 10 x 4$' compare a.png b.png --mask r/epr.png
refuses ': black everywhere: nothing to judge$' compare a.png b.png --mask black.png
refuses ': black everywhere: nothing to judge$' compare a.png b.png --mask opaque.png
views=$(ls r/trace-epr/*scene.info.npy)
refuses '^touchstone: --mask: means something for pixels only; .* holds scene.info: leave the option out$' \
	compare "$views" "$views" --mask black.png
run compare missing.png a.png --junit /dev/stdout
[ "$status" -eq 2 ] && [ "$(grep -c '<?xml' stdout)" -eq 1 ]
verdict $? 'an error is in the XML once'

# Display values and radiance.
refuses \
	'^touchstone: r/epr.exr holds linear radiance, and r/epr.png sRGB codes; --exposure 1 compares them as a display shows them$' \
	compare r/epr.png r/epr.exr
refuses '^touchstone: r/epr.exr holds linear radiance, and r/epr.png sRGB codes;' compare r/epr.exr r/epr.png
for pair in 'r/epr.png r/epr.exr' 'r/epr.exr r/epr.png' 'r/epr.exr r/epr.exr'; do
	# shellcheck disable=SC2086
	ends 0 'as a display shows them' $pair --exposure 1
	grep -q '^15552 values, 0 different in 0 % .*; relaxed: --exposure 1$' stdout
	verdict $? 'to the bit'
done
ends 1 'by another exposure' r/epr.png r/epr.exr --exposure 1.01
refuses '--exposure: a.png and a.png both hold sRGB codes; leave it out$' compare a.png a.png --exposure 1
writes grey.png <<< 'pixels = [[0]] * 40'
writes_exr grey.exr Y
writes_exr alpha.exr RGBA
ends 0 'greys' grey.png grey.exr --exposure 1
refuses '--exposure: alpha.exr has 4 channels; expected 1 or 3, as alpha is not shown' \
	compare alpha.exr black.png --exposure 1
refuses '--exposure auto: needs a scene' compare r/epr.png r/epr.exr --exposure auto
cp r/epr.exr named.png
refuses 'named.png holds linear radiance, and r/epr.png sRGB codes;' compare r/epr.png named.png

finish
