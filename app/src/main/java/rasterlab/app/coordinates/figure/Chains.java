package rasterlab.app.coordinates.figure;

import java.util.Arrays;
import java.util.List;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.transform.chain.Chain;
import rasterlab.engine.transform.chain.TransformTopic;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.NamedMatrices;

/** Lists of matrices, and points that go through them from left to right. */
public final class Chains {
    private static final TransformTopic TOPIC = new TransformTopic();

    private Chains() {}

    /** Cells row by row of a matrix by its right formula. */
    public static double[] cells(MatrixCall call) {
        double[] numbers = call.numbers().stream().mapToDouble(Double::doubleValue).toArray();
        return flat(NamedMatrices.named(call.name()).rows(numbers));
    }

    public static List<double[]> cells(List<MatrixCall> calls) {
        return calls.stream().map(Chains::cells).toList();
    }

    public static double[] flat(double[][] rows) {
        return Arrays.stream(rows).flatMapToDouble(Arrays::stream).toArray();
    }

    /**
     * Images and H of points, by the method in double.
     *
     * @param matrices cells row by row
     * @param points numbers of each, one after the other
     */
    public static TransformTopic.Output images(
            int dimension, List<double[]> matrices, double[] points) {
        return images(TOPIC.method("double").implementation(), dimension, matrices, points);
    }

    /**
     * @throws IllegalArgumentException when the method refuses
     */
    public static TransformTopic.Output images(
            PointTransformer method, int dimension, List<double[]> matrices, double[] points) {
        var chain = new Chain(dimension, matrices.toArray(double[][]::new), points);
        return TOPIC.record(method, chain, Integer.MAX_VALUE);
    }

    /**
     * Cells of the product, left to right.
     *
     * @param size 3 or 4
     */
    public static double[] product(int size, List<double[]> matrices) {
        if (size == 4) return cells(product(matrices));
        var product = new Matrix3d();
        for (double[] cells : matrices) product.mulLocal(new Matrix3d().set(cells));
        return product.get(new double[9]);
    }

    /** The product of matrices of space, left to right. */
    public static Matrix4d product(List<double[]> matrices) {
        var product = new Matrix4d();
        for (double[] cells : matrices) product.mulLocal(new Matrix4d().set(cells));
        return product;
    }

    /** Cells row by row, as the textbook writes them. */
    public static double[] cells(Matrix4d matrix) {
        return matrix.get(new double[16]);
    }
}
