package rasterlab.engine.visibility.painter;

import java.util.stream.IntStream;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.FaceMiddle;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityWalk;

/**
 * The painter's algorithm: faces from the farthest to the nearest, each over the ones before.
 *
 * <p>Depth of a face is the mean z of all its corners in eye space; equal ones keep the order of
 * the mesh. A mean cannot order faces that overlap in depth, which is where this method errs.
 */
public final class Painter implements SteppedVisibility {

    @Override
    public boolean drawsOutlines() {
        return true;
    }

    @Override
    public String decision() {
        return "mean z of the face's corners";
    }

    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        var tally = new Tally();
        double[] depth = meanZ(view);
        int[] all = IntStream.range(0, depth.length).toArray();
        int[] order = farthestFirst(depth, all, tally);
        return new FaceSequence(view, order, depth, tally, paint, out);
    }

    /**
     * Sorts faces, the farthest first, equal ones in the given order.
     *
     * @param depth of each face of the mesh
     * @param tally gets the comparisons
     */
    public static int[] farthestFirst(double[] depth, int[] faces, Tally tally) {
        return IntStream.of(faces)
                .boxed()
                .sorted(
                        (a, b) -> {
                            tally.comparisons++;
                            return Double.compare(depth[b], depth[a]);
                        })
                .mapToInt(Integer::intValue)
                .toArray();
    }

    /** The mean z of each face's corners. */
    public static double[] meanZ(ViewedMesh view) {
        return IntStream.range(0, view.mesh().faceCount())
                .mapToDouble(face -> FaceMiddle.of(view.mesh(), face, view::eyeZ))
                .toArray();
    }
}
