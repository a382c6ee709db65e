"""Many drawings of many parts: `burin batch`. Needs Python 3.11 and the command `burin`, nothing else.

`catalogue` makes jobs of a catalogue, `jobs` holds and names them, `child` runs one process with its limits, `work` draws
what is left of one job, `state` remembers what is done, `runner` runs jobs on this machine, `on_dask` and `slurm` on
others, `report` shows them, `prune` removes what is no more. kernel/docs/catalogues.md is its manual.
"""
