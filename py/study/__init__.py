"""Studies of many beds: from a study file (YAML) to a plan of runs, from their results to a table, statistics and figures."""
