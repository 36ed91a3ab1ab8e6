#!/bin/sh
# SPDX-License-Identifier: MIT
#
# A private Slurm on this machine's loopback: slurm_loop.sh FOLDER up | down. Two nodes, each with a daemon
# here; no cgroups, no accounting, no munge. Prints the variable for the environment. All files are in FOLDER.
set -eu
folder=${1:?usage: slurm_loop.sh FOLDER up|down}
host=$(hostname -s)

stop() { # the processes with recorded numbers, and no others
    for file in "$folder"/*.pid; do
        [ ! -s "$file" ] || kill "$(cat "$file")" 2>/dev/null || true
    done
}
free_port() {
    for port in $(seq "$1" $(($1 + 200))); do
        grep -qi ":$(printf '%04X' "$port") " /proc/net/tcp || { echo "$port" && return; }
    done
}

case ${2:?up or down} in
down)
    stop
    exit 0
    ;;
up) ;;
*) exit 2 ;;
esac
mkdir -p "$folder/state" "$folder/n1" "$folder/n2"
start=$((20000 + $$ % 20000))
controller=$(free_port $start)
first=$(free_port $((controller + 1)))
second=$(free_port $((first + 1)))
cat >"$folder/slurm.conf" <<TEXT
ClusterName=loop
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$controller
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/none
CredType=cred/none
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=bf_interval=1,sched_interval=1
ReturnToService=2
MpiDefault=none
SwitchType=switch/none
SlurmdTimeout=10
MinJobAge=3600
KillWait=1
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$first CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$second CPUs=1 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
TEXT
export SLURM_CONF="$folder/slurm.conf"
slurmctld -i >/dev/null 2>&1
slurmd -N n1 >/dev/null 2>&1
slurmd -N n2 >/dev/null 2>&1
for _ in $(seq 100); do
    [ "$(timeout 5 sinfo -h -o %t 2>/dev/null | head -n 1)" = idle ] && echo "SLURM_CONF=$SLURM_CONF" && exit 0
    sleep 0.2
done
stop
echo "slurm_loop: the nodes do not come up; see $folder/slurmctld.log" >&2
exit 1
