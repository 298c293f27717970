package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.circle.SteppedCircle;
import rasterlab.engine.circle.SteppedEllipse;
import rasterlab.engine.clip.segment.SteppedSegmentClipper;
import rasterlab.engine.clip.volume.SteppedVolumeClipper;
import rasterlab.engine.fill.TracedFill;
import rasterlab.engine.line.SteppedLine;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.polygon.inside.SteppedPolygonTest;
import rasterlab.engine.polygon.triangle.SteppedTriangleTest;
import rasterlab.engine.polygon.triangulation.SteppedTriangulator;
import rasterlab.engine.spline.curve.SteppedCurve;
import rasterlab.engine.spline.function.SteppedSpline;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Visibility;

/**
 * The texts on methods and hazards in both languages, and the Russian of what the engine itself
 * says in English.
 */
class TopicTextsTest {
    /** The texts that any topic may have beside its methods, hazards and workloads. */
    private static final Pattern OTHERS =
            Pattern.compile(
                    "title|name|unit|item|errors|mode|letters|(field|mutant|slip|property|place|decided|rule|bound|told|complaint)\\..+");

    static List<String> topics() {
        return Topics.names();
    }

    @ParameterizedTest(name = "the English was changed and its translation was not: {0}")
    @MethodSource("topics")
    void eachTranslationWasMadeForTheEnglish(String topic) throws IOException {
        Map<String, String> english = explained(topic);
        english.putAll(ofTheEngine(topic));
        assertEquals(List.of(), Translations.of(topic).outdated(english));
    }

    @ParameterizedTest(name = "a text has no translation, or a translation no text: {0}")
    @MethodSource("topics")
    void translatesWhatThereIsAndNothingElse(String topic) throws IOException {
        Map<String, String> english = Translations.english(topic);
        english.putAll(ofTheEngine(topic));
        assertEquals(List.of(), Translations.of(topic).unmatched(english));
    }

    @ParameterizedTest(name = "a method or hazard is not explained, or what is none is: {0}")
    @MethodSource("topics")
    void explainsWhatThereIsAndNothingElse(String topic) throws IOException {
        var keys = new TreeSet<>(Translations.english(topic).keySet());
        keys.removeIf(key -> OTHERS.matcher(key).matches());
        keys.removeAll(ofWorkloads(topic));
        var known = new TreeSet<>(explanations(topic));
        for (Hazard<?> hazard : Topics.named(topic).hazards()) known.add("label." + hazard.name());
        assertEquals(known, keys);
    }

    @ParameterizedTest(name = "a text has no words: {0}")
    @MethodSource("topics")
    void hasNoEmptyText(String topic) throws IOException {
        var empty = new TreeSet<String>();
        for (var texts : List.of(Translations.english(topic), Translations.of(topic).texts()))
            texts.forEach(
                    (key, text) -> {
                        if (text.isBlank()) empty.add(key);
                    });
        assertEquals(new TreeSet<>(), empty);
    }

    @ParameterizedTest(name = "a sentence about a topic gets a placeholder: {0}")
    @MethodSource("topics")
    void hasNoPlaceholderThatNothingFills(String topic) throws IOException {
        Map<String, String> english = Translations.english(topic);
        english.putAll(ofTheEngine(topic));
        Translations.of(topic)
                .texts()
                .forEach(
                        (key, text) ->
                                assertEquals(
                                        Placeholders.of(english.getOrDefault(key, "")),
                                        Placeholders.of(text),
                                        key));
    }

    /** The keys of the explanations of methods and hazards. */
    private static Set<String> explanations(String name) {
        Topic<?, ?, ?> topic = Topics.named(name);
        var keys = new TreeSet<String>();
        for (Method<?> method : topic.methods()) explanations(method.name(), keys);
        for (Hazard<?> hazard : topic.hazards()) keys.add("hazard." + hazard.name());
        if (name.equals("hidden-surfaces"))
            for (Method<?> method : Renderer.visibilityMethods()) explanations(method.name(), keys);
        return keys;
    }

    private static void explanations(String method, Set<String> keys) {
        for (String part : List.of("formula", "invariant", "cost", "failures", "source"))
            keys.add(method + "." + part);
    }

    /** The English of those explanations that there are. */
    private static Map<String, String> explained(String topic) throws IOException {
        Map<String, String> english = Translations.english(topic);
        var kept = new TreeSet<>(explanations(topic));
        kept.add("letters");
        english.keySet().retainAll(kept);
        return english;
    }

    /** The keys of what a topic's workloads and their sizes may be called. */
    private static Set<String> ofWorkloads(String topic) {
        var keys = new TreeSet<String>();
        for (Workload<?> workload : Topics.named(topic).workloads()) {
            String kind = workload.name().replaceAll("-\\d+(?=-|$)", "");
            keys.add("workload." + kind);
            keys.add("size." + kind);
        }
        return keys;
    }

    /** The words of the engine about JSON, and in the JSON of the topic's steps. */
    private static Map<String, String> ofTheEngine(String name) throws IOException {
        Topic<?, ?, ?> topic = Topics.named(name);
        var said = new TreeMap<String, String>();
        Set<String> russian = Translations.of(name).texts().keySet();
        // Forms without words are the same in each language.
        if (russian.contains("reads")) said.put("reads", topic.format().reads());
        if (russian.contains("answers")) said.put("answers", topic.format().answers());
        for (Method<?> method : topic.methods()) {
            String decision = decision(method.implementation());
            if (!decision.isEmpty()) said.put(method.name() + ".decision", decision);
        }
        if (name.equals("hidden-surfaces"))
            for (Method<Visibility> method : Renderer.visibilityMethods())
                if (method.implementation() instanceof SteppedVisibility stepped)
                    said.put(method.name() + ".decision", stepped.decision());
        if (name.equals("matrix"))
            for (NamedMatrix matrix : NamedMatrices.all())
                said.put("matrix." + matrix.name(), matrix.meaning());
        else topic.vocabulary().forEach((word, meaning) -> said.put("word." + word, meaning));
        return said;
    }

    private static String decision(Object method) {
        if (method instanceof SteppedLine line) return line.decisionFormula();
        if (method instanceof SteppedCurve curve) return curve.decisionFormula();
        if (method instanceof SteppedSpline spline) return spline.decisionFormula();
        if (method instanceof SteppedSegmentClipper clipper) return clipper.decisionFormula();
        if (method instanceof SteppedVolumeClipper clipper) return clipper.decisionFormula();
        if (method instanceof SteppedTriangleTest test) return test.valueFormula();
        if (method instanceof SteppedPolygonTest test) return test.countFormula();
        if (method instanceof SteppedCircle circle) return circle.decisionFormula();
        if (method instanceof SteppedEllipse ellipse) return ellipse.decisionFormula();
        if (method instanceof SteppedTriangulator cutter) return cutter.choice();
        return method instanceof TracedFill fill ? fill.waitingMeans() : "";
    }
}
