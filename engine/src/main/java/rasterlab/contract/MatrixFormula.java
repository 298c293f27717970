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
     * @param name upper-case, such as ROT3DX
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
