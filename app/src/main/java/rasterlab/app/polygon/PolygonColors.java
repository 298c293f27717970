package rasterlab.app.polygon;

import static rasterlab.app.canvas.method.MethodColors.BLUE;
import static rasterlab.app.canvas.method.MethodColors.DARK_GREEN;
import static rasterlab.app.canvas.method.MethodColors.GRAY;
import static rasterlab.app.canvas.method.MethodColors.GREEN;
import static rasterlab.app.canvas.method.MethodColors.OLIVE;
import static rasterlab.app.canvas.method.MethodColors.ORANGE;
import static rasterlab.app.canvas.method.MethodColors.PURPLE;
import static rasterlab.app.canvas.method.MethodColors.SKY_BLUE;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColors;

/** The colours of the methods for polygons. */
final class PolygonColors {
    static final TopicColors OWN =
            new TopicColors(
                    Map.ofEntries(
                            Map.entry("recursive-textbook", PURPLE),
                            Map.entry("stack", ORANGE),
                            Map.entry("span", BLUE),
                            Map.entry("naive", ORANGE),
                            Map.entry("scanline", DARK_GREEN),
                            Map.entry("edge-function", BLUE),
                            Map.entry("half-plane", BLUE),
                            Map.entry("rotation", PURPLE),
                            Map.entry("simplex", ORANGE),
                            Map.entry("sign-int", SKY_BLUE),
                            Map.entry("sign-float", OLIVE),
                            Map.entry("sign-double", GREEN),
                            Map.entry("robust", DARK_GREEN),
                            Map.entry("ray-naive", ORANGE),
                            Map.entry("ray", BLUE),
                            Map.entry("winding", PURPLE),
                            Map.entry("fan", SKY_BLUE),
                            Map.entry("shortest-diagonal-printed-textbook", GRAY),
                            Map.entry("shortest-diagonal-textbook", PURPLE),
                            Map.entry("shortest-diagonal", ORANGE),
                            Map.entry("ear-clipping", BLUE)));

    private PolygonColors() {}
}
