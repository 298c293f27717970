package rasterlab.contract;

/**
 * Writes down a matrix of the course by its name.
 *
 * <p>Points are rows: a point times the matrix is its image. The matrix has 3 rows of 3 numbers for
 * names of the plane, {@code [x y 1] · M}, and 4 rows of 4 otherwise, {@code [x y z 1] · M}; the
 * image's last number w divides the others where it is not 1. In what follows x', y', z' and w are
 * the numbers of the image, undivided; what is not told stays as it is, and w is 1.
 *
 * <p>The plane:
 *
 * <ul>
 *   <li>IDENTITY2D
 *   <li>ROT2D(angle): x' = x·cos − y·sin, y' = x·sin + y·cos
 *   <li>SCALE2D(x, y): x and y times the two numbers
 *   <li>REFL2DX, REFL2DY: in the x axis, y' = −y; in the y axis, x' = −x
 *   <li>SHEAR2D(b, c): x' = x + c·y, y' = b·x + y
 *   <li>TRANSL2D(m, n): x' = x + m, y' = y + n
 * </ul>
 *
 * <p>Space:
 *
 * <ul>
 *   <li>IDENTITY
 *   <li>ROT3DX(angle), ROT3DY(angle), ROT3DZ(angle): about x turns y towards z, about y turns z
 *       towards x, about z turns x towards y
 *   <li>SCALE3DX(a), SCALE3DY(e), SCALE3DZ(j): one coordinate times the number
 *   <li>SCALE3D(s): w = s, so that everything is scaled by 1/s; s is not 0
 *   <li>REFL3DXY, REFL3DYZ, REFL3DZX: in the plane of the two axes
 *   <li>TRANSL3D(l, m, n): x' = x + l, y' = y + m, z' = z + n
 *   <li>ROTAXIS(through, direction, angle): about the line through a point in a direction of any
 *       length but 0
 * </ul>
 *
 * <p>Projections:
 *
 * <ul>
 *   <li>ORTHOX(l), ORTHOY(t), ORTHOZ(n): x' = l, y' = t, z' = n
 *   <li>FRONT: z' = 0
 *   <li>BACK: y' = −y, z' = −z
 *   <li>LEFT: x' = z, z' = −x
 *   <li>RIGHT: x' = −z, z' = x
 *   <li>TOP: y' = −z, z' = y
 *   <li>BOTTOM: y' = z, z' = −y
 *   <li>TRIMETRIC(alpha, beta): ROT3DY(alpha) · ROT3DX(beta)
 *   <li>DIMETRIC: TRIMETRIC with sin² beta = 1/8 and sin² alpha = 1/7, both angles acute
 *   <li>ISOMETRIC: TRIMETRIC with sin² beta = 1/3 and alpha = 45°
 *   <li>CAVALIER: x' = x − z·cos 45°, y' = y − z·cos 45°; CABINET: the same with half of it
 *   <li>PERSPECTIVE(p, q, r): w = p·x + q·y + r·z + 1
 *   <li>CENTRAL(k): x' = k·x, y' = k·y, w = z + k; k is not 0
 *   <li>CENTRAL_ORIGIN(k): x' = k·x, y' = k·y, w = z; k is not 0
 *   <li>NORMALIZE(a, xscreen, yscreen, zmax): x' = x·a/(xscreen·zmax), y' = y·a/(yscreen·zmax), z'
 *       = z/zmax; all four are above 0
 *   <li>CANONICAL(zmin): z' = (z − zmin)/(1 − zmin), w = z; zmin is above 0 and below 1
 * </ul>
 *
 * <p>From the world to the eye and to the window:
 *
 * <ul>
 *   <li>VIEW_LEFT(theta, phi, rho): to the eye space of {@link EyeView}, y up; VIEW_RIGHT(theta,
 *       phi, rho): the same with y down; rho is above 0
 *   <li>LOOKAT(eye, center, up): eye at the origin, center on the negative z axis, up in the plane
 *       of y and z with y above 0, x to the right; center differs from eye, and up lies at least
 *       10⁻⁸ radians off the line of sight
 *   <li>GL_ORTHO(left, right, bottom, top, near, far): the box left to right, bottom to top, −near
 *       to −far becomes −1 to 1 in x, y and z
 *   <li>GL_FRUSTUM(left, right, bottom, top, near, far): the cut pyramid from the origin through
 *       left to right, bottom to top at z = −near, up to z = −far, becomes the same box with w =
 *       −z; near and far are above 0
 *   <li>GL_PERSPECTIVE(fovy, aspect, near, far): GL_FRUSTUM with top = −bottom = near·tan(fovy/2)
 *       and right = −left = aspect·top; fovy is above 0 and below 180
 *   <li>VIEWPORT(x, y, width, height, n, f): x' = x + width·(1 + x of the point)/2 and y' likewise,
 *       z' = n + (f − n)·(1 + z)/2; width and height are above 0, n and f from 0 to 1
 * </ul>
 *
 * <p>Cubic curves, {@code [t³ t² t 1] · M · G} being a point of the curve:
 *
 * <ul>
 *   <li>HERMITE: the rows of G are the ends P1, P4 and the tangents R1, R4 there
 *   <li>BEZIER: the rows of G are four points P1 to P4
 *   <li>HERMITE_BEZIER: M · G are P1, P4, R1 and R4 of the curve with the four points of G
 * </ul>
 *
 * <p>Left and right, bottom and top, near and far differ, except n and f of VIEWPORT. An entry may
 * be off by the rounding of its own formula, or by what an exercise allows.
 */
@FunctionalInterface
public interface MatrixFormula {
    /**
     * The rows of the matrix.
     *
     * @param name upper-case, one of those above
     * @param parameters all numbers in the order of the name's parameters, a point or direction
     *     being three of them; angles in degrees, positive ones counter-clockwise seen from the
     *     axis's positive end
     * @return a new array
     * @throws IllegalArgumentException if there is no such name, or a parameter is missing, not
     *     finite or out of its range, or an entry is too large for a double; the message names it,
     *     its value and the range
     */
    double[][] rows(String name, double... parameters);
}
