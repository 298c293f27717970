package rasterlab.exercises.graded;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.segment.ClipWindow;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.clip.segment.SegmentsInWindow;
import rasterlab.exercises.drawing.PlaneFigure;
import rasterlab.exercises.drawing.PlanePictures;
import rasterlab.exercises.drawing.YAxis;
import rasterlab.exercises.judging.ByTopic;
import rasterlab.exercises.score.CasePicture;

/** Grades the topic {@code clip-segment}; draws what is left of each segment. */
public final class ClipGrading extends ByTopic<SegmentClipper, SegmentsInWindow, ClippedEnds> {
    /** The most that a right end may be off, in window sizes. */
    private static final double RIGHT = 1e-12;

    public ClipGrading() {
        super(new SegmentClipTopic(), new PlainClip());
    }

    @Override
    protected List<CasePicture> pictures(
            SegmentsInWindow input, ClippedEnds exact, ClippedEnds actual) {
        ClipWindow window = input.window();
        var given = new ArrayList<PlaneFigure>();
        given.add(PlaneFigure.window(window.xmin(), window.ymin(), window.xmax(), window.ymax()));
        for (double[] s : input.segments()) given.add(PlaneFigure.segment(s[0], s[1], s[2], s[3]));
        return PlanePictures.of(given, left(exact), left(actual), RIGHT * window.unit(), YAxis.UP);
    }

    private static List<PlaneFigure> left(ClippedEnds ends) {
        return ends.parts().stream()
                .flatMap(Optional::stream)
                .map(one -> PlaneFigure.segment(one[0], one[1], one[2], one[3]))
                .toList();
    }
}
