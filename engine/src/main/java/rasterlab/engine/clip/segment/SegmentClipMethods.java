package rasterlab.engine.clip.segment;

import java.util.List;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.study.Method;

/** The methods that clip a segment, in teaching order; each is a {@link SteppedSegmentClipper}. */
final class SegmentClipMethods {
    private SegmentClipMethods() {}

    static List<Method<SegmentClipper>> all() {
        return List.of(
                Method.right("four-lines", new FourLines()),
                Method.failing("cohen-sutherland-textbook", new CohenSutherlandTextbook()),
                Method.failing(
                        "cohen-sutherland-nested-textbook", new CohenSutherlandNestedTextbook()),
                Method.failing(
                        "cohen-sutherland-float-textbook", new CohenSutherlandFloatTextbook()),
                Method.right("cohen-sutherland", new CohenSutherland()),
                Method.right("liang-barsky", new LiangBarsky()),
                Method.right("liang-barsky-branchless", new BranchlessLiangBarsky()),
                Method.right("midpoint", new MidpointClip()),
                Method.right("cyrus-beck", new CyrusBeck()));
    }
}
