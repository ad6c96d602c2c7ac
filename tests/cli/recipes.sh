#!/bin/bash
# The recipes of reference/CI.md, as they stand there, on three goldens of which one differs: the merged JUnit XML is
# that of one run. Slurm is a real one, of one node, where it is installed; a stand-in for its array runs everywhere.
. "$(dirname "$0")/tap.bash"
root=$PWD page=$PWD/reference/CI.md
export OMP_WAIT_POLICY=passive
cd "$scratch" || exit 2
mkdir bin && ln -s "$touchstone" bin/touchstone
export PATH=$scratch/bin:$PATH

# recipe HEADING: the block below it.
recipe() { sed -n "/^### $1\$/,/^### /p" "$page" | sed -n '/^```[a-z]/,/^```$/p' | sed '/^```/d'; }
# skip NAME TOOL: visible, where a tool is not installed.
skip() { verdict 0 "$1 # SKIP $2 is not installed"; }
# timeless FILE: JUnit XML without what differs from run to run.
timeless() { sed -E 's/ (time|timestamp|hostname)="[^"]*"//g' "$1"; }
# judged STATUS NAME: golden.xml and the exit code are those of one run.
judged() {
	[ "$1" -eq 1 ] && diff <(timeless whole.xml) <(timeless golden.xml) > differs
	verdict $? "$2"
	rm -rf shards golden.xml
}

mkdir -p reference/goldens
for i in 1 2 3; do
	echo "case-$i: mvr dining:triangles=10000:texels=32 --size 24x16 --reflectors 0 --set seed=$i"
done > reference/goldens/cases.txt
touchstone golden new > made
accepts reference/goldens case-{1,2,3}
sed -i '3s/^./g/;3s/^g/0/' reference/goldens/case-2/SHA256SUMS
sed -i '3{s/^0/1/;t;s/^./0/}' reference/goldens/case-2/SHA256SUMS
touchstone golden check --junit whole.xml > whole
[ $? -eq 1 ] && grep -q 'failures="1"' whole.xml
verdict $? 'one of three goldens differs'

recipe Slurm > goldens.sh
array=$(sed -n 's/^#SBATCH --array=1-//p' goldens.sh)
mkdir shards
for ((i = 1; i <= array; i++)); do
	SLURM_ARRAY_TASK_ID=$i SLURM_ARRAY_TASK_MAX=$array bash goldens.sh > "shards/$i.log" 2>&1
