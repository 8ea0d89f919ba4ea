#!/usr/bin/env bash
# Tiles out of core on a cluster with Slurm: a job array for each round, of jobs that have one tile in memory at a time.
#
#   ./tiles_out_of_core.sh FOLDER TILES POINTS...
#
# It waits for the arrays, so it is started where it may stay for hours, as in a job of its own. What was stopped goes on
# when it is called again. The jobs:
#SBATCH --job-name=tiles
#SBATCH --cpus-per-task=1
#SBATCH --mem=8G
#SBATCH --time=4:00:00
set -euo pipefail

most_jobs=1000 # of an array, as Slurm's MaxArraySize has it if nobody changed it
run=(delaunay_from_surface tiles "${@:3}" --tiles "$2" --memory 6G --output "$1")

if [ -n "${SLURM_ARRAY_TASK_ID-}" ]; then # a job of the array: every so manieth task
  for ((k = SLURM_ARRAY_TASK_ID; k < TASKS; k += SLURM_ARRAY_TASK_COUNT)); do
    "${run[@]}" --task "$k"
  done
  exit
fi

while true; do
  TASKS=$("${run[@]}" --next)
  export TASKS
  if [ "$TASKS" -eq 0 ]; then break; fi
  jobs=$((TASKS < most_jobs ? TASKS : most_jobs))
  sbatch --wait --array=0-$((jobs - 1)) "$0" "$@"
done
