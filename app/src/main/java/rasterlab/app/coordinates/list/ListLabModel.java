package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import rasterlab.app.canvas.Steps;
import rasterlab.app.coordinates.figure.ChoiceModel;
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
 */
public final class ListLabModel extends ChoiceModel<ListChoice> implements Steps {
    private static final double TURN = 180;
    private static final String FORMULA = "formula";
    private static final String PRINTED = "formula-textbook";

    private final MatrixTopic topic = new MatrixTopic();
    private ListScene scene;
    private int step;

    public ListLabModel() {
        super(ListChoice.first());
        scene = ListScene.of(topic, choice());
        step = scene.last();
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

    /** Shows points of space that go through matrices, by the right formula. */
    public void show(PointList list) {
        rearrange(
                choice().with(list.points())
                        .withItems(list.items(), list.items().size() - 1)
                        .withMethod(FORMULA));
        goTo(last());
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

    /** One matrix more behind the selected one; none beyond {@link ListChoice#MOST}. */
    public void add(String name) {
        ListChoice now = choice();
        if (now.items().size() >= ListChoice.MOST) return;
        var items = new ArrayList<>(now.items());
        int at = now.selected() + 1;
        items.add(at, ListItem.first(name, now.dimension()));
        edit(now.withItems(items, at));
    }

    /** The selected one less. */
    public void remove() {
        ListChoice now = choice();
        if (now.selected() < 0) return;
        var items = new ArrayList<>(now.items());
        items.remove(now.selected());
        edit(now.withItems(items, now.selected()));
    }

    /** The selected one so many places later. */
    public void move(int by) {
        ListChoice now = choice();
        int to = now.selected() + by;
        if (now.selected() < 0 || to < 0 || to >= now.items().size()) return;
        var items = new ArrayList<>(now.items());
        Collections.swap(items, now.selected(), to);
        edit(now.withItems(items, to));
    }

    /**
     * Another number for the selected matrix; one out of its range is shown with why it is refused.
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

    @Override
    protected void chosen(ListChoice next) {
        scene = ListScene.of(topic, next);
        step = Math.min(step, scene.last());
    }

    @Override
    public int first() {
        return 0;
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

    @Override
    public boolean turnsRound() {
        return false;
    }
}
