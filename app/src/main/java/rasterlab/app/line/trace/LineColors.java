package rasterlab.app.line.trace;

import static rasterlab.app.canvas.method.MethodColors.BLUE;
import static rasterlab.app.canvas.method.MethodColors.DARK_GREEN;
import static rasterlab.app.canvas.method.MethodColors.GRAY;
import static rasterlab.app.canvas.method.MethodColors.GREEN;
import static rasterlab.app.canvas.method.MethodColors.INDIGO;
import static rasterlab.app.canvas.method.MethodColors.OLIVE;
import static rasterlab.app.canvas.method.MethodColors.ORANGE;
import static rasterlab.app.canvas.method.MethodColors.PURPLE;
import static rasterlab.app.canvas.method.MethodColors.SKY_BLUE;
import static rasterlab.app.canvas.method.MethodColors.WINE;
import static rasterlab.app.canvas.method.MethodColors.YELLOW;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColors;

/** The colours of the methods for segments, circles and ellipses. */
public final class LineColors {
    public static final TopicColors OWN =
            new TopicColors(
                    Map.ofEntries(
                            Map.entry("naive-textbook", SKY_BLUE),
                            Map.entry("naive", ORANGE),
                            Map.entry("dda-float", GRAY),
                            Map.entry("dda", GREEN),
                            Map.entry("bresenham-first-textbook", INDIGO),
                            Map.entry("bresenham-pascal-textbook", OLIVE),
                            Map.entry("bresenham-textbook", PURPLE),
                            Map.entry("bresenham", BLUE),
                            Map.entry("midpoint", YELLOW),
                            Map.entry("clip-first-textbook", DARK_GREEN),
                            Map.entry("wu", WINE),
                            Map.entry("parametric", GREEN)));

    private LineColors() {}
}
