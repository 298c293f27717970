package rasterlab.app.study;

import java.util.Map;
import java.util.Optional;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

/**
 * What a lab says in the window's language about a topic's methods and hazards.
 *
 * @param part what stands before names in the keys of a lab with several topics; "" for one
 * @param labels of the lab that shows the hazards
 * @param shownAs what stands before hazards' names in their keys
 */
public record TopicTexts(Texts texts, String part, Texts labels, String shownAs) {
    /** A lab with texts of its own, and what its keys have before names. */
    private record Source(String lab, String part) {}

    /** Its hazards are shown in another lab than the one that explains them. */
    private static final Map<String, Source> SHOWN_ELSEWHERE =
            Map.of("transform", new Source("coordinates.list", "transform."));

    private static final Map<String, Source> SOURCES =
            Map.ofEntries(
                    entry("line", "line", ""),
                    entry("circle", "line", "circle."),
                    entry("ellipse", "line", "ellipse."),
                    entry("point-in-triangle", "polygon", "triangle."),
                    entry("point-in-polygon", "polygon", "polygon."),
                    entry("triangulate", "polygon", "triangulation."),
                    entry("polygon-fill", "polygon", "fill."),
                    entry("fill", "polygon", "seed."),
                    entry("clip-segment", "clip", "segments."),
                    entry("clip-polygon", "clip", "polygon."),
                    entry("clip-volume", "clip", "volume."),
                    entry("curve", "spline", ""),
                    entry("spline-function", "spline", ""),
                    entry("rotate", "coordinates.turn", ""),
                    entry("matrix", "coordinates.list", ""),
                    entry("transform", "coordinates.view", ""),
                    entry("rotate-axis", "coordinates.list", "rotate-axis."),
                    entry("view", "coordinates.list", "view."),
                    entry("line-plane", "coordinates.meeting", ""),
                    entry("hidden-surfaces", "visibility", ""),
                    entry("visible-faces", "visibility", "faces."),
                    entry("depth-order", "visibility", "order."),
                    entry("color", "light", ""),
                    entry("shade", "light", "shade."),
                    entry("shade-face", "light", "face."),
                    entry("vertex-normals", "light", "normals."),
                    entry("depth-buffer", "row", ""),
                    entry("texture-mapping", "row", ""),
                    entry("texture-filter", "row", ""));

    private static Map.Entry<String, Source> entry(String topic, String lab, String part) {
        return Map.entry(topic, new Source(lab, part));
    }

    /** Empty where no lab has such texts: the engine's English serves then. */
    public static Optional<TopicTexts> of(String topic, Language language) {
        return Optional.ofNullable(SOURCES.get(topic))
                .map(
                        source -> {
                            Source shown = SHOWN_ELSEWHERE.getOrDefault(topic, source);
                            return new TopicTexts(
                                    Texts.of(source.lab(), "topic", language),
                                    source.part(),
                                    Texts.of(shown.lab(), language),
                                    shown.part());
                        });
    }

    /** What the lab calls the hazard; empty where it does not show it. */
    Optional<String> label(Hazard<?> hazard) {
        String key = "hazard." + shownAs + hazard.name();
        return labels.has(key) ? Optional.of(labels.text(key)) : Optional.empty();
    }

    /** What is special about the hazard; empty where the engine's English serves. */
    public Optional<String> hazard(Hazard<?> hazard) {
        String key = "hazard." + part + hazard.name();
        return texts.has(key) ? Optional.of(texts.text(key)) : Optional.empty();
    }

    /**
     * @param what "formula", "cost" or "failures"
     * @param english the engine's, where the lab has no other words
     */
    public String about(Method<?> method, String what, String english) {
        return texts.textOr(key(method) + "." + what, english);
    }

    /** What the keys of a method's texts begin with. */
    String key(Method<?> method) {
        String key = part + method.name();
        return texts.has(key + ".formula") ? key : method.name();
    }
}
