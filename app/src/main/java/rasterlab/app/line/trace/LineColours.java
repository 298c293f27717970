package rasterlab.app.line.trace;

import static rasterlab.app.canvas.method.MethodColours.BLUE;
import static rasterlab.app.canvas.method.MethodColours.DARK_GREEN;
import static rasterlab.app.canvas.method.MethodColours.GREEN;
import static rasterlab.app.canvas.method.MethodColours.GREY;
import static rasterlab.app.canvas.method.MethodColours.INDIGO;
import static rasterlab.app.canvas.method.MethodColours.OLIVE;
import static rasterlab.app.canvas.method.MethodColours.ORANGE;
import static rasterlab.app.canvas.method.MethodColours.PURPLE;
import static rasterlab.app.canvas.method.MethodColours.SKY_BLUE;
import static rasterlab.app.canvas.method.MethodColours.WINE;
import static rasterlab.app.canvas.method.MethodColours.YELLOW;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColours;

/** The colours of the methods for segments, circles and ellipses. */
public final class LineColours {
    public static final TopicColours OWN =
            new TopicColours(
                    Map.ofEntries(
                            Map.entry("naive-textbook", SKY_BLUE),
                            Map.entry("naive", ORANGE),
                            Map.entry("dda-float", GREY),
                            Map.entry("dda", GREEN),
                            Map.entry("bresenham-first-textbook", INDIGO),
                            Map.entry("bresenham-pascal-textbook", OLIVE),
                            Map.entry("bresenham-textbook", PURPLE),
                            Map.entry("bresenham", BLUE),
                            Map.entry("midpoint", YELLOW),
                            Map.entry("clip-first-textbook", DARK_GREEN),
                            Map.entry("wu", WINE),
                            Map.entry("parametric", GREEN)));

    private LineColours() {}
}
