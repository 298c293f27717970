package rasterlab.app.clip;

import java.util.List;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.PlaneFigures;

/** One thing in the picture, in plane coordinates; {@link ClipPainter} knows how it looks. */
sealed interface ClipMark {
    /** The meaning of a line or an area. */
    enum MarkMeaning {
        /** The window or volume and its sides. */
        WINDOW,
        /** An edge of the volume behind the others. */
        HIDDEN,
        /** A line that helps the eye: a side beyond its corners, a ray from the eye. */
        HELP,
        /** The figure that is to be clipped. */
        GIVEN,
        /** The part that the method left. */
        LEFT,
        /** The part that the method has not yet cut off. */
        STEP,
        /** The side that the step tests. */
        TESTED,
        /** The part that is missing. */
        MISSING,
        /** The part that is too much. */
        EXTRA,
        /** The part that only the first of two methods left. */
        ONLY_FIRST,
        /** The part that only the second one left. */
        ONLY_SECOND
    }

    /** The meaning of a sign's shape. */
    enum SignShape {
        /** A filled arrow head: the segment enters here. */
        ENTERING,
        /** A hollow arrow head: it leaves here. */
        LEAVING,
        /** A dot: this point is tested. */
        TESTED,
        /** An eye. */
        EYE
    }

    /** A line through points in turn, and back to the first one if it is closed. */
    record MarkedLine(List<ClipPoint> points, boolean closed, MarkMeaning ink) implements ClipMark {
        static MarkedLine of(double[] ends, MarkMeaning ink) {
            return new MarkedLine(PlaneFigures.points(ends), false, ink);
        }
    }

    /** The inside of a closed line. */
    record MarkedArea(List<ClipPoint> corners, MarkMeaning ink) implements ClipMark {}

    /**
     * A sign.
     *
     * @param dx the way an arrow head points, with dy
     * @param words beside it, "" for none
     */
    record MarkedSign(ClipPoint at, double dx, double dy, SignShape shape, String words)
            implements ClipMark {}

    /** Words in the middle of what is seen of a region, whose ends may be infinite. */
    record Region(double xmin, double ymin, double xmax, double ymax, String words)
            implements ClipMark {}
}
