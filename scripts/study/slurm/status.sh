#!/bin/bash
# Say how the job $1 stands, in snakemake's words: running, success or failed.
# squeue knows jobs that are waiting, running, or ended a moment ago; the accounting, where there is one, the older ones.
state=$(squeue --noheader --jobs="$1" --states=all --format=%T 2>/dev/null | head -n 1)
[ -n "$state" ] || state=$(sacct --noheader --allocations --parsable2 --jobs="$1" --format=State 2>/dev/null | head -n 1)
[ -n "$state" ] || state=$(scontrol show job "$1" 2>/dev/null | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p')
case $state in
  COMPLETED) echo success ;;
  BOOT_FAIL | CANCELLED* | DEADLINE | FAILED | NODE_FAIL | OUT_OF_MEMORY | PREEMPTED | TIMEOUT) echo failed ;;
  *) echo running ;;  # an unknown state may be a controller that does not answer just now
esac
