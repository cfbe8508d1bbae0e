#!/bin/sh
# Draws everything in this folder from databases of fig2b-ridge and fig4-ridge by `survey`:
#   docs/notebook/results/make.sh FOLDER_OF_DATABASES     (from the root of the repository, after make run)
# The runs themselves (some two core-hours):
#   eerie run sweeps/fig2b-ridge.json --fidelity survey --set numerics.seed=1 --db FOLDER/fig2b.sqlite
#   eerie run sweeps/fig2b-ridge.json --fidelity survey --set numerics.seed=2 --db FOLDER/fig2b.sqlite
#   eerie run sweeps/fig2b-ridge.json --fidelity auto --db FOLDER/fig2b.sqlite
#   eerie run sweeps/fig4-ridge.json --fidelity survey --db FOLDER/fig4.sqlite
#   for s in fig2a fig2b fig4 phi30 fig6 q025; do
#     eerie run sweeps/table2-$s.json --fidelity sketch --db FOLDER/table2.sqlite; done
set -eu
eerie=${EERIE:-build/eerie}
out=docs/notebook/results
columns=hash,q,phi_d_deg,v_imp_cm_per_s,theta_imp_deg,v_over_v_esc,seed,class,m_lr_over_m_total
columns=$columns,m_slr_over_m_total,b_over_a,c_over_a,period_h,eer,n_eer,n_remnants,settled
columns=$columns,ended_at_s,end_reason,dL_over_L,particle_steps,solver_version,fidelity
for fig in fig2b fig4; do
  db=$1/$fig.sqlite
  of="--db $db --fidelity survey"
  $eerie map $of -o $out/$fig-b-over-a.svg
  $eerie map $of --quantity class,c/a,m-lr,period,n-eer,p-eer -o $out/$fig-panels.png
  rm $out/$fig-panels.csv  # the same numbers as $fig-b-over-a.csv
  $eerie threshold $of -o $out/$fig-threshold.svg > $out/$fig-threshold.txt
  $eerie threshold $of -o $out/$fig-threshold.csv > /dev/null
  $eerie check $of -o $out/$fig-check.md > /dev/null
  $eerie query $of --columns $columns -o $out/$fig-results.csv
  $eerie query $of --of remnants -o $out/$fig-remnants.csv
  $eerie sizes $of -o $out/$fig-sizes.svg -o $out/$fig-sizes.csv
  $eerie catalogue export $of -o $out/$fig-catalogue.csv
done
if [ -e $1/table2.sqlite ]; then
  of="--db $1/table2.sqlite --fidelity sketch"
  $eerie map $of -o $out/table2-sketch.png
  $eerie check $of > $out/table2-check.txt
fi
