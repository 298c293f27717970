package rasterlab.app.shell;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Function;
import rasterlab.app.canvas.HazardNote;
import rasterlab.app.canvas.OpenInLab;
import rasterlab.app.canvas.Unlike;
import rasterlab.app.canvas.Unshown;
import rasterlab.app.line.LineInput;
import rasterlab.engine.Topics;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

/** Opens inputs of topics in their tabs, hazards and cases of exercises by the same ways. */
final class LabOpening implements OpenInLab {
    private static final Duration LONGEST = Duration.ofSeconds(5);

    private final Map<String, Topic<?, ?, ?>> topics = new TreeMap<>();
    private final TopicWays ways;

    /** What makes an input of a topic from JSON, for the topics of exercises. */
    private final Map<String, Function<String, Object>> readers = Map.of("line", LineInput::read);

    private Consumer<String> showTab = tab -> {};

    LabOpening(LabModels models) {
        for (Topic<?, ?, ?> topic : Topics.all()) topics.put(topic.name(), topic);
        ways = new TopicWays(models);
    }

    /**
     * @param next brings the tab of that name to the front
     */
    void showTabsBy(Consumer<String> next) {
        showTab = next;
    }

    @Override
    public Optional<Unshown> obstacleTo(String topic, String hazard) {
        input(topic, hazard);
        return ways.of(topic).isPresent() ? Optional.empty() : Optional.of(Unshown.NO_TAB);
    }

    @Override
    public void showHazard(String topic, String hazard, String method) {
        TopicInput input = input(topic, hazard);
        TopicWay way = show(topic, input, method);
        List<Unlike> unlike = way.unlike().apply(input, method);
        if (!unlike.isEmpty() && !method.isEmpty())
            way.note()
                    .accept(
                            new HazardNote(
                                    hazard, method, verdict(named(topic), hazard, method), unlike));
    }

    /** What the method does with the hazard's own numbers. */
    static <C, I, O> Verdict verdict(Topic<C, I, O> topic, String hazard, String method) {
        Hazard<I> found = Named.find("hazard", hazard, topic.hazards(), Hazard::name);
        return HazardTrial.judge(topic, topic.method(method), found, LONGEST);
    }

    @Override
    public Optional<Unshown> obstacleToInputs(String topic) {
        return readers.containsKey(topic) ? Optional.empty() : Optional.of(Unshown.NO_READER);
    }

    @Override
    public void showInput(String topic, String json, String method) {
        var reader =
                Named.find(
                                "reader of topic",
                                topic,
                                List.copyOf(readers.entrySet()),
                                Map.Entry::getKey)
                        .getValue();
        show(topic, new TopicInput(topic, "", reader.apply(json)), method);
    }

    private TopicInput input(String topic, String hazard) {
        List<Hazard<?>> hazards = List.copyOf(named(topic).hazards());
        Hazard<?> found = Named.find("hazard", hazard, hazards, Hazard::name);
        return new TopicInput(topic, hazard, found.input());
    }

    private Topic<?, ?, ?> named(String topic) {
        return Named.find("topic", topic, List.copyOf(topics.values()), Topic::name);
    }

    private TopicWay show(String topic, TopicInput input, String method) {
        if (!method.isEmpty()) named(topic).method(method);
        TopicWay way =
                ways.of(topic)
                        .orElseThrow(
                                () ->
                                        new IllegalArgumentException(
                                                "no tab shows inputs of topic " + topic));
        way.show().accept(input, method);
        showTab.accept(way.tab());
        return way;
    }
}
