package rasterlab.app.shell.labs;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.app.canvas.lab.NotShown;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.canvas.method.HazardNote;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.app.card.TopicBinding;
import rasterlab.app.card.TopicCard;
import rasterlab.app.card.TopicInput;
import rasterlab.app.exercise.OtherTexts;
import rasterlab.app.exercise.panel.ExerciseRoom;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.mine.OwnProgram;
import rasterlab.app.practice.GradedSheet;
import rasterlab.app.rooms.LabRooms;
import rasterlab.engine.Topics;
import rasterlab.engine.naming.Named;
import rasterlab.engine.raster.Plotted;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.predicting.HandedAnswers;
import rasterlab.exercises.scene.MethodCase;

/** Opens inputs of topics in their tabs, hazards and cases of exercises by the same ways. */
public final class LabOpening implements OpenInLab {
    private final Map<String, Topic<?, ?, ?>> topics = new TreeMap<>();
    private final Map<String, TopicCard<?>> cards = new TreeMap<>();
    private final Executor background;
    private final Executor events;
    private final Consumer<Throwable> onFailure;
    private final LabModels models;
    private Consumer<String> showTab = tab -> {};
    private Consumer<String> tellHazard = hazard -> {};
    private BiConsumer<String, OwnProgram> tellOwn = (tab, program) -> {};
    private Consumer<String> tellNoOwn = tab -> {};
    private BiConsumer<String, Exercise> tellHandingIn = (tab, exercise) -> {};

    /** Counts what was asked for, so that only the newest is shown. */
    private int asked;

    /**
     * @param background tries methods
     * @param events runs what it is given on the one thread that uses the models
     * @param onFailure told what trying threw, on any thread
     */
    public LabOpening(
            LabModels models, Executor background, Executor events, Consumer<Throwable> onFailure) {
        this.models = models;
        this.background = background;
        this.events = events;
        this.onFailure = onFailure;
    }

    /**
     * @param next brings the tab of that name to the front
     */
    public void showTabsBy(Consumer<String> next) {
        showTab = next;
    }

    /**
     * @param told which hazard the next tab that is shown has
     */
    public void tellHazardsTo(Consumer<String> told) {
        tellHazard = told;
    }

    /**
     * @param told which program of the user's the tab of that name is about to show
     * @param toldNone which tab is about to show none any more
     */
    public void tellOwnTo(BiConsumer<String, OwnProgram> told, Consumer<String> toldNone) {
        tellOwn = told;
        tellNoOwn = toldNone;
        models.own().shown().forEach(told);
    }

    @Override
    public Optional<NotShown> obstacleTo(String topic, String hazard) {
        input(topic, hazard);
        return card(topic).isPresent() ? Optional.empty() : Optional.of(NotShown.NO_TAB);
    }

    /** Opens the hazard; results that take long come once they are found. */
    @Override
    public void showHazard(String topic, String hazard, String method) {
        TopicInput input = input(topic, hazard);
        TopicCard<?> card = shown(topic, method);
        boolean unable = method.equals(OwnMethods.NAME) && card.way().own().isEmpty();
        showHazard(card, input, unable ? "" : method);
    }

    private <M> void showHazard(TopicCard<M> card, TopicInput input, String method) {
        M lab = models.of(card.lab());
        int mine = ++asked;
        Optional<TopicBinding.PictureNotes<M>> notes = card.way().notes();
        if (notes.isEmpty()) show(card, lab, input, method);
        else background.execute(() -> tryAndShow(card, notes.get(), lab, input, method, mine));
    }

    private <M> void tryAndShow(
            TopicCard<M> card,
            TopicBinding.PictureNotes<M> notes,
            M lab,
            TopicInput input,
            String method,
            int mine) {
        try {
            Optional<HazardNote> note = note(notes, lab, input, method);
            events.execute(
                    () -> {
                        if (mine != asked) return;
                        show(card, lab, input, method);
                        note.ifPresent(said -> notes.note().accept(lab, said));
                    });
        } catch (RuntimeException e) {
            onFailure.accept(e);
        }
    }

    /** Tries the method, if there is something to say of it. */
    private <M> Optional<HazardNote> note(
            TopicBinding.PictureNotes<M> notes, M lab, TopicInput input, String method) {
        if (method.isEmpty()) return Optional.empty();
        Verdict verdict = verdict(models.own().in(named(input.topic())), input.hazard(), method);
        var differences = new ArrayList<>(notes.differences().differences(lab, input, method));
        if (verdict.kind() != Verdict.Kind.EXACT && !notes.drawsBy().test(method))
            differences.add(ShownDifference.of(ShownDifference.ShownDifferenceKind.OTHER_METHOD));
        return differences.isEmpty()
                ? Optional.empty()
                : Optional.of(new HazardNote(input.hazard(), method, verdict, differences));
    }

