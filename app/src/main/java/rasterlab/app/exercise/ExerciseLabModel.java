package rasterlab.app.exercise;

import static rasterlab.app.exercise.Work.Phase.CHECKING;
import static rasterlab.app.exercise.Work.Phase.JOINING;
import static rasterlab.app.exercise.Work.Phase.SENDING;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rasterlab.app.canvas.Background;
import rasterlab.app.canvas.Kept;
import rasterlab.app.canvas.Listeners;
import rasterlab.app.canvas.ShellPath;
import rasterlab.app.course.Standings;
import rasterlab.app.exercise.JoinAnswer.Field;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.server.Account;
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
    final Formulas formulas = new Formulas();
    final Standings standings;
    private final ExerciseList exercises;
    private final CourseServer.Patience patience;
    private final OwnMethods own;
    private final Executor events;
    private final Background background;
    private final Checking checking = new Checking();
    private final Listeners<ExerciseState> listeners = new Listeners<>();
    private final Map<String, String> sources = new HashMap<>();
    private final Outcomes outcomes;
    private final HintDesk hints;

    /** Holds the key of each submission until it is graded, by exercise and source. */
    private final Map<String, String> keys = new HashMap<>();

    private ExerciseChoice chosen = ExerciseChoice.FIRST;
    private Optional<Path> folder = Optional.empty();
    private Optional<Drafts> drafts = Optional.empty();
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
        this(catalogue, own, CourseServer.Patience.USUAL, events, onFailure);
    }

    ExerciseLabModel(
            Supplier<List<Exercise>> catalogue,
            CourseServer.Patience patience,
            Executor events,
            Consumer<Throwable> onFailure) {
        this(catalogue, new OwnMethods(), patience, events, onFailure);
    }

    private ExerciseLabModel(
            Supplier<List<Exercise>> catalogue,
            OwnMethods own,
            CourseServer.Patience patience,
            Executor events,
            Consumer<Throwable> onFailure) {
        this.own = own;
        exercises = new ExerciseList(catalogue);
        this.patience = patience;
        standings = new Standings(patience, events, onFailure);
        this.events = events;
        background = new Background("exercise", events, onFailure);
        hints = new HintDesk(patience, events, onFailure, () -> publish(changed()));
        outcomes = new Outcomes(id -> drafts.flatMap(held -> held.outcomePath(id)), events);
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

    ExerciseState state() {
        if (state == null) open();
        return state;
    }

    private void open() {
        drafts =
                folder.map(
                        kept ->
                                new Drafts(
                                        kept.resolve("drafts"),
                                        exercises::ending,
                                        saving -> events.execute(() -> accept(saving))));
        Exercise first = exercises.namedOrFirst(chosen.exercise());
        chosen = chosen.with(first.id());
        state = ExerciseState.of(first, source(first));
        state = changed().otherDrafts(others(first)).made();
        folder.ifPresent(this::loadAccount);
        outcomes.read(first, outcome -> show(first, outcome));
    }

    private void loadAccount(Path kept) {
        try {
            state = changed().account(new AccountFile(kept).load()).made();
        } catch (IOException e) {
            state = changed().notice(Notice.of("account.unreadable", e.getMessage())).made();
        }
    }

    /** All there are; on any thread. */
    List<Exercise> exercises() {
        return exercises.get();
    }

    /** The open cases of the chosen exercise, none of them tried. */
    List<TriedCase> untried() {
        return TriedCase.untried(state().exercise());
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    Runnable listen(Consumer<ExerciseState> listener) {
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
                        .exercise(next, source(next))
                        .otherDrafts(others(next))
                        .outcome(outcomes.of(next))
                        .notice(Notice.NONE)
                        .unsaved(unsaved(id)));
        outcomes.read(next, outcome -> show(next, outcome));
    }

    /** Takes the text as the user has just left it, and keeps it. */
    public void type(String source) {
        if (source.equals(state().source())) return;
        String id = state.exercise().id();
        sources.put(id, source);
        drafts.ifPresent(kept -> kept.save(id, source));
        publish(changed().source(source));
    }

    /** Begins anew with the exercise's own text, or with a new sheet. */
    public void restoreStarter() {
        var beginning = new Beginning(state().exercise(), state.account(), patience);
        beginning.give(this::type, this::tell, (task, no) -> begin(Work.of(JOINING), task, no));
    }

    /** Shows the next hint, or asks the server what it costs. */
    void takeHint() {
        hints.next(state().exercise(), state.account());
    }

    /** What may be shown of the hints of the chosen exercise. */
    HintView hints() {
        return hints.of(state().exercise(), state.account());
    }

    HintDesk hintDesk() {
        return hints;
    }

    /**
     * The shell command that checks the source as it is kept; empty where it is not on the disk.
     */
    Optional<String> command() {
        String id = state().exercise().id();
        if (!state.unsaved().isEmpty()) return Optional.empty();
        return drafts.flatMap(kept -> kept.path(id))
                .map(path -> "./lab check " + id + " " + ShellPath.quoted(path));
    }

    /** Lets the labs run a source as a program for the chosen exercise. */
    void bringToLabs(String source) {
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
    public void bringBack(ExerciseChoice choice) {
        chosen = choice;
        if (state != null
                && exercises().stream().anyMatch(one -> one.id().equals(choice.exercise())))
            choose(choice.exercise());
    }

    /** The sources that are not on the disk; tries once more to write them, and waits for that. */
    public List<UnsavedDraft> unsavedDrafts() throws InterruptedException {
        return drafts.isPresent() ? drafts.get().unsaved() : List.of();
    }

    /** Goes on with what another window wrote. */
    void takeDraft(DraftFile.Other draft) {
        type(draft.text());
        publish(changed().otherDrafts(others(state.exercise())));
    }

    /** Tries the source on the open cases on this machine. */
    public void check() {
        Exercise exercise = state().exercise();
        String source = state.source();
        int of = untried().size() + 1;
        begin(
                new Work(CHECKING, 0, of, List.of()),
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

    /** A form asks for a course, to which there is no answer yet. */
    void askForCourse() {
        publish(changed().joining(JoinAnswer.NONE));
    }

    /**
     * Joins a course, to submit to it from now on.
     *
     * @param address of the server
     * @param code of the course
     * @param name of the student
     */
    void join(String address, String code, String name) {
        String key = key(address + "\n" + code + "\n" + name);
        server(address).ifPresent(at -> join(at, course -> course.join(code, name, key)));
    }

    /** Submits with a token that the student has already, if the server knows it. */
    void signIn(String address, String token) {
        server(address).ifPresent(server -> join(server, course -> course.known(token.strip())));
    }

    private Optional<URI> server(String address) {
        try {
            return Optional.of(Account.server(address));
        } catch (IllegalArgumentException e) {
            accept(JoinAnswer.refused(Field.ADDRESS, Notice.of("server.address", address)));
            return Optional.empty();
        }
    }

    private void join(URI server, Joining joining) {
        begin(
                Work.of(JOINING),
                tell -> {
                    var account = joining.with(new CourseServer(server, patience));
                    return () -> use(account);
                },
                failure -> accept(ServerNotices.joining(server, failure)));
    }

    private void accept(JoinAnswer refused) {
        publish(changed().joining(refused).notice(refused.problem()));
    }

    private void use(Account account) {
        Notice notice =
                folder.flatMap(kept -> new AccountFile(kept).unsaved(account))
                        .orElse(Notice.of("joined", account.toString()));
        var joined = changed().account(Optional.of(account)).joining(JoinAnswer.JOINED);
        publish(joined.notice(notice));
    }

    /** Hands the source in and follows its grading; needs an account. */
    public void submit() {
        if (state().account().isEmpty()) {
            tell(Notice.of("noAccount"));
            return;
        }
        var account = state.account().get();
        Exercise exercise = state.exercise();
        String source = state.source();
        String about = account.server() + "\n" + exercise.id() + "\n" + source;
        String key = key(about);
        var submitting = Submitting.to(account, patience, exercise.form());
        begin(
                Work.of(SENDING),
                tell -> {
                    UnreadableSheet.check(exercise, source);
                    Outcome outcome =
                            submitting.result(
                                    exercise.id(),
                                    source,
                                    key,
                                    new GradingWork(
                                            work ->
                                                    tell.accept(
                                                            () -> publish(changed().work(work)))));
                    return () -> {
                        keys.remove(about);
                        accept(exercise, outcome);
                    };
                },
                failure -> tell(ServerNotices.of(account.server(), failure)));
    }

    private String key(String about) {
        return keys.computeIfAbsent(about, is -> UUID.randomUUID().toString());
    }

    private void judged(List<TriedCase> cases, int of) {
        publish(changed().work(new Work(CHECKING, cases.size(), of, cases)));
    }

    private void begin(Work first, Background.Task task, Consumer<IOException> failed) {
        if (state().work().running()) return;
        publish(changed().work(first).notice(Notice.NONE).joining(JoinAnswer.NONE));
        background.begin(task, () -> publish(changed().work(Work.NONE)), failed);
    }

    /** Gives up what runs. */
    public void cancel() {
        if (!state().work().running()) return;
        background.cancel();
        publish(changed().work(Work.NONE).notice(Notice.of(state.work().givenUp())));
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
        Notice unsaved = unsaved(saving.exercise());
        if (shown && !unsaved.equals(state.unsaved())) publish(changed().unsaved(unsaved));
    }

    private Notice unsaved(String exercise) {
        String problem = drafts.map(kept -> kept.problem(exercise)).orElse("");
        return problem.isEmpty() ? Notice.NONE : Notice.of("draft.unsaved", problem);
    }

    private String source(Exercise exercise) {
        return sources.computeIfAbsent(
                exercise.id(),
                id -> drafts.flatMap(kept -> kept.open(id)).orElse(Beginning.here(exercise)));
    }

    private List<DraftFile.Other> others(Exercise exercise) {
        String own = source(exercise);
        return drafts.map(kept -> kept.others(exercise.id(), own)).orElse(List.of());
    }

    /** Waits until every change so far is on the disk or told not to be. Any other thread. */
    void settle() throws InterruptedException {
        if (drafts.isPresent()) drafts.get().settle();
        outcomes.settle();
    }

    /** Gives up what runs, and writes what is not written yet. */
    @Override
    public void close() {
        background.close(checking::close);
        outcomes.close();
        standings.close();
        hints.close();
        drafts.ifPresent(Drafts::close);
    }

    void tell(Notice notice) {
        publish(changed().notice(notice));
    }

    private ExerciseStateChange changed() {
        return new ExerciseStateChange(state());
    }

    private void publish(ExerciseStateChange change) {
        state = change.made();
        listeners.tell(state);
    }
}
