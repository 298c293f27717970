package rasterlab.app.exercise;

import static rasterlab.app.exercise.BackgroundWork.Phase.CHECKING;
import static rasterlab.app.exercise.BackgroundWork.Phase.READING;
import static rasterlab.app.exercise.BackgroundWork.Phase.SENDING;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.file.ShellPath;
import rasterlab.app.canvas.work.Background;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.course.Standings;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.outcome.Outcomes;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.server.CourseServer;
import rasterlab.engine.naming.Named;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.formula.Formulas;

/**
 * The tab of exercises without its window: which exercise, its source, what was said to it.
 *
 * <p>Checks and talks with a server run on a thread of the model's own; commands and news all run
 * on the thread of the executor it is given. Nothing is read before the state is first asked for.
 */
public final class ExerciseLabModel implements Kept<ExerciseChoice>, AutoCloseable {
    public final Formulas formulas = new Formulas();
    public final Standings standings;
    final ExerciseList exercises;
    private final CourseServer.ServerTimeouts patience;
    private final OwnMethods own;
    private final Executor events;
    private final Background background;
    private final Checking checking = new Checking();
    private final Listeners<ExerciseState> listeners = new Listeners<>();
    private final Outcomes outcomes;
    private final HintDesk hints;
    private final Enrolment enrolment;

    /** Holds the key of each submission until it is graded, by exercise and source. */
    private final Map<String, String> keys = new HashMap<>();

    private ExerciseChoice chosen = ExerciseChoice.FIRST;
    private Optional<Path> folder = Optional.empty();
    Sources sources = new Sources(Optional.empty());
    private ExerciseState state;

    /** The tab of a window without labs. */
    public ExerciseLabModel(
            Supplier<List<Exercise>> catalogue, Executor events, Consumer<Throwable> onFailure) {
        this(catalogue, new OwnMethods(), events, onFailure);
    }

    /**
     * @param catalogue read once, when the exercises are first asked for
     * @param own takes the programs that labs are to run
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what a check threw, on any thread
     */
    public ExerciseLabModel(
            Supplier<List<Exercise>> catalogue,
            OwnMethods own,
            Executor events,
            Consumer<Throwable> onFailure) {
        this(catalogue, own, CourseServer.ServerTimeouts.USUAL, events, onFailure);
    }

    ExerciseLabModel(
            Supplier<List<Exercise>> catalogue,
            CourseServer.ServerTimeouts patience,
            Executor events,
            Consumer<Throwable> onFailure) {
        this(catalogue, new OwnMethods(), patience, events, onFailure);
    }

    private ExerciseLabModel(
            Supplier<List<Exercise>> catalogue,
            OwnMethods own,
            CourseServer.ServerTimeouts patience,
            Executor events,
            Consumer<Throwable> onFailure) {
        this.own = own;
        exercises = new ExerciseList(catalogue);
        this.patience = patience;
        enrolment = new Enrolment(this, patience);
        standings = new Standings(patience, events, onFailure);
        this.events = events;
        background = new Background("exercise", events, onFailure);
        hints = new HintDesk(patience, events, onFailure, () -> publish(changed()));
        outcomes = new Outcomes(id -> sources.outcomePath(id), events);
    }

    /**
     * Keeps sources and the account in that folder; without one they end with the window.
     *
     * @throws IllegalStateException when the state was asked for before
     */
    public void keepIn(Path folder) {
        if (state != null) throw new IllegalStateException("sources are kept elsewhere already");
        this.folder = Optional.of(folder);
        standings.readFrom(folder.resolve("drafts"));
    }

    public ExerciseState state() {
        if (state == null) open();
        return state;
    }

    private void open() {
        sources = new Sources(folder.map(this::drafts));
        Exercise first = exercises.namedOrFirst(chosen.exercise());
        chosen = chosen.with(first.id());
        state = ExerciseState.of(first, sources.of(first));
        state = changed().otherDrafts(sources.others(first)).made();
        folder.ifPresent(this::loadAccount);
        outcomes.read(first, outcome -> show(first, outcome));
    }