    /** The verdict on the method for the hazard's own numbers. */
    static <C, I, O> Verdict verdict(Topic<C, I, O> topic, String hazard, String method) {
        Hazard<I> found = Named.find("hazard", hazard, topic.hazards(), Hazard::name);
        return HazardTrial.judge(topic, topic.method(method), found, HazardTrial.WALL_LIMIT);
    }

    @Override
    public Optional<NotShown> obstacleToInputs(String topic) {
        return card(topic)
                        .map(TopicCard::way)
                        .filter(way -> way.cases().isPresent() || way.anyInput())
                        .isPresent()
                ? Optional.empty()
                : Optional.of(NotShown.NO_READER);
    }

    @Override
    public void showInput(String topic, String json, String method, Optional<Plotted> drawn) {
        showInput(shown(topic, method), json, method, drawn);
    }

    private <M> void showInput(
            TopicCard<M> card, String json, String method, Optional<Plotted> drawn) {
        TopicBinding<M> way = card.way();
        if (way.cases().isEmpty() && !way.anyInput())
            throw new IllegalArgumentException("no tab reads inputs of topic " + card.topic());
        asked++;
        M lab = models.of(card.lab());
        if (way.cases().isPresent()) {
            TopicBinding.Cases<M> cases = way.cases().get();
            cases.show().show(lab, cases.read().apply(json), method, drawn);
        } else {
            Object input = GivenInput.read(named(card.topic()).format(), json);
            way.show().show(lab, new TopicInput(card.topic(), "", input), method);
        }
        tellOwn(card, method);
        bring(card);
    }

    /**
     * Says whether a tab shows the user's program, from which exercise.
     *
     * @param method that it shows; "" for the one that it showed before
     */
    private void tellOwn(TopicCard<?> card, String method) {
        String tab = card.lab().name();
        if (method.equals(OwnMethods.NAME))
            models.own().showIn(tab, card.topic()).ifPresent(mine -> tellOwn.accept(tab, mine));
        else if (!method.isEmpty()) {
            hideOwn(tab);
            tellNoOwn.accept(tab);
        }
    }

    /**
     * @param told for which exercise the input of the tab of that name can be handed in
     */
    public void tellHandingInTo(BiConsumer<String, Exercise> told) {
        tellHandingIn = told;
    }

    @Override
    public Optional<NotShown> obstacleToOwn(String topic) {
        return card(topic).map(TopicCard::way).filter(way -> way.own().isPresent()).isPresent()
                ? Optional.empty()
                : Optional.of(NotShown.NO_OWN);
    }

    @Override
    public void showOwn(String topic, String json, String beside) {
        showOwn(shown(topic, beside), json, beside.isEmpty() ? right(topic) : beside);
    }

    private <M> void showOwn(TopicCard<M> card, String json, String beside) {
        String topic = card.topic();
        TopicBinding.ShowOwn<M> showing =
                card.way()
                        .own()
                        .orElseThrow(
                                () ->
                                        new IllegalArgumentException(
                                                "no tab runs programs on topic " + topic));
        Optional<TopicInput> input =
                json.isEmpty()
                        ? Optional.empty()
                        : Optional.of(
                                new TopicInput(
                                        topic, "", GivenInput.read(named(topic).format(), json)));
        asked++;
        showing.show(models.of(card.lab()), input, beside);
        tellOwn(card, OwnMethods.NAME);
        bring(card);
    }

    /**
     * Has the program of a case run in the lab, where that can, else shows what is recorded; the
     * program is the text of its exercise from then on.
     */
    public void showCase(FirstCase one) {
        one.program()
                .ifPresent(
                        own ->
                                new OtherTexts(models.exercises())
                                        .open(own.exercise(), own.source(), own.file()));
        MethodCase scene = one.scene();
        String right = scene.method().orElse("");
        Optional<FirstCase.WrittenSource> program =
                one.program().filter(own -> obstacleToOwn(scene.topic()).isEmpty());
        if (program.isPresent()) {
            models.own().bring(program.get().exercise(), program.get().source());
            showOwn(scene.topic(), scene.input(), right);
        } else showInput(scene.topic(), scene.input(), right, scene.plotted());
    }

    /** The method whose answers a program's exercise calls right, or one that is right. */
    private String right(String topic) {
        return models.own()
                .of(topic)
                .flatMap(program -> program.exercise().tolerance().truth())
                .orElseGet(() -> OwnMethods.right(named(topic)));
    }

