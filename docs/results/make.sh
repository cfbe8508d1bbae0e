#!/bin/sh
# Draws everything in this folder from the campaign's database. It runs no impact.
#   docs/results/make.sh [DATABASE]      (from the root of the repository, after `make build`)
set -eu
eerie=${EERIE:-build/eerie}
out=docs/results
db=${1:-$out/table2.sqlite}
# Impacts of `standard`; other settings answer single statements of the paper.
of="--db $db --settings 1"
runs="--db $db --where settings=1"
columns=hash,q,phi_d_deg,v_imp_cm_per_s,theta_imp_deg,v_over_v_esc,seed,fidelity,class,m_lr_over_m_total
columns=$columns,m_slr_over_m_total,b_over_a,c_over_a,period_h,eer,n_eer,n_remnants,settled
columns=$columns,ended_at_s,end_reason,dL_over_L,particle_steps,wall_s,solver_version

draw() { # NAME Q PHI_D: the maps of one series into a folder, and the ridge where there is one
  to=$out/$1
  map="$of --q $2 --phi-d $3"
  # A map of a few cells says nothing yet.
  [ "$($eerie query $runs --q $2 --phi-d $3 --columns hash --format csv | tail -n +2 | wc -l)" -ge 20 ] || return 0
  mkdir -p $to
  $eerie map $map -o $to/b-over-a.svg
  $eerie map $map --quantity class,p-eer,m-lr,period -o $to/panels.png
  rm -f $to/panels.csv # the same numbers as in b-over-a.csv
  if $eerie threshold $map > $to/threshold.txt; then
    # Where no ridge is fitted there is nothing to draw.
    if $eerie threshold $map -o $to/threshold.svg > /dev/null 2>&1; then
      $eerie map $map --quantity p-eer -o $to/p-eer.svg
    else
      rm -f $to/threshold.svg
    fi
  fi
}
draw fig2 1 40
draw fig4 1 50
draw fig6 0.5 50
draw q025 0.25 50
draw phi30 1 30

$eerie threshold $of -o $out/threshold.csv > /dev/null
$eerie check --db $db > $out/check.txt
$eerie odds $of -o $out/odds.svg -o $out/odds.csv > /dev/null
$eerie query $runs --columns $columns -o $out/results.csv
$eerie query $runs --of remnants -o $out/remnants.csv
$eerie sizes $runs -o $out/sizes.svg > /dev/null
python3 $out/beyond/figures.py
python3 $out/page.py $eerie $db
