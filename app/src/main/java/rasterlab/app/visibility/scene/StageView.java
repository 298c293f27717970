package rasterlab.app.visibility.scene;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** The view that the stage shows. */
public enum StageView {
    /** The picture. */
    @JsonProperty("COLOURS")
    COLORS,
    /** The depths that the method keeps; where it keeps none, those of the usual buffer. */
    DEPTHS,
    /** How the methods' work grows. */
    GROWTH,
    /** The chart of what depth buffers tell apart. */
    PRECISION;

    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    public boolean isChart() {
        return this == GROWTH || this == PRECISION;
    }

    public static List<String> codes() {
        return Arrays.stream(values()).map(StageView::code).toList();
    }

    public static StageView coded(String code) {
        return Named.find("view", code, List.of(values()), StageView::code);
    }
}
