#!/bin/bash
# Runs assets/cluster/burl-array.sh under Slurm on this machine, with a controller and two node daemons
# on loopback, and compares the outputs with those of one local run; then once more with a node daemon
# that is killed on the way, whose tasks go back into the queue.
#   slurm.sh BURL SOURCE FOLDER    77: Slurm is absent, or this is not root
set -uo pipefail
burl=$1 source=$2 folder=$3
PATH=$PATH:/usr/sbin
for program in slurmctld slurmd sbatch scontrol squeue; do
    command -v $program >/dev/null || { echo "$program is absent"; exit 77; }
done
[[ $(id -u) == 0 ]] || { echo "node daemons want root"; exit 77; }
rm -rf "$folder"
mkdir -p "$folder"/{bin,state,spool,log,meshes}
ln -s "$burl" "$folder/bin/burl"
host=$(hostname -s)
cat >"$folder/slurm.conf" <<CONF
ClusterName=burl
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=46817
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool/%n
SlurmctldPidFile=$folder/state/ctld.pid
SlurmdPidFile=$folder/spool/%n.pid
SlurmctldLogFile=$folder/log/ctld
SlurmdLogFile=$folder/log/%n
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SchedulerParameters=bf_interval=1,sched_interval=1
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
NodeName=n0 NodeHostname=$host NodeAddr=127.0.0.1 Port=46818 CPUs=2
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=46819 CPUs=2
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm.conf PATH=$folder/bin:$PATH
slurmctld -D -c >"$folder/log/ctld.out" 2>&1 &
controller=$!
declare -A daemons
for node in n0 n1; do
    mkdir -p "$folder/spool/$node"
    slurmd -D -N $node >"$folder/log/$node.out" 2>&1 &
    daemons[$node]=$!
done
trap 'kill -9 $controller ${daemons[*]} 2>/dev/null; wait 2>/dev/null' EXIT
for ((i = 0; i < 60; i++)); do
    [[ $(sinfo -h -t idle -o %D 2>/dev/null) == 2 ]] && break
    sleep 0.5
done
[[ $(sinfo -h -t idle -o %D) == 2 ]] || { echo "the nodes did not come up"; tail -5 "$folder"/log/*; exit 1; }

fail() { echo "FAILED: $*"; exit 1; }
for ((i = 0; i < 12; i++)); do
    printf '# %d\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n' $i >"$folder/meshes/m$i.obj"
done
manifest() { # OUTPUTS SIZE
    printf '{"bakes": [{"mesh": "meshes/*.obj", "recipe": ["oak", "marble"], "size": %d, "output": "%s/{mesh}_{recipe}.glb"}]}\n' \
        "$2" "$1" >"$folder/$1.json"
}
pictures() { (cd "$folder/$1" && sha256sum ./*.glb); }
submit() { # OUTPUTS TASKS: prints the array's number
    (cd "$folder/log" && sbatch --parsable --array=1-$2 "$source/assets/cluster/burl-array.sh" "$folder/$1.json")
}
wait_for() { # JOB SECONDS
    for ((i = 0; i < 2 * $2; i++)); do
        # A task that is requeued waits two minutes unless it is told to start.
        scontrol release "$1" >/dev/null 2>&1
        scontrol update jobid="$1" StartTime=now >/dev/null 2>&1
        [[ -z $(squeue -h -j "$1" 2>/dev/null) ]] && return 0
        sleep 0.5
    done
    squeue
    return 1
}

for outputs in whole array killed; do manifest $outputs 512; done
burl batch "$folder/whole.json" --quiet || fail "the local run"
[[ $(pictures whole | wc -l) == 24 ]] || fail "24 outputs"

job=$(submit array 6) || fail "sbatch"
wait_for "$job" 120 || fail "the array did not end"
diff <(pictures whole) <(pictures array) || fail "an array gives other files"
echo "an array of six tasks gives the 24 files of one run"

job=$(submit killed 6) || fail "sbatch"
for ((i = 0; i < 200; i++)); do
    [[ -n $(squeue -h -j "$job" -t R -w n1 2>/dev/null) ]] && break
    sleep 0.1
done
[[ -n $(squeue -h -j "$job" -t R -w n1) ]] || fail "no task ran on the second node"
kill -9 "${daemons[n1]}"
pkill -9 -f "slurmstepd: \[$job" 2>/dev/null
scontrol update nodename=n1 state=down reason=killed || fail "scontrol"
requeued=$(squeue -h -j "$job" -t PD | wc -l)
wait_for "$job" 240 || fail "the array did not end after a node was lost"
diff <(pictures whole) <(pictures killed) || fail "an array that lost a node gives other files"
ls "$folder"/killed/*.tmp* "$folder"/killed/.[!.]* 2>/dev/null && fail "something temporary is left"
echo "an array that lost a node ($requeued tasks were waiting then) gives them, too"
