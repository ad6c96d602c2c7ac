#!/bin/bash
# The subject of the last commit is an imperative; and scripts/subjects sees those that are not. Prints TAP.
set -u
if ! git rev-parse --git-dir > /dev/null 2>&1; then
	echo "1..0 # SKIP not a git checkout"
	exit
fi
. tests/cli/tap.bash
scripts/subjects | sed 's/^/# /'
verdict "${PIPESTATUS[0]}" 'the last commit'
subjects=$(realpath scripts/subjects)
cd "$scratch" && git init -q . && git config user.name one && git config user.email one || exit
commit() { git commit -q --allow-empty -m "$1" -m 'The reason, which may be as long as it is.'; }
commit 'tests: Begin'

# sees REASON SUBJECT: the last commit is refused for the reason.
sees() {
	commit "$2"
	"$subjects" > said
	[ $? -eq 1 ] && [ "$(cat said)" = "$(git log -1 --format=%h): $1: $2" ]
	verdict $? "the check sees: $2"
}
for subject in 'docs: The front door' 'docs: A row of rows' 'vectors: No u64 becomes a float' 'bench: What it says'; do
	word=${subject#*: }
	sees "${word%% *} is no verb; an imperative is wanted" "$subject"
done
sees 'Says is a plural, or the third person; an imperative is wanted' 'ci: Says so'
sees 'Mirrors is a plural, or the third person; an imperative is wanted' 'goldens: Mirrors on a ground'
sees 'Wrapped is the past; an imperative is wanted' 'tests: Wrapped lines'
sees 'Adding is a gerund; an imperative is wanted' 'tests: Adding lines'
sees 'README is a name; an imperative is wanted' 'docs: README says more'
sees 'not `area: Imperative summary`' 'Wrap lines'
sees 'not `area: Imperative summary`' 'tests: wrap lines'
sees '73 characters, at most 72' "tests: Wrap $(printf '%61s' '' | tr ' ' a)"

for subject in 'tests: Pass' 'mutants-src: Embed it' 'a/b.c: Bring it' 'CHANGELOG: Focus' 'a: Feed the reader' \
	"tests: Wrap $(printf '%60s' '' | tr ' ' a)"; do
	commit "$subject"
	"$subjects" > said
	verdict $? "an imperative: $subject"
done
"$subjects" HEAD~7.. > said
[ $? -eq 1 ] && [ "$(wc -l < said)" -eq 1 ]
verdict $? 'the commits of a range'
"$subjects" none..HEAD > said 2>&1
[ $? -eq 2 ]
verdict $? 'a range that there is not'
finish
