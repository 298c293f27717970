package rasterlab.engine.visibility.buffer;

import java.util.stream.IntStream;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.painter.Painter;

/**
 * The order in which a depth buffer draws faces: opaque ones as the mesh has them, then transparent
 * ones, the farthest mean z first. Where these pierce each other a mean cannot order them.
 *
 * @param faces all of them
 * @param opaque how many are opaque
 */
record OpaqueFirst(int[] faces, int opaque) {
    static OpaqueFirst of(ViewedMesh view, FacePaint paint, Tally tally) {
        int faces = view.mesh().faceCount();
        int[] hiding = IntStream.range(0, faces).filter(paint::opaque).toArray();
        if (hiding.length == faces) return new OpaqueFirst(hiding, faces);
        int[] seenThrough = IntStream.range(0, faces).filter(face -> !paint.opaque(face)).toArray();
        int[] sorted = Painter.farthestFirst(Painter.meanZ(view), seenThrough, tally);
        int[] all = IntStream.concat(IntStream.of(hiding), IntStream.of(sorted)).toArray();
        return new OpaqueFirst(all, hiding.length);
    }
}
