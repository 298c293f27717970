package rasterlab.app.coordinates.figure;

import static rasterlab.app.canvas.method.MethodColors.BLUE;
import static rasterlab.app.canvas.method.MethodColors.GRAY;
import static rasterlab.app.canvas.method.MethodColors.GREEN;
import static rasterlab.app.canvas.method.MethodColors.OLIVE;
import static rasterlab.app.canvas.method.MethodColors.ORANGE;
import static rasterlab.app.canvas.method.MethodColors.PURPLE;
import static rasterlab.app.canvas.method.MethodColors.SKY_BLUE;
import static rasterlab.app.canvas.method.MethodColors.WINE;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColors;

/** The colours of the methods for coordinates. */
public final class FigureColors {
    public static final TopicColors OWN =
            new TopicColors(
                    Map.ofEntries(
                            Map.entry("direct", BLUE),
                            Map.entry("float", GRAY),
                            Map.entry("table", ORANGE),
                            Map.entry("buneman-textbook", PURPLE),
                            Map.entry("buneman", GREEN),
                            Map.entry("orthonormal", SKY_BLUE),
                            Map.entry("quaternion", WINE),
                            Map.entry("total-angle", OLIVE),
                            Map.entry("formula-textbook", PURPLE),
                            Map.entry("formula", BLUE),
                            Map.entry("divide-first-textbook", PURPLE),
                            Map.entry("double", BLUE),
                            Map.entry("double-double", GREEN)));

    private FigureColors() {}
}
