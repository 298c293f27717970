package rasterlab.app.light.panel;

import static rasterlab.app.canvas.method.MethodColours.BLUE;
import static rasterlab.app.canvas.method.MethodColours.PURPLE;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColours;

/** The colours of the methods for light and colour. */
final class LightColours {
    static final TopicColours OWN =
            new TopicColours(
                    Map.ofEntries(
                            Map.entry("formula-textbook", PURPLE), Map.entry("formula", BLUE)));

    private LightColours() {}
}
