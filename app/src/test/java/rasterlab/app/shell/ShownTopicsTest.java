package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.Color;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.StringJoiner;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.method.TopicColors;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.golden.GoldenFile;
import rasterlab.app.language.Language;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.outcome.KeptJson;
import rasterlab.app.rooms.LabRooms;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabOpening;
import rasterlab.app.shell.labs.LabsFile;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.app.visibility.VisibilityRoom;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/**
 * Holds how each topic is shown to what was published: its tab, its name and those of its hazards,
 * its sentences and the colours of its methods, and what the tab shows of each hazard by each
 * method. Sentences and what tabs show are kept by their checksums.
 *
 * @see GoldenFile
 */
@EnabledOnOs(
        architectures = {"amd64", "x86_64"},
        disabledReason = "the last bits of sines and cosines differ between processors")
@Tag("slow")
class ShownTopicsTest {
    /** A number that is not whole, since its digits differ between versions of Java. */
    private static final Pattern FRACTION = Pattern.compile("-?\\d+\\.\\d+(?:E-?\\d+)?");

    private final Deque<Runnable> background = new ArrayDeque<>();
    private final LabModels models = LabModels.first(answer -> {}, ShownTopicsTest::fail);
    private final LabOpening opening =
            new LabOpening(models, background::add, Runnable::run, ShownTopicsTest::fail);
    private final List<String> tabs = new ArrayList<>();

    private static void fail(Throwable failure) {
        throw new AssertionError(failure);
    }

    @AfterEach
    void close() {
        models.close();
    }

    static Stream<String> topics() {
        return Topics.all().stream().map(Topic::name);
    }

    @ParameterizedTest
    @MethodSource("topics")
    void everyTopicIsShownAsPublished(String topic) throws IOException {
        GoldenFile.of(topic).assertKept("shown", shown(Topics.named(topic)));
    }

    private List<String> shown(Topic<?, ?, ?> topic) {
        opening.showTabsBy(tabs::add);
        var lines = new ArrayList<String>();
        for (Language language : Language.values())
            lines.add("topic " + TopicNames.in(language).topic(topic.name()));
        for (Method<?> method : topic.methods()) lines.add(method(topic, method));
        for (Hazard<?> hazard : topic.hazards()) {
            lines.add(hazard(topic, hazard));
            lines.add(opened(topic, hazard));
        }
        return lines;
    }

    private static String method(Topic<?, ?, ?> topic, Method<?> method) {
        List<String> names = topic.methods().stream().map(Method::name).toList();
        var line = new StringJoiner(" ");
        line.add("method " + method.name());
        TopicColors colors = LabRooms.card(topic.name()).colors();
        line.add(hex(colors.of(method.name())));
        line.add(hex(colors.among(names).get(method.name())));
        for (Language language : Language.values()) {
            TopicTexts said = TopicTexts.of(topic.name(), language);
            for (String what : List.of("formula", "invariant", "cost", "failures", "source"))
                line.add(sum(said.about(method, what)));
        }
        return line.toString();
    }

    private static String hazard(Topic<?, ?, ?> topic, Hazard<?> hazard) {
        var line = new StringJoiner(" | ");
        line.add("hazard " + hazard.name());
        for (Language language : Language.values()) {
            TopicTexts said = TopicTexts.of(topic.name(), language);
            line.add(TopicNames.in(language).hazard(topic, hazard));
            line.add(sum(said.hazard(hazard)));
        }
        return line.toString();
    }

    /** Where the hazard opens, and by each method what the labs show then. */
    private String opened(Topic<?, ?, ?> topic, Hazard<?> hazard) {
        var line = new StringJoiner(" ");
        assertEquals(Optional.empty(), opening.obstacleTo(topic.name(), hazard.name()));
        for (Method<?> method : topic.methods()) {
            tabs.clear();
            opening.showHazard(topic.name(), hazard.name(), method.name());
            while (!background.isEmpty()) background.remove().run();
            assertEquals(1, tabs.size(), hazard.name() + " " + method.name());
            line.add(tabs.get(0) + " " + sum(choices()));
        }
        return line.toString();
    }

    /** The state of the labs as it is kept, and the scene and notes, which are not. */
    private String choices() {
        var choices = new StringJoiner("\n");
        for (Map.Entry<String, Object> lab : LabsFile.choices(models).entrySet())
            choices.add(lab.getKey() + ordered(KeptJson.MAPPER.valueToTree(lab.getValue())));
        var seen = models.of(new VisibilityRoom()).state();
        choices.add(seen.choice().visibility() + " of " + seen.choice().scene());
        for (var note : List.of(seen.note(), models.of(new LightRoom()).state().note()))
            choices.add(note.map(one -> one.in(Language.ENGLISH)).orElse("-"));
        return FRACTION.matcher(choices.toString())
                .replaceAll(number -> Double.toHexString(Double.parseDouble(number.group())));
    }

    /** Sets come in an order that changes from run to run: fields and words are sorted. */
    private static String ordered(JsonNode node) {
        var parts = new ArrayList<String>();
        if (node.isObject())
            node.properties().forEach(one -> parts.add(one.getKey() + ordered(one.getValue())));
        else if (node.isArray()) node.forEach(one -> parts.add(ordered(one)));
        else return node.toString();
        if (node.isObject() || node.size() > 0 && node.get(0).isTextual()) parts.sort(null);
        return parts.toString();
    }

    private static String hex(Color color) {
        return "%06X".formatted(color.getRGB() & 0xFFFFFF);
    }

    private static String sum(String text) {
        var sum = new CRC32();
        sum.update(text.getBytes(StandardCharsets.UTF_8));
        return "%08x".formatted(sum.getValue());
    }
}
