package rasterlab.app.study;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.work.Background;
import rasterlab.app.canvas.work.LatestReading;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.canvas.work.ThrottledUpdates;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.mine.OwnProgram;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.study.chart.StudyWork;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Progress;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyRunner;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;

/**
 * The tab of speed and accuracy without its window: which topic, what was measured, what is chosen.
 *
 * <p>Measuring runs on a thread of the model's own; commands and news run on the thread of the
 * executor it is given. What was measured of a topic stays until it is measured again, also from
 * one run of the program to the next; before that it is the result that ships with the program.
 */
public final class StudyLabModel implements Kept<StudyLabModel.Chosen>, AutoCloseable {
    /** The time between news of a measurement; to show more of them would slow it down. */
    private static final Duration BETWEEN_NEWS = Duration.ofMillis(50);

    /** The time between two charts of what was measured so far. */
    private static final Duration BETWEEN_POINTS = Duration.ofMillis(700);

    private final List<Topic<?, ?, ?>> topics;
    private final OwnMethods own;
    private final Runnable deaf;
    private final Background background;
    private final LatestReading reading;
    private final Map<String, Study> studies = new HashMap<>();
    private final Map<String, Study> shipped = new HashMap<>();
    private final Map<String, List<VerdictCell>> verdicts = new HashMap<>();
    private final Listeners<StudyLabState> listeners = new Listeners<>();
    private Optional<KeptStudies> kept = Optional.empty();
    private StudyLabState state;

    /** The tab of somebody without programs of his own. */
    public StudyLabModel(
            List<Topic<?, ?, ?>> topics, Executor events, Consumer<Throwable> onFailure) {
        this(topics, new OwnMethods(), events, onFailure);
    }

    /**
     * @param topics at least one
     * @param own has the user's program in its topic's list while there is one
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what measuring threw, on any thread
     */
    public StudyLabModel(
            List<Topic<?, ?, ?>> topics,
            OwnMethods own,
            Executor events,
            Consumer<Throwable> onFailure) {
        this.topics = List.copyOf(topics);
        this.own = own;
        deaf = own.whenBrought(topic -> events.execute(() -> renew(topic)));
        background = new Background("study", events, onFailure);
        reading = new LatestReading("kept studies", events, onFailure);
        state = first(topics.get(0), false, StudyView.CHART);
    }

    /** The part that is kept between runs beside the measurements. */
    record Chosen(String topic, boolean thorough, StudyView view) {}

    @Override
    public Class<Chosen> keptType() {
        return Chosen.class;
    }

    @Override
    public Chosen kept() {
        return new Chosen(state.topic().name(), state.thorough(), state.view());
    }

    @Override
    public void restore(Chosen choice) {
        choose(choice.topic());
        takeTime(choice.thorough());
        show(choice.view());
    }

    private StudyLabState first(Topic<?, ?, ?> topic, boolean thorough, StudyView view) {
        return new StudyLabState(
                own.listing(topic),
                thorough,
                view.isPossible(topic) ? view : StudyView.CHART,
                Optional.ofNullable(studies.get(topic.name())),
                verdicts.getOrDefault(topic.name(), List.of()),
                "",
                "",
                "",
                topic.methods().get(0).name(),
                StudyWork.NONE);
    }

    public StudyLabState state() {
        return state;
    }

    List<Topic<?, ?, ?>> topics() {
        return topics;
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<StudyLabState> listener) {
        return listeners.add(listener);
    }

    /**
     * Shows another topic; what is being measured is given up.
     *
     * @throws IllegalArgumentException naming the topics there are
     */
    public void choose(String topic) {
        Topic<?, ?, ?> chosen = Named.find("topic", topic, topics, Topic::name);
        if (chosen.name().equals(state.topic().name())) return;
        cancel();
        publish(first(chosen, state.thorough(), state.view()));
        readLastResult();
    }

    /**
     * Keeps the last result of each topic in a folder, and shows those that are there, or else
     * those that ship with the program.
     */
    public void keepIn(Path folder) {
        kept = Optional.of(new KeptStudies(folder.resolve("studies")));
        readLastResult();
    }

