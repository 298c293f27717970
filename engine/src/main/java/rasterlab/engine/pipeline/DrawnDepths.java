package rasterlab.engine.pipeline;

import rasterlab.engine.transform.Projection;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The depths that are drawn, in eye z: world units from the eye in perspective.
 *
 * @param near the smallest one
 * @param far the largest one, above {@code near}; infinity cuts nothing off
 */
public record DrawnDepths(double near, double far) {
    /** The smallest near depth in perspective, as a share of ρ: what is nearer grows too large. */
    private static final double LEAST_SHARE = 1e-6;

    public DrawnDepths {
        if (Double.isNaN(near))
            throw new IllegalArgumentException(
                    "near must be a number below far, %s, got %s".formatted(far, near));
        if (Double.isNaN(far))
            throw new IllegalArgumentException(
                    "far must be a number above near, %s, got %s".formatted(near, far));
        if (!(near < far))
            throw new IllegalArgumentException(
                    "near must be below far, got near %s, far %s".formatted(near, far));
    }

    /** All that a projection can draw from a distance ρ. */
    public static DrawnDepths all(Projection projection, double rho) {
        boolean central = projection == Projection.PERSPECTIVE;
        return new DrawnDepths(
                central ? ViewedMesh.NEAR_SHARE * rho : Double.NEGATIVE_INFINITY,
                Double.POSITIVE_INFINITY);
    }

    /**
     * @throws IllegalArgumentException if the range reaches the eye of a perspective picture
     */
    public void require(Projection projection, double rho) {
        double least = LEAST_SHARE * rho;
        if (projection == Projection.PERSPECTIVE && !(near >= least))
            throw new IllegalArgumentException(
                    "near must be above 0 in perspective, at least %s for an eye at %s, got %s"
                            .formatted(least, rho, near));
    }
}
