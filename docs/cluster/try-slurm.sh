#!/usr/bin/env bash
# Tries frames.sbatch on a Slurm of one node that it sets up on this machine, as root, on Debian: an array of four,
# of which a task is queued again half-way; then holds the frames against those of one process. What it prints
# stands in docs/cluster.md.
set -eu
cd "$(dirname "$0")"
taut=${TAUT:-$PWD/../../build/release/taut}
work=$(mktemp -d /tmp/taut-slurm-XXXXXX)

command -v slurmctld > /dev/null || DEBIAN_FRONTEND=noninteractive apt-get install -y slurm-wlm > /dev/null
mkdir -p "$work/state" "$work/spool" /run/munge
chown munge: /run/munge
pgrep -x munged > /dev/null || runuser -u munge -- munged
cat > /etc/slurm/slurm.conf <<EOF
ClusterName=one
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
JobRequeue=1
KillWait=5
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
EOF
slurmctld -c -L "$work/slurmctld.log"
slurmd -L "$work/slurmd.log"
trap 'pkill -x slurmd; pkill -x slurmctld' EXIT
for _ in $(seq 60); do sinfo -h -o %T 2> /dev/null | grep -q idle && break; sleep 0.5; done
sinfo

"$taut" simulate curtain -o "$work/motion"
"$taut" render --motion "$work/motion" -o "$work/whole" --quiet
export TAUT=$taut
job=$(sbatch --parsable --output "$work/task-%a.log" frames.sbatch "$work/motion" "$work/frames")
while [ "$(find "$work/frames" -name 'frame-*.png' 2> /dev/null | wc -l)" -lt 20 ]; do sleep 0.1; done
echo "queued again with $(find "$work/frames" -name 'frame-*.png' | wc -l) of 300 frames there: task 1 of $job"
scontrol requeue "${job}_1"
# Slurm holds back what it has just stopped for a while.
sleep 2
scontrol update jobid="${job}_1" starttime=now || true
while squeue -h -j "$job" 2> /dev/null | grep -q .; do sleep 0.5; done
cat "$work"/task-*.log
"$taut" merge "$work/frames" --film "$work/film.mp4"
"$taut" verify "$work/frames"
for frame in "$work"/whole/*.png; do cmp "$frame" "$work/frames/$(basename "$frame")"; done
echo "all frames are those of one process"
rm -r "$work"
