package rasterlab.contract;

/**
 * Writes down a matrix of the course by its name.
 *
 * <p>Points are rows: a point times the matrix is its image. The matrix has 3 rows of 3 numbers for
 * transformations of the plane ({@code [x y 1] · M}) and 4 rows of 4 otherwise ({@code [x y z 1] ·
 * M}); HERMITE and BEZIER stand between {@code [t³ t² t 1]} and four rows of points or tangents.
 */
@FunctionalInterface
public interface MatrixFormula {
    /**
     * The rows of the matrix.
     *
     * @param name upper-case. Of the plane: IDENTITY2D, ROT2D(angle), SCALE2D(x, y), REFL2DX,
     *     REFL2DY, SHEAR2D(b, c), TRANSL2D(m, n). Of space: IDENTITY, ROT3DX, ROT3DY and
     *     ROT3DZ(angle), SCALE3DX(a), SCALE3DY(e), SCALE3DZ(j), SCALE3D(s), REFL3DXY, REFL3DYZ,
     *     REFL3DZX, TRANSL3D(l, m, n), ROTAXIS(through, direction, angle). Further names, of
     *     projections, views and curves, stand with parameters and meaning in what {@code ./lab
     *     methods matrix} prints
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
