// wedge, half angle alpha with tan = 0.2, half model x>0 ; apex cut at y=-5..0 ; faces at x = 2+0.2*(y+5)...
Point(1)={0,0,0,.5}; Point(2)={2,0,0,.5}; Point(3)={3,5,0,.5}; Point(4)={0,5,0,.5};
Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,1};
Curve Loop(1)={1,2,3,4}; Plane Surface(1)={1}; Recombine Surface{1}; Mesh.SubdivisionAlgorithm=1;
Physical Curve("bottom")={1}; Physical Curve("flank")={2}; Physical Curve("top")={3}; Physical Curve("mid")={4}; Physical Surface("w")={1};
