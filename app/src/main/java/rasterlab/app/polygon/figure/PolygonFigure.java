package rasterlab.app.polygon.figure;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import java.util.Map;

/** The figure of a mode before any method works on it; immutable. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "figure")
@JsonSubTypes({
    @JsonSubTypes.Type(value = InsideFigure.class, name = "inside"),
    @JsonSubTypes.Type(value = CutFigure.class, name = "cut"),
    @JsonSubTypes.Type(value = FillFigure.class, name = "fill"),
    @JsonSubTypes.Type(value = SeedFigure.class, name = "seed")
})
public sealed interface PolygonFigure permits InsideFigure, CutFigure, FillFigure, SeedFigure {
    /** The points that can be moved, by name and place. */
    Map<Grip, PolygonPoint> grips();

    PolygonFigure moved(Grip grip, PolygonPoint to);

    /** One corner more behind that one, or a wall at the pen. */
    PolygonFigure grown(Grip beside);

    /** The figure without that corner unless it is needed, or without the wall at the pen. */
    PolygonFigure without(Grip grip);

    /**
     * The figure after two clicks on the ground: a corner more there, the point there, or a wall
     * there.
     */
    PolygonFigure clicked(PolygonPoint at);

    /** The least way that a key moves a point, in the plane's units; 0 for any. */
    double leastStep();
}
