package rasterlab.app.clip;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Vector4d;
import rasterlab.app.clip.scene.SpacePoint;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.engine.transform.ProjectionMatrices;

/**
 * The two normalisations of a view volume and a segment's ends on their way through them.
 *
 * @param normalize NORMALIZE in the textbook's layout, row by row
 * @param canonical CANONICAL, the same
 * @param ends for each end of the first segment in turn: in the eye's space, normalised, times
 *     CANONICAL, and divided by H; x, y, z, H of each
 */
record VolumeNumbers(double[] normalize, double[] canonical, List<double[]> ends) {
    /** Rows of {@link #ends} for one end. */
    static final int STAGES = 4;

    static VolumeNumbers of(VolumeScene scene) {
        Matrix4d normalize = scene.screen().normalize();
        Matrix4d canonical = ProjectionMatrices.canonical(scene.zmin());
        Matrix4d back = new Matrix4d(normalize).invert();
        var ends = new ArrayList<double[]>();
        for (int end = 0; end < 2; end++) {
            SpacePoint p = scene.segments().get(0).end(end);
            var normalized = new Vector4d(p.x(), p.y(), p.z(), 1);
            Vector4d clip = canonical.transform(new Vector4d(normalized));
            ends.add(numbers(back.transform(new Vector4d(normalized))));
            ends.add(numbers(normalized));
            ends.add(numbers(clip));
            ends.add(numbers(new Vector4d(clip).div(clip.w)));
        }
        return new VolumeNumbers(rows(normalize), rows(canonical), ends);
    }

    private static double[] numbers(Vector4d p) {
        return new double[] {p.x, p.y, p.z, p.w};
    }

    /** The textbook's rows are JOML's columns, which it lists one after the other. */
    private static double[] rows(Matrix4d matrix) {
        return matrix.get(new double[16]);
    }
}
