package rasterlab.app.coordinates.figure;

import java.util.List;
import rasterlab.engine.raster.PixelMark;

/** One thing drawn in the plane of the stage. */
public sealed interface Mark {
    MarkInk ink();

    record LineMark(StagePoint from, StagePoint to, MarkInk ink) implements Mark {}

    /** Lines through all places. */
    record PathMark(List<StagePoint> places, MarkInk ink) implements Mark {
        public PathMark {
            places = List.copyOf(places);
        }
    }

    record AreaMark(List<StagePoint> corners, MarkInk ink) implements Mark {
        public AreaMark {
            corners = List.copyOf(corners);
        }
    }

    /**
     * @param label at its tip, "" for none
     */
    record ArrowMark(StagePoint from, StagePoint to, MarkInk ink, String label) implements Mark {}

    /**
     * @param label beside it, "" for none
     */
    record DotMark(StagePoint at, MarkInk ink, String label) implements Mark {}

    /** A cross for a place that is computed, such as a vanishing point. */
    record CrossMark(StagePoint at, MarkInk ink, String label) implements Mark {}

    /** A mark around a place where a point is missing, or over one where there should be none. */
    record WrongMark(StagePoint at, PixelMark kind) implements Mark {
        @Override
        public MarkInk ink() {
            return MarkInk.WRONG;
        }
    }

    /** Words whose middle is there. */
    record WordsMark(StagePoint at, MarkInk ink, String label) implements Mark {}

    /** Words that begin there. */
    record Beside(StagePoint at, MarkInk ink, String label) implements Mark {}
}
