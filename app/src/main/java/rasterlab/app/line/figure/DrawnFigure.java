package rasterlab.app.line.figure;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import java.util.Map;
import rasterlab.app.line.trace.RasterPoint;

/** The figure of a mode, in pixel coordinates; immutable. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "figure")
@JsonSubTypes({
    @JsonSubTypes.Type(value = ArcFigure.class, name = "arc"),
    @JsonSubTypes.Type(value = PenFigure.class, name = "pen"),
    @JsonSubTypes.Type(value = SlopeFigure.class, name = "slope")
})
public sealed interface DrawnFigure permits ArcFigure, PenFigure, SlopeFigure {
    /** The points that can be moved, by the names of their handles. */
    Map<String, RasterPoint> grips();

    DrawnFigure moved(String grip, RasterPoint to);

    /** The figure after two clicks on the ground; the same where nothing can be added. */
    default DrawnFigure added(RasterPoint at) {
        return this;
    }

    /** The figure without that point; the same where it is needed. */
    default DrawnFigure without(String grip) {
        return this;
    }
}
