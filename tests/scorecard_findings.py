"""What the scorecard (scorecard.py) found: why rows are red, and what it cannot run. Numbers with DoFs are of finer meshes than those of the table, run by hand."""

HEAD = """References are closed forms, computed anew by the script, or numbers that others have
published or computed. Lengths in mm, forces in N, plane forces per thickness. Where a row has no reference, its error is the norm of a difference."""

BOUNDS = """A row is green where its error is at most `floor` + `estimate`:

| | | from |
|---|---|---|
| estimate | of pressures, sizes and forces `error_estimate.contact`; of shears and slips `error_estimate.shear`; of displacements, stresses and what a singular pressure gives `error_estimate.bulk`; with friction also what `increments` says of the quantity | the program: `summary.json` of the same run |
| finite block | of a, plane: 0.38 (a/H)^2; axisymmetric: 0.19 (a/H)^3, of p0 0.39 (a/H)^3; of the approach 0.52 a/H, of which 1 % is left (two digits) where it is taken off | measured for a rigid parabola on a block of half-width = height = H, far face fixed; for other bodies H is the nearest there is, and each body has its share of the compliance |
| circle for parabola | of a: 3/16 (a/R)^2, spheres 2/15 (a/R)^2 | half-plane elasticity, true circle |
| both, of an L2 norm | the change of the ellipse by that part of a: more, since its edge is steep | integral |
| digits | half a unit of the last digit | the published number |
| half a face | the end of a zone of states lies between two nodes | the nodes of the run |
| plate of 30 radii | (R/R_out)^2 | Persson's plate is infinite |
| height of the bar, thickness of the strip | (h tau/F)^2; h/(2 R) | a bar has no height, a rope no thickness |
| shortest increment | 1e-4 of the end time | `Minimum increment` |
| the solver's tolerance | 1e-9 | `Contact solver/Tolerance` |

The estimate is that of the whole pressure or stress in the mean square. For single numbers, as a force, it is generous: how far below the bound an error is says more than the colour. `a` is measured twice:
from the spread of nodal forces (`contact.csv`; of second order, but with a larger constant, since the forces are those of the nodes' dual functions), and by the program's integral of the pressure (`contact_size`)."""

PIN = (
    "two things. With the pin as slave, as here, recovery alone sees a third of the error (0.010, 0.0068, 0.0035 for 0.039, 0.021, 0.014 on uniform meshes); with the difference of meshes it is enough for the smaller loads, not quite "
    "for this one. With the plate as slave recovery says up to twelve times too much (0.43, 0.23, 0.098 for 0.035, 0.021, 0.015). And where the size of cells changes in the midst of the contact, single nodes are off by 0.108 of a peak "
    "of 0.70 after one refinement, 0.040 after three, 0.019 after seven (E1* dR/Q = 1), with penalty, linear elements, finite strain and without clearance as well; on uniform meshes, matching or not, by 0.012 at most. Of the hanging "
    "nodes beside the contact, then; the cause is not known. A defect of the program; the semi-angle and p(0) do not suffer from it"
)

EXPLAINED = {
    ("1a", "largest shear stress on the axis"): "model. The block adds a horizontal stress of first order in a/H, which the floor, that of a, does not know: with blocks of H = 10, 40, 160 the value converges to 816.6, 800.0, 796.1 "
    "(half plane: 794.2). The box below has no such error.",
    ("1b", "largest nodal pressure"): "model, in part: halves of disks that end at their centre are no blocks. With 22424 DoFs a and p0 end at 1.1e-3 from the half planes (the block's floor: 2.2e-4), this at 1.8e-3; the rest "
    "falls with the mesh, 4.5e-3, 4.0e-3, 2.0e-3, 1.8e-3 on four.",
    ("2a", "pressure, L2 to 1.3 a"): "discretisation: the true error is 1.1 times the bound on this mesh. It falls with the mesh.",
    ("punch", "in space, either slave"): "the table `contact.csv` says 0 at the node (2.1, 0.75) of the foundation, which is 0.03 from one edge of the punch and 0.05 from another: a node counts as covered if no edge is within about "
    "a tenth of a face. Its force is that of the pressure 5 (next row), and so is the pressure of the solution (`pressure_l2` 2e-11): a rule of the output that is too strict at corners.",
    ("pin", "pressure, L2 to 1.3 eps, 10"): PIN + ".",
    ("CM .9", "c/a"): "the measure: (c/a)^4 = 0.01 is what is left of 1 less a moment of nodal forces, so that 4e-4 of the moment is 1e-2 of c. By the program's integral it is within 5e-4 (last but one row).",
    ("box", "half-width a"): "the measure: the spread of nodal forces has a larger constant than the pressure, whose estimate is the bound here (and no longer told too large); "
    "the program's own `contact_size` is right to 1e-5.",
    ("GRECO", "slips to x"): "converged: 29.77, 29.84, 29.854, 29.856 with 3014, 4652, 8806 DoFs and here, where faces are 0.005 long; the reference has one digit after the point.",
    ("roller mu", "c, one increment (known to be wrong)"): "0.879 still sticks and 0.903 slips on the finest mesh (14452 DoFs; 0.977 and 1.17 on one of 4690). The reference is 0.87, of another program in one increment; how much of an increment counts as slip "
    "at a node that closes in it is a matter of the method.",
    ("punch NAFEMS", "contact ends at r"): "with 20230 DoFs the last node in contact is at 40.411, the next at 40.414: the reference, 40.40, is 3e-4 smaller. The mesh of the reference is not known.",
    ("punch mu", "sticks to r"): "the end of the stick zone comes in with the mesh: between 17.19 and 17.58 here (78428 DoFs), between 16.99 and 17.19 with 310964. It is known to a face; the reference's 16.9 is 0.5 % from the last.",
    ("MOOSE", "half force"): "converged: 344.7437, 344.7428, 344.7427 with 4786, 15790, 29244 DoFs, 5.1e-4 from the reference. A parabola in place of the circle changes it by 2e-5. With finite strain it is 344.83 (neo-Hookean) or 343.66 "
    "(St. Venant-Kirchhoff): MOOSE's input has finite strain with a law in rates, and the number is in the range of such laws. Open whether the reference is of small strain.",
}

CANNOT = [
    ("deal.II step-42, step-41 as running peers", "programs of their own, which this does not build"),
    ("CalculiX, GetFEM, MOOSE", "their numbers are quoted; they are not run"),
    ("peers.csv IR3, ironing in space", "no reference value: CalculiX's die locks (3.92, 1.32; 3.15, 1.05 with other elements), ours has 2.83, 0.865 ([results](results.md)); 2.4 minutes"),
    ("peers.csv IR2 at full resolution", "80 s; here with cells twice as long and slide 7"),
    ("peers.csv, rows 'tie' and 'linear', rows of two threads", "one linear solve or seconds: no answer that has a reference"),
    ("Mindlin's whole tangential approach delta_t", "refers to points far away in half spaces; of blocks only what is not linear in Q can be compared"),
    ("NAFEMS CGS-4 with mu = 0", "there is an equilibrium at F/G = 0.1 only; a stop takes what is left of it instead"),
    ("floating slab with E = 1000", "small strain leaves out 0.13 there, so that the program ends with *not converged: kinematics* (after N = 800, T = -120); with E = 1e6 the same forces and pressures"),
    ("approach in the plane", "depends on the size of the bodies (logarithm): no reference"),
]


def explanation(case, quantity):
    return EXPLAINED.get((case, quantity), "")
