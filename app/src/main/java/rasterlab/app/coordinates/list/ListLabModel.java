package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.coordinates.figure.ChoiceModel;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.MatrixTopic;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;

/**
 * The lab of lists without its window: which matrices, read how, and how many of them are done. The
 * steps are the matrices.
 *
 * <p>Methods are tried on a thread of the model's own; answers and commands all run on the thread
 * of the executor it is given.
 */
public final class ListLabModel extends ChoiceModel<ListChoice> implements Steps, AutoCloseable {
    private static final double TURN = 180;
    private static final String FORMULA = "formula";
    private static final String PRINTED = "formula-textbook";

    private final MatrixTopic topic = new MatrixTopic();
    private final Trials trials;
    private final LatestOnly<Trial, TrialScene> tried;
    private ListScene scene;
    private Optional<Trial> asked = Optional.empty();
    private Optional<TrialScene> trial = Optional.empty();
    private int step;

    /** A lab for a user without own programs. */
    public ListLabModel(Executor events, Consumer<Throwable> onFailure) {
        this(new OwnMethods(), events, onFailure);
    }

    /**
     * @param own the programs of the user's
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what trying threw, on any thread
     */
    public ListLabModel(OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        super(ListChoice.first());
        trials = new Trials(own);
        scene = ListScene.of(topic, choice());
        step = scene.last();
        tried =
                new LatestOnly<>(
                        "trial",
                        (question, cancelled) -> trials.scene(question),
                        (question, answer) -> events.execute(() -> accept(answer)),
                        onFailure);
    }

    ListScene scene() {
        return scene;
    }

    List<Method<MatrixFormula>> methods() {
        return topic.methods();
    }

    Method<MatrixFormula> method() {
        return topic.method(choice().method());
    }

    List<Hazard<MatrixCall>> hazards() {
        return topic.hazards();
    }

    /** Names of the matrices that fit the subject, and the free one first. */
    List<String> names(int dimension) {
        var names = new ArrayList<String>();
        names.add(ListItem.FREE);
        for (NamedMatrix matrix : NamedMatrices.all())
            if (matrix.size() == dimension + 1
                    && !matrix.name().startsWith("HERMITE")
                    && !matrix.name().equals("BEZIER")) names.add(matrix.name());
        return names;
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        change(choice().withMethod(topic.method(method).name()));
    }

    /** Shows a hazard's matrix alone, by the printed cells where those are wrong. */
    public void show(Hazard<MatrixCall> hazard) {
        boolean printedRight = hazard.recorded().get(PRINTED) == Verdict.Kind.EXACT;
        rearrange(alone(hazard.input()).withMethod(printedRight ? choice().method() : PRINTED));
        goTo(last());
    }

    /** Shows a matrix alone. */
    public void show(MatrixCall call) {
        rearrange(alone(call));
        goTo(last());
    }

    private ListChoice alone(MatrixCall call) {
        ListItem item = ListItem.of(call);
        ListChoice next = choice();
        if (item.dimension() != next.dimension())
            next = next.with(item.dimension() == 2 ? Subject.SQUARE : Subject.CUBE);
        return next.withItems(List.of(item), 0);
    }

    Trials trials() {
        return trials;
    }

    /**
     * Shows a hazard about points of space, and what a method makes of it.
     *
     * @throws IllegalArgumentException naming what there is
     */
    public void show(Trial next) {
        rearrange(choice().with(trials.list(next), next, FORMULA));
        goTo(last());
    }

    /**
     * Shows the same by the method that was tried last, or the first one where the topic is
     * another.
     *
     * @param method "" for none in particular
     */
    public void show(String topic, String hazard, String method) {
        String kept =
                choice().trial()
                        .filter(now -> now.topic().equals(topic))
                        .orElseGet(() -> trials.first(topic))
                        .method();
        show(new Trial(topic, hazard, method.isEmpty() ? kept : method));
    }

    /**
     * Shows another input of the topic as it shows hazards.
     *
     * @param method "" for the one that was tried last, or the first where the topic is another
     */
    public void show(String topic, Object input, String method) {
        show(topic, trials.kind(topic).given(input), method);
    }

    /** The list as an input of the topic, in JSON; empty where it is none. */
    public Optional<String> input(String of) {
        return of.equals(topic.name())
                ? choice().selectedCall().map(call -> GivenInput.name(topic, call))
                : trials.input(of, scene);
    }

    /** Shows the topic: what is tried of it, or its first hazard. */
    public void enter(String topic) {
        if (choice().trial().filter(now -> now.topic().equals(topic)).isEmpty())
            show(trials.first(topic));
    }

    /** Tries another method on the same hazard, where there is one. */
    public void tryMethod(String method) {
        choice().trial().ifPresent(now -> change(choice().with(now.by(method))));
    }

