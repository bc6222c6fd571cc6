// Two unit squares, one on the other with flush sides, that overlap by `overlap`; each has one name for all of its boundary.
overlap = 0.01;
n = 4;  // cells a side of the lower one
m = 5;  // of the upper one

Macro Square
  p = newp;
  Point(p) = {0, y, 0}; Point(p + 1) = {1, y, 0}; Point(p + 2) = {1, y + 1, 0}; Point(p + 3) = {0, y + 1, 0};
  l = newl;
  Line(l) = {p, p + 1}; Line(l + 1) = {p + 1, p + 2}; Line(l + 2) = {p + 2, p + 3}; Line(l + 3) = {p + 3, p};
  loop = newll;
  Curve Loop(loop) = {l : l + 3};
  s = news;
  Plane Surface(s) = {loop};
  Transfinite Curve {l : l + 3} = cells + 1;
  Transfinite Surface {s};
  Recombine Surface {s};
Return

y = 0; cells = n;
Call Square;
Physical Surface("lower", 1) = {s};
Physical Curve("lower_all", 11) = {l : l + 3};
y = 1 - overlap; cells = m;
Call Square;
Physical Surface("upper", 2) = {s};
Physical Curve("upper_all", 21) = {l : l + 3};
