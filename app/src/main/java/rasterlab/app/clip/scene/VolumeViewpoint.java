package rasterlab.app.clip.scene;

import org.joml.Matrix4d;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.ProjectionMatrices;

/**
 * The direction from which space is looked at: a parallel picture, turned by α about y, then by β
 * about x.
 *
 * @param alphaDegrees α, in [−180, 180]
 * @param betaDegrees β, in [−90, 90]; from above where it is below 0
 */
public record VolumeViewpoint(double alphaDegrees, double betaDegrees) {
    /** The view from the right and above, the eye at the left. */
    public static final VolumeViewpoint FIRST = new VolumeViewpoint(50, -18);

    public VolumeViewpoint {
        if (!(Math.abs(alphaDegrees) <= 180) || !(Math.abs(betaDegrees) <= 90))
            throw new IllegalArgumentException(
                    "alpha must be in [-180, 180] and beta in [-90, 90], got "
                            + alphaDegrees
                            + " and "
                            + betaDegrees);
    }

    /** The viewpoint turned further; β stops at its ends. */
    public VolumeViewpoint turned(double alpha, double beta) {
        return new VolumeViewpoint(
                Math.IEEEremainder(alphaDegrees + alpha, 360),
                Math.max(-90, Math.min(90, betaDegrees + beta)));
    }

    /** Where a point is in the picture. */
    ClipPoint picture(SpacePoint p) {
        Matrix4d m = matrix();
        return new ClipPoint(
                p.x() * m.m00() + p.y() * m.m10() + p.z() * m.m20(),
                p.x() * m.m01() + p.y() * m.m11() + p.z() * m.m21());
    }

    /** The point moved parallel to the picture so that it is seen at that place. */
    SpacePoint lifted(SpacePoint p, ClipPoint picture) {
        Matrix4d m = matrix();
        ClipPoint now = picture(p);
        double right = picture.x() - now.x();
        double up = picture.y() - now.y();
        return new SpacePoint(
                p.x() + right * m.m00() + up * m.m01(),
                p.y() + right * m.m10() + up * m.m11(),
                p.z() + right * m.m20() + up * m.m21());
    }

    /**
     * Whether a face is turned to whom looks at the picture. x, y, z are a left-handed frame: z
     * points away from whom sees x to the right and y upwards.
     *
     * @param outward normal of the face
     */
    public boolean faces(SpacePoint outward) {
        double alpha = Math.toRadians(alphaDegrees);
        double beta = Math.toRadians(betaDegrees);
        double toX = Math.sin(alpha) * Math.cos(beta);
        double toY = -Math.sin(beta);
        double toZ = -Math.cos(alpha) * Math.cos(beta);
        return outward.x() * toX + outward.y() * toY + outward.z() * toZ > 0;
    }

    private Matrix4d matrix() {
        return ProjectionMatrices.trimetric(
                Angle.ofDegrees(alphaDegrees), Angle.ofDegrees(betaDegrees));
    }
}
