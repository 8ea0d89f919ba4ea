#!/usr/bin/env bash
# Tiles in the memory of a cluster with Slurm and MPI:
#
#   sbatch tiles_by_mpi.sh FOLDER POINTS...
#
# A task has one tile. It takes about 1 KB for each point of its own if the points are on a surface, and 5 KB in the worst tile.
#SBATCH --job-name=tiles
#SBATCH --ntasks=64
#SBATCH --mem-per-cpu=8G
#SBATCH --time=4:00:00
set -euo pipefail

mpirun -n "$SLURM_NTASKS" delaunay_from_surface_mpi "${@:2}" --output "$1"
