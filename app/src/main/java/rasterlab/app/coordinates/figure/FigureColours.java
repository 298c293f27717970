package rasterlab.app.coordinates.figure;

import static rasterlab.app.canvas.method.MethodColours.BLUE;
import static rasterlab.app.canvas.method.MethodColours.GREEN;
import static rasterlab.app.canvas.method.MethodColours.GREY;
import static rasterlab.app.canvas.method.MethodColours.OLIVE;
import static rasterlab.app.canvas.method.MethodColours.ORANGE;
import static rasterlab.app.canvas.method.MethodColours.PURPLE;
import static rasterlab.app.canvas.method.MethodColours.SKY_BLUE;
import static rasterlab.app.canvas.method.MethodColours.WINE;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColours;

/** The colours of the methods for coordinates. */
public final class FigureColours {
    public static final TopicColours OWN =
            new TopicColours(
                    Map.ofEntries(
                            Map.entry("direct", BLUE),
                            Map.entry("float", GREY),
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

    private FigureColours() {}
}
