# answer.sh SETAE FOLDER: makes the tutorial's data, drafts their study, answers what the draft asks, and runs it.
set -e
cd "$(dirname "$0")/../../.."
"$1" lab make examples/tutorial/recipe.toml -o "$2/mine" > "$2/made"
"$1" study init "$2/mine" -o "$2/draft.toml" > "$2/drafted"
sed -e '/^# Left out:/,$d' \
  -e 's/^# tip_radius = "?" *# such as "10.*/tip_radius = "10 ± 0.5 nm"/' -e 's/^# tip_radius = "?" *# such as "5.*/tip_radius = "5 ± 0.2 um"/' \
  -e 's/^# \(\[\|[a-z_]* = \)/\1/' -e '/^power_spectrum/d' \
  -e 's/^youngs_modulus = "?"/youngs_modulus = "1100 GPa"/' -e 's/^poisson_ratio = "?"/poisson_ratio = "0.06"/' \
  -e 's/^surface_energy = "?"/surface_energy = "25 ± 1 mJ\/m2"/' -e 's/^sphere_radius = "?"/sphere_radius = "1.25 mm"/' "$2/draft.toml" > "$2/answered.toml"
"$1" study "$2/answered.toml" --dry-run > "$2/plan"
! grep -q '^Missing' "$2/plan"
"$1" study "$2/answered.toml" --no-figures --json
