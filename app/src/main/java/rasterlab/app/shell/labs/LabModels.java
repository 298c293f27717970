package rasterlab.app.shell.labs;

import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.ThreadLocalRandom;
import java.util.function.Consumer;
import java.util.function.Function;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.card.LabRoom;
import rasterlab.app.exercise.ExerciseLabModel;
import rasterlab.app.exercise.UnsavedDraft;
import rasterlab.app.exercise.panel.ExerciseRoom;
import rasterlab.app.found.FoundHazards;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.practice.PracticeExercises;
import rasterlab.app.practice.PracticeModel;
import rasterlab.app.study.StudyLabModel;
import rasterlab.app.study.StudyRoom;

/**
 * The labs' models, which outlive the panels that show them; used on the event thread. Each is made
 * when it is first asked for; since that takes long, {@link #make} asks on another thread before.
 */
public final class LabModels implements AutoCloseable {
    /** The mode "which is next?" of each tab that was shown. */
    private final Map<String, PracticeModel> practice = new LinkedHashMap<>();

    private final PracticeExercises exercises = new PracticeExercises();

    /** The models by the names of their tabs. */
    private final Map<String, LabModel<?>> labs = new LinkedHashMap<>();

    private final OwnMethods own = new OwnMethods();
    private final HandInOffers handIn = new HandInOffers();
    private final Executor events;
    private final Consumer<Map<String, Kept<?>>> restore;
    private final Consumer<Throwable> onFailure;

    /** The states of the labs when they were made, by the names under which they are kept. */
    private final Map<String, Object> asMade = new ConcurrentHashMap<>();

    private Optional<FoundHazards> found = Optional.empty();

    private LabModels(
            Executor events,
            Consumer<Map<String, Kept<?>>> restore,
            Consumer<Throwable> onFailure) {
        this.events = events;
        this.restore = restore;
        this.onFailure = onFailure;
        TabRooms.all().forEach(this::add);
    }

    private <M> void add(LabRoom<M> room) {
        Function<Executor, M> making = held -> room.model(held, onFailure, own);
        labs.put(room.name(), new LabModel<>(making, room::keep, room::close, events, this::begin));
    }

    private void begin(Map<String, Kept<?>> kept) {
        restore.accept(kept);
        asMade.putAll(LabsFile.choices(kept));
    }

    /**
     * Every lab as it opens, made.
     *
     * @param onFailure told what background work threw, on any thread
     */
    public static LabModels first(Consumer<Throwable> onFailure) {
        return first(EventQueue::invokeLater, onFailure);
    }

    /** Every lab as it opens, made, with other events than the window's. */
    public static LabModels first(Executor events, Consumer<Throwable> onFailure) {
        LabModels models = unmade(events, kept -> {}, onFailure);
        models.makeAll();
        return models;
    }

    /**
     * The models of a new window, none of them made.
     *
     * @param events runs what it is given on one thread, in order
     * @param restore brings parts of a lab that is made, by the name under which they are kept, to
     *     what they showed; on the thread that makes the lab
     * @param onFailure told what background work threw, on any thread
     */
    public static LabModels unmade(
            Executor events,
            Consumer<Map<String, Kept<?>>> restore,
            Consumer<Throwable> onFailure) {
        return new LabModels(events, restore, onFailure);
    }

    /**
     * Makes what is not made of what a tab needs, the first one for a name that none has. What is
     * closed meanwhile is not made.
     */
    public void make(String tab) {
        lab(TabRooms.namedOrFirst(tab)).prepare();
    }

    /** Makes what is not made and not closed meanwhile. */
    public void makeAll() {
        labs.values().forEach(LabModel::prepare);
    }

    /** The model of that lab; the same one every time. */
    public <M> M of(LabRoom<M> room) {
        return lab(room).get();
    }

    @SuppressWarnings("unchecked") // under a room's name is the model that the room makes
    private <M> LabModel<M> lab(LabRoom<M> room) {
        return (LabModel<M>) labs.get(room.name());
    }

    /** The user's programs, which the labs have among their methods. */
    public OwnMethods own() {
        return own;
    }

    /** Remembers what is said over the labs of handing their input in. */
    public HandInOffers handIn() {
        return handIn;
    }

    /** The mode "which is next?" of that lab; the same one every time. */
    public PracticeModel practice(LabRoom<?> room) {
        return practice.computeIfAbsent(
                room.name(),
                name -> new PracticeModel(exercises, LabModels::seed, events, onFailure));
    }

    private static long seed() {
        return ThreadLocalRandom.current().nextLong(PracticeModel.SEEDS);
    }

    public StudyLabModel study() {
        return of(new StudyRoom());
    }

    public ExerciseLabModel exercises() {
        return of(new ExerciseRoom()).model();
    }

    /** Keeps the exercises' sources and what was measured in a folder, where finds are too. */
    public void keepSourcesIn(Path folder) {
        found = Optional.of(FoundHazards.in(folder));
        lab(new ExerciseRoom()).whenMade(desk -> desk.model().keepIn(folder));
        lab(new StudyRoom()).whenMade(study -> study.keepIn(folder));
    }

    /** The hazards that the user keeps; empty where no folder is known. */
    public Optional<FoundHazards> found() {
        return found;
    }

    /** The sources that are not on the disk; tries once more to write them, and waits for that. */
    public List<UnsavedDraft> unsavedDrafts() throws InterruptedException {
        Optional<ExerciseRoom.Desk> made = lab(new ExerciseRoom()).ifMade();
        return made.isPresent() ? made.get().model().unsavedDrafts() : List.of();
    }

    /**
     * The labs that open as they were left, of those that are made, by the names under which they
     * are kept.
     */
    public Map<String, Kept<?>> kept() {
        var kept = new LinkedHashMap<String, Kept<?>>();
        labs.values().forEach(lab -> kept.putAll(lab.kept()));
        return kept;
    }

    /** The states of the labs when they were made, by the same names. */
    Map<String, Object> asMade() {
        return Map.copyOf(asMade);
    }

    /** Ends background work; what is not made stays so. */
    @Override
    public void close() {
        labs.values().forEach(LabModel::giveUp);
        labs.values().forEach(LabModel::close);
        own.close();
        practice.values().forEach(PracticeModel::close);
    }
}