    /**
     * The result of a method for the hazard: the method of the choice, or the one before until that
     * has answered. Empty before the first answer and where nothing is tried.
     */
    Optional<TrialScene> trial() {
        return trial;
    }

    /** The trial, where the stage shows it: once all matrices are done. */
    Optional<TrialScene> shownTrial() {
        return trial.filter(known -> step == last());
    }

    /** The result of another method for the same hazard stays until the answer is there. */
    private void ask(Optional<Trial> next) {
        if (next.equals(asked)) return;
        asked = next;
        if (next.isEmpty()) tried.cancel();
        if (next.filter(now -> trial.filter(old -> old.trial().isLike(now)).isPresent()).isEmpty())
            trial = Optional.empty();
        next.ifPresent(tried::ask);
    }

    private void accept(TrialScene answer) {
        if (choice().trial().filter(answer.trial()::equals).isEmpty()) return;
        trial = Optional.of(answer);
        tell();
    }

    /** Waits until every trial so far is answered or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        tried.settle();
    }

    /** Ends the thread. */
    @Override
    public void close() {
        tried.close();
    }

    public void show(Example example) {
        rearrange(example.in(choice()));
        goTo(last());
    }

    public void choose(Subject subject) {
        rearrange(choice().with(subject));
    }

    /** Reads the list another way, from its beginning on. */
    public void read(Reading reading) {
        change(choice().with(reading));
    }

    public void select(int index) {
        pass(choice().withSelected(index));
    }

    /** Adds a matrix behind the selected one; none beyond {@link ListChoice#MOST}. */
    public void add(String name) {
        ListChoice now = choice();
        if (now.items().size() >= ListChoice.MOST) return;
        var items = new ArrayList<>(now.items());
        int at = now.selected() + 1;
        items.add(at, ListItem.first(name, now.dimension()));
        edit(now.withItems(items, at));
    }

    /** Removes the selected matrix. */
    public void remove() {
        ListChoice now = choice();
        if (now.selected() < 0) return;
        var items = new ArrayList<>(now.items());
        items.remove(now.selected());
        edit(now.withItems(items, now.selected()));
    }

    /** Moves the selected matrix so many places towards the end. */
    public void move(int by) {
        ListChoice now = choice();
        int to = now.selected() + by;
        if (now.selected() < 0 || to < 0 || to >= now.items().size()) return;
        var items = new ArrayList<>(now.items());
        Collections.swap(items, now.selected(), to);
        edit(now.withItems(items, to));
    }

    /**
     * Sets another number for the selected matrix; one out of its range is shown with why it is
     * refused.
     */
    public void set(int number, double value) {
        ListChoice now = choice();
        var items = new ArrayList<>(now.items());
        items.set(now.selected(), items.get(now.selected()).with(number, value));
        change(now.withItems(items, now.selected()));
    }

    /** Moves a point of the subject as it is given; of the plane only. */
    public void movePoint(int index, double x, double y) {
        if (choice().dimension() == 2) change(choice().withPoint(index, x, y));
    }

    /** Turns the viewpoint by shares of half a turn. */
    public void turn(double right, double up) {
        turnBy(TURN * right, -TURN * up);
    }

    public void turnBy(double alphaDegrees, double betaDegrees) {
        change(choice().with(choice().viewpoint().turned(alphaDegrees, betaDegrees)));
    }

    /** Changes the list and shows all of it. */
    private void edit(ListChoice next) {
        boolean ended = step == last();
        change(next);
        if (ended) goTo(last());
    }

    /** How far the selected matrix is from the exact one; empty for a free or a refused one. */
    Optional<Deviation> deviation() {
        ListChoice now = choice();
        if (now.selected() < 0 || scene.isRefused()) return Optional.empty();
        ListItem item = now.items().get(now.selected());
        if (item.free()) return Optional.empty();
        return Optional.of(
                topic.compare(
                        item.call(),
                        topic.exact(item.call(), Integer.MAX_VALUE),
                        topic.record(method().implementation(), item.call(), Integer.MAX_VALUE)));
    }

    /** Whether an error of that size is rounding. */
    boolean correct(Deviation deviation) {
        return topic.correct(deviation);
    }

    /** Leaves the hazard, if there is one; its points and matrices stay. */
    void endTrial() {
        change(choice().withoutTrial());
    }

    @Override
    protected void chosen(ListChoice next) {
        trials.require(next);
        ask(next.trial());
        scene = ListScene.of(topic, next);
        step = Math.min(step, scene.last());
    }

    @Override
    public int last() {
        return scene.last();
    }

    @Override
    public int step() {
        return step;
    }

    @Override
    public void goTo(int next) {
        int inside = Math.max(0, Math.min(last(), next));
        if (inside == step) return;
        step = inside;
        tell();
    }
}
