package rasterlab.app.shell;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import rasterlab.app.canvas.HazardNote;
import rasterlab.app.canvas.OpenInLab;
import rasterlab.app.canvas.Unlike;
import rasterlab.app.canvas.Unshown;
import rasterlab.app.line.LineInput;
import rasterlab.engine.Topics;
import rasterlab.engine.line.Segment;
import rasterlab.engine.naming.Named;
import rasterlab.engine.raster.Plotted;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

/** Opens inputs of topics in their tabs, hazards and cases of exercises by the same ways. */
final class LabOpening implements OpenInLab {
    /** Shows an input of its topic, beside it what the user's program plotted. */
    private interface ShowTried {
        void show(Object input, String method, Optional<Plotted> drawn);
    }

    private final Map<String, Topic<?, ?, ?>> topics = new TreeMap<>();

    /** What makes an input of a topic from JSON, for the topics of exercises. */
    private final Map<String, Function<String, Object>> readers = Map.of("line", LineInput::read);

    /** What shows an input and what the user's program plotted, for the same topics. */
    private final Map<String, ShowTried> tried;

    private final Executor background;
    private final Executor events;
    private final Consumer<Throwable> onFailure;
    private final LabModels models;
    private Optional<TopicWays> ways = Optional.empty();
    private Consumer<String> showTab = tab -> {};
    private Consumer<String> tellHazard = hazard -> {};

    /** Counts what was asked for, so that only the newest is shown. */
    private int asked;

    /**
     * @param background tries methods
     * @param events runs what it is given on the one thread that uses the models
     * @param onFailure told what trying threw, on any thread
     */
    LabOpening(
            LabModels models, Executor background, Executor events, Consumer<Throwable> onFailure) {
        for (Topic<?, ?, ?> topic : Topics.all()) topics.put(topic.name(), topic);
        this.models = models;
        tried =
                Map.of(
                        "line",
                        (input, method, drawn) ->
                                models.line().showTried((Segment) input, method, drawn));
        this.background = background;
        this.events = events;
        this.onFailure = onFailure;
    }

    /**
     * @param next brings the tab of that name to the front
     */
    void showTabsBy(Consumer<String> next) {
        showTab = next;
    }

    /**
     * @param told which hazard the next tab that is shown has
     */
    void tellHazardsTo(Consumer<String> told) {
        tellHazard = told;
    }

    @Override
    public Optional<Unshown> obstacleTo(String topic, String hazard) {
        input(topic, hazard);
        return ways().of(topic).isPresent() ? Optional.empty() : Optional.of(Unshown.NO_TAB);
    }

    /** What takes long comes once it is found. */
    @Override
    public void showHazard(String topic, String hazard, String method) {
        TopicInput input = input(topic, hazard);
        TopicWay way = way(topic, method);
        int mine = ++asked;
        if (way.notes().isEmpty()) show(way, input, method);
        else background.execute(() -> tryAndShow(way, input, method, mine));
    }

    private void tryAndShow(TopicWay way, TopicInput input, String method, int mine) {
        try {
            Runnable note = note(way, input, method);
            events.execute(
                    () -> {
                        if (mine != asked) return;
                        show(way, input, method);
                        note.run();
                    });
        } catch (RuntimeException e) {
            onFailure.accept(e);
        }
    }

    /** Tries the method, if there is something to say of it; the answer says it. */
    private Runnable note(TopicWay way, TopicInput input, String method) {
        if (method.isEmpty() || way.notes().isEmpty()) return () -> {};
        TopicWay.Notes notes = way.notes().get();
        Verdict verdict = verdict(named(input.topic()), input.hazard(), method);
        var unlike = new ArrayList<>(notes.unlike().apply(input, method));
        if (verdict.kind() != Verdict.Kind.EXACT && !notes.drawsBy().test(method))
            unlike.add(Unlike.of(Unlike.Kind.OTHER_METHOD));
        if (unlike.isEmpty()) return () -> {};
        var note = new HazardNote(input.hazard(), method, verdict, unlike);
        return () -> notes.note().accept(note);
    }

    /** What the method does with the hazard's own numbers. */
    static <C, I, O> Verdict verdict(Topic<C, I, O> topic, String hazard, String method) {
        Hazard<I> found = Named.find("hazard", hazard, topic.hazards(), Hazard::name);
        return HazardTrial.judge(topic, topic.method(method), found, HazardTrial.WALL_LIMIT);
    }

    @Override
    public Optional<Unshown> obstacleToInputs(String topic) {
        return readers.containsKey(topic) ? Optional.empty() : Optional.of(Unshown.NO_READER);
    }

    @Override
    public void showInput(String topic, String json, String method, Optional<Plotted> drawn) {
        var reader =
                Named.find(
                                "reader of topic",
                                topic,
                                List.copyOf(readers.entrySet()),
                                Map.Entry::getKey)
                        .getValue();
        TopicWay way = way(topic, method);
        asked++;
        tried.get(topic).show(reader.apply(json), method, drawn);
        showTab.accept(way.tab());
    }

    private TopicInput input(String topic, String hazard) {
        List<Hazard<?>> hazards = List.copyOf(named(topic).hazards());
        Hazard<?> found = Named.find("hazard", hazard, hazards, Hazard::name);
        return new TopicInput(topic, hazard, found.input());
    }

    private Topic<?, ?, ?> named(String topic) {
        return Named.find("topic", topic, List.copyOf(topics.values()), Topic::name);
    }

    private TopicWay way(String topic, String method) {
        if (!method.isEmpty()) named(topic).method(method);
        return ways().of(topic)
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "no tab shows inputs of topic " + topic));
    }

    /** Asks for all models, which whoever opens the window need not wait for. */
    private TopicWays ways() {
        if (ways.isEmpty()) ways = Optional.of(new TopicWays(models));
        return ways.get();
    }

    private void show(TopicWay way, TopicInput input, String method) {
        way.show().accept(input, method);
        tellHazard.accept(input.hazard());
        showTab.accept(way.tab());
    }
}
