# SPDX-License-Identifier: Apache-2.0
# awk -v phase=packages|build|measure -f quickstart_progress.awk: turns what apt (APT::Status-Fd), ninja (NINJA_STATUS "%f %t") and
# `umbrameter validate` write into lines with the time that is left, one every few seconds. Other lines of a failing build pass.
BEGIN { start = systime(); last = 0; every_s = 3; task = "" }

function time_text(s) { return sprintf("%d:%02d", s / 60, s % 60) }

# `share` of the task is done since `begun`.
function say(what, share, begun,    now) {
  now = systime()
  if (now - last < every_s) return
  last = now
  if (share <= 0.01) printf "quickstart: %s, %s so far\n", what, time_text(now - begun)
  else printf "quickstart: %s, %d %%, about %s left\n", what, 100 * share, time_text((now - begun) * (1 - share) / share)
  fflush()
}

phase == "packages" && /^(dl|pm)status:/ {
  split($0, field, ":")
  what = field[1] == "dlstatus" ? "[1/4] downloading" : "[1/4] installing"
  if (what != task) { task = what; start = systime() }
  say(what, field[3] / 100, start)
  next
}

phase == "build" && /^@@[0-9]+ [0-9]+ / {
  sub(/^@@/, "", $1)
  say("[3/4] building, file " $1 " of " $2, $1 / $2, start)
  next
}

phase == "measure" && match($0, /\([0-9]+ of [0-9]+\)/) {
  split(substr($0, RSTART + 1, RLENGTH - 2), part, " of ")
  within = match($0, /[0-9]+ %/) ? substr($0, RSTART, RLENGTH - 2) / 100 : 0
  # A scene's tasks follow each other; the one that is seen stands for half of it.
  say("[4/4] measuring, scene " part[1] " of " part[2], (part[1] - 1 + within / 2) / part[2], start)
  next
}

phase == "packages" || phase == "measure" && /^umbrameter: .*: done/ { next }

{ print; fflush() }