done
touchstone merge shards/*.d --junit golden.xml > merged
judged $? 'a job array of Slurm, by a stand-in that sets its variables'

# slurm: one node with a key of its own, which listens to this machine alone; only root's runs jobs.
slurm() {
	mkdir -p state spool
	(umask 077 && head -c 1024 /dev/urandom > munge.key)
	munged --foreground --force --key-file="$PWD/munge.key" --socket="$PWD/munge.socket" --pid-file="$PWD/munge.pid" \
		--log-file="$PWD/munge.log" --seed-file="$PWD/munge.seed" > munged.log 2>&1 & munge=$!
	cat > slurm.conf <<CONF
ClusterName=one
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmctldPort=16847
SlurmdPort=16848
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$PWD/munge.socket
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
ReturnToService=2
StateSaveLocation=$PWD/state
SlurmdSpoolDir=$PWD/spool
SlurmctldPidFile=$PWD/ctld.pid
SlurmdPidFile=$PWD/d.pid
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$(hostname) Default=YES State=UP
CONF
	export SLURM_CONF=$PWD/slurm.conf
	for ((i = 0; i < 30; i++)); do
		[ ! -S munge.socket ] || break
		sleep 0.2
	done
	slurmctld -D > ctld.log 2>&1 & slurm=$!
	slurmd -D > d.log 2>&1 & node=$!
	trap 'kill "$slurm" "$node" "$munge" 2> /dev/null; wait; rm -rf "$scratch"' EXIT
	for ((i = 0; i < 30; i++)); do
		timeout 5 sinfo -h -o %t 2> /dev/null | grep -q idle && return
		sleep 1
	done
	false
}
name='a job array of Slurm'
if ! command -v slurmctld slurmd sbatch munged > found || [ "$(id -u)" -ne 0 ]; then
	skip "$name" 'Slurm, for root,'
elif ! slurm; then
	verdict 0 "$name # SKIP no daemon of Slurm can run here: $(tail -n 1 ctld.log d.log | tr -d '#' | tr '\n' ' ')"
else
	mkdir shards
	timeout 300 sbatch --wait goldens.sh > submitted 2>&1
	status=$?
	touchstone merge shards/*.d --junit golden.xml > merged
	[ $? -eq "$status" ] || status=-1
	judged "$status" "$name"
fi

if command -v parallel > found; then
	recipe 'GNU parallel' > goldens.sh
	bash goldens.sh > merged 2> said
	judged $? 'GNU parallel'
else
	skip 'GNU parallel' parallel
fi

mkdir build && ln -s "$touchstone" build/touchstone
recipe 'GitHub Actions' > workflow.yml
if /usr/bin/python3 -c 'import yaml' 2> found; then
	/usr/bin/python3 - <<'PY' > commands
import yaml
flow = yaml.safe_load(open("workflow.yml"))
jobs = flow["jobs"]
build, shard, merge = jobs["build"], jobs["shard"], jobs["merge"]
matrix = shard["strategy"]["matrix"]["shard"]
run = {step["name"]: step["run"] for job in jobs.values() for step in job["steps"] if "name" in step}
assert shard["needs"] == "build" and merge["needs"] == "shard", "the order of jobs"
assert all("uses" in step or "run" in step for job in jobs.values() for step in job["steps"]), "steps"
open("built", "w").write("\n".join(line for line in (run["build"] + run["unpack"]).splitlines()
                                   if line.startswith("make ")))
assert f"/{len(matrix)} " in run["check"] and matrix == list(range(1, len(matrix) + 1)), "the matrix is all shards"
for i in matrix:
	print(run["check"].replace("${{ matrix.shard }}", str(i)), "|| :")
print(run["merge"])
PY
	verdict $? 'a matrix of GitHub Actions is YAML'
	grep -q 'make deps-build' built &&
		(cd "$root" &&
		env -u MAKEFLAGS TS_INSTALL=0 bash -e <(sed 's/\bmake\b/make -n/g; s/&& tar .*//' "$scratch/built")) > made 2>&1
	verdict $? 'what it makes can be made'
	mkdir shards
	bash commands > merged 2> said
	judged $? 'and its commands work'
	recipe GitLab > gitlab.yml
	/usr/bin/python3 - <<'PY' > commands
import yaml
flow = yaml.safe_load(open("gitlab.yml"))
check, merge = flow["check"], flow["merge"]
assert [flow[job]["stage"] for job in ("build", "check", "merge")] == flow["stages"], "stages"
there = open("workflow.yml").read().replace("          ", "").splitlines()
assert set(flow["build"]["script"]) <= set(there), "built as there"
for i in range(1, check["parallel"] + 1):
	print(f"CI_NODE_INDEX={i} CI_NODE_TOTAL={check['parallel']};", check["script"][1], "|| :")
print(merge["script"][1])
PY
	verdict $? 'stages of GitLab are YAML, and build as there'
	mkdir shards
	bash commands > merged 2> said
	judged $? 'and their commands work'
else
	skip 'GitHub Actions, GitLab' python3-yaml
fi

# Jenkins: the shell of its stages; what it makes is what the others make.
recipe Jenkins | sed -n "s/.* sh '\(.*\)' }.*/\1/p" > commands
[ "$(wc -l < commands)" -eq 2 ] && sed -n 1p commands | grep -q ' && make deps-build && make$'
verdict $? 'a pipeline of Jenkins builds as the others'
sed 1d commands > check
bash check > merged 2> said
judged $? 'and its check works'
finish
