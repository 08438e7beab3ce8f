# A loop on a sphere: R = 1 mm, E* = 1 MPa; W = 30 mJ/m² of loading, W (1 + (v/100 µm/s)^0.6) of unloading, the edge ever faster.
function sample(radius, work,    force, depth) {
  force = radius > 0 ? 4 * modulus * radius ^ 3 / (3 * lens) - sqrt(8 * pi * work * modulus * radius ^ 3) : 0
  depth = radius > 0 ? radius ^ 2 / lens - sqrt(2 * pi * radius * work / modulus) : position
  printf "%.6g,%.6g,%.6g,%.6g\n", time, force + 2e-8 * sin(++n * n), depth, radius
  time += 0.1
}
BEGIN {
  pi = 3.14159265358979; modulus = 1e6; lens = 1e-3; work = 0.03
  print "time [s],force [N],displacement [m],contact_radius [m]"
  for (position = -6e-6; position < -1e-9; position += 1e-7) sample(0)
  for (radius = 6.4e-5; radius <= 2e-4; radius += 6.8e-7) sample(radius, work)
  radius = 2e-4
  for (speed = 1e-7; radius > 1.1e-4; speed *= 1.028) sample(radius -= speed * 0.1, work * (1 + (speed / 1e-4) ^ 0.6))
  for (position = -3e-6; position > -6e-6; position -= 1e-7) sample(0)
}
