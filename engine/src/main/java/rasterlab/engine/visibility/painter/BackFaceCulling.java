package rasterlab.engine.visibility.painter;

import java.util.stream.IntStream;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityWalk;

/**
 * Faces that turn their outer side to the eye, in the order of the mesh.
 *
 * <p>A face shows its outer side when n·p &lt; 0 for a point p of it seen from the eye, or n_z &lt;
 * 0 in parallel projection. Of one convex body that is all there is to do; of others it leaves
 * about half of the faces to another method.
 *
 * <p>Source: I. E. Sutherland, R. F. Sproull, R. A. Schumacker, A characterization of ten
 * hidden-surface algorithms, ACM Computing Surveys, 1974, pp. 1–55.
 */
final class BackFaceCulling implements SteppedVisibility {
    @Override
    public boolean drawsOutlines() {
        return true;
    }

    @Override
    public String decision() {
        return "n·p in perspective, n_z in parallel projection; not above 0 for the outer side";
    }

    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        var tally = new Tally();
        tally.comparisons = view.mesh().faceCount();
        int[] order =
                IntStream.range(0, view.mesh().faceCount())
                        .filter(face -> !view.seenFromInside(face))
                        .toArray();
        return new FaceSequence(view, order, facing(view), tally, paint, out);
    }

    /** The number whose sign tells the side of each face. */
    static double[] facing(ViewedMesh view) {
        boolean central = view.transform().central();
        return IntStream.range(0, view.mesh().faceCount())
                .mapToDouble(face -> central ? view.planeOffset(face) : view.eyeNormal(face, 2))
                .toArray();
    }
}