    private Drafts drafts(Path kept) {
        return new Drafts(
                kept.resolve("drafts"),
                exercises::ending,
                saving -> events.execute(() -> accept(saving)));
    }

    private void loadAccount(Path kept) {
        try {
            state = changed().account(new AccountFile(kept).load()).made();
        } catch (IOException e) {
            state = changed().notice(Notice.of("account.unreadable", e.getMessage())).made();
        }
    }

    public void readAhead() {
        exercises.readAhead();
    }

    /** All there are; on any thread. */
    public List<Exercise> exercises() {
        return exercises.get();
    }

    /** The open cases of the chosen exercise, none of them tried. */
    public List<CaseResult> untried() {
        return CaseResult.untried(state().exercise());
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<ExerciseState> listener) {
        return listeners.add(listener);
    }

    /**
     * Shows another exercise; work on the one that was shown is given up.
     *
     * @throws IllegalArgumentException naming the exercises there are
     */
    public void choose(String id) {
        Exercise next = Named.find("exercise", id, exercises(), Exercise::id);
        if (next.equals(state().exercise())) return;
        cancel();
        hints.turnTo();
        chosen = chosen.with(id);
        publish(
                changed()
                        .exercise(next, sources.of(next))
                        .otherDrafts(sources.others(next))
                        .outcome(outcomes.of(next))
                        .notice(Notice.NONE)
                        .unsaved(sources.problem(id)));
        outcomes.read(next, outcome -> show(next, outcome));
    }

    public Beginning beginning() {
        return new Beginning(state().exercise(), state.account(), patience);
    }

    /** Takes the text as the user has just left it, and keeps it. */
    public void type(String source) {
        if (source.equals(state().source())) return;
        sources.put(state.exercise().id(), source);
        publish(changed().source(source));
    }

    /** Begins anew with the exercise's own text, or with a new sheet. */
    public void restoreStarter() {
        var reading = BackgroundWork.of(READING);
        beginning().give(this::type, this::tell, (task, no) -> begin(reading, task, no));
    }

    /** Shows the next hint, or asks the server what it costs. */
    public void takeHint() {
        hints.next(state().exercise(), state.account());
    }

    /** The part of the chosen exercise's hints that may be shown. */
    public HintView hints() {
        return hints.of(state().exercise(), state.account());
    }

    public HintDesk hintDesk() {
        return hints;
    }

    /**
     * The shell command that checks the source as it is kept; empty where it is not on the disk.
     */
    public Optional<String> command() {
        String id = state().exercise().id();
        if (!state.unsaved().isEmpty()) return Optional.empty();
        return sources.path(id).map(path -> "./lab check " + id + " " + ShellPath.quoted(path));
    }

    /** Lets the labs run a source as a program for the chosen exercise. */
    public void bringToLabs(String source) {
        own.bring(state().exercise(), source);
    }

    /** Makes the editor's type larger, or smaller; stops where it cannot be read. */
    public void growType(int points) {
        chosen = chosen.grown(points);
    }

    @Override
    public Class<ExerciseChoice> keptType() {
        return ExerciseChoice.class;
    }

    @Override
    public ExerciseChoice kept() {
        return chosen;
    }

    /** An exercise that there is no more gives way to the first one. */
    @Override
    public void restore(ExerciseChoice choice) {
        chosen = choice;
        if (state != null
                && exercises().stream().anyMatch(one -> one.id().equals(choice.exercise())))
            choose(choice.exercise());
    }

    /** The sources that are not on the disk; tries once more to write them, and waits for that. */
    public List<UnsavedDraft> unsavedDrafts() throws InterruptedException {
        return sources.unsaved();
    }

