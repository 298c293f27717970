package rasterlab.engine.transform.matrix;

import java.util.Optional;
import java.util.function.Function;
import org.joml.Matrix3d;
import org.joml.Matrix4d;

/**
 * The inverse of a named matrix, in words and as a formula of the same parameters.
 *
 * @param text the inverse in terms of named matrices, or why there is none
 * @param cells all cells row by row, not finite where there is no inverse; empty where there never
 *     is one
 */
public record MatrixInverse(String text, Optional<Function<double[], double[]>> cells) {
    /** The answer for a matrix that flattens space, which has none. */
    static final MatrixInverse NONE = new MatrixInverse("none: it flattens", Optional.empty());

    static MatrixInverse space(String text, Function<double[], Matrix4d> formula) {
        return new MatrixInverse(
                text, Optional.of(numbers -> formula.apply(numbers).get(new double[16])));
    }

    /** The inverse of turns and reflections: rows and columns exchanged. */
    static MatrixInverse transpose(Function<double[], Matrix4d> formula) {
        return space("its transpose", numbers -> formula.apply(numbers).transpose());
    }

    static MatrixInverse plane(String text, Function<double[], Matrix3d> formula) {
        return new MatrixInverse(
                text, Optional.of(numbers -> formula.apply(numbers).get(new double[9])));
    }
}
