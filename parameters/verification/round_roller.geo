// The same as a mesh of second order: its nodes are on the circle.
Include "polygon_roller.geo";
Mesh.ElementOrder = 2;
