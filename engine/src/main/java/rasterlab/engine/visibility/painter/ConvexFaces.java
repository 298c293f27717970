package rasterlab.engine.visibility.painter;

import java.util.stream.IntStream;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityWalk;

/**
 * One convex closed body: the faces that turn their outer side to the eye hide nothing of each
 * other and are drawn unsorted.
 *
 * <p>Inner sides are drawn before them only where they can be seen: through a transparent face, or
 * where the near plane or a clip plane cuts the body open.
 *
 * <p>Source: I. E. Sutherland, R. F. Sproull, R. A. Schumacker, A characterization of ten
 * hidden-surface algorithms, ACM Computing Surveys, 1974, pp. 1–55.
 */
final class ConvexFaces implements SteppedVisibility {
    @Override
    public boolean drawsOutlines() {
        return true;
    }

    @Override
    public String decision() {
        return "n·p in perspective, n_z in parallel projection; not above 0 for the outer side";
    }

    /**
     * @throws IllegalArgumentException unless the mesh is one convex closed body; the message names
     *     faces that show it
     */
    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        ConvexBody.require(view.mesh());
        var tally = new Tally();
        int faces = view.mesh().faceCount();
        tally.comparisons = faces;
        IntStream outer = IntStream.range(0, faces).filter(face -> !view.seenFromInside(face));
        IntStream inner =
                insideShows(view, paint)
                        ? IntStream.range(0, faces).filter(view::seenFromInside)
                        : IntStream.empty();
        int[] order = IntStream.concat(inner, outer).toArray();
        return new FaceSequence(view, order, BackFaceCulling.facing(view), tally, paint, out);
    }

    private static boolean insideShows(ViewedMesh view, FacePaint paint) {
        return view.cutsOpen()
                || IntStream.range(0, view.mesh().faceCount())
                        .anyMatch(face -> !paint.opaque(face));
    }
}
