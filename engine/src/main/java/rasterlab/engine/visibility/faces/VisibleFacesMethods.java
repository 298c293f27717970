package rasterlab.engine.visibility.faces;

import java.util.List;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.study.Method;

/** The methods that tell which faces are turned towards the eye, in teaching order. */
final class VisibleFacesMethods {

    private VisibleFacesMethods() {}

    static List<Method<VisibleFaces>> all() {
        return List.of(
                Method.right("back-face", new BackFace()),
                Method.failing("convex-segment-textbook", new ConvexSegmentTextbook()),
                Method.right("convex-segment", new ConvexSegment()));
    }
}
