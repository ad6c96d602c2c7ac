#!/bin/bash
# Citations name pages, sections, rules and papers that exist; and the check sees those that do not. Prints TAP.
set -u
if ! git rev-parse --git-dir >/dev/null 2>&1; then
	echo "1..0 # SKIP not a git checkout"
	exit
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

scripts/cite-check | sed 's/^/# /'
result "${PIPESTATUS[0]}" "sources and documents"

# sees REASON TEXT: a comment with the text is refused for the reason, on its second line.
sees() {
	printf '/* A comment.\n * %b */\n' "$2" > "$folder/a.c"
	scripts/cite-check "$folder/a.c" > "$folder/out"
	[ $? -eq 1 ] && grep -q "a.c:2: $1" "$folder/out"
	result $? "the check sees: $1"
}
sees "METHODS has no section 7.2" "As in METHODS 7.2"
sees "METHODS has no section 99" "As in METHODS 2 and\n * 99"
sees "FIGURES has no section 99" "As in FIGURES 99"
sees "PORTING has no section 70" "(PORTING\n * 70)"
sees "CONTRACT has no rule 43" "(CONTRACT rules 41 to 43)"
sees "CONTRACT has no rule 60" "as rule 60 says"
sees "METHODS has no section 30" "section 30 of METHODS.md"
sees "there is no page or paper DETAILS" "(DETAILS 3)"
sees "there is no page or paper NUMBERS" "(NUMBERS rule 3)"
sees "EPR has no section 4.3" "(EPR section 4.3; METHODS 2)"
sees "EPR has no section 3.9" "(EPR 3.2, 3.9)"
sees "EPR has no eq 7" "(EPR 3.2, eq. 7)"
sees "SSAGH has no eq 24" "(SSAGH eqs 4 and 24)"
sees "iVIR has no table 4" "as in iVIR's table 4"
sees "MegaViews has no figure 18" "(MegaViews section 3.2, figures 4 and 18)"
sees "NV40 has no section 5" "(NV40 5)"
sees "NV40 has no slide" "(NV40: Immediate Shading; METHODS 16)"

printf \
	'/* METHODS 16, FIGURES 2 and 3, CONTRACT rules 4 to 6, EPR 3.2, eq. 1, SSAGH 4, eqs 15 to 18, MegaViews, figure 10,\n' \
	> "$folder/a.c"
printf ' * NV40: Deferred Shading, EPR 4.1.1 to 4.1.4; iVIR table 1; IEEE 754; SSIM 0.84 */\n' >> "$folder/a.c"
scripts/cite-check "$folder/a.c"
result $? "what exists may be cited"
echo "1..$n"
