#!/bin/bash
# A table of the user's own: that of BENCH.md measures what it says, and mistakes are told with their place.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/bench.bash"
page=reference/BENCH.md
small=(--scene atrium:triangles=10000:texels=32 --size 64x36 --set cube.max_px=32 --runs 1)

python3 - "$page" "$scratch/mirrors.table" <<'PY'
import re, sys
page = open(sys.argv[1]).read()
open(sys.argv[2], "w").write(re.search(r"```\n(.*?)```", page, re.S)[1])
lines = set(re.findall(r"`([a-z_]+)[ `]", "".join(l for l in page.splitlines(True) if l.startswith("|"))))
keys = set(re.findall(r'{"(\w+)", (?:(?:ts_)?take_|A_)', open("src/study/tables/text.c").read()))
assert len(keys) > 25 and not keys - lines, keys - lines
PY
verdict $? 'BENCH.md has all keys'

run bench "$scratch/mirrors.table" "${small[@]}" -o "$scratch/out"
python3 - "$scratch/out" <<'PY'
import sys
from results import results
report = results(sys.argv[1])
for errors, costs, n in zip(report["errors"], report["costs"], (1, 3)):
	assert errors["mirrors"] == costs["mirrors"] == n
	assert abs(errors["fewer"] - 100 * (1 - errors["dense"] / errors["epr"])) < 1e-4
	assert abs(costs["speedup"] - costs["mvr_ms"] / costs["epr_ms"]) < 1e-4 and 0 < costs["splat_ms"] < costs["epr_ms"]
	assert 7.9 < costs["bytes"] < 12
names = [name.split("/")[-1] for name in report["files"]]
assert {"errors.csv", "times-costs.csv", "relations.csv"} <= set(names), names
assert sum(name.endswith(".png") for name in names) == 2 * 4 and sum(name.endswith(".svg") for name in names) == 1
PY
[ $? -eq 0 ] && [ "$status" -eq 0 ]
verdict $? 'the table of BENCH.md measures what it says'

cat "$scratch/mirrors.table" <(sed 's/^table mirrors/table more/' "$scratch/mirrors.table") > "$scratch/two.table"
refuses 'two.table: has several tables; name one, as .*two.table:mirrors$' bench "$scratch/two.table"
refuses 'no table "mor"; the nearest is more' bench "$scratch/two.table:mor"
prints '^atrium:triangles=10000:texels=32 *1 ' bench "$scratch/two.table:more" --objects 1 "${small[@]}"
refuses 'no.table: No such file or directory$' bench "$scratch/no.table"
: > "$scratch/empty.table"
refuses 'empty.table: has no table$' bench "$scratch/empty.table"
sed 's/epr.ms.splat/epr.ms.spalt/' "$scratch/mirrors.table" > "$scratch/wrong.table"
refuses 'wrong.table:22:23: spalt is no stage, and no list of stages$' bench "$scratch/wrong.table"
refuses 'bench mirrors: takes no --method$' bench "$scratch/mirrors.table" --method epr
sed 's/^truth A/truth Z/' "$scratch/mirrors.table" > "$scratch/truth.table"
refuses "truth Z: no truth of reflections" bench "$scratch/truth.table" "${small[@]}"
sed 's/^scenes .*/scenes nowhere/' "$scratch/mirrors.table" > "$scratch/scene.table"
refuses 'nowhere' bench "$scratch/scene.table" "${small[@]:2}"

echo "1..$tests"
[ "$failures" -eq 0 ]
