package rasterlab.app.spline;

import static rasterlab.app.canvas.method.MethodColours.BLUE;
import static rasterlab.app.canvas.method.MethodColours.GREEN;
import static rasterlab.app.canvas.method.MethodColours.GREY;
import static rasterlab.app.canvas.method.MethodColours.OLIVE;
import static rasterlab.app.canvas.method.MethodColours.ORANGE;
import static rasterlab.app.canvas.method.MethodColours.PURPLE;
import static rasterlab.app.canvas.method.MethodColours.ROSE;
import static rasterlab.app.canvas.method.MethodColours.SAND;
import static rasterlab.app.canvas.method.MethodColours.SKY_BLUE;
import static rasterlab.app.canvas.method.MethodColours.WINE;
import static rasterlab.app.canvas.method.MethodColours.YELLOW;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColours;

/** The colours of the methods for curves and functions. */
final class SplineColours {
    static final TopicColours OWN =
            new TopicColours(
                    Map.ofEntries(
                            Map.entry("blending-textbook", SAND),
                            Map.entry("matrix", PURPLE),
                            Map.entry("horner", YELLOW),
                            Map.entry("de-casteljau", GREEN),
                            Map.entry("forward-differences", OLIVE),
                            Map.entry("forward-differences-float", GREY),
                            Map.entry("uniform", WINE),
                            Map.entry("adaptive-naive", ORANGE),
                            Map.entry("adaptive", BLUE),
                            Map.entry("curvature-unchecked", ROSE),
                            Map.entry("fewest", SKY_BLUE),
                            Map.entry("cubic", BLUE),
                            Map.entry("monotone", ORANGE)));

    private SplineColours() {}
}