    @Override
    public boolean handsIn(String topic) {
        return card(topic).filter(card -> card.way().written().isPresent()).isPresent();
    }

    @Override
    public void showToHandIn(String exercise, String topic, String json) {
        TopicCard<?> card = shown(topic, "");
        // A program of another exercise does not belong to this one.
        String method = models.own().of(topic).isPresent() ? right(topic) : "";
        String input = json.isEmpty() && !method.isEmpty() ? written(card).orElse("") : json;
        if (input.isEmpty()) bring(card);
        else showInput(card, input, method, Optional.empty());
        tellHandingIn.accept(card.lab().name(), exercise(exercise));
    }

    private Exercise exercise(String id) {
        return Named.find("exercise", id, models.exercises().exercises(), Exercise::id);
    }

    @Override
    public boolean asksSteps(String topic) {
        return card(topic).isPresent();
    }

    @Override
    public void answerSteps(String exercise, HandedAnswers begun) {
        Exercise found = exercise(exercise);
        TopicCard<?> card = shown(found.topic(), "");
        models.practice(card.lab())
                .answer(
                        new GradedSheet(
                                found,
                                begun,
                                sheet -> {
                                    models.exercises().choose(exercise);
                                    models.exercises().type(sheet);
                                },
                                sheet -> {
                                    showTab.accept(new ExerciseRoom().name());
                                    models.exercises().handIn(exercise, sheet);
                                },
                                () -> showExercise(found)));
        showTab.accept(card.lab().name());
    }

    /**
     * Hands in what the lab of the exercise's topic shows, and shows the exercise; false where the
     * lab shows no input of that topic.
     */
    public boolean handIn(Exercise exercise) {
        Optional<String> input = written(exercise.topic());
        if (input.isEmpty()) return false;
        showTab.accept(new ExerciseRoom().name());
        models.exercises().handIn(exercise.id(), input.get());
        return true;
    }

    /** The input of that topic that its lab shows; empty where it shows none. */
    public Optional<String> written(String topic) {
        return written(shown(topic, ""));
    }

    private <M> Optional<String> written(TopicCard<M> card) {
        return card.way().written().flatMap(way -> way.input(models.of(card.lab())));
    }

    /** Notes that a tab tells nothing of the user's program any more. */
    public void hideOwn(String tab) {
        models.own().hideIn(tab);
    }

    /** Whether that tab has waited that long for a program of the user's. */
    public boolean isOwnAwaited(String tab, Duration least) {
        return models.own().awaited(least).stream()
                .flatMap(topic -> card(topic).stream())
                .anyMatch(card -> card.lab().name().equals(tab));
    }

    /** Shows the exercise that a program came from. */
    public void showExercise(Exercise exercise) {
        models.exercises().choose(exercise.id());
        showTab.accept(new ExerciseRoom().name());
    }

    private TopicInput input(String topic, String hazard) {
        List<Hazard<?>> hazards = List.copyOf(named(topic).hazards());
        Hazard<?> found = Named.find("hazard", hazard, hazards, Hazard::name);
        return new TopicInput(topic, hazard, found.input());
    }

    private Topic<?, ?, ?> named(String topic) {
        if (topics.isEmpty())
            for (Topic<?, ?, ?> each : Topics.all()) topics.put(each.name(), each);
        return Named.find("topic", topic, List.copyOf(topics.values()), Topic::name);
    }

    /**
     * The card of a topic that some tab shows.
     *
     * @throws IllegalArgumentException if none does, or the topic has no such method
     */
    private TopicCard<?> shown(String topic, String method) {
        if (!method.isEmpty()) models.own().method(named(topic), method);
        return card(topic)
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "no tab shows inputs of topic " + topic));
    }

    /** Asks for the cards, which whoever opens the window need not wait for. */
    private Optional<TopicCard<?>> card(String topic) {
        if (cards.isEmpty())
            for (TopicCard<?> card : LabRooms.cards()) cards.put(card.topic(), card);
        return Optional.ofNullable(cards.get(topic));
    }

    private <M> void show(TopicCard<M> card, M lab, TopicInput input, String method) {
        card.way().show().show(lab, input, method);
        tellOwn(card, method);
        tellHazard.accept(input.hazard());
        bring(card);
    }

    /** Brings the lab itself to the front, not the questions that it asks in its place. */
    private void bring(TopicCard<?> card) {
        models.practice(card.lab()).giveWay();
        showTab.accept(card.lab().name());
    }
}
