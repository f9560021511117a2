#!/usr/bin/env bash
# A batch in parts, by Slurm's job arrays on one node and by GNU parallel: every model is there once, also when a task is killed and queued
# again, and the manifest is that of one run.
# Usage: batch-cluster-test.sh STROMAR-CLI SOURCE-FOLDER [TREES]     exit status 77: a program is not installed
set -euo pipefail
cli=$1 source=$2 trees=${3:-200}
for program in slurmctld slurmd munged sbatch parallel; do
  command -v "$program" >/dev/null || { echo "batch-cluster: $program is not installed"; exit "$([ -n "${CI:-}" ] && echo 1 || echo 77)"; }
done
[ "$(id -u)" -eq 0 ] || { echo "batch-cluster: Slurm's daemons are run by root alone"; exit 77; }
work=$(mktemp -d)
cleanup() {
  for program in slurmctld slurmd munged; do [ -s "$work/$program.pid" ] && kill "$(cat "$work/$program.pid")" 2>/dev/null; done
  rm -rf "$work"
}
trap cleanup EXIT
fail() { echo "batch-cluster: $*" >&2; cat "$work"/slurm/*.log "$work"/*/task*.out 2>/dev/null | tail -40 >&2; exit 1; }

# Small trees, some of them in one task; the same plan in a folder for each way to run it.
for way in one parallel slurm; do
  mkdir -p "$work/$way"
  cat >"$work/$way/plan.json" <<PLAN
{"trees": "$source/presets/quaking_aspen.tree", "seeds": {"from": 1, "to": $trees}, "lods": [0], "set": {"Levels": 2, "1Branches": 12},
 "formats": ["glb"], "textures": "shared", "output": "out/{seed}.{format}"}
PLAN
done
"$cli" batch "$work/one/plan.json" --quiet
same() { cmp "$work/one/out/manifest.json" "$work/$1/out/manifest.json" || fail "$1: another manifest than one run's"; }

parallel --jobs 2 "$cli" batch "$work/parallel/plan.json" --quiet --part {}/8 ::: $(seq 8)
"$cli" batch "$work/parallel/plan.json" --merge --quiet || fail "parallel: models are missing"
same parallel

host=$(hostname -s) port=$((20000 + $$ % 20000))
mkdir -p "$work/munge" "$work/state" "$work/spool"
chmod 700 "$work/munge"
head -c 1024 /dev/urandom >"$work/munge/key"
chmod 400 "$work/munge/key"
munged --key-file="$work/munge/key" --socket="$work/munge/socket" --pid-file="$work/munged.pid" --log-file="$work/munge/log" \
  --seed-file="$work/munge/seed" --force
cat >"$work/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
JobRequeue=1
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurm/ctld.log
SlurmdLogFile=$work/slurm/d.log
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
export SLURM_CONF=$work/slurm.conf
slurmctld -f "$SLURM_CONF"
slurmd -f "$SLURM_CONF" -N "$host"
until_true() { for _ in $(seq "$1"); do "${@:2}" && return; sleep 0.5; done; fail "waited too long for ${*:2}"; }
idle() { sinfo -h -o %t 2>/dev/null | grep -q idle; }
until_true 60 idle

cat >"$work/slurm/task.sh" <<TASK
#!/bin/bash
# The first try of one task dies as if its machine had been switched off.
if [ "\$SLURM_ARRAY_TASK_ID" = 3 ] && [ -z "\${SLURM_RESTART_COUNT:-}" ]; then
  "$cli" batch "$work/slurm/plan.json" --quiet --part 3/8 &
  until [ "\$(find "$work/slurm/out" -name '*.glb' | wc -l)" -gt 3 ]; do sleep 0.05; done
  kill -9 \$! \$\$
fi
"$cli" batch "$work/slurm/plan.json" --quiet --part "\$SLURM_ARRAY_TASK_ID/8"
TASK
cd "$work/slurm"
job=$(sbatch --parsable --array=1-8 --requeue --output="task%a.out" task.sh)
failed() { scontrol show job "${job}_3" 2>/dev/null | grep -q "JobState=FAILED"; }
until_true 240 failed
scontrol requeue "${job}_3"
pending() { scontrol show job "${job}_3" | grep -q "JobState=PENDING"; }
until_true 60 pending
scontrol update JobId="${job}_3" StartTime=now # it would wait two minutes
over() { [ -z "$(squeue -h -j "$job" -t PENDING,RUNNING,COMPLETING 2>/dev/null)" ]; }
until_true 600 over
"$cli" batch "$work/slurm/plan.json" --merge || fail "slurm: models are missing"
same slurm
[ "$(find "$work/slurm/out" -name '*.glb' | wc -l)" -eq "$trees" ] || fail "not every file is there once"
echo "batch-cluster: $trees trees by one run, by parallel and by Slurm: the same manifest"