    /** Tries the source on the open cases on this machine. */
    public void check() {
        Exercise exercise = state().exercise();
        String source = state.source();
        int of = untried().size() + 1;
        begin(
                new BackgroundWork(CHECKING, 0, of, List.of()),
                tell -> {
                    Outcome outcome =
                            checking.outcome(
                                    exercise,
                                    source,
                                    cases -> tell.accept(() -> judged(cases, of)));
                    return () -> accept(exercise, outcome);
                },
                failure -> tell(Notice.of("failed", failure.toString())));
    }

    /** Joins courses and signs in, for a form. */
    public Enrolment enrolment() {
        return enrolment;
    }

    /** The folder that the account is kept in; empty where it ends with the window. */
    Optional<Path> folder() {
        return folder;
    }

    /**
     * Hands in an input or a sheet from a lab: to the server where a course was joined, else on
     * this machine.
     */
    public void handIn(String id, String json) {
        choose(id);
        type(HandedInput.taken(state().exercise(), state.source(), json));
        if (state.account().isPresent()) submit();
        else check();
    }

    /** Hands the source in and follows its grading; needs an account. */
    public void submit() {
        submit(false);
    }

    public void submit(boolean late) {
        if (state().account().isEmpty()) {
            tell(Notice.of("noAccount"));
            return;
        }
        var account = state.account().get();
        Exercise exercise = state.exercise();
        String source = state.source();
        String about = account.server() + "\n" + exercise.id() + "\n" + source;
        String key = key(about);
        var submitting = Submitting.to(account, patience, exercise.form()).late(late);
        begin(
                BackgroundWork.of(SENDING),
                tell -> {
                    UnreadableSheet.check(exercise, source);
                    var follower = new GradingWork(work -> tell.accept(() -> show(work)));
                    Outcome outcome = submitting.result(exercise.id(), source, key, follower);
                    return () -> {
                        keys.remove(about);
                        accept(exercise, outcome);
                    };
                },
                failure -> tell(ServerNotices.of(account.server(), failure)));
    }

    private void judged(List<CaseResult> cases, int of) {
        show(new BackgroundWork(CHECKING, cases.size(), of, cases));
    }

    private void show(BackgroundWork work) {
        publish(changed().work(work));
    }

    /** The key of a request: the same each time it is tried, until it is answered. */
    String key(String about) {
        return keys.computeIfAbsent(about, is -> UUID.randomUUID().toString());
    }

    public void begin(BackgroundWork first, Background.Task task, Consumer<IOException> failed) {
        if (state().work().running()) return;
        publish(changed().work(first).notice(Notice.NONE).joining(JoinAnswer.NONE));
        background.begin(task, () -> publish(changed().work(BackgroundWork.NONE)), failed);
    }

    /** Gives up what runs. */
    public void cancel() {
        if (!state().work().running()) return;
        background.cancel();
        publish(changed().work(BackgroundWork.NONE).notice(Notice.of(state.work().givenUp())));
    }

    private void accept(Exercise exercise, Outcome outcome) {
        outcomes.keep(exercise, outcome);
        show(exercise, outcome);
    }

    private void show(Exercise exercise, Outcome outcome) {
        if (exercise.equals(state.exercise())) publish(changed().outcome(Optional.of(outcome)));
    }

    private void accept(Drafts.Saving saving) {
        boolean shown = state != null && saving.exercise().equals(state.exercise().id());
        Notice unsaved = sources.problem(saving.exercise());
        if (shown && !unsaved.equals(state.unsaved())) publish(changed().unsaved(unsaved));
    }

    /** Gives up what runs, and writes what is not written yet. */
    @Override
    public void close() {
        background.close(checking::close);
        outcomes.close();
        standings.close();
        hints.close();
        sources.close();
    }

    public void tell(Notice notice) {
        publish(changed().notice(notice));
    }

    ExerciseStateChange changed() {
        return new ExerciseStateChange(state());
    }

    void publish(ExerciseStateChange change) {
        state = change.made();
        listeners.tell(state);
    }
}
