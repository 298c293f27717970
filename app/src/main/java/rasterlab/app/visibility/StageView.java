package rasterlab.app.visibility;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** What the stage shows. */
public enum StageView {
    /** The picture. */
    COLOURS,
    /** The depths that the method keeps; where it keeps none, those of the usual buffer. */
    DEPTHS,
    /** How the methods' work grows. */
    GROWTH,
    /** What depth buffers tell apart. */
    PRECISION;

    String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    boolean isChart() {
        return this == GROWTH || this == PRECISION;
    }

    static List<String> codes() {
        return Arrays.stream(values()).map(StageView::code).toList();
    }

    static StageView coded(String code) {
        return Named.find("view", code, List.of(values()), StageView::code);
    }
}
