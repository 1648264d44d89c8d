# Sourced: an empty folder with a small plan, the set that an undisturbed run makes of it, and how
# others are held to it. Arguments: the command, the source tree, the folder.
set -eu
craze=$1 source=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$work"
cat >plan.toml <<'END'
samples = 24
shard_samples = 2
clean = 0.2
width = 192
height = 160
[object]
mesh = "shape:plate?n=20&jitter=0.3"
[recipe]
preset = "mud"
layer.relative_spacing = {uniform = [0.2, 0.4]}
END
"$craze" dataset plan.toml -o undisturbed --quiet

# The same files with the same bytes, but for where the plan lay.
expect_same() {
  diff -r -x made_by.json undisturbed "$1" >differences || {
    head -5 differences
    exit 1
  }
  "$craze" dataset verify "$1" --quiet
}
