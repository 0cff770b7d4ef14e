# Adds up the closing lines of all test runs: "N passed, N failed, N skipped in N s", and those of ctest.
/^[0-9]+ passed/ {
  for (i = 2; i <= NF; ++i) { word = $i; sub(/,/, "", word); if (word ~ /^(passed|failed|skipped)$/) count[word] += $(i - 1) }
}
/tests passed, [0-9]+ tests? failed out of [0-9]+/ {
  for (i = 2; i <= NF; ++i) if ($i ~ /^tests?$/ && $(i + 1) == "failed") { count["failed"] += $(i - 1); count["passed"] += $NF - $(i - 1) }
}
END {
  printf "\n%d passed, %d failed", count["passed"], count["failed"]
  if (count["skipped"]) printf ", %d skipped", count["skipped"]
  print ""
}