    /** Reads the last result of the topic that is shown, unless it has one. */
    private void readLastResult() {
        Topic<?, ?, ?> topic = plain(state.topic().name());
        if (kept.isEmpty() || studies.containsKey(topic.name())) return;
        KeptStudies from = kept.get();
        reading.accept(
                () -> {
                    try {
                        Optional<Study> read = from.read(topic);
                        if (read.isPresent()) return () -> showKept(read.get());
                        Optional<Study> other = ShippedStudies.of(topic);
                        return () -> other.ifPresent(this::showShipped);
                    } catch (Complaint unread) {
                        return () -> tell(topic, StudyWork.Kind.NOT_READ, unread);
                    }
                });
    }

    private void showShipped(Study study) {
        shipped.put(study.topic(), study);
        showKept(study);
    }

    /** The study that is shown, if it is the one that ships with the program. */
    Optional<Study> shippedStudy() {
        Study one = shipped.get(state.topic().name());
        return state.study().filter(study -> study.equals(one));
    }

    private void showKept(Study study) {
        boolean measured = studies.putIfAbsent(study.topic(), study) != null;
        if (!measured && isShown(study.topic())) publish(state.with(study));
    }

    private void tell(Topic<?, ?, ?> topic, StudyWork.Kind kind, Complaint why) {
        if (isShown(topic.name()) && !state.work().running())
            publish(state.with(StudyWork.failed(kind, why.getMessage())));
    }

    private boolean isShown(String topic) {
        return topic.equals(state.topic().name());
    }

    private Topic<?, ?, ?> plain(String topic) {
        return Named.find("topic", topic, topics, Topic::name);
    }

    /** Forgets what another program did on that topic before. */
    private void renew(String topic) {
        studies.computeIfPresent(topic, (name, before) -> KeptStudies.withoutOwn(before));
        verdicts.computeIfPresent(topic, (name, before) -> HazardRuns.withoutOwn(before));
        if (!isShown(topic)) return;
        cancel();
        publish(first(plain(topic), state.thorough(), state.view()));
    }

    /** Says whether the next measurement takes its time. */
    public void takeTime(boolean thorough) {
        publish(state.withThorough(thorough));
    }

    /** Shows that view of the topic, if there is such. */
    public void show(StudyView view) {
        if (view != state.view() && view.isPossible(plain(state.topic().name())))
            publish(state.with(view));
    }

    /** Shows the chart of what was measured elsewhere. */
    public void show(Study study) {
        choose(study.topic());
        studies.put(study.topic(), study);
        publish(state.with(study).with(StudyView.CHART));
    }

    /** Shows the chart of that workload; the chosen point is that of the same method. */
    void chooseLevel(String workload) {
        publish(state.withLevel(workload));
    }

    /** Chooses a point of the chart. */
    void choose(Measurement point) {
        publish(state.with(point));
    }

    /**
     * Chooses a pair of the table of hazards.
     *
     * @throws IllegalArgumentException naming the hazards or methods there are
     */
    public void choose(String hazard, String method) {
        publish(state.withCell(hazard(hazard).name(), state.topic().method(method).name()));
    }

    Hazard<?> hazard(String name) {
        List<? extends Hazard<?>> hazards = state.topic().hazards();
        return Named.find("hazard", name, hazards, Hazard::name);
    }

    /** The verdict on the method there that is written down. */
    String recorded(Hazard<?> hazard, Method<?> method) {
        if (method.name().equals(OwnMethods.NAME)) return "none";
        var kind = hazard.recorded().get(method.name());
        return kind == null ? "exact" : kind.code();
    }

    /** Measures speed and accuracy of every method of the topic. */
    public void measure() {
        Topic<?, ?, ?> topic = state.topic();
        StudySettings settings =
                state.thorough() ? StudySettings.thorough() : StudySettings.quick();
        begin(
                StudyWork.Kind.STUDY,
                tell -> {
                    var news = new ThrottledUpdates<Progress>(tell, BETWEEN_NEWS, this::tell);
                    var points = new ThrottledUpdates<Study>(tell, BETWEEN_POINTS, this::tellSoFar);
                    Study study =
                            measured(
                                    topic,
                                    settings,
                                    step -> news.accept(() -> step),
                                    points::accept);
                    Optional<Complaint> unkept = keep(study);
                    return () -> {
                        studies.put(topic.name(), study);
                        publish(state.with(study));
                        unkept.ifPresent(why -> tell(topic, StudyWork.Kind.NOT_KEPT, why));
                    };
                });
    }

