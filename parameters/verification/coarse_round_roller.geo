// The same with arcs of 22 degrees: their nodes are on the circle, but they meet at kinks.
lc = 8; fine = 8;
Include "polygon_roller.geo";
Mesh.ElementOrder = 2;
