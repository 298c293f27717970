package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.card.TopicCard;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.rooms.LabRooms;
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
import rasterlab.engine.spline.SteppedCurve;
import rasterlab.engine.spline.SteppedSpline;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;

/**
 * The texts on methods and hazards in both languages, and the Russian of what the engine itself
 * says in English.
 */
class TopicTextsTest {
    static Stream<String> features() {
        return LabRooms.cards().stream().map(card -> card.texts().feature()).distinct();
    }

    @ParameterizedTest(name = "the English was changed and its translation was not: {0}")
    @MethodSource("features")
    void eachTranslationWasMadeForTheEnglish(String feature) throws IOException {
        assertEquals(List.of(), Translations.of(feature).outdated(english(feature)));
    }

    @ParameterizedTest(name = "a text has no translation, or a translation no text: {0}")
    @MethodSource("features")
    void translatesWhatThereIsAndNothingElse(String feature) throws IOException {
        assertEquals(List.of(), Translations.of(feature).unmatched(english(feature)));
    }

    @ParameterizedTest(name = "a method or hazard is not explained, or what is none is: {0}")
    @MethodSource("features")
    void explainsWhatThereIsAndNothingElse(String feature) throws IOException {
        assertEquals(explained(feature), new TreeSet<>(Translations.english(feature).keySet()));
    }

    @ParameterizedTest(name = "a text has no words: {0}")
    @MethodSource("features")
    void hasNoEmptyText(String feature) throws IOException {
        var empty = new TreeSet<String>();
        for (var texts : List.of(Translations.english(feature), Translations.of(feature).texts()))
            texts.forEach(
                    (key, text) -> {
                        if (text.isBlank()) empty.add(key);
                    });
        assertEquals(new TreeSet<>(), empty);
    }

    @ParameterizedTest(name = "a sentence about a topic gets a placeholder: {0}")
    @MethodSource("features")
    void hasNoPlaceholderThatNothingFills(String feature) throws IOException {
        Map<String, String> english = english(feature);
        Translations.of(feature)
                .texts()
                .forEach(
                        (key, text) ->
                                assertEquals(
                                        Placeholders.of(english.getOrDefault(key, "")),
                                        Placeholders.of(text),
                                        key));
    }

    @Test
    @DisplayName("a lab shows a hazard that has no short name there")
    void hazardsHaveShortNamesInTheirLab() {
        var nameless = new TreeSet<String>();
        for (Language language : Language.values())
            for (TopicCard<?> card : LabRooms.cards()) {
                if (namedElsewhere(card, language)) continue;
                TopicTexts said = TopicTexts.of(card, language);
                for (Hazard<?> hazard : Topics.named(card.topic()).hazards())
                    if (said.label(hazard).isEmpty())
                        nameless.add(language + " " + card.topic() + " " + hazard.name());
            }
        assertEquals(new TreeSet<>(), nameless);
    }

    /** Whether the lab has scenes of its own beside hazards, which have names for the tables. */
    private static boolean namedElsewhere(TopicCard<?> card, Language language) {
        String hazards = "study.hazard." + card.topic() + ".";
        return Texts.of(card.lab().texts(), language).keys().stream()
                .anyMatch(key -> key.startsWith(hazards));
    }

    /** The keys of the texts on methods and hazards that are explained in that package. */
    private static TreeSet<String> explained(String feature) {
        var keys = new TreeSet<String>();
        for (TopicCard<?> card : LabRooms.cards())
            if (card.texts().feature().equals(feature)) explained(card, keys);
        return keys;
    }

    private static void explained(TopicCard<?> card, Set<String> keys) {
        Topic<?, ?, ?> topic = Topics.named(card.topic());
        TopicTexts said = TopicTexts.of(card, Language.ENGLISH);
        for (Method<?> method : topic.methods()) explained(said.key(method), keys);
        for (Hazard<?> hazard : topic.hazards()) keys.add("hazard." + said.part() + hazard.name());
        if (topic.name().equals("hidden-surfaces"))
            for (Method<?> method : Renderer.visibilityMethods()) explained(method.name(), keys);
    }

    private static void explained(String method, Set<String> keys) {
        for (String part : List.of("formula", "invariant", "cost", "failures", "source"))
            keys.add(method + "." + part);
    }

    /** The English on the topics that are explained in that package, by the keys. */
    private static Map<String, String> english(String feature) throws IOException {
        Map<String, String> said = new TreeMap<>(Translations.english(feature));
        for (TopicCard<?> card : LabRooms.cards())
            if (card.texts().feature().equals(feature)) ofTheEngine(card, said);
        return said;
    }

    /** Puts what the engine writes into the JSON of the topic's steps, and its words. */
    private static void ofTheEngine(TopicCard<?> card, Map<String, String> said) {
        Topic<?, ?, ?> topic = Topics.named(card.topic());
        TopicTexts russian = TopicTexts.of(card, Language.RUSSIAN);
        for (Method<?> method : topic.methods()) {
            String decision = decision(method.implementation());
            String own = russian.key(method) + ".decision";
            if (!decision.isEmpty())
                said.put(russian.texts().has(own) ? own : "decision." + method.name(), decision);
        }
        if (topic.name().equals("matrix"))
            for (NamedMatrix matrix : NamedMatrices.all())
                said.put("matrix." + matrix.name(), matrix.meaning());
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
