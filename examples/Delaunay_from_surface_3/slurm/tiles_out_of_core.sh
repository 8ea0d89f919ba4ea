#!/usr/bin/env bash
# Tiles out of core on a cluster with Slurm: a job array for each round, whose jobs have one tile in memory at a time.
#
#   ./tiles_out_of_core.sh FOLDER TILES POINTS...
#
# It waits for the arrays, so start it where it may run for hours, for example in a job of its own. If it was stopped, call
# it again: it continues. The jobs:
#SBATCH --job-name=tiles
#SBATCH --cpus-per-task=1
#SBATCH --mem=8G
#SBATCH --time=4:00:00
set -euo pipefail

most_jobs=1000 # of an array: the default of Slurm's MaxArraySize
run=(delaunay_from_surface tiles "${@:3}" --tiles "$2" --memory 6G --output "$1")

if [ -n "${SLURM_ARRAY_TASK_ID-}" ]; then # a job of the array: every n-th task, for n jobs
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