    /** Writes a whole result where they are kept; answers why it could not be. */
    private Optional<Complaint> keep(Study study) {
        try {
            if (study.isWhole()) kept.ifPresent(where -> where.keep(study));
            return Optional.empty();
        } catch (Complaint unwritten) {
            return Optional.of(unwritten);
        }
    }

    private Study measured(
            Topic<?, ?, ?> topic,
            StudySettings settings,
            Consumer<Progress> progress,
            Consumer<Supplier<Study>> points)
            throws InterruptedException {
        Topic<?, ?, ?> plain = plain(topic.name());
        Optional<OwnProgram> program = own.of(topic.name());
        return program.isPresent()
                ? new OwnStudy<>(plain, program.get(), own)
                        .measure(settings, progress, Thread.currentThread()::isInterrupted)
                : StudyRunner.follow(
                        plain,
                        settings,
                        (step, soFar) -> {
                            progress.accept(step);
                            points.accept(soFar);
                        },
                        Thread.currentThread()::isInterrupted);
    }

    /** Shows the points as they come; they stay if it is cancelled. */
    private void tellSoFar(Study soFar) {
        if (!soFar.isTimed() || !isShown(soFar.topic())) return;
        studies.put(soFar.topic(), soFar);
        publish(state.with(soFar));
    }

    private void tell(Progress progress) {
        publish(
                state.with(
                        new StudyWork(
                                StudyWork.Kind.STUDY,
                                progress.done(),
                                progress.total(),
                                progress.method(),
                                progress.workload())));
    }

    /** Tries every method of the topic on each of its hazards. */
    public void tryHazards() {
        if (state.work().running()) return;
        Topic<?, ?, ?> topic = state.topic();
        int of = topic.methods().size() * topic.hazards().size();
        publish(state.withCells(List.of()));
        begin(
                StudyWork.Kind.HAZARDS,
                tell -> {
                    var judged = new ArrayList<VerdictCell>();
                    var news =
                            new ThrottledUpdates<List<VerdictCell>>(
                                    tell, BETWEEN_NEWS, cells -> tell(cells, of));
                    List<VerdictCell> all =
                            new HazardRuns(plain(topic.name()), own)
                                    .tried(
                                            cell -> {
                                                judged.add(cell);
                                                news.accept(() -> List.copyOf(judged));
                                            });
                    return () -> {
                        verdicts.put(topic.name(), all);
                        publish(state.withCells(all));
                    };
                });
    }

    private void tell(List<VerdictCell> cells, int of) {
        VerdictCell last = cells.get(cells.size() - 1);
        var work =
                new StudyWork(
                        StudyWork.Kind.HAZARDS, cells.size(), of, last.method(), last.hazard());
        publish(state.withCells(cells).with(work));
    }

    private void begin(StudyWork.Kind kind, Background.Task task) {
        if (state.work().running()) return;
        publish(state.with(StudyWork.begun(kind, 1)));
        background.begin(
                task,
                () -> publish(state.with(StudyWork.NONE)),
                failure -> {
                    throw new AssertionError("measuring reads and writes nothing", failure);
                });
    }

    /** Gives up what is being measured; what was measured so far, or before, stays. */
    public void cancel() {
        if (!state.work().running()) return;
        background.cancel();
        publish(
                state.with(StudyWork.GIVEN_UP)
                        .withCells(verdicts.getOrDefault(state.topic().name(), List.of())));
    }

    /** Ends the thread. */
    @Override
    public void close() {
        deaf.run();
        reading.close();
        background.close();
    }

    private void publish(StudyLabState next) {
        state = next;
        listeners.tell(next);
    }
}
