#!/bin/bash
# slurm.sh CRAZE SOURCE WORK: a Slurm of one node, started here as root with ports of its own, and an
# array of tasks on it, one of which is killed and one put back into the queue. They go on with a set
# of fewer samples.
for program in munged slurmctld slurmd sbatch scontrol squeue; do
  PATH=$PATH:/usr/sbin command -v $program >/dev/null || {
    echo "skipped: no $program (apt: slurm-wlm munge)"
    exit 77
  }
done
[ "$(id -u)" = 0 ] || {
  echo "skipped: needs root"
  exit 77
}
PATH=$PATH:/usr/sbin
. "$(dirname "$0")/plan.sh"

host=$(hostname -s)
mkdir -p slurm/state slurm/spool munge
chmod 700 munge
port=$((20000 + $$ % 20000))
head -c 1024 /dev/urandom >munge/key
chmod 400 munge/key
cat >slurm/slurm.conf <<END
ClusterName=craze
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
SlurmctldPort=$port
SlurmdPort=$((port + 1))
StateSaveLocation=$work/slurm/state
SlurmdSpoolDir=$work/slurm/spool
SlurmctldPidFile=$work/slurm/ctld.pid
SlurmdPidFile=$work/slurm/d.pid
SlurmctldLogFile=$work/slurm/ctld.log
SlurmdLogFile=$work/slurm/d.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobRequeue=1
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MaxArraySize=100
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES State=UP MaxTime=60
END
export SLURM_CONF=$work/slurm/slurm.conf
pids=()
stop() {
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null; done
  wait
}
trap stop EXIT
munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" \
  --pid-file="$work/munge/pid" --seed-file="$work/munge/seed" --log-file="$work/munge/log" >munge/out 2>&1 &
pids+=($!)
for _ in $(seq 50); do [ -S munge/socket ] && break; sleep 0.1; done
slurmctld -D >slurm/ctld.out 2>&1 &
pids+=($!)
slurmd -D -N "$host" >slurm/d.out 2>&1 &
pids+=($!)
for _ in $(seq 100); do
  scontrol ping 2>/dev/null | grep -q UP && sinfo -h -o %T 2>/dev/null | grep -q idle && break
  sleep 0.2
done
sinfo -h -o %T | grep -q idle || {
  tail -5 slurm/*.log
  exit 1
}

# The array, with other numbers of tasks from one submission to the next.
submit() {
  CRAZE=$craze sbatch --parsable --array="$1" -o "task_%a.log" --export=ALL,CRAZE="$craze" \
    "$source/scripts/craze_array.sbatch" dataset "$work/plan.toml" -o "$work/out"
}
finish() {
  for _ in $(seq 600); do
    [ -z "$(squeue -h -j "$1" 2>/dev/null)" ] && return
    sleep 0.3
  done
  squeue
  exit 1
}
"$craze" dataset "$work/plan.toml" -o out --quiet --samples 5
job=$(submit 0-3)
sleep 1
scancel --batch --signal=TERM "${job}_1" 2>/dev/null || true  # as at the end of its time
scancel --signal=KILL "${job}_0" 2>/dev/null || true         # as a node that dies
sleep 1
scontrol requeue "${job}_0" 2>/dev/null || true
sleep 3
scancel "$job" 2>/dev/null || true
finish "$job"
job=$(submit 3-17:7)
finish "$job"
expect_same out
