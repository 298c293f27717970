package rasterlab.contract;

/**
 * Shades points of a triangle, by {@link PointShader}'s formula with Phong's r·v.
 *
 * <p>What is right is that formula at each point, with the corners' normals mixed by the point's
 * weights and brought to length 1, and the true directions to lamp and eye. Methods save work by
 * evaluating it elsewhere.
 */
@FunctionalInterface
public interface FaceShader {
    /**
     * Red, green and blue of each point.
     *
     * @param weights of the three corners, for each point: none negative, with the sum 1 up to
     *     rounding; the point is the mean of the corners by these weights
     * @return three shares from 0 to 1 of each point, one after the other
     * @throws IllegalArgumentException if a normal or direction that is needed is (0, 0, 0); the
     *     message names it
     */
    double[] shade(LitFace face, double[] weights);
}
